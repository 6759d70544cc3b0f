// SPDX-License-Identifier: MIT
#include <apart/stage/records/replay_store.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

/// Provides a separate folder for each test, and a recorded game.
class ReplayStore : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        best_ = bestFile(folder_, Mode::Standard, level_->name);
    }

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

TEST_F(ReplayStore, ListsTheLastGameAndTheBestOnesWithTheirLevels) {
    std::vector<std::pair<ReplayRun, std::string>> kept;
    StageDef def = StageRig::playing();
    def.keeping.keepReplay = [&](const ReplayRun& run, const std::string& best) {
        return keepReplay(folder_, run, best);
    };
    const LevelList levels = def.levels;
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    ASSERT_FALSE(writeTextFile(folder_ / "best" / "torn-standard.replay", "apart-replay 2\nlevel"));
    const std::vector<fs::path> files = replayFiles(folder_);
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0].filename(), "last.replay");
    for (const fs::path& file : files) {
        const ShowEntry entry = entryOf(file, levels);
        EXPECT_EQ(entry.date.size(), 10u);
        if (file.stem() == "torn-standard") {
            EXPECT_EQ(entry.title, "torn-standard.replay");
            EXPECT_EQ(entry.result, "cannot be read");
            continue;
        }
        const bool last = file.stem() == "last";
        EXPECT_EQ(entry.title, last ? "Last game: One block" : "One block");
        EXPECT_EQ(entry.result, "won");
        EXPECT_EQ(entry.score, std::optional<std::int64_t>(rig.stage.session().game().score()));
        EXPECT_EQ(entry.best.has_value(), !last);
    }
    const auto run = std::get<ReplayRun>(readRunFile(files[0]));
    Playback playback(run[0], levels[0]);
    while (!playback.done()) {
        playback.tick();
    }
    EXPECT_TRUE(playback.failures().empty()) << "the noted result and score are checked";
}

TEST_F(ReplayStore, AnOlderRecordingIsListedWithoutResultAndScore) {
    EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
    const ShowEntry entry = entryOf(best_, {level_});
    EXPECT_EQ(entry.title, "One block");
    EXPECT_EQ(entry.result, "");
    EXPECT_FALSE(entry.score);
    EXPECT_EQ(entry.best, (std::pair<Mode, std::string>{Mode::Standard, level_->name}));
}

/// The stage after the start of the game on the files of a folder.
StageDef started(const fs::path& folder, const LevelList& levels) {
    LoadedProfile loaded = loadProfile(folder / "profile.toml");
    restoreScores(loaded, folder / "profile.toml");
    StageDef def = StageRig::twoLevels();
    def.levels = levels;
    def.profile = std::move(loaded.profile);
    if (!loaded.notice.empty()) {
        def.notices = {loaded.notice};
    }
    def.scores = scoresIn(folder, levels);
    def.keeping.save = profileSaver(folder / "profile.toml", def.profile);
    return def;
}

// Regression: all scores were gone, although each had its replay.
TEST_F(ReplayStore, WithoutAProfileTheScoresAreThoseOfTheReplays) {
    EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
    EXPECT_EQ(keepReplay(folder_, {game_}, "gone"), "") << "a replay of another level";
    Playback played(game_, level_);
    while (!played.done()) {
        played.tick();
    }
    {
        StageRig rig(started(folder_, {level_}));
        const std::vector<std::string>& notices = rig.stage.records().notices();
        ASSERT_EQ(notices.size(), 1u);
        EXPECT_NE(notices[0].find("is missing: the scores are taken from 2 replays in best"),
                  std::string::npos);
        rig.frames(60 * 10);
        rig.clickItem(Action::Levels);
        EXPECT_TRUE(rig.picture().says("1 of 1 cleared"));
    }
    const LoadedProfile saved =
        loadProfile(folder_ / "profile.toml"); // without the end of the game
    EXPECT_TRUE(saved.whole);
    EXPECT_EQ(saved.profile.bestOf(Mode::Standard, level_->name),
              (Best{played.game().score(), true, false, false}));
    EXPECT_TRUE(started(folder_, {level_}).notices.empty()) << "the next time";
}

TEST_F(ReplayStore, AScoreThatADamagedProfileHasLostIsThatOfItsReplay) {
    EXPECT_EQ(keepReplay(folder_, {game_}, level_->name), "");
    ASSERT_FALSE(writeTextFile(folder_ / "profile.toml", "format = 1\n[best.test_1\nscore = 70\n"));
    StageRig rig(started(folder_, {level_}));
    rig.frames(60 * 20);
    EXPECT_GT(rig.stage.records().provedScore(Mode::Standard, level_->name), 0);
}

TEST_F(ReplayStore, WithoutProfileAndReplaysNothingIsSaid) {
    EXPECT_TRUE(started(folder_, {level_}).notices.empty());
}

TEST_F(ReplayStore, ListsOfTheBestGamesOnlyTheLatest) {
    for (int i = 0; i < 15; ++i) {
        EXPECT_EQ(keepReplay(folder_, {game_}, "level_" + std::to_string(i)), "");
    }
    EXPECT_EQ(replayFiles(folder_).size(), kMostReplays);
    EXPECT_TRUE(replayFiles(folder_ / "none").empty());
}

} // namespace
} // namespace apart
