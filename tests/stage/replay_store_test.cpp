// SPDX-License-Identifier: MIT
#include <apart/stage/replay_store.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

/// Provides a separate folder for each test, and a recorded game.
class ReplayStore : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / "apart-replays" / test->name();
        fs::remove_all(folder_);
        best_ = bestFile(folder_, Mode::Standard, level_->name);
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& text) const {
        fs::create_directories(best_.parent_path());
        ASSERT_FALSE(writeTextFile(best_, text));
    }
    static std::string read(const fs::path& file) {
        const Read<std::string> text = readTextFile(file, kLargestReplay);
        const auto* good = std::get_if<std::string>(&text);
        return good != nullptr ? *good : "";
    }
    /// Keeps the game as the best one of its level, and expects the old file under another name.
    void expectAside(const std::string& old, const std::string& ending) const {
        write(old);
        EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
        EXPECT_EQ(read(best_), toText(game_));
        EXPECT_EQ(read(best_.string() + ending), old);
    }

    std::shared_ptr<const Level> level_ = glassLevel("One block", {7});
    Replay game_ = recordedGame(level_, 3);
    fs::path folder_;
    fs::path best_;
};

TEST_F(ReplayStore, ABestGameIsLoadedAgain) {
    const ScoreStore store = scoresIn(folder_, {level_});
    EXPECT_EQ(std::get<std::string>(store.load(Mode::Standard, level_->name)), "no replay");
    EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
    EXPECT_EQ(std::get<ReplayRun>(store.load(Mode::Standard, level_->name)), ReplayRun{game_});
    EXPECT_EQ(std::get<std::shared_ptr<const Level>>(store.levelOf(game_)), level_);
    EXPECT_FALSE(fs::exists(folder_ / "last.replay"));
    EXPECT_EQ(keepReplay(folder_, {game_}, ""), "");
    EXPECT_EQ(read(folder_ / "last.replay"), toText(game_));
}

TEST_F(ReplayStore, ABetterGameReplacesAnotherOfTheSameRules) {
    EXPECT_EQ(keepReplay(folder_, {recordedGame(level_, 4)}, level_->name), "");
    EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
    EXPECT_EQ(read(best_), toText(game_));
    const auto files = fs::directory_iterator(best_.parent_path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

// D12: what is damaged or of another version is kept, and is no proof.
TEST_F(ReplayStore, ADamagedBestGameIsKeptAside) {
    const std::string damaged = toText(game_).substr(0, 100);
    write(damaged);
    EXPECT_EQ(std::get<std::string>(scoresIn(folder_, {level_}).load(Mode::Standard, level_->name)),
              "damaged replay");
    expectAside(damaged, ".broken");
    expectAside("another", ".broken-2");
}

TEST_F(ReplayStore, ABestGameOfOtherRulesOrOfAnotherLevelIsKeptAside) {
    Replay old = game_;
    old.rules = kRulesVersion - 1;
    expectAside(toText(old), ".rules-" + std::to_string(kRulesVersion - 1));
    old = game_;
    old.levelDigest = *old.levelDigest + 1;
    expectAside(toText(old), ".older-level");
}

TEST_F(ReplayStore, AFailureIsASentence) {
    fs::create_directories(folder_);
    ASSERT_FALSE(writeTextFile(folder_ / "best", "a file where the folder should be"));
    EXPECT_NE(keepReplay(folder_, {game_}, level_->name).find("The game is not recorded: "),
              std::string::npos);
}

} // namespace
} // namespace apart
