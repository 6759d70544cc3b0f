// SPDX-License-Identifier: MIT
#include <apart/core/lint.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;

constexpr const char* kOpen = "...............\n"
                              ".....XXXXX.....\n"
                              ".....XbbbX.....\n"
                              ".....X.b.X.....\n"
                              "...............\n";

TEST(Lint, ABallReachesAPocketThatIsOpenBelow) {
    EXPECT_TRUE(outOfReach(levelOf(kOpen)).empty());
}

// Steel on all sides except diagonal gaps, too narrow for a ball.
TEST(Lint, NamesABlockEnclosedBySteel) {
    const Level level = levelOf("...............\n"
                                "......XXX......\n"
                                "......XbX......\n"
                                ".......X.......\n"
                                "....b.....g....\n");
    const std::vector<Cell> shut = outOfReach(level);
    ASSERT_EQ(shut.size(), 1u);
    EXPECT_EQ(shut[0].row, 2);
    EXPECT_EQ(shut[0].column, 7);

    const LintReport report = lint(level, {.seeds = 1, .mostTicks = 1200});
    EXPECT_FALSE(report.passed());
    EXPECT_EQ(report.problems.front(), "no ball can come to the block in row 3, column 8");
}

// Blocks behind breakable blocks are reachable.
TEST(Lint, BlocksBehindBreakableBlocksAreReachable) {
    EXPECT_TRUE(outOfReach(levelOf("XXXXXXXXXXXXXXX\n"
                                   "XgX.........XbX\n"
                                   "XgXXXXXXXXXXXbX\n"
                                   "XgsssssssssssbX\n"
                                   "XXXXXXXbXXXXXXX\n"
                                   "...............\n"))
                    .empty());
}

// A gap of one row (0.8 m) lets a ball of 0.6 m pass; rows are lower than columns are wide.
TEST(Lint, ABallPassesAGapOfOneRow) {
    EXPECT_TRUE(outOfReach(levelOf("XXXXXXXXXXXXXXX\n"
                                   "b.............X\n"
                                   "XXXXXXXXXXXXX.X\n"
                                   "..............X\n"
                                   "XXXXXXXXXXXXXX.\n"
                                   "...............\n"))
                    .size() == 1); // the last gap is diagonal
    EXPECT_TRUE(outOfReach(levelOf("XXXXXXXXXXXXXXX\n"
                                   "b.............X\n"
                                   "XXXXXXXXXXXXX.X\n"
                                   "...............\n"
                                   "XXXXXXXXXXXXXX.\n"
                                   "...............\n"))
                    .empty());
}

// No ball can hit these blocks. Their mounts give way one by one, so the level ends in time. The
// skilled bot does not wait for that and pulls them off.
TEST(Lint, TheTimeBoundsHoldIfNoBlockCanBeHit) {
    const Level level = levelOf("XXXXXXXXXXXXXXX\n"
                                "XgXgXgXgXgXgXgX\n"
                                "XXXXXXXXXXXXXXX\n");
    for (const BotKind kind : {BotKind::Good, BotKind::Lazy, BotKind::Random}) {
        const BotRun run = runBot(level, 1, 2 * kFailTicks + 100 * kFailEvery, kind);
        const LintReport report = lint(level, {.seeds = 1, .mostTicks = 1});
        EXPECT_EQ(run.result, Result::Won);
        EXPECT_LE(run.longestWait, kind == BotKind::Good ? kShakeTicks : report.waitBound);
        if (kind == BotKind::Good) {
            continue;
        }
        EXPECT_LE(run.ticks, report.clearBound + 1); // the first tick serves
        EXPECT_GE(run.ticks, kFailTicks + 6 * kFailEvery) << "they did not wait for the clock";
    }
}

TEST(Lint, WarnsOfCharactersThatTheTypefaceLacks) {
    Level level = levelOf(kOpen);
    level.title =
        "Gr\u00fc\u00dfe, \u0391\u03b8\u03ae\u03bd\u03b1, \u041c\u043e\u0441\u043a\u0432\u0430";
    EXPECT_TRUE(lint(level, {.seeds = 0}).warnings.empty());
    level.title = "\u5854 and \u5854";
    level.idea = "\u4e00\u4e8c\u4e09\u56db\U0001f9f1";
    const LintReport report = lint(level, {.seeds = 0});
    ASSERT_EQ(report.warnings.size(), 2u);
    EXPECT_EQ(report.warnings[0], "title has characters that the typeface lacks: U+5854");
    EXPECT_EQ(report.warnings[1],
              "idea has characters that the typeface lacks: U+4E00, U+4E8C, U+4E09 and 2 more");
    EXPECT_TRUE(report.passed());
}

