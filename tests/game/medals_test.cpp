// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/medals.hpp>
#include <apart/core/tuning.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace apart {
namespace {

const std::vector<MedalMarks> kMarks = {{"a", 7, {100, 200, 400}, 12, 20}, {"b", 8, {50, 50, 50}}};

TEST(Medals, AScoreEarnsTheHighestMarkThatItReaches) {
    EXPECT_EQ(medalOf(99, "a", kMarks), Medal::None);
    EXPECT_EQ(medalOf(100, "a", kMarks), Medal::Bronze);
    EXPECT_EQ(medalOf(399, "a", kMarks), Medal::Silver);
    EXPECT_EQ(medalOf(400, "a", kMarks), Medal::Gold);
    EXPECT_EQ(medalOf(50, "b", kMarks), Medal::Gold);
    EXPECT_EQ(medalOf(9999, "c", kMarks), Medal::None);
    EXPECT_EQ(nextMark(0, "a", kMarks), 100);
    EXPECT_EQ(nextMark(100, "a", kMarks), 200);
    EXPECT_EQ(nextMark(400, "a", kMarks), 0);
    EXPECT_EQ(nextMark(0, "c", kMarks), 0);
}

TEST(Medals, ALostGameWinsBronzeAtMost) {
    EXPECT_EQ(medalWon(99, false, "a", kMarks), Medal::None);
    for (const std::int32_t score : {100, 399, 400}) {
        EXPECT_EQ(medalWon(score, false, "a", kMarks), Medal::Bronze);
        EXPECT_EQ(medalWon(score, true, "a", kMarks), medalOf(score, "a", kMarks));
    }
}

TEST(Medals, BronzeIsForTheLazySilverForTwoGamesInTenAndGoldIsFifteenPercentAbove) {
    std::vector<std::int32_t> lazy(101);
    std::iota(lazy.begin(), lazy.end(), 1000); // 1000 to 1100: quantile q is 1000 + 100 q
    std::vector<std::int32_t> good(101);
    std::iota(good.begin(), good.end(), 1920);
    using Marks = std::array<std::int32_t, 3>;
    EXPECT_EQ(scoresForMedals(lazy, good, {}), (Marks{1050, 2000, 2300}));
    EXPECT_EQ(scoresForMedals(good, lazy, {}), (Marks{1950, 2000, 2300}));
    EXPECT_EQ(scoresForMedals({0}, {0}, {}), (Marks{50, 50, 100}));
}

TEST(Medals, GoldIsForOneLuckyGameOfABotInTenAtMost) {
    std::vector<std::int32_t> lazy(10, 100);
    lazy[2] = lazy[5] = 1000;
    using Marks = std::array<std::int32_t, 3>;
    EXPECT_EQ(scoresForMedals(lazy, {100}, {}), (Marks{100, 100, 1050}));
    EXPECT_EQ(scoresForMedals({100}, lazy, {}), (Marks{100, 100, 1050}));
}

TEST(Medals, SilverAndGoldLieAboveThePlayerWhoNeverMoves) {
    using Marks = std::array<std::int32_t, 3>;
    EXPECT_EQ(scoresForMedals({100}, {200}, {50, 199}), (Marks{100, 200, 250}));
    EXPECT_EQ(scoresForMedals({100}, {200}, {50, 200}), (Marks{100, 250, 300}));
}

/// The best score of games in which the paddle never moves.
std::int32_t bestOfAbsent(const Level& level, std::uint32_t seeds, std::uint32_t mostTicks) {
    std::int32_t best = 0;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        best = std::max(best, runBot(level, seed, mostTicks, BotKind::Absent).score);
    }
    return best;
}

TEST(Medals, MeasuringPutsSilverAboveThePlayerWhoNeverMoves) {
    constexpr std::uint32_t kMostTicks = 120 * kTicksPerSecond;
    const Level level = std::get<Level>(loadLevel("stone_circle"));
    EXPECT_GT(marksOf(level, playForMedals(level, 1, kMostTicks)).scores[1],
              bestOfAbsent(level, kAbsentGames, kMostTicks));
}

TEST(Medals, ThePlayerWhoNeverMovesWinsBronzeAtMost) {
    const auto read = readMedals(assetsFolder() / "medals.toml");
    ASSERT_TRUE(std::holds_alternative<std::vector<MedalMarks>>(read));
    for (const char* name : {"dominoes", "stone_circle", "barrels", "card_house", "cradle",
                             "pagoda", "funnel", "stilts", "springs"}) {
        const std::int32_t best = bestOfAbsent(std::get<Level>(loadLevel(name)), 12, 7200);
        EXPECT_LE(medalOf(best, name, std::get<std::vector<MedalMarks>>(read)), Medal::Bronze)
            << name << " has changed: run tools/medals " << name;
    }
}

TEST(Medals, TheTableIsReadAsItIsWritten) {
    const Read<std::vector<MedalMarks>> read = parseMedals(toText(kMarks), "x");
    ASSERT_TRUE(std::holds_alternative<std::vector<MedalMarks>>(read));
    EXPECT_EQ(std::get<std::vector<MedalMarks>>(read), kMarks);
}

TEST(Medals, AnInvalidTableIsRefused) {
    const std::string head = "format = 1\nrules = " + std::to_string(kRulesVersion) + "\n";
    const std::string digest = "digest = \"0000000000000007\"\n";
    for (const std::string& text :
         {std::string("format = 1\nrules = 1\n"), std::string("rules = 1\n"), head + "a = 1\n",
          head + "[a]\n" + digest, head + "[a]\n" + digest + "scores = [1, 2]\n",
          head + "[a]\n" + digest + "scores = [1, 3, 2]\n",
          head + "[a]\n" + digest + "scores = [0, 1, 2]\n", head + "[a]\nscores = [1, 2, 3]\n"}) {
        EXPECT_TRUE(std::holds_alternative<FileProblem>(parseMedals(text, "x"))) << text;
    }
}

TEST(Medals, MeasuringIsRepeatable) {
    const Level level = std::get<Level>(loadLevel("first_light"));
    const MedalMarks marks = marksOf(level, playForMedals(level, 1, 600));
    EXPECT_EQ(marks, marksOf(level, playForMedals(level, 1, 600)));
    EXPECT_GE(marks.oneFall, 8) << "the temple falls";
    EXPECT_TRUE(measuredOn(marks, level));
    EXPECT_FALSE(measuredOn({"first_light", marks.digest + 1, {}}, level));
}

// tools/medals remakes the table after a change of the rules or of a level.
TEST(Medals, TheTableOfTheGameIsUpToDate) {
    const auto read = readMedals(assetsFolder() / "medals.toml");
    ASSERT_TRUE(std::holds_alternative<std::vector<MedalMarks>>(read))
        << std::get<FileProblem>(read).text();
    const auto& marks = std::get<std::vector<MedalMarks>>(read);
    EXPECT_EQ(marks.size(), levelNames().size());
    for (const std::string& name : levelNames()) {
        const Level level = std::get<Level>(loadLevel(name));
        EXPECT_TRUE(std::any_of(marks.begin(), marks.end(),
                                [&](const auto& m) { return measuredOn(m, level); }))
            << name << " has changed: run tools/medals " << name;
    }
}

} // namespace
} // namespace apart
