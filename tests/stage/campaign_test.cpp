// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/screens/ending.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

constexpr std::array<std::string_view, 2> kTestBosses = {"day_4", "harbour_2"};

/// Five levels of one theme and three of another, each with a boss at its end, and one of the
/// player.
LevelList nineLevels() {
    LevelList levels;
    const auto add = [&](const std::string& name, Theme theme) {
        Level level = *glassLevel("x", {7});
        level.name = name;
        level.title = "The " + name;
        level.theme = theme;
        levels.push_back(std::make_shared<const Level>(level));
    };
    for (int i = 0; i < 5; ++i) {
        add("day_" + std::to_string(i), Theme::Daybreak);
    }
    for (int i = 0; i < 3; ++i) {
        add("harbour_" + std::to_string(i), Theme::Harbour);
    }
    add("mine", Theme::Harbour);
    return levels;
}

std::vector<MedalMarks> marksOfAll(const LevelList& levels) {
    std::vector<MedalMarks> marks;
    for (const auto& level : levels) {
        marks.push_back({level->name, 0, {10, 20, 30}});
    }
    return marks;
}

struct CampaignRules : testing::Test {
    std::vector<int> missing() const {
        std::vector<int> medals;
        for (const Stop& stop : stopsOf(levels, campaign, profile, marks)) {
            medals.push_back(stop.medals);
        }
        return medals;
    }
    std::size_t countOpen() const {
        const std::vector<Stop> stops = stopsOf(levels, campaign, profile, marks);
        return static_cast<std::size_t>(std::count_if(
            stops.begin(), stops.end(), [](const Stop& stop) { return stop.open(); }));
    }
    void score(const char* level, std::int32_t points, Mode mode = Mode::Standard) {
        profile.enter(mode, level, {points, points >= 10, false, false});
    }

    LevelList levels = nineLevels();
    std::vector<MedalMarks> marks = marksOfAll(levels);
    Campaign campaign{kTestBosses, 8};
    Profile profile;
};

TEST_F(CampaignRules, TwoLevelsAreOpenAtFirstAndEachMedalOpensOneMore) {
    EXPECT_EQ(missing(), (std::vector{0, 0, 1, 2, 6, 0, 0, 3, 0}));
    EXPECT_EQ(countOpen(), 3u) << "two, and the one of the player";
    score("day_0", 10);
    EXPECT_EQ(missing(), (std::vector{0, 0, 0, 1, 5, 0, 0, 3, 0}));
    score("day_0", 20); // silver counts as two
    EXPECT_EQ(missing(), (std::vector{0, 0, 0, 0, 4, 0, 0, 3, 0}));
    score("day_1", 30, Mode::Pure); // of any mode
    EXPECT_EQ(missing(), (std::vector{0, 0, 0, 0, 1, 0, 0, 3, 0}));
    score("day_2", 5); // without a medal
    EXPECT_EQ(missing()[4], 1);
    score("day_2", 10);
    EXPECT_EQ(missing()[4], 0);
    EXPECT_EQ(countOpen(), 6u);
}

TEST_F(CampaignRules, AThemeOpensWithTheBossBeforeIt) {
    std::vector<Stop> stops = stopsOf(levels, campaign, profile, marks);
    ASSERT_TRUE(stops[5].after);
    EXPECT_EQ(stops[5].asks(), "Opens once The day_4 is won.");
    EXPECT_TRUE(stops[4].boss);
    EXPECT_EQ(stops[4].asks(), "Opens with 6 more medals.");
    profile.enter(Mode::Standard, "day_4", {500, false, false, false}); // gold, but not won
    EXPECT_TRUE(stopsOf(levels, campaign, profile, marks)[5].after);
    profile.enter(Mode::Standard, "day_4", {1, true, false, false});
    stops = stopsOf(levels, campaign, profile, marks);
    EXPECT_TRUE(stops[5].open());
    EXPECT_TRUE(stops[6].open());
    EXPECT_EQ(stops[7].medals, 3);
}

TEST_F(CampaignRules, WhereNoMedalsCanBeWonVictoriesOpenTheBoss) {
    marks.clear();
    for (const char* level : {"day_0", "day_1", "day_2"}) {
        score(level, 10);
    }
    EXPECT_EQ(missing()[4], 1);
    score("day_3", 10);
    EXPECT_EQ(missing()[4], 0);
}

TEST_F(CampaignRules, WhatWasPlayedStaysOpenAndTheSwitchOpensAll) {
    score("harbour_1", 0);
    const std::vector<Stop> stops = stopsOf(levels, campaign, profile, marks);
    EXPECT_TRUE(stops[6].open());
    EXPECT_FALSE(stops[5].open());
    campaign.open = true;
    EXPECT_EQ(countOpen(), levels.size());
}

TEST_F(CampaignRules, TheNextLevelIsTheFirstOpenOneThenThePoorest) {
    const auto next = [&] {
        return nextToPlay(levels, stopsOf(levels, campaign, profile, marks), profile, marks);
    };
    levels.pop_back(); // that of the player
    EXPECT_EQ(next(), 0u);
    score("day_0", 20);
    score("day_1", 10);
    EXPECT_EQ(next(), 2u);
    score("day_2", 10);
    score("day_3", 10);
    EXPECT_EQ(next(), 1u) << "the boss asks for another medal";
    score("day_1", 20);
    EXPECT_EQ(next(), 4u);
}

