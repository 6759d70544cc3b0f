// SPDX-License-Identifier: MIT
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/records/replay_store.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

/// A finished game of the bot, with its score.
Records::Result resultOf(const std::shared_ptr<const Level>& level, std::uint32_t seed) {
    Game game(*level, seed);
    Recorder recorder(game);
    while (game.result() == Result::Playing) {
        const Input input = bot(game);
        game.tick(input);
        recorder.record(input, game);
    }
    return {{Mode::Standard, level->name},
            {game.score(), game.result() == Result::Won, false, false},
            {recorder.finish(game)}};
}

/// Games that run at once on one folder: each has read the profile at its start.
class TwoGames : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        for (std::uint32_t seed = 1; seed < 20 && better_.best.score == worse_.best.score; ++seed) {
            better_ = resultOf(level_, seed);
        }
        if (better_.best.score < worse_.best.score) {
            std::swap(better_, worse_);
        }
        ASSERT_GT(better_.best.score, worse_.best.score);
    }

    fs::path file() const { return folder_ / "profile.toml"; }
    Records start(bool withProfile = true) const {
        LoadedProfile loaded = withProfile ? loadProfile(file()) : LoadedProfile{};
        Keeping keeping;
        if (withProfile) {
            keeping.save = profileSaver(file(), loaded.profile);
            keeping.saved = [path = file()] { return savedProfile(path); };
        }
        keeping.keepReplay = [folder = folder_](const ReplayRun& run, const std::string& best) {
            return keepReplay(folder, run, best);
        };
        return {std::move(loaded.profile), keeping, scoresIn(folder_, {level_}), {}};
    }
    /// The better game is the one that is stored, and its score is proved at the next start.
    void expectTheBetterStays() const {
        const ScoreStore store = scoresIn(folder_, {level_});
        EXPECT_EQ(std::get<ReplayRun>(store.load(Mode::Standard, level_->name)), better_.run);
        Records next = start();
        EXPECT_EQ(next.profile().bestOf(Mode::Standard, level_->name).score, better_.best.score);
        next.checkFirst(Mode::Standard, level_->name);
        for (int i = 0; i < 10000 && next.provedScore(Mode::Standard, level_->name) == 0; ++i) {
            next.advance(100);
        }
        EXPECT_EQ(next.provedScore(Mode::Standard, level_->name), better_.best.score);
    }

    std::shared_ptr<const Level> level_ = glassLevel("Three blocks", {2, 7, 12});
    Records::Result worse_ = resultOf(level_, 3);
    Records::Result better_ = worse_;
};

TEST_F(TwoGames, TheBetterScoreStaysIfTheWorseEndsLast) {
    Records one = start();
    Records other = start();
    EXPECT_FALSE(other.enter(better_));
    other.close();
    EXPECT_FALSE(one.enter(worse_));
    one.close();
    expectTheBetterStays();
}

TEST_F(TwoGames, TheBetterScoreStaysIfItEndsLast) {
    Records one = start();
    Records other = start();
    one.enter(worse_);
    one.close();
    other.enter(better_);
    other.close();
    expectTheBetterStays();
}

// I1: one game is delayed after it has read the profile, the other saves meanwhile: its score was
// lost, since the first one did not know of it.
TEST_F(TwoGames, TheSecondWaitsWhileTheFirstMergesAndSaves) {
    fs::create_directories(folder_); // a folder that is missing cannot be locked
    Profile one;
    one.best[0]["a"].score = 10;
    Profile other;
    other.best[0]["b"].score = 20;
    std::optional<FileProblem> problem;
    std::atomic<bool> done{false};
    std::thread second;
    {
        const FolderLock lock(folder_); // the first one merges
        second = std::thread([&] {
            problem = saveProfile(file(), other, std::nullopt);
            done = true;
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        EXPECT_FALSE(done);
        EXPECT_FALSE(writeTextFile(file(), toText(one)));
    }
    second.join();
    EXPECT_FALSE(problem);
    const std::optional<Profile> saved = savedProfile(file());
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->bestOf(Mode::Standard, "a").score, 10);
    EXPECT_EQ(saved->bestOf(Mode::Standard, "b").score, 20);
}

// The stored replay alone tells that it is better: the profile was lost, or is not written yet.
TEST_F(TwoGames, AStoredReplayWithoutAProfileIsPlayedBeforeItIsReplaced) {
    EXPECT_EQ(keepReplay(folder_, better_.run, level_->name), "");
    Records one = start(false);
    EXPECT_FALSE(one.enter(worse_));
    one.close();
    EXPECT_EQ(one.provedScore(Mode::Standard, level_->name), better_.best.score);
    const ScoreStore store = scoresIn(folder_, {level_});
    EXPECT_EQ(std::get<ReplayRun>(store.load(Mode::Standard, level_->name)), better_.run);

    EXPECT_EQ(keepReplay(folder_, worse_.run, level_->name), "");
    Records other = start(false);
    other.enter(better_);
    other.close();
    EXPECT_EQ(std::get<ReplayRun>(store.load(Mode::Standard, level_->name)), better_.run);
}

// A score that was proved at the start is compared with what another game has stored since.
TEST_F(TwoGames, AProvedScoreIsComparedWithALaterReplay) {
    Records first = start();
    Records::Result least = worse_;
    least.best.score = 1;
    first.enter(least);
    EXPECT_EQ(keepReplay(folder_, better_.run, level_->name), "");
    EXPECT_FALSE(first.enter(worse_));
    first.close();
    expectTheBetterStays();
}

TEST_F(TwoGames, AnInvalidStoredReplayIsReplaced) {
    Replay forged = better_.run[0];
    forged.hashes.back().hash ^= 1;
    EXPECT_EQ(keepReplay(folder_, {forged}, level_->name), "");
    Records one = start();
    one.enter(worse_);
    one.close();
    const ScoreStore store = scoresIn(folder_, {level_});
    EXPECT_EQ(std::get<ReplayRun>(store.load(Mode::Standard, level_->name)), worse_.run);
    EXPECT_EQ(one.provedScore(Mode::Standard, level_->name), worse_.best.score);
}

} // namespace
} // namespace apart
