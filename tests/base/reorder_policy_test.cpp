// SPDX-License-Identifier: MIT
#include "base/reorder_policy.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kodo {
namespace {

/// Steps until sorting a list of `size` elements is due, with `coming` new elements per step;
/// `patience` if it is not due before.
int stepsUntilDue(std::size_t size, std::size_t coming, int patience) {
    ReorderPolicy reorderPolicy;
    for (int step = 1; step < patience; ++step) {
        reorderPolicy.strayed += coming;
        if (reorderPolicy.countStep(size)) {
            return step;
        }
    }
    return patience;
}

// With one more stray element per step, the cost of n steps is n (n + 1) / 2, as long as not all
// elements stray.
TEST(ReorderPolicy, IsDueWhenLossesReachTheCostOfSorting) {
    constexpr std::size_t kSize = 10000;
    for (const std::size_t coming : {1u, 10u, 1000u, 10000u}) {
        const auto steps = static_cast<std::size_t>(stepsUntilDue(kSize, coming, 100000));
        const auto costOf = [&](std::size_t n) {
            std::size_t cost = 0;
            for (std::size_t step = 1; step <= n; ++step) {
                cost += std::min(coming * step, kSize);
            }
            return cost;
        };
        EXPECT_GE(costOf(steps), ReorderPolicy::kSteps * kSize);
        EXPECT_LT(costOf(steps - 1), ReorderPolicy::kSteps * kSize);
    }
}

// However many elements arrive per step, at most the whole list is out of order.
TEST(ReorderPolicy, IsNotDueBeforeTheMinimumNumberOfSteps) {
    EXPECT_EQ(stepsUntilDue(10000, 1000000, 1000), static_cast<int>(ReorderPolicy::kSteps));
}

TEST(ReorderPolicy, IsNeverDueWithoutNewElements) {
    EXPECT_EQ(stepsUntilDue(100000, 0, 100000), 100000);
}

TEST(ReorderPolicy, IsNeverDueForAShortList) {
    EXPECT_EQ(stepsUntilDue(ReorderPolicy::kMany - 1, ReorderPolicy::kMany, 1000), 1000);
    EXPECT_LT(stepsUntilDue(ReorderPolicy::kMany, ReorderPolicy::kMany, 1000), 1000);
}

// A single stray element costs time in every later step.
TEST(ReorderPolicy, IsEventuallyDueForASingleStrayElement) {
    ReorderPolicy reorderPolicy;
    reorderPolicy.strayed = 1;
    std::uint64_t steps = 1;
    while (!reorderPolicy.countStep(ReorderPolicy::kMany)) {
        ++steps;
    }
    EXPECT_EQ(steps, ReorderPolicy::kSteps * ReorderPolicy::kMany);
}

} // namespace
} // namespace kodo