// A profile of a game without a map: the levels up to the one that it offered stay open.
TEST_F(CampaignRules, AnOldProfileKeepsWhatItHadReached) {
    StageDef def;
    def.levels = levels;
    def.campaign = campaign;
    def.marks = marks;
    def.profile = std::get<Profile>(profileFrom(
        "format = 1\n[best.day_3]\nscore = 3\ncleared = false\nunhurt = false\nchain = false\n",
        "profile.toml"));
    std::vector<Profile> kept;
    def.keeping.save = StageRig::keeping(kept);
    StageRig rig(std::move(def));
    rig.clickItem(Action::Levels);
    const auto open = [&](std::size_t level) { return rig.stage.levelMap().stops()[level].open(); };
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_TRUE(open(i)) << i;
    }
    EXPECT_FALSE(open(5));
    rig.press(Command::Back);
    rig.clickItem(Action::Options);
    rig.press(Command::Back); // saves
    ASSERT_EQ(kept.size(), 1u);
    const Profile again = std::get<Profile>(profileFrom(toText(kept[0]), "profile.toml"));
    EXPECT_EQ(again, kept[0]);
    EXPECT_TRUE(stopsOf(levels, campaign, again, marks)[4].open());
    EXPECT_FALSE(stopsOf(levels, campaign, again, marks)[5].open());
}

TEST(Campaign, EachThemeOfTheGameHasABossAtItsEnd) {
    LevelList levels;
    for (const std::string& name : levelNames()) {
        levels.push_back(std::make_shared<const Level>(std::get<Level>(loadLevel(name))));
    }
    putBossesLast(levels);
    const std::vector<Stop> stops = stopsOf(levels, {kBosses}, {}, {});
    std::size_t bosses = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool last = i + 1 == levels.size() || levels[i + 1]->theme != levels[i]->theme;
        EXPECT_EQ(stops[i].boss, last) << levels[i]->name;
        bosses += last ? 1 : 0;
    }
    EXPECT_EQ(bosses, kThemeNames.size());
}

/// The second of two levels is a boss, and the last one.
StageDef withBoss(bool bossWon) {
    StageDef def = StageRig::twoLevels();
    static constexpr std::array<std::string_view, 1> kOne = {"test_3"};
    def.campaign = {kOne};
    def.marks = {{"test_1", 0, {1, 900000, 999999}}, {"test_3", 0, {1, 900000, 999999}}};
    if (bossWon) {
        def.profile.enter(Mode::Standard, "test_3", {50, true, false, false});
    }
    return def;
}

TEST(Campaign, ABossAsksForAMedalAndIsNamedBeforeItsFirstGame) {
    StageRig rig(withBoss(false));
    rig.clickItem(Action::Levels);
    rig.press(Command::Right);
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Levels) << "it is closed";
    EXPECT_TRUE(rig.picture().says("1 more medal"));
    rig.press(Command::Left);
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    rig.press(Command::Confirm); // next
    ASSERT_EQ(rig.stage.screen(), Screen::BossCard);
    EXPECT_TRUE(rig.picture().says("Three blocks"));
    EXPECT_TRUE(rig.picture().says("THE BOSS"));
    const std::uint32_t before = rig.stage.session().game().ticks();
    rig.frames(30);
    EXPECT_EQ(rig.stage.session().game().ticks(), before) << "the game waits";
    rig.press(Command::Launch);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.stage.session().game().serving());
}

TEST(Campaign, ABossWithAResultIsNotNamedAgain) {
    StageRig rig(withBoss(true));
    rig.clickItem(Action::Levels);
    rig.press(Command::Right);
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, withBoss(true).levels[1]->name);
}

TEST(Campaign, TheEndingFollowsTheLastBossAndTellsWhatIsLeft) {
    StageRig rig(withBoss(true));
    rig.clickItem(Action::Levels);
    rig.press(Command::Right);
    rig.press(Command::Confirm);
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Ending);
    EXPECT_TRUE(rig.picture().says("Three blocks: "));
    EXPECT_TRUE(rig.picture().says("1 of 6 medals"));
    EXPECT_TRUE(rig.picture().says("gold in 2 levels"));
    EXPECT_TRUE(rig.picture().says("2 levels under pure rules"));
    rig.clickItem(Action::Levels);
    EXPECT_EQ(rig.stage.screen(), Screen::Levels);
}

TEST(Campaign, AClosedNextLevelIsNotOfferedAfterAVictory) {
    StageDef def = withBoss(false);
    def.marks[0].scores = {900000, 950000, 999999};
    StageRig rig(std::move(def));
    rig.clickItem(Action::Play);
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    EXPECT_EQ(rig.stage.menu().items()[0].action, Action::Levels);
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Levels);
}

TEST(Campaign, TheOptionOpensAllLevels) {
    StageRig rig(withBoss(false));
    rig.clickItem(Action::Options);
    for (int i = 0; i < 3; ++i) {
        rig.clickItem(Action::Page);
    }
    rig.clickItem(Action::Dial);
    rig.press(Command::Right);
    EXPECT_EQ(rig.stage.records().profile().settings.openLevels, 1);
    rig.press(Command::Back);
    rig.clickItem(Action::Levels);
    EXPECT_TRUE(rig.stage.levelMap().stops()[1].open());
}

} // namespace
} // namespace apart
