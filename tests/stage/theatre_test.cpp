// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <support/draws.hpp>

#include "stage_rig.hpp"

namespace {

using namespace apart;

constexpr std::uint32_t kLength = 1500; // ticks

StageDef watching() {
    const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel("keystones")));
    StageDef def = StageRig::twoLevels();
    const Replay replay = recordedGame(level, 3, kLength);
    const Pilot pilot = [replay](const Game& game) {
        return game.ticks() < replay.end ? std::optional(inputAt(replay, game.ticks()))
                                         : std::nullopt;
    };
    def.show = Show{level, 3, Mode::Standard, pilot, replay.end};
    return def;
}

TEST(Theatre, SeekingGivesTheSameStateAsPlaying) {
    StageRig rig(watching());
    while (rig.stage.session().game().ticks() < 900) {
        rig.frame();
    }
    rig.press(Command::Pause);
    const std::uint32_t tick = rig.stage.session().game().ticks();
    const std::uint64_t hash = rig.stage.session().game().stateHash();
    rig.press(Command::Left);
    EXPECT_EQ(rig.stage.session().game().ticks(), tick - 600);
    rig.press(Command::Right);
    EXPECT_EQ(rig.stage.session().game().ticks(), tick);
    EXPECT_EQ(rig.stage.session().game().stateHash(), hash);
    rig.press(Command::Next);
    EXPECT_EQ(rig.stage.session().game().ticks(), tick + 1);
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.session().game().ticks(), 0u);
    for (int i = 0; i < 10; ++i) {
        rig.press(Command::Left); // before the start
    }
    EXPECT_EQ(rig.stage.session().game().ticks(), 0u);
}

/// Input of a mouse at this share of the bar.
Signals mouseOnBar(Real share, bool clicked, bool dragging) {
    const Aabb bar = Theatre::barPlace();
    Signals signals;
    signals.pointerNow = {Real(23) * (share - Real(0.5)), bar.center().y};
    signals.pointer = signals.pointerNow;
    signals.clicked = clicked;
    signals.dragging = dragging;
    return signals;
}

TEST(Theatre, AClickOrADragOnTheBarGoesThere) {
    StageRig rig(watching());
    rig.press(Command::Pause);
    EXPECT_TRUE(rig.stage.wantsPointer());
    const auto expectTick = [&](Real share) {
        EXPECT_NEAR(rig.stage.session().game().ticks(), share * kLength, 1);
    };
    rig.frame(mouseOnBar(Real(0.5), false, false));
    EXPECT_EQ(rig.stage.session().game().ticks(), 0u) << "without a button";
    rig.frame(mouseOnBar(Real(0.5), true, true));
    expectTick(Real(0.5));
    Signals drag = mouseOnBar(Real(0.25), false, true);
    drag.pointerNow.y = 9; // the bar stays held
    drag.pointer = drag.pointerNow;
    rig.frame(drag);
    expectTick(Real(0.25));
    rig.frame(mouseOnBar(Real(0.75), false, false)); // released there
    expectTick(Real(0.75));
    rig.frame(mouseOnBar(Real(0.1), false, true));
    expectTick(Real(0.75));
    rig.click({0, 9});
    expectTick(Real(0.75));
    rig.frame(mouseOnBar(Real(1), true, false));
    EXPECT_EQ(rig.stage.session().game().ticks(), kLength);
    rig.frame(mouseOnBar(Real(0), true, false));
    EXPECT_EQ(rig.stage.session().game().ticks(), 0u);
    rig.press(Command::Confirm); // takes over
    rig.press(Command::Confirm); // goes on
    EXPECT_FALSE(rig.stage.wantsPointer());
}

TEST(Theatre, PausesAndChangesItsSpeed) {
    Theatre theatre;
    EXPECT_EQ(theatre.pace(), 1);
    for (int i = 0; i < 5; ++i) {
        theatre.take(Command::Up, 0);
    }
    EXPECT_EQ(theatre.pace(), 8);
    for (int i = 0; i < 9; ++i) {
        theatre.take(Command::Down, 0);
    }
    EXPECT_EQ(theatre.pace(), 0.125);
    EXPECT_EQ(theatre.speedText(), "1/8");
    theatre.take(Command::Launch, 0);
    EXPECT_EQ(theatre.pace(), 0);
}

