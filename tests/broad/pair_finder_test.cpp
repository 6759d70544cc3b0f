// SPDX-License-Identifier: MIT
#include <kodo/broad/pair_finder.hpp>

#include <broad/bounds_scenes.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace kodo {
namespace {

using namespace bounds_scenes;

/// Some of a scene, at random.
struct SomeMoved {
    std::vector<std::uint32_t> list;
    std::vector<std::uint8_t> flags;

    SomeMoved(support::RandomNumbers& random, std::size_t count) : flags(count, 0) {
        for (std::uint32_t i = 0; i < count; ++i) {
            if (random.below(4) == 0) {
                list.push_back(i);
                flags[i] = 1;
            }
        }
    }
    operator Moved() const { return {list, flags}; }
    std::vector<BoundsPair> of(const std::vector<BoundsPair>& all) const {
        std::vector<BoundsPair> some;
        for (const BoundsPair pair : all) {
            if (flags[pair.first] + flags[pair.second] > 0) {
                some.push_back(pair);
            }
        }
        return some;
    }
};

/// Sizes over four powers of ten, with a ground, an endless plane and an escaped body.
std::vector<Aabb> mixedScene(support::RandomNumbers& random, std::size_t count) {
    std::vector<Aabb> bounds = randomScene(random, count);
    for (std::size_t i = 0; i < bounds.size(); i += 5) {
        const Real size = std::pow(Real(10), random.between(-2, 2));
        bounds[i].upper = bounds[i].lower + Vec2{size, size};
    }
    bounds.push_back(boxAt(-500, -1, 1000, 1));
    bounds.push_back({{Real(-1e9), Real(-1e9)}, {Real(1e9), -5}});
    bounds.push_back(boxAt(Real(1e6), Real(-1e6)));
    return bounds;
}

template <typename Finder>
void findPairs(Finder& finder, std::span<const Aabb> bounds, const Moved& moved,
               std::vector<BoundsPair>& pairs) {
    if constexpr (std::is_same_v<Finder, SortAndSweep>) {
        finder.pairs(bounds, moved, acceptAll, pairs);
    } else {
        Crew alone;
        finder.pairs(bounds, moved, acceptAll, pairs, alone);
    }
}

template <typename Finder>
void expectWhatBruteForceFinds(std::uint64_t seed) {
    support::RandomNumbers random(seed);
    Finder finder;
    std::size_t found = 0;
    for (int scene = 0; scene < 200; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<Aabb> bounds = mixedScene(random, random.below(150));
        for (int frame = 0; frame < 4; ++frame) {
            const SomeMoved moved(random, bounds.size());
            std::vector<BoundsPair> pairs;
            findPairs(finder, bounds, moved, pairs);
            if constexpr (!std::is_same_v<Finder, PairFinder>) {
                PairSorter().sort(pairs, bounds.size());
            }
            ASSERT_EQ(pairs, moved.of(byBruteForce(bounds)));
            found += pairs.size();
            for (Aabb& box : bounds) {
                box = kodo::moved(box, random.point(0.5));
            }
        }
    }
    EXPECT_GT(found, 1000u);
}

// O2: whichever way, the same pairs; from PairFinder in order.
TEST(Grid, FindsWhatBruteForceFinds) {
    expectWhatBruteForceFinds<Grid>(61);
}
TEST(SortAndSweep, FindsThePairsOfWhatMoved) {
    expectWhatBruteForceFinds<SortAndSweep>(62);
}
TEST(PairFinder, FindsWhatBruteForceFinds) {
    expectWhatBruteForceFinds<PairFinder>(63);
}

std::vector<Aabb> square(int side) {
    std::vector<Aabb> bounds;
    for (int i = 0; i < side * side; ++i) {
        bounds.push_back(boxAt(static_cast<Real>(i % side), static_cast<Real>(i / side), Real(0.99),
                               Real(0.99)));
    }
    return bounds;
}

std::size_t gridTests(const std::vector<Aabb>& bounds) {
    Grid grid;
    std::vector<BoundsPair> pairs;
    findPairs(grid, bounds, AllMoved(bounds.size()), pairs);
    return grid.testCount();
}

// A cell is as large as a box, so a box with half a cell around it reaches 3 x 3 of them: 9 tests
// each, whatever the number.
TEST(Grid, TestsAsManyForEachInALargeSceneAsInASmallOne) {
    EXPECT_LE(gridTests(square(20)), 9u * 400u);
    EXPECT_LE(gridTests(square(100)), 9u * 10000u);
}

// One body that left for a million metres must not spread the cells so wide that all the others
// share one.
TEST(Grid, AnEscapedBodyCostsNothing) {
    std::vector<Aabb> bounds = square(50);
    const std::size_t before = gridTests(bounds);
    bounds.push_back(boxAt(Real(1e6), Real(-3e5)));
    EXPECT_LE(gridTests(bounds), before + before / 4);
}

PairFinder::Way wayAfter(const std::vector<Aabb>& bounds, int calls) {
    PairFinder finder;
    for (int i = 0; i < calls; ++i) {
        std::vector<BoundsPair> pairs;
        findPairs(finder, bounds, AllMoved(bounds.size()), pairs);
    }
    return finder.way(bounds.size());
}

// O2: few: brute force. A flat row, where sweeping tests nothing: sort and sweep. A pile, where it
// tests whole columns: the grid.
TEST(PairFinder, TakesTheCheapestWay) {
    std::vector<Aabb> row;
    for (int i = 0; i < 500; ++i) {
        row.push_back(boxAt(static_cast<Real>(2 * i), 0));
    }
    EXPECT_EQ(wayAfter(square(5), 200), PairFinder::Way::BruteForce);
    EXPECT_EQ(wayAfter(row, 200), PairFinder::Way::SortAndSweep);
    EXPECT_EQ(wayAfter(square(40), 200), PairFinder::Way::Grid);
}

} // namespace
} // namespace kodo
