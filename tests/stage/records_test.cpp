// SPDX-License-Identifier: MIT
#include <apart/core/endless.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/results.hpp>
#include <apart/stage/screens/statistics_page.hpp>

#include <gtest/gtest.h>

#include <algorithm>

#include "stage_rig.hpp"

namespace apart {
namespace {

constexpr Day kToday = 20261126;

TEST(Daily, ADayIsAKeyAndASeed) {
    EXPECT_EQ(dayText(kToday), "2026-11-26");
    EXPECT_EQ(dailyKey(kToday), "daily-2026-11-26");
    EXPECT_EQ(dayOf("daily-2026-11-26"), std::optional(kToday));
    EXPECT_EQ(dayOf("daily-2028-02-29"), std::optional(Day{20280229}));
    for (const char* key :
         {"daily-", "daily-2026-1-1", "daily-202611-2-6", "endless", "daily-2026-11-2x",
          "daily-2026_11_26", "daily-2100-02-29", "daily-2026-13-01", "daily-0000-00-00"}) {
        EXPECT_EQ(dayOf(key), std::nullopt) << key;
    }
}

TEST(Daily, OnlyARunFromItsFirstLevelWithItsSeedsIsOne) {
    Replay first;
    first.level = "endless:20261126:1";
    first.seed = dailySeed(kToday, 1);
    Replay second;
    second.level = "endless:20261126:2";
    second.seed = dailySeed(kToday, 2);
    EXPECT_TRUE(isDaily({first}, kToday));
    EXPECT_TRUE(isDaily({first, second}, kToday));
    EXPECT_FALSE(isDaily({}, kToday));
    EXPECT_FALSE(isDaily({second}, kToday));
    EXPECT_FALSE(isDaily({first}, kToday + 1));
    first.seed = 1; // another serve
    EXPECT_FALSE(isDaily({first}, kToday));
}

StageDef withRuns() {
    StageDef def = StageRig::twoLevels();
    def.endless = [](std::uint32_t, std::uint32_t) { return glassLevel("Row", {7}); };
    def.today = [] { return kToday; };
    def.daily = [](Day day, std::uint32_t number) {
        Level level = *glassLevel("Row of today", {7});
        level.name = EndlessName{day, number}.text();
        return std::make_shared<const Level>(level);
    };
    return def;
}

TEST(Daily, AStageMayStartWithTheRunOfADay) {
    StageDef def = withRuns();
    def.firstDay = kToday - 1;
    StageRig rig(std::move(def));
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-25, level 1"));
    EXPECT_EQ(rig.stage.session().game().seed(), dailySeed(kToday - 1, 1));
}

TEST(Daily, ItsScoreStandsOnTheTitleAndApartFromEndlessRuns) {
    std::vector<ReplayRun> kept;
    StageDef def = withRuns();
    def.keeping.keepReplay = [&kept](const ReplayRun& run, const std::string& best) {
        if (best == dailyKey(kToday)) {
            kept.push_back(run);
        }
        return std::string();
    };
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-26"));
    rig.clickItem(Action::Daily);
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-26, level 1"));
    EXPECT_EQ(rig.stage.session().game().seed(), dailySeed(kToday, 1));
    playToTheEnd(rig);
    const std::int32_t score = rig.stage.session().game().score();
    ASSERT_GT(score, 0);
    rig.press(Command::Next);
    EXPECT_EQ(rig.stage.session().game().seed(), dailySeed(kToday, 2));
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::ToTitle); // the run has points
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-26   best " + grouped(score)));
    EXPECT_EQ(rig.stage.records().profile().bestOf(Mode::Standard, kEndlessKey), Best{});
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_TRUE(isDaily(kept[0], kToday));
}

TEST(Statistics, EachGameIsCountedOnceInItsTheme) {
    StageRig rig(StageRig::playing());
    playToTheEnd(rig);
    const PlayTotals& totals = rig.stage.records().profile().totals[0];
    EXPECT_EQ(totals.games, 1);
    EXPECT_EQ(totals.won, rig.stage.session().game().result() == Result::Won ? 1 : 0);
    EXPECT_GE(totals.broken, 1);
    rig.press(Command::Restart); // a game of less than two seconds does not count
    rig.frames(30);
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.records().profile().totals[0].games, 1);
    rig.frames(180);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    EXPECT_EQ(rig.stage.records().profile().totals[0].games, 2);
    EXPECT_GE(rig.stage.records().profile().totals[0].seconds, 3);
    rig.clickItem(Action::Records);
    EXPECT_EQ(rig.stage.screen(), Screen::Records);
    EXPECT_TRUE(rig.picture().says("All themes"));
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
}

