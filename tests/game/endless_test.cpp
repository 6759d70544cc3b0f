// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/endless_building.hpp>
#include <apart/core/game.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/text_file.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace apart;

TEST(Endless, NamesRoundTripThroughText) {
    const EndlessName name{4294967295u, 12};
    EXPECT_EQ(name.text(), "endless:4294967295:12");
    EXPECT_EQ(parseEndless(name.text()), name);
    EXPECT_EQ(parseEndless("endless"), (EndlessName{1, 1}));
    EXPECT_EQ(parseEndless("endless:7"), (EndlessName{7, 1}));
    for (const char* wrong : {"", "endles", "endless:", "endless:x", "endless:1:", "endless:1:0",
                              "endless:1:2:3", "endless:-1:1", "endless:4294967296:1",
                              "endless:1:1000000", "endlessly", "first_light"}) {
        EXPECT_EQ(parseEndless(wrong), std::nullopt) << wrong;
    }
}

TEST(Endless, TheNameDeterminesTheLevel) {
    const Level one = endlessLevel({7, 3});
    EXPECT_EQ(one, endlessLevel({7, 3}));
    EXPECT_EQ(one, std::get<Level>(loadLevel("endless:7:3")));
    EXPECT_EQ(one.name, "endless:7:3");
    EXPECT_NE(digestOf(one), digestOf(endlessLevel({8, 3})));
    EXPECT_NE(digestOf(one), digestOf(endlessLevel({7, 4})));
}

// Digests of the first levels detect differences between machines and accidental changes. Old
// replays of endless levels depend on them.
TEST(Endless, GoldenDigests) {
    std::vector<std::uint64_t> digests;
    for (std::uint32_t number = 1; number <= 12; ++number) {
        digests.push_back(digestOf(endlessLevel({2006, number})));
    }
    std::sort(digests.begin(), digests.end());
    EXPECT_EQ(std::unique(digests.begin(), digests.end()), digests.end()) << "two are alike";
    std::uint64_t all = 0;
    for (const std::uint64_t digest : digests) {
        all = all * 31 + digest;
    }
    EXPECT_EQ(toHex(all), "0e8ab94fc819e679");
}

// Even numbers are walls.
TEST(Endless, EveryBlockOfAWallIsReachableAndThereAreEnough) {
    for (int seed = 0; seed < support::draws(40); ++seed) {
        for (const std::uint32_t number : {2u, 6u, 12u, 26u, 998u}) {
            const Level level = endlessLevel({static_cast<std::uint32_t>(seed), number});
            SCOPED_TRACE(level.name);
            EXPECT_TRUE(outOfReach(level).empty());
            const auto breakable =
                std::count_if(level.cells.begin(), level.cells.end(),
                              [&](const Cell& c) { return level.kinds[c.kind].breakable(); });
            EXPECT_GE(breakable, 20);
            EXPECT_LT(level.cells.back().row, kMostRows);
        }
    }
}

// Later levels have stone and steel instead of glass, and a faster ball.
TEST(Endless, GetsHarder) {
    const auto strengthOf = [](std::uint32_t number) {
        std::int64_t sum = 0;
        std::int64_t blocks = 0;
        for (std::uint32_t seed = 0; seed < 50; ++seed) {
            const Level level = endlessLevel({seed, number});
            for (const Cell& cell : level.cells) {
                sum += level.kinds[cell.kind].strength;
                blocks += level.kinds[cell.kind].breakable() ? 1 : 0;
            }
        }
        return sum / blocks;
    };
    EXPECT_GT(strengthOf(10), strengthOf(2) * 11 / 10);
    EXPECT_GT(strengthOf(26), strengthOf(10) * 11 / 10);
    EXPECT_GT(endlessLevel({1, 20}).ballSpeed, endlessLevel({1, 1}).ballSpeed);
}

// Odd numbers are buildings.
TEST(Endless, BuildingsStandForAMinuteAndFallWhenHit) {
    constexpr std::uint32_t kStands = 60 * kTicksPerSecond;
    for (const std::uint32_t number : {1u, 9u, 25u}) {
        const Level level = endlessLevel({11, number});
        SCOPED_TRACE(level.name);
        ASSERT_GE(level.freeBlocks.size(), 10u) << "a wall: no building was accepted";
        Game game(level, 1);
        const std::vector<Block> blocks(game.blocks().begin(), game.blocks().end());
        while (game.ticks() < kStands) {
            game.tick({});
        }
        for (const Block& block : blocks) {
            ASSERT_TRUE(game.world().contains(block.body));
            const kodo::BodyView body = game.world()[block.body];
            EXPECT_TRUE(body.isAsleep());
            EXPECT_LE(length(body.position() - block.home.position), 0.01);
        }
        EXPECT_TRUE(isSolvable(level));
    }
}

// The ball flies straight from the paddle in the middle, so a ledge above it would bar all serves.
TEST(Endless, TheFirstServeHitsABlock) {
    int levels = 0;
    int buildings = 0;
    for (std::uint32_t seed = 1; seed <= static_cast<std::uint32_t>(support::draws(20)); ++seed) {
        for (std::uint32_t number = 1; number <= 8; ++number) {
            const Level level = endlessLevel({seed, number});
            EXPECT_TRUE(servesHit(level)) << level.name;
            ++levels;
            buildings += level.freeBlocks.empty() ? 0 : 1;
        }
    }
    EXPECT_GE(buildings, levels * 4 / 10) << "too few of the candidates are accepted";
}

TEST(Endless, ALedgeAboveThePaddleIsNotAccepted) {
    Level level = endlessLevel({11, 1});
    ASSERT_TRUE(servesHit(level));
    level.obstructions.push_back(
        {.kind = ObstructionKind::Ledge, .y = 5000, .size = 5200, .heights = {}, .height = 400});
    EXPECT_FALSE(servesHit(level));
}

// Without the check some of the candidates would move, or the bot would not win.
TEST(Endless, ABuildingThatMovesIsNotAccepted) {
    Level level = endlessLevel({11, 1});
    ASSERT_TRUE(stands(level));
    level.freeBlocks.back().y += 500; // its top falls onto it
    EXPECT_FALSE(stands(level));
}

TEST(Endless, TheBotWins) {
    for (const std::uint32_t number : {1u, 8u, 25u}) {
        const LintReport report = lint(endlessLevel({5, number}));
        EXPECT_TRUE(report.passed()) << report.level << ": " << report.problems.front();
    }
}

} // namespace
