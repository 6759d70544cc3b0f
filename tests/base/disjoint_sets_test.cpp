// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "base/disjoint_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

TEST(DisjointSets, ContainOnlyElementsOfMadeSets) {
    DisjointSets sets;
    sets.resize(2);
    EXPECT_FALSE(sets.contains(1));
    sets.makeSet(1);
    EXPECT_TRUE(sets.contains(1));
    EXPECT_EQ(sets.rootOf(1), 1u);
    sets.drop(1);
    sets.resize(3);
    EXPECT_FALSE(sets.contains(1));
    EXPECT_FALSE(sets.contains(2));
}

TEST(DisjointSets, JoinReturnsBothFormerRoots) {
    DisjointSets sets;
    sets.resize(4);
    for (std::uint32_t i = 0; i < 4; ++i) {
        sets.makeSet(i);
    }
    sets.join(3, 2);
    const auto [root, other] = sets.join(3, 1);
    EXPECT_EQ(root, 1u);
    EXPECT_EQ(other, 2u);
    const auto [again, same] = sets.join(2, 3);
    EXPECT_EQ(again, 1u);
    EXPECT_EQ(same, 1u);
    EXPECT_EQ(sets.rootOf(0), 0u);
}

// After random joins, two elements have the same root exactly if they are connected. The root is
// the lowest connected index. The oracle spreads labels over all indices.
TEST(DisjointSets, HaveTheirLowestIndexAsRoot) {
    constexpr std::uint32_t kCount = 60;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        support::RandomNumbers random(seed);
        DisjointSets sets;
        sets.resize(kCount);
        std::vector<std::uint32_t> label;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            sets.makeSet(i);
            label.push_back(i);
        }
        for (int k = 0; k < 40; ++k) {
            const auto a = static_cast<std::uint32_t>(random.below(kCount));
            const auto b = static_cast<std::uint32_t>(random.below(kCount));
            sets.join(a, b);
            const std::uint32_t least = std::min(label[a], label[b]);
            const std::uint32_t most = std::max(label[a], label[b]);
            std::replace(label.begin(), label.end(), most, least);
        }
        for (std::uint32_t i = 0; i < kCount; ++i) {
            EXPECT_EQ(sets.rootOf(i), label[i]) << i;
        }
    }
}

} // namespace
} // namespace kodo