// The record of the continued game has the inputs of the show before it, so it replays from the
// first tick. It has no score.
TEST(Theatre, AGameTakenOverIsRecordedFromTheFirstTick) {
    std::vector<Replay> kept;
    std::vector<Profile> saved;
    StageDef def = watching();
    def.keeping.keepReplay = [&](const ReplayRun& run, const std::string& best) {
        EXPECT_EQ(best, "");
        kept.push_back(run.at(0));
        return std::string();
    };
    def.keeping.save = StageRig::keeping(saved);
    const std::shared_ptr<const Level> level = def.show->level;
    StageRig rig(std::move(def));
    rig.press(Command::Right);
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused) << "it waits for the player";
    const std::uint32_t from = rig.stage.session().game().ticks();
    const Real place =
        rig.stage.session().game().world()[rig.stage.session().game().paddle()].position().x;
    rig.frames(30);
    EXPECT_EQ(rig.stage.session().game().ticks(), from);
    EXPECT_TRUE(rig.picture().says("replay at 0:05 of"));
    EXPECT_TRUE(rig.picture().says("The score does not count"));
    rig.press(Command::Confirm);
    EXPECT_TRUE(rig.picture().says("WHAT IF   no score"));
    rig.frames(3);
    EXPECT_NEAR(
        rig.stage.session().game().world()[rig.stage.session().game().paddle()].position().x, place,
        0.5)
        << "the mouse has not moved";
    rig.frames(57);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::ToTitle); // the game has points
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_GT(kept[0].end, 600u);
    Playback playback(kept[0], level);
    while (!playback.done()) {
        playback.tick();
    }
    EXPECT_FALSE(playback.divergence());
}

TEST(Theatre, ListsReplaysAndTellsWhyOneCannotBePlayed) {
    StageDef def = StageRig::twoLevels();
    def.profile.enter(Mode::Standard, "test_1", {6789, true, false, false});
    def.replays = [] {
        std::vector<ShowEntry> entries;
        entries.push_back({"a game", "2026-11-26", "won", 12345});
        entries.back().load = [] { return watching().show.value(); };
        entries.push_back({"an old game", "2026-11-25"});
        entries.back().best = {Mode::Standard, "test_1"};
        entries.back().load = [] { return std::variant<Show, std::string>("It is too old."); };
        return entries;
    };
    def.replayFolder = "a/folder";
    StageRig rig(std::move(def));
    rig.clickItem(Action::Records);
    rig.clickItem(Action::Replays);
    for (const char* text :
         {"a game", "2026-11-26", "won", "12 345", "an old game", "files in a/folder"}) {
        EXPECT_TRUE(rig.picture().says(text)) << text;
    }
    EXPECT_TRUE(rig.picture().says("6 789")) << "the score of the profile";
    rig.click(rig.stage.menu().place(1).center());
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    EXPECT_TRUE(rig.picture().says("It is too old."));
    rig.clickItem(Action::Records);
    rig.clickItem(Action::Replays);
    rig.click(rig.stage.menu().place(0).center());
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.picture().says("REPLAY"));
}

