// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/run.hpp>
#include <apart/core/tuning.hpp>

#include <game/level_of_glass.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace apart {
namespace {

/// A level of one glass block, under the name of an endless one.
std::shared_ptr<const Level> row(std::uint32_t number) {
    Level level = levelOfGlass({7});
    level.name = "endless:7:" + std::to_string(number);
    level.title = "Row";
    return std::make_shared<const Level>(level);
}

LevelOrReason find(const Replay& replay) {
    for (std::uint32_t number = 1; number < 4; ++number) {
        if (replay.level == row(number)->name) {
            return row(number);
        }
    }
    return "no such level";
}

/// The bot's games on the first levels, each won, and their score.
struct Played {
    ReplayRun run;
    std::int32_t score = 0;

    explicit Played(std::uint32_t levels) {
        for (std::uint32_t number = 1; number <= levels; ++number) {
            Game game(row(number), number);
            Recorder recorder(game);
            while (game.result() == Result::Playing) {
                const Input input = bot(game);
                game.tick(input);
                recorder.record(input, game);
            }
            EXPECT_EQ(game.result(), Result::Won);
            run.push_back(recorder.finish(game));
            score += game.score();
        }
    }
};

std::optional<std::int32_t> scoreOf(const ReplayRun& run) {
    RunCheck check(run, find);
    while (!check.done()) {
        check.advance(1000);
    }
    return check.score();
}

TEST(ReplayRun, AFileHoldsAllItsLevels) {
    const Played played(3);
    const Read<ReplayRun> read = parseRun(toText(played.run), "x");
    ASSERT_TRUE(std::holds_alternative<ReplayRun>(read)) << std::get<FileProblem>(read).text();
    EXPECT_EQ(std::get<ReplayRun>(read), played.run);
}

TEST(ReplayRun, AFileOfOneReplayIsARunOfOneLevel) {
    const Played played(1);
    const Read<ReplayRun> read = parseRun("# a comment\n" + toText(played.run[0]), "x");
    ASSERT_TRUE(std::holds_alternative<FileProblem>(read)) << "the digest covers the comment";
    EXPECT_EQ(std::get<ReplayRun>(parseRun(toText(played.run[0]), "x")), played.run);
    Replay written = played.run[0];
    written.handwritten = true;
    EXPECT_EQ(std::get<ReplayRun>(parseRun("# a comment\n" + toText(written), "x")),
              ReplayRun{written});
}

TEST(ReplayRun, AProblemIsReportedWithItsLineInTheFile) {
    const Played played(2);
    const std::string first = toText(played.run[0]);
    const auto lines = static_cast<int>(std::count(first.begin(), first.end(), '\n'));
    const Read<ReplayRun> read = parseRun(first + "apart-replay 2\nlevel\n", "x");
    ASSERT_TRUE(std::holds_alternative<FileProblem>(read));
    EXPECT_EQ(std::get<FileProblem>(read).line, lines + 2);
    EXPECT_TRUE(std::holds_alternative<FileProblem>(parseRun("", "x")));
    EXPECT_TRUE(std::holds_alternative<FileProblem>(parseRun(first + "more\n", "x")));
}

TEST(ReplayRun, OnlyConsecutiveLevelsOfOneSeedAndModeAreARun) {
    const Played played(3);
    const auto refused = [](const ReplayRun& run) {
        return std::holds_alternative<FileProblem>(parseRun(toText(run), "x"));
    };
    EXPECT_TRUE(refused({played.run[0], played.run[2]}));
    EXPECT_TRUE(refused({played.run[1], played.run[0]}));
    EXPECT_FALSE(refused({played.run[1], played.run[2]}));
    Replay other = played.run[1];
    other.mode = Mode::Pure;
    EXPECT_TRUE(refused({played.run[0], other}));
    other = played.run[1];
    other.level = "endless:8:2";
    EXPECT_TRUE(refused({played.run[0], other}));
    other.level = "first_light";
    EXPECT_TRUE(refused({played.run[0], other}));
}

TEST(RunCheck, GivesTheSumOfTheScores) {
    const Played played(3);
    EXPECT_EQ(scoreOf(played.run), std::optional(played.score));
    RunCheck check(played.run, find);
    double before = 0;
    for (int i = 0; i < 100000 && !check.done(); ++i) {
        EXPECT_EQ(check.score(), std::nullopt);
        check.advance(7);
        EXPECT_GE(check.share(), before);
        EXPECT_LE(check.share(), 1);
        before = check.share();
    }
    EXPECT_EQ(check.score(), std::optional(played.score));
}

TEST(RunCheck, ARunThatCannotHappenHasNoScore) {
    const Played played(2);
    EXPECT_EQ(scoreOf({}), std::nullopt);
    ReplayRun cut = played.run; // the first level is not won
    cut[0].end /= 2;
    std::erase_if(cut[0].inputs, [&](const auto& change) { return change.tick > cut[0].end; });
    std::erase_if(cut[0].hashes, [&](const auto& mark) { return mark.tick > cut[0].end; });
    EXPECT_EQ(scoreOf(cut), std::nullopt);
    ReplayRun unknown = played.run;
    unknown[1].level = "endless:9:9";
    EXPECT_EQ(scoreOf(unknown), std::nullopt);
    ReplayRun forged = played.run;
    forged[1].hashes[0].hash ^= 1;
    EXPECT_EQ(scoreOf(forged), std::nullopt);
    ReplayRun old = played.run;
    old[0].rules = kRulesVersion - 1;
    EXPECT_EQ(scoreOf(old), std::nullopt);
}

} // namespace
} // namespace apart
