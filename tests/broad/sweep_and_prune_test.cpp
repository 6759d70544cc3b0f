// SPDX-License-Identifier: MIT
#include <broad/bounds_scenes.hpp>
#include <broad/sweep_and_prune.hpp>
#include <gtest/gtest.h>

namespace kodo {
namespace {

using namespace bounds_scenes;

// O1: the same pairs in the same order, with state of the last call and with changing counts.
TEST(SweepAndPrune, AgreesWithBruteForce) {
    support::RandomNumbers random(51);
    SweepAndPrune sweep;
    std::size_t found = 0;
    for (int scene = 0; scene < 300; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<Octagon> bounds = randomScene(random, random.below(120));
        for (int frame = 0; frame < 4; ++frame) {
            ASSERT_EQ(sweep.pairs(bounds), byBruteForce(bounds));
            found += byBruteForce(bounds).size();
            for (Octagon& each : bounds) {
                each = each.moved(random.point(0.5));
            }
        }
    }
    EXPECT_GT(found, 10000u);
}

TEST(SweepAndPrune, FindsTouchingAndEqualBounds) {
    SweepAndPrune sweep;
    const std::vector<Octagon> bounds{boxAt(0, 0), boxAt(1, 1), boxAt(0, 0), boxAt(5, 5, 0, 0)};
    EXPECT_EQ(sweep.pairs(bounds), byBruteForce(bounds));
    EXPECT_EQ(byBruteForce(bounds).size(), 3u);
}

TEST(SweepAndPrune, FindsNoPairAmongFewerThanTwoBounds) {
    SweepAndPrune sweep;
    EXPECT_TRUE(sweep.pairs({}).empty());
    EXPECT_TRUE(sweep.pairs(std::vector{boxAt(0, 0)}).empty());
}

// O2: below the threshold all pairs are tested, with the same result.
TEST(SweepAndPrune, TestsAllPairsUpToTheThreshold) {
    support::RandomNumbers random(52);
    for (const std::size_t count : {std::size_t{20}, std::size_t{21}}) {
        const std::vector<Octagon> bounds = randomScene(random, count);
        SweepAndPrune sweep(20);
        EXPECT_EQ(sweep.pairs(bounds), byBruteForce(bounds));
        EXPECT_EQ(sweep.testCount() == count * (count - 1) / 2, count == 20);
    }
}

// O1: the flat row of ten boxes of the thesis (5.1). Brute force makes 45 tests, a sweep along the
// row none, a sweep across it 45.
TEST(SweepAndPrune, NeedsNoTestForAFlatRow) {
    std::vector<Octagon> along;
    std::vector<Octagon> upright;
    for (int i = 0; i < 10; ++i) {
        along.push_back(boxAt(static_cast<Real>(2 * i), 0));
        upright.push_back(boxAt(0, static_cast<Real>(2 * i)));
    }
    SweepAndPrune sweep;
    EXPECT_TRUE(sweep.pairs(along).empty());
    EXPECT_EQ(sweep.testCount(), 0u);
    EXPECT_TRUE(sweep.alongX());
    SweepAndPrune other;
    EXPECT_TRUE(other.pairs(upright).empty());
    EXPECT_EQ(other.testCount(), 0u) << "the axis was not swapped";
    EXPECT_FALSE(other.alongX());
}

/// n boxes on the diagonal of a rectangle of that width and height (m).
std::vector<Octagon> spread(std::size_t n, Real width, Real height) {
    std::vector<Octagon> bounds;
    for (std::size_t i = 0; i < n; ++i) {
        const Real share = static_cast<Real>(i) / static_cast<Real>(n);
        bounds.push_back(boxAt(width * share, height * share, Real(0.1), Real(0.1)));
    }
    return bounds;
}

// O1: when a scene changes from flat to tall, the axis is swapped after at most some calls.
TEST(SweepAndPrune, SwapsTheAxisWhenTheOtherIsBetter) {
    SweepAndPrune sweep;
    std::vector<Octagon> flat;
    std::vector<Octagon> tall;
    for (int i = 0; i < 40; ++i) {
        const Real at = static_cast<Real>(i);
        flat.push_back(boxAt(3 * at, 0));
        tall.push_back(boxAt(0, 3 * at));
    }
    sweep.pairs(flat);
    ASSERT_TRUE(sweep.alongX());
    for (int call = 0; call < 100; ++call) {
        ASSERT_TRUE(sweep.pairs(tall).empty());
    }
    EXPECT_FALSE(sweep.alongX());
    EXPECT_EQ(sweep.testCount(), 0u);
}

// O1, hysteresis: two equal axes are never swapped, whether x or y is in use.
TEST(SweepAndPrune, KeepsTheAxisWhileBothAreEqual) {
    SweepAndPrune sweep;
    const std::vector<Octagon> diagonal = spread(40, 100, 100);
    for (int call = 0; call < 200; ++call) {
        sweep.pairs(diagonal);
        ASSERT_TRUE(sweep.alongX());
    }
    SweepAndPrune tall;
    std::vector<Octagon> column;
    for (int i = 0; i < 40; ++i) {
        column.push_back(boxAt(0, static_cast<Real>(3 * i)));
    }
    tall.pairs(column);
    ASSERT_FALSE(tall.alongX());
    for (int call = 0; call < 200; ++call) {
        tall.pairs(diagonal);
        ASSERT_FALSE(tall.alongX());
    }
}

} // namespace
} // namespace kodo