TEST(Lint, ALevelThatTheBotCannotFinishInTimeFails) {
    const LintReport report = lint(levelOf(kOpen), {.seeds = 2, .mostTicks = 10});
    ASSERT_EQ(report.runs.size(), 2u);
    EXPECT_EQ(report.runs[0].result, Result::Playing);
    EXPECT_EQ(report.problems.front(), "the bot's game with seed 1 is not won after 0 s");
    EXPECT_EQ(report.problems.size(), 2u);
}

// A second set of seeds is other games; the same set is the same games.
TEST(Lint, TheFirstSeedChoosesTheGames) {
    const Level level = levelOf("bbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\n", 15000);
    const auto scoresFrom = [&](const LintOptions& options) {
        std::vector<std::pair<std::uint32_t, std::int32_t>> scores; // by seed
        for (const BotRun& run : lint(level, options).runs) {
            scores.emplace_back(run.seed, run.score);
        }
        return scores;
    };
    const auto first = scoresFrom({.seeds = 4, .mostTicks = 1200});
    EXPECT_EQ(scoresFrom({.seeds = 4, .firstSeed = 1, .mostTicks = 1200}), first);
    const auto later = scoresFrom({.seeds = 2, .firstSeed = 3, .mostTicks = 1200});
    EXPECT_EQ(scoresFrom({.seeds = 2, .firstSeed = 3, .mostTicks = 1200}), later);
    ASSERT_EQ(first.size(), 4u);
    ASSERT_EQ(later.size(), 2u);
    EXPECT_EQ(later[0], first[2]);
    EXPECT_EQ(later[1], first[3]);
    EXPECT_EQ(later[0].first, 3u);
    EXPECT_NE(later[0].second, first[0].second);
}

/// A block on a ledge with `more` tables.
Level oneOnALedge(const std::string& more) {
    return levelFrom("format = 1\ntitle = \"t\"\nidea = \"i\"\n[legend.b]\nstuff = \"brick\"\n"
                     "hold = \"standing\"\n[legend.w]\nstuff = \"wood\"\nhold = \"standing\"\n"
                     "[[ledge]]\nx = 0\ny = 7800\nwidth = 4000\n[[block]]\nkind = \"b\"\n"
                     "shape = \"square\"\nx = 0\ny = 8400\n" +
                     more);
}

TEST(Lint, RefusesABuildingThatNoBallCanReach) {
    const std::string sides = "[[ledge]]\nx = 2000\ny = 9000\nwidth = 400\nheight = 2800\n"
                              "mirror = true\n";
    EXPECT_TRUE(lint(oneOnALedge(sides), {.seeds = 0}).passed()) << "open above";
    const LintReport shut =
        lint(oneOnALedge(sides + "[[ledge]]\nx = 0\ny = 10400\nwidth = 4000\n"), {.seeds = 0});
    ASSERT_EQ(shut.problems.size(), 1u);
    EXPECT_EQ(shut.problems[0], "no ball can come to a block of the building");
}

TEST(Lint, RefusesAWayThatCanNeverBeMet) {
    const auto way = [](const std::string& strikes) {
        return "[[way]]\nname = \"x\"\nstrikes = \"" + strikes + "\"\n";
    };
    EXPECT_TRUE(lint(oneOnALedge(way("wb")), {.seeds = 0}).passed());
    const LintReport report = lint(oneOnALedge(way("w")), {.seeds = 0});
    ASSERT_EQ(report.problems.size(), 1u);
    EXPECT_EQ(report.problems[0], "the way \"x\" can never be met: there is no block of w");
}

TEST(Lint, NamesTheBlockThatMovesWhenNobodyPlays) {
    const std::string head = "format = 1\ntitle = \"t\"\nidea = \"i\"\n[legend.b]\n"
                             "stuff = \"brick\"\nhold = \"standing\"\n[[ledge]]\nx = 0\n"
                             "y = 7800\nwidth = 2000\n";
    const auto block = [](const char* x, const char* y) {
        return std::string("[[block]]\nkind = \"b\"\nshape = \"square\"\nx = ") + x + "\ny = " + y +
               "\n";
    };
    const Level stands = levelFrom(head + block("0", "8400"));
    EXPECT_TRUE(lint(stands, {.seeds = 0}).passed());
    const Level leans = levelFrom(head + block("0", "8400") + block("1200", "8400"));
    const LintReport report = lint(leans, {.seeds = 0});
    ASSERT_EQ(report.problems.size(), 1u);
    EXPECT_EQ(report.problems[0].find("untouched, the block of brick at x = 1200, y = 8400 moves"),
              0u)
        << report.problems[0];
}

} // namespace
