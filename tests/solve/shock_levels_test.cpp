// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "propagation/shock_levels.hpp"

namespace {

using kodo::ShockLevels;
using kodo::SupportEdge;

constexpr std::uint32_t kUnreached = ShockLevels::kUnreached;
using Indices = std::vector<std::uint32_t>;

Indices levels(std::uint32_t bodies, const Indices& immovable,
               const std::vector<SupportEdge>& edges) {
    ShockLevels shockLevels;
    const std::span<const std::uint32_t> found = shockLevels.find(bodies, immovable, edges);
    return {found.begin(), found.end()};
}

// W5
TEST(ShockLevels, CountAStackFromTheGround) {
    EXPECT_EQ(levels(4, {0}, {{0, 1}, {1, 2}, {2, 3}}), (Indices{0, 1, 2, 3}));
}

TEST(ShockLevels, DoNotDependOnTheOrderOfBodiesOrEdges) {
    EXPECT_EQ(levels(4, {2}, {{3, 1}, {2, 0}, {0, 3}}), (Indices{1, 3, 0, 2}));
}

TEST(ShockLevels, OfSeparateStacksAreIndependent) {
    EXPECT_EQ(levels(6, {0, 3}, {{0, 1}, {1, 2}, {3, 4}, {4, 5}}), (Indices{0, 1, 2, 0, 1, 2}));
}

// A plank on the ground and on a tower comes after the tower.
TEST(ShockLevels, AreOneMoreThanThatOfTheHighestSupport) {
    EXPECT_EQ(levels(4, {0}, {{0, 1}, {1, 2}, {0, 3}, {2, 3}}), (Indices{0, 1, 2, 3}));
}

TEST(ShockLevels, LeaveBodiesWithoutImmovableSupportUnreached) {
    EXPECT_EQ(levels(4, {0}, {{2, 3}, {0, 1}}), (Indices{0, 1, kUnreached, kUnreached}));
}

TEST(ShockLevels, IgnoreABodyThatFallsOnAStack) {
    EXPECT_EQ(levels(3, {0}, {{0, 1}, {2, 1}}), (Indices{0, 1, kUnreached}));
}

TEST(ShockLevels, OfImmovableBodiesAreZero) {
    EXPECT_EQ(levels(3, {0, 2}, {{0, 1}, {1, 2}}), (Indices{0, 1, 0}));
}

TEST(ShockLevels, CountEachPairOfBodiesOnce) {
    EXPECT_EQ(levels(3, {0}, {{0, 1}, {0, 1}, {1, 2}, {1, 2}, {1, 2}}), (Indices{0, 1, 2}));
}

TEST(ShockLevels, AreFiniteInACycleOfSupports) {
    const Indices found = levels(5, {0}, {{0, 1}, {1, 2}, {2, 3}, {3, 1}, {3, 4}});
    EXPECT_EQ(found, (Indices{0, 1, 2, 3, 4}));
}

TEST(ShockLevels, WithoutImmovableBodiesAreUnreached) {
    EXPECT_TRUE(levels(0, {}, {}).empty());
    EXPECT_EQ(levels(2, {}, {{0, 1}}), (Indices{kUnreached, kUnreached}));
}

/// The definition, repeated until nothing changes. Only for graphs without cycles.
Indices slowLevels(std::uint32_t bodies, const Indices& immovable,
                   const std::vector<SupportEdge>& edges) {
    Indices result(bodies, kUnreached);
    for (const std::uint32_t body : immovable) {
        result[body] = 0;
    }
    for (std::uint32_t round = 0; round < bodies; ++round) {
        for (const SupportEdge& edge : edges) {
            const bool ground = result[edge.upper] == 0;
            if (result[edge.lower] != kUnreached && !ground) {
                const std::uint32_t next = result[edge.lower] + 1;
                result[edge.upper] =
                    result[edge.upper] == kUnreached ? next : std::max(result[edge.upper], next);
            }
        }
    }
    return result;
}

TEST(ShockLevels, AgreeWithTheirDefinitionOnRandomPiles) {
    support::RandomNumbers random(5);
    ShockLevels reused; // must keep no state between calls
    for (int trial = 0; trial < 500; ++trial) {
        const auto bodies = static_cast<std::uint32_t>(2 + random.below(30));
        Indices immovable{0};
        if (random.below(2) == 0) {
            immovable.push_back(1);
        }
        std::vector<SupportEdge> edges;
        for (std::size_t i = random.below(80); i > 0; --i) {
            const auto a = static_cast<std::uint32_t>(random.below(bodies));
            const auto b = static_cast<std::uint32_t>(random.below(bodies));
            if (a != b) {
                edges.push_back({std::min(a, b), std::max(a, b)}); // so there is no cycle
            }
        }
        const std::span<const std::uint32_t> found = reused.find(bodies, immovable, edges);
        EXPECT_EQ(Indices(found.begin(), found.end()), slowLevels(bodies, immovable, edges))
            << "trial " << trial;
    }
}

} // namespace
