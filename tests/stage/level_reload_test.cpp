// SPDX-License-Identifier: MIT
// The level of a file that is edited while the game runs.
#include <apart/stage/own_levels.hpp>
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/records/replay_store.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

/// A level file outside of the player's folder, and that folder. Separate for each test.
class LevelReload : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        // Short, so that a sentence with its name fits in a line.
        folder_ = fs::path(testing::TempDir()) / ("reload-" + std::to_string(test->line()));
        fs::remove_all(folder_);
        fs::create_directories(player());
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path file() const { return folder_ / (name_ + ".toml"); }
    fs::path player() const { return folder_ / "player"; }
    fs::path bestReplay() const { return bestFile(player(), Mode::Standard, name_); }

    /// Writes the file with this row of blocks, or replaces it.
    void write(const std::string& row, const std::string& title = "Mine") {
        std::ofstream(file()) << "format = 1\ntitle = \"" << title
                              << "\"\nidea = \"Glass.\"\ngrid = '''\n...............\n"
                              << row << "\n'''\n[legend.b]\nstuff = \"glass\"\n";
        time_ += std::chrono::seconds(2);
        fs::last_write_time(file(), time_);
    }
    /// The game with --level FILE, with what earlier ones have kept.
    StageDef start() const {
        StageDef def = StageRig::twoLevels();
        LoadedProfile loaded = loadProfile(player() / "profile.toml");
        def.profile = std::move(loaded.profile);
        def.scores = scoresIn(player(), def.levels);
        def.keeping.save = profileSaver(player() / "profile.toml", def.profile);
        def.keeping.keepReplay = [folder = player()](const ReplayRun& run, const std::string& key) {
            return keepReplay(folder, run, key);
        };
        EXPECT_EQ(takeLevelFile(def, file(), {}), "");
        return def;
    }
    static void look(StageRig& rig) { rig.frames(40); } // at the file, at least once

    const std::string name_ = "my_glass";
    fs::path folder_;
    fs::file_time_type time_ = fs::file_time_type::clock::now();
};

constexpr const char* kThree = "..b....b....b..";
constexpr const char* kOne = ".......b.......";

TEST_F(LevelReload, AnotherContentStartsANewTableAndKeepsTheFormerScore) {
    write(kThree);
    std::int32_t second = 0;
    {
        StageRig rig(start());
        playToTheEnd(rig);
        const std::int32_t first = rig.stage.session().game().score();
        ASSERT_EQ(rig.stage.records().provedScore(Mode::Standard, name_), first);
        write(kOne);
        look(rig);
        rig.press(Command::Restart);
        rig.frames(10);
        EXPECT_EQ(rig.stage.session().game().blocksAtStart(), 1);
        EXPECT_TRUE(
            rig.picture().says("a new table of scores begins. " + grouped(first) + " points"));
        EXPECT_FALSE(rig.picture().says("best  ")) << "no score to beat";
        playToTheEnd(rig);
        second = rig.stage.session().game().score();
        ASSERT_LT(second, first);
        EXPECT_TRUE(rig.picture().says(grouped(first) + " points of an earlier content"));
        const Best best = rig.stage.records().profile().bestOf(Mode::Standard, name_);
        EXPECT_EQ(best.score, second);
        EXPECT_EQ(best.unproved, first);
        EXPECT_EQ(rig.stage.records().provedScore(Mode::Standard, name_), second);
        EXPECT_TRUE(fs::exists(fs::path(bestReplay().string() + ".older-level")))
            << "the replay of the former score";
        rig.press(Command::Restart);
        rig.frames(10);
        EXPECT_TRUE(rig.picture().says("best  " + grouped(second)));
    }
    StageRig later(start());
    later.frames(600);
    EXPECT_EQ(later.stage.records().provedScore(Mode::Standard, name_), second)
        << "also of a file that is in no folder of levels";
}

