// SPDX-License-Identifier: MIT
#include <kodo/base/disorder.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace kodo {
namespace {

/// Steps until a list of that length is put in order, if so many come in each; none comes of it in
/// `patience` steps: that many.
int stepsUntilDue(std::size_t size, std::size_t coming, int patience) {
    Disorder disorder;
    for (int step = 1; step < patience; ++step) {
        disorder.strayed += coming;
        if (disorder.countStep(size)) {
            return step;
        }
    }
    return patience;
}

// What n steps with one more stray in each have cost is n (n + 1) / 2, as long as not all stray.
TEST(Disorder, IsDueWhenItHasCostAsMuchAsOrder) {
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
        EXPECT_GE(costOf(steps), Disorder::kSteps * kSize);
        EXPECT_LT(costOf(steps - 1), Disorder::kSteps * kSize);
    }
}

// However much comes in each step, all of the list cannot be strayed more than once.
TEST(Disorder, IsNotDueMoreOftenThanThat) {
    EXPECT_EQ(stepsUntilDue(10000, 1000000, 1000), static_cast<int>(Disorder::kSteps));
}

TEST(Disorder, IsNeverDueWhereNothingCame) {
    EXPECT_EQ(stepsUntilDue(100000, 0, 100000), 100000);
}

TEST(Disorder, IsNeverDueInAShortList) {
    EXPECT_EQ(stepsUntilDue(Disorder::kMany - 1, Disorder::kMany, 1000), 1000);
    EXPECT_LT(stepsUntilDue(Disorder::kMany, Disorder::kMany, 1000), 1000);
}

// Whatever comes once costs in each step from then on.
TEST(Disorder, OfWhatCameOnceIsDueInTheEnd) {
    Disorder disorder;
    disorder.strayed = 1;
    std::uint64_t steps = 1;
    while (!disorder.countStep(Disorder::kMany)) {
        ++steps;
    }
    EXPECT_EQ(steps, Disorder::kSteps * Disorder::kMany);
}

} // namespace
} // namespace kodo
