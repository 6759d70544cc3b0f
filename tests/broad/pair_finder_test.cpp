// SPDX-License-Identifier: MIT
#include <kodo/broad/pair_finder.hpp>

#include <broad/bounds_scenes.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace kodo {
namespace {

using namespace bounds_scenes;

/// One of so many of a scene, at random.
struct SomeMoved {
    std::vector<std::uint32_t> list;
    std::vector<std::uint8_t> flags;

    SomeMoved(support::RandomNumbers& random, std::size_t count, std::size_t ofSoMany)
        : flags(count, 0) {
        for (std::uint32_t i = 0; i < count; ++i) {
            if (random.below(ofSoMany) == 0) {
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
std::vector<Octagon> mixedScene(support::RandomNumbers& random, std::size_t count) {
    std::vector<Octagon> bounds = randomScene(random, count);
    for (std::size_t i = 0; i < bounds.size(); i += 5) {
        const Real size = std::pow(Real(10), random.between(-2, 2));
        const auto [x, y] = bounds[i].box().lower;
        bounds[i] = boxAt(x, y, size, size);
    }
    bounds.push_back(boxAt(-500, -1, 1000, 1));
    bounds.push_back(Octagon::of(Aabb{{Real(-1e9), Real(-1e9)}, {Real(1e9), -5}}));
    bounds.push_back(boxAt(Real(1e6), Real(-1e6)));
    return bounds;
}

template <typename Finder>
void findPairs(Finder& finder, std::span<const Octagon> bounds, const Moved& moved,
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
        std::vector<Octagon> bounds = mixedScene(random, random.below(150));
        for (int frame = 0; frame < 4; ++frame) {
            const SomeMoved moved(random, bounds.size(),
                                  frame == 0 ? 1 : 4); // all are new at first
            for (const std::uint32_t i : moved.list) {
                bounds[i] = bounds[i].moved(random.point(0.5));
            }
            std::vector<BoundsPair> pairs;
            findPairs(finder, bounds, moved, pairs);
            if constexpr (!std::is_same_v<Finder, PairFinder>) {
                PairSorter().sort(pairs, bounds.size());
            }
            ASSERT_EQ(pairs, moved.of(byBruteForce(bounds)));
            found += pairs.size();
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

// What one way keeps from call to call must not be out of date when another had its turn.
TEST(PairFinder, FindsTheSameWhicheverHasItsTurn) {
    support::RandomNumbers random(64);
    std::vector<Octagon> bounds = mixedScene(random, 100);
    PairFinder finder;
    for (int frame = 0; frame < 100; ++frame) {
        SCOPED_TRACE(frame);
        const SomeMoved moved(random, bounds.size(), frame == 0 ? 1 : 4);
        for (const std::uint32_t i : moved.list) {
            bounds[i] = bounds[i].moved(random.point(0.5));
        }
        finder.use(static_cast<PairSearch>(random.below(3)));
        std::vector<BoundsPair> pairs;
        findPairs(finder, bounds, moved, pairs);
        ASSERT_EQ(pairs, moved.of(byBruteForce(bounds)));
    }
}

std::vector<Octagon> square(int side) {
    std::vector<Octagon> bounds;
    for (int i = 0; i < side * side; ++i) {
        bounds.push_back(boxAt(static_cast<Real>(i % side), static_cast<Real>(i / side), Real(0.99),
                               Real(0.99)));
    }
    return bounds;
}

std::size_t gridTests(const std::vector<Octagon>& bounds) {
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

// What is a little larger than most shares their cells, and its neighbours are looked for no
// farther than it reaches: 3.6 x 3.6 cells in the mean, with one each.
TEST(Grid, ThoseThatAreLargerThanMostCostLittle) {
    std::vector<Octagon> bounds = square(100);
    for (std::size_t i = 0; i < bounds.size(); i += 5) {
        const auto [x, y] = bounds[i].box().lower;
        bounds[i] = boxAt(x, y, Real(1.5), Real(1.5));
    }
    EXPECT_LE(gridTests(bounds), 16u * bounds.size());
}

// One body that left for a million metres must not spread the cells so wide that all the others
// share one.
TEST(Grid, AnEscapedBodyCostsNothing) {
    std::vector<Octagon> bounds = square(50);
    const std::size_t before = gridTests(bounds);
    bounds.push_back(boxAt(Real(1e6), Real(-3e5)));
    EXPECT_LE(gridTests(bounds), before + before / 4);
}

PairSearch wayAfter(const std::vector<Octagon>& bounds, const Moved& moved, int calls) {
    PairFinder finder;
    for (int i = 0; i < calls; ++i) {
        std::vector<BoundsPair> pairs;
        findPairs(finder, bounds, moved, pairs);
    }
    return finder.way();
}

// O2: few, or few that have moved: brute force. A flat row, where sweeping tests nothing: sort and
// sweep. A pile, where it tests whole columns: the grid.
TEST(PairFinder, TakesTheCheapestWay) {
    std::vector<Octagon> row;
    for (int i = 0; i < 500; ++i) {
        row.push_back(boxAt(static_cast<Real>(2 * i), 0));
    }
    const std::vector<Octagon> pile = square(40);
    EXPECT_EQ(wayAfter(square(5), AllMoved(25), 200), PairSearch::BruteForce);
    EXPECT_EQ(wayAfter(row, AllMoved(500), 200), PairSearch::SortAndSweep);
    EXPECT_EQ(wayAfter(pile, AllMoved(1600), 200), PairSearch::Grid);
    const std::vector<std::uint32_t> one{7};
    std::vector<std::uint8_t> flags(pile.size(), 0);
    flags[7] = 1;
    EXPECT_EQ(wayAfter(pile, {one, flags}, 200), PairSearch::BruteForce);
}

// A row that falls together into a pile, and a pile that is drawn out into a row.
TEST(PairFinder, FollowsTheScene) {
    std::vector<Octagon> row;
    for (int i = 0; i < 1600; ++i) {
        row.push_back(boxAt(static_cast<Real>(2 * i), 0));
    }
    const AllMoved moved(row.size());
    PairFinder finder;
    const auto wayIn = [&](const std::vector<Octagon>& bounds) {
        for (int i = 0; i < 600; ++i) {
            std::vector<BoundsPair> pairs;
            findPairs(finder, bounds, moved, pairs);
        }
        return finder.way();
    };
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(wayIn(row), PairSearch::SortAndSweep);
        EXPECT_EQ(wayIn(square(40)), PairSearch::Grid);
    }
}

// A turn of the idle one is paid from what has been spent since its last: 1/16 for the two of them,
// and a half more for the first, which are guesses.
TEST(PairFinder, TurnsOfTheIdleCostLittle) {
    const std::vector<Octagon> pile = square(60);
    const AllMoved moved(pile.size());
    PairFinder chosen;
    PairFinder grid;
    grid.use(PairSearch::Grid);
    for (int i = 0; i < 500; ++i) {
        for (PairFinder* finder : {&chosen, &grid}) {
            std::vector<BoundsPair> pairs;
            findPairs(*finder, pile, moved, pairs);
        }
    }
    EXPECT_EQ(chosen.way(), PairSearch::Grid);
    EXPECT_GT(chosen.work(), grid.work());
    EXPECT_LT(static_cast<double>(chosen.work()), 1.1 * static_cast<double>(grid.work()));
}

TEST(PairFinder, KeepsToTheWayItIsTold) {
    const std::vector<Octagon> pile = square(10);
    for (const PairSearch way :
         {PairSearch::BruteForce, PairSearch::Grid, PairSearch::SortAndSweep}) {
        PairFinder finder;
        finder.use(way);
        std::vector<BoundsPair> pairs;
        for (int i = 0; i < 100; ++i) {
            pairs.clear();
            findPairs(finder, pile, AllMoved(pile.size()), pairs);
            ASSERT_EQ(finder.way(), way);
        }
        EXPECT_EQ(pairs, byBruteForce(pile));
    }
}

} // namespace
} // namespace kodo