// Escape, the menu of a game that was taken over, and the end of a replay lead back to the list.
TEST(Theatre, AReplayOfTheListLeadsBackToIt) {
    StageDef def = StageRig::twoLevels();
    def.replays = [] {
        std::vector<ShowEntry> entries(3, {"a game"});
        for (ShowEntry& entry : entries) {
            entry.load = [] {
                Show show = watching().show.value();
                show.end = 200;
                show.pilot = [](const Game& game) {
                    return game.ticks() < 200 ? std::optional(Input{}) : std::nullopt;
                };
                return show;
            };
        }
        return entries;
    };
    StageRig rig(std::move(def));
    rig.clickItem(Action::Records);
    rig.clickItem(Action::Replays);
    const auto watchTheSecond = [&] {
        ASSERT_EQ(rig.stage.screen(), Screen::Replays);
        rig.click(rig.stage.menu().place(1).center());
        ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    };
    const auto expectTheList = [&] {
        EXPECT_EQ(rig.stage.screen(), Screen::Replays);
        EXPECT_EQ(rig.stage.menu().chosen(), 1u);
    };
    watchTheSecond();
    EXPECT_TRUE(rig.picture().says("escape: all replays"));
    rig.press(Command::Back);
    expectTheList();
    watchTheSecond();
    rig.press(Command::Confirm); // takes over, and waits
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    rig.clickItem(Action::Replays);
    expectTheList();
    watchTheSecond();
    rig.untilOver();
    EXPECT_TRUE(rig.picture().says("All replays"));
    rig.press(Command::Back);
    expectTheList();
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Records);
    rig.press(Command::Back);
    rig.clickItem(Action::Play);
    rig.press(Command::Pause);
    EXPECT_FALSE(rig.picture().says("All replays")) << "a game of one's own";
}

TEST(Theatre, AReplayOfAFileLeadsToTheMenu) {
    StageRig rig(watching());
    EXPECT_TRUE(rig.picture().says("escape: menu"));
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    EXPECT_FALSE(rig.picture().says("All replays"));
}

/// A replay of 100 ticks without input.
Show idle(std::shared_ptr<const Level> level) {
    return Show{
        std::move(level), 1, Mode::Standard,
        [](const Game& game) { return game.ticks() < 100 ? std::optional(Input{}) : std::nullopt; },
        100};
}

TEST(Theatre, ARunIsShownLevelByLevelAndFromItsStartAgain) {
    StageDef def = StageRig::twoLevels();
    Show second = idle(def.levels[1]);
    def.show = idle(def.levels[0]);
    def.show->next = [second] { return second; };
    StageRig rig(std::move(def));
    EXPECT_EQ(rig.stage.session().game().level().title, "One block");
    rig.press(Command::Up); // twice the speed, kept in the next level
    for (int i = 0; i < 600 && rig.stage.session().game().level().title == "One block"; ++i) {
        rig.frame();
    }
    EXPECT_EQ(rig.stage.session().game().level().title, "Three blocks");
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.picture().says("2 x"));
    rig.untilOver();
    rig.clickItem(Action::Restart);
    EXPECT_EQ(rig.stage.session().game().level().title, "One block");
}

TEST(Theatre, ARunWhoseNextLevelCannotBePlayedEndsWithANotice) {
    StageDef def = StageRig::twoLevels();
    def.show = idle(def.levels[0]);
    def.show->next = [] { return std::variant<Show, std::string>("It is too old."); };
    StageRig rig(std::move(def));
    rig.untilOver();
    EXPECT_EQ(rig.stage.screen(), Screen::Over);
    rig.clickItem(Action::ToTitle);
    EXPECT_TRUE(rig.picture().says("It is too old."));
}

// Also a game that the player left is kept.
TEST(Theatre, AnUnfinishedGameIsKept) {
    std::vector<Replay> kept;
    StageDef def = StageRig::playing();
    def.keeping.keepReplay = [&](const ReplayRun& run, const std::string&) {
        kept.push_back(run.at(0));
        return std::string();
    };
    StageRig rig(std::move(def));
    rig.frames(200);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].end, 400u);
}

// The lines of the result screen add up, for each way to earn points.
TEST(Results, ThePointsBySourceAddUpToTheScore) {
    for (const char* name : {"first_light", "tower", "keystones", "galleon", "castle"}) {
        Game game(std::get<Level>(loadLevel(name)), 2);
        RunStatistics statistics;
        while (game.result() == Result::Playing &&
               game.ticks() < (support::kSanitized ? 3000 : 9000)) {
            game.tick(bot(game));
            statistics.update(game);
            ASSERT_EQ(statistics.points.sum(), game.score()) << name << " " << game.ticks();
        }
    }
}

} // namespace