TEST_F(LevelReload, OnlyAnotherContentStartsAGameInProgressAgain) {
    write(kThree);
    StageRig rig(start());
    rig.frames(100);
    write(kThree, "Yours");
    look(rig);
    EXPECT_GT(rig.stage.session().game().ticks(), 100u) << "a new title";
    EXPECT_TRUE(rig.picture().says("The next game shows the new texts"));
    EXPECT_TRUE(rig.picture().says("LEVEL ")) << "it is still a level of the list";
    write(kOne, "Yours");
    look(rig);
    EXPECT_LT(rig.stage.session().game().ticks(), 100u);
    EXPECT_EQ(rig.stage.session().game().level().title, "Yours");
}

TEST_F(LevelReload, ANewTitleKeepsTheScores) {
    write(kThree);
    StageRig rig(start());
    playToTheEnd(rig);
    const std::int32_t score = rig.stage.session().game().score();
    write(kThree, "Yours");
    look(rig);
    rig.press(Command::Restart);
    rig.frames(10);
    EXPECT_EQ(rig.stage.session().game().level().title, "Yours");
    EXPECT_TRUE(rig.picture().says("best  " + grouped(score)));
}

// The window of the editor has the focus: the game is paused while the file is saved.
TEST_F(LevelReload, APausedGameStartsAgainOnceItGoesOn) {
    write(kThree);
    StageRig rig(start());
    rig.frames(60);
    rig.press(Command::Pause);
    write(kOne);
    look(rig);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    EXPECT_EQ(rig.stage.session().game().blocksAtStart(), 3);
    rig.press(Command::Pause);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().blocksAtStart(), 1);
    EXPECT_LE(rig.stage.session().game().ticks(), 3u);
}

TEST_F(LevelReload, TheScoreOfAGameThatHasEndedIsEnteredFirst) {
    write(kOne);
    StageRig rig(start());
    while (rig.stage.session().game().result() == Result::Playing) {
        makeMove(rig);
    }
    ASSERT_EQ(rig.stage.screen(), Screen::Playing) << "the fanfare";
    const std::int32_t score = rig.stage.session().game().score();
    write(kThree);
    look(rig);
    rig.untilOver();
    EXPECT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_EQ(rig.stage.records().profile().bestOf(Mode::Standard, name_).score, score);
    look(rig);
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.session().game().blocksAtStart(), 3);
}

TEST_F(LevelReload, ErrorsAreShownInPlayInThePauseAndOnTheResults) {
    write(kOne);
    StageRig rig(start());
    write("..b....b....b", ""); // two errors
    look(rig);
    EXPECT_TRUE(rig.picture().says("a row of the grid has 15 letters"));
    EXPECT_TRUE(rig.picture().says("title must be a text"));
    rig.press(Command::Pause);
    EXPECT_TRUE(rig.picture().says("my_glass.toml:2: title must be a text"));
    EXPECT_TRUE(rig.picture().says("(1 more error)"));
    rig.press(Command::Pause);
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_TRUE(rig.picture().says("my_glass.toml:2: title must be a text"));
    write(kOne);
    look(rig);
    EXPECT_FALSE(rig.picture().says("my_glass.toml")) << "all is right again";
}

TEST_F(LevelReload, ADeletedFileIsToldUntilItIsThereAgain) {
    write(kOne);
    StageRig rig(start());
    fs::rename(file(), folder_ / "away");
    look(rig);
    EXPECT_TRUE(rig.picture().says("my_glass.toml: there is no such file"));
    EXPECT_EQ(rig.stage.session().game().blocksAtStart(), 1) << "the game goes on";
    EXPECT_GT(rig.stage.session().game().ticks(), 30u);
    fs::rename(folder_ / "away", file()); // with the same time
    look(rig);
    EXPECT_FALSE(rig.picture().says("my_glass.toml"));
    EXPECT_GT(rig.stage.session().game().ticks(), 100u)
        << "the same content does not start it again";
}

// An edit changes no other game: a run, or a replay.
TEST_F(LevelReload, AGameOnAnotherLevelGoesOn) {
    write(kOne);
    StageDef def = start();
    def.endless = [](std::uint32_t, std::uint32_t) { return glassLevel("Row", {2, 7}); };
    StageRig rig(std::move(def));
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::Endless);
    write(kThree);
    look(rig);
    EXPECT_EQ(rig.stage.session().game().level().title, "Row");
    EXPECT_GT(rig.stage.session().game().ticks(), 30u);
}

} // namespace
} // namespace apart