TEST(Statistics, TotalsAddAndMaximaStay) {
    PlayTotals sum{3, 1, 100, 20, 5, 7, 4};
    add(sum, {1, 1, 50, 10, 0, 9, 2});
    EXPECT_EQ(sum, (PlayTotals{4, 2, 150, 30, 5, 9, 4}));
    add(sum, {kMostTotal, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(sum.games, kMostTotal) << "no overflow";
    EXPECT_EQ(durationText(59), "0:59");
    EXPECT_EQ(durationText(3723), "1:02:03");
}

/// A stage whose first level has a recorded best game.
StageDef withBest(const Replay& best, std::int32_t score) {
    StageDef def = StageRig::twoLevels();
    def.startAtOnce = true;
    def.profile.enter(Mode::Standard, def.levels[0]->name, {score, true, false, false});
    def.scores.load = [best](Mode, const std::string&) { return ReplayRun{best}; };
    def.scores.levelOf = [level = def.levels[0]](const Replay&) -> LevelOrReason { return level; };
    return def;
}

// The ghost is a game of its own: with and without it the player's game has the same states.
TEST(Ghost, RunsBesideTheGameAndDoesNotChangeIt) {
    const auto level = StageRig::twoLevels().levels[0];
    const Replay best = recordedGame(level, 3);
    StageRig with(withBest(best, 100));
    StageDef off = withBest(best, 100);
    off.profile.settings.ghost = 0;
    StageRig without(std::move(off));
    const auto discs = [](StageRig& rig) {
        const auto& strokes = rig.picture().strokes();
        return std::count_if(strokes.begin(), strokes.end(), [](const Stroke& stroke) {
            return stroke.kind == Stroke::Kind::Ring && stroke.size == kBallRadius;
        });
    };
    for (StageRig* rig : {&with, &without}) {
        rig->press(Command::Launch);
        rig->frames(30);
    }
    EXPECT_EQ(with.stage.session().game().stateHash(), without.stage.session().game().stateHash());
    EXPECT_EQ(discs(with), discs(without) + 1) << "the ball of the ghost";
    with.press(Command::Restart);
    with.press(Command::Restart);
    with.frames(5);
    EXPECT_EQ(discs(with), discs(without) + 1) << "it starts again with the game";
}

TEST(Ghost, FollowsTheReplayTickByTickAndEndsWithIt) {
    const auto level = StageRig::twoLevels().levels[0];
    const Replay best = recordedGame(level, 3);
    Ghost ghost(best, level);
    Playback playback(best, level);
    while (!playback.done()) {
        playback.tick();
        ghost.tick();
        ASSERT_EQ(ghost.game().stateHash(), playback.game().stateHash());
    }
    EXPECT_TRUE(ghost.done());
    RecordingCanvas canvas;
    canvas.begin({{-16, 0}, {16, 20}}, {});
    ghost.draw(canvas, 1, 0.5f);
    EXPECT_TRUE(canvas.strokes().empty());
    ghost.tick(); // does nothing
    EXPECT_EQ(ghost.game().ticks(), best.end);
}

TEST(Honours, ThoseOfALevelDependOnItsMarks) {
    Game game(*glassLevel("One block", {7}), 3);
    RunStatistics statistics;
    while (game.result() == Result::Playing) {
        game.tick(bot(game));
        statistics.update(game);
    }
    ASSERT_EQ(game.result(), Result::Won);
    const int hits = game.counts().hits;
    ASSERT_GT(hits, 0);
    MedalMarks marks{"x", 0, {1, 2, 3}, hits, 5};
    EXPECT_TRUE(statistics.bestOf(game, &marks).fewHits);
    EXPECT_FALSE(statistics.bestOf(game, &marks).oneFall);
    marks.fewHits = hits - 1;
    EXPECT_FALSE(statistics.bestOf(game, &marks).fewHits);
    EXPECT_FALSE(statistics.bestOf(game).fewHits) << "a level without marks";
    for (int i = 0; i < 600; ++i) { // the game is over: nothing counts any more
        game.tick(bot(game));
        statistics.update(game);
    }
    EXPECT_EQ(game.counts().hits, hits);
    statistics.largestFall = 5;
    EXPECT_TRUE(statistics.bestOf(game, &marks).oneFall);
}

TEST(Honours, ALevelWithABlockToKeepOffersIt) {
    Level level = *glassLevel("One block", {7});
    EXPECT_EQ(honourNames(level, nullptr).size(), 2u);
    level.keep = 0;
    level.keepName = "bell";
    EXPECT_EQ(honourNames(level, nullptr).back(), "keep the bell");
    Game game(*glassLevel("One block", {7}), 3);
    RunStatistics statistics;
    while (game.result() == Result::Playing) {
        game.tick(bot(game));
        statistics.update(game);
    }
    EXPECT_FALSE(statistics.bestOf(game).kept) << "a level without one";
    statistics.keptAtEnd = true;
    EXPECT_TRUE(statistics.bestOf(game).kept);
}

// Regression: a level of one block asked for eight in one fall.
TEST(Honours, AChainIsOfferedWhereItCanBe) {
    Level level = *glassLevel("Seven blocks", {1, 2, 3, 4, 5, 6, 7});
    const auto offered = [&] {
        const std::vector<std::string> names = honourNames(level, nullptr);
        const auto chains = std::count(names.begin(), names.end(), "8 in one combo or fall");
        EXPECT_EQ(usualHonours(level), 2u + static_cast<std::size_t>(chains));
        EXPECT_EQ(honoursWon({{}, level, nullptr}).size(), names.size());
        return chains == 1;
    };
    EXPECT_FALSE(offered());
    BlockKind steel = level.kinds[0];
    steel.stuff = Stuff::Steel;
    level.kinds.push_back(steel);
    level.freeBlocks.push_back({.kind = 1, .x = 0, .y = 9000, .width = 1600, .height = 800});
    EXPECT_FALSE(offered()) << "steel does not count";
    level.freeBlocks.push_back({.kind = 0, .x = 2000, .y = 9000, .width = 1600, .height = 800});
    EXPECT_TRUE(offered());
}

TEST(Honours, ALevelWithWaysOffersThemAndTheProfileAddsThemUp) {
    Level level = *glassLevel("One block", {7});
    level.ways = {{"by bank", "", true}, {"head on", "g", false}};
    EXPECT_EQ(honourNames(level, nullptr).back(), "head on");
    EXPECT_EQ(honourNames(level, nullptr).size(), 4u);
    Profile profile;
    Best best;
    best.ways = 1;
    profile.enter(Mode::Standard, "x", best);
    best.ways = 2;
    profile.enter(Mode::Standard, "x", best);
    EXPECT_EQ(profile.bestOf(Mode::Standard, "x").ways, 3u);
}

TEST(Results, OneOfAThingIsSingular) {
    EXPECT_EQ(countText(0, "point"), "0 points");
    EXPECT_EQ(countText(1, "point"), "1 point");
    EXPECT_EQ(countText(12345, "point"), "12 345 points");
    StageDef def = StageRig::playing();
    def.marks = {{def.levels[0]->name, 0, {10, 20, 9999999}, 1, 7}};
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    EXPECT_TRUE(rig.picture().says("1 of 1 block in"));
    EXPECT_TRUE(rig.picture().says("1 hit at most"));
}

TEST(Medals, TheResultAndTheMapShowThem) {
    StageDef def = StageRig::playing();
    const std::string name = def.levels[0]->name;
    def.marks = {{name, 0, {10, 20, 9999999}, 99, 7}};
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    ASSERT_GT(rig.stage.session().game().score(), 20);
    EXPECT_TRUE(rig.picture().says("silver medal, gold from 9 999 999"));
    EXPECT_TRUE(rig.picture().says("99 hits at most"));
    EXPECT_TRUE(rig.picture().says("a fall of 7"));
    EXPECT_TRUE(rig.stage.records().profile().bestOf(Mode::Standard, name).fewHits);
    EXPECT_EQ(rig.stage.records().medalOf(Mode::Standard, name), Medal::Silver);
    EXPECT_EQ(rig.stage.records().medalOf(Mode::Pure, name), Medal::None);
    rig.clickItem(Action::Levels);
    rig.press(Command::Left);
    EXPECT_TRUE(rig.picture().says("gold 9 999 999"));
}

} // namespace
} // namespace apart
