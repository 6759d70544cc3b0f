// SPDX-License-Identifier: MIT
#include "broad/pair_finder.hpp"

#include <broad/bounds_scenes.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace kodo {
namespace {

using namespace bounds_scenes;

/// Marks on average one in `ofSoMany` bounds as moved.
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

/// Sizes over four powers of ten, with a ground, a half-plane and an escaped body.
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
    if constexpr (std::is_same_v<Finder, SweepAndPrune>) {
        finder.pairs(bounds, moved, acceptAll, pairs);
    } else {
        WorkerTeam alone;
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

// O2: all algorithms find the same pairs. PairFinder reports them in order.
TEST(Grid, AgreesWithBruteForce) {
    expectWhatBruteForceFinds<Grid>(61);
}
TEST(SweepAndPrune, FindsThePairsOfMovedBounds) {
    expectWhatBruteForceFinds<SweepAndPrune>(62);
}
TEST(PairFinder, AgreesWithBruteForce) {
    expectWhatBruteForceFinds<PairFinder>(63);
}

// State that an algorithm keeps between calls must not be outdated after calls of another one.
TEST(PairFinder, FindsTheSamePairsAfterAnySwitchOfAlgorithm) {
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

// A cell is as large as a box. A box with half a cell around it reaches 3 x 3 cells: 9 tests per
// box for any number of boxes.
TEST(Grid, TestsPerBoxDoNotGrowWithTheScene) {
    EXPECT_LE(gridTests(square(20)), 9u * 400u);
    EXPECT_LE(gridTests(square(100)), 9u * 10000u);
}

// Slightly larger boxes share the cells of the others. Their neighbours are searched only within
// their own extent: on average 3.6 x 3.6 cells with one box each.
TEST(Grid, LargerBoxesCostLittle) {
    std::vector<Octagon> bounds = square(100);
    for (std::size_t i = 0; i < bounds.size(); i += 5) {
        const auto [x, y] = bounds[i].box().lower;
        bounds[i] = boxAt(x, y, Real(1.5), Real(1.5));
    }
    EXPECT_LE(gridTests(bounds), 16u * bounds.size());
}

// One body a million metres away must not enlarge the cells so much that all others share one.
TEST(Grid, AnEscapedBodyCostsLittle) {
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
    return finder.algorithm();
}

// O2: brute force for few bounds or few moved ones. Sweep and prune for a flat row, which it sorts
// without overlap tests. The grid for a pile, where sweep and prune tests whole columns.
TEST(PairFinder, ChoosesTheCheapestAlgorithm) {
    std::vector<Octagon> row;
    for (int i = 0; i < 500; ++i) {
        row.push_back(boxAt(static_cast<Real>(2 * i), 0));
    }
    const std::vector<Octagon> pile = square(40);
    EXPECT_EQ(wayAfter(square(5), AllMoved(25), 200), PairSearch::BruteForce);
    EXPECT_EQ(wayAfter(row, AllMoved(500), 200), PairSearch::SweepAndPrune);
    EXPECT_EQ(wayAfter(pile, AllMoved(1600), 200), PairSearch::Grid);
    const std::vector<std::uint32_t> one{7};
    std::vector<std::uint8_t> flags(pile.size(), 0);
    flags[7] = 1;
    EXPECT_EQ(wayAfter(pile, {one, flags}, 200), PairSearch::BruteForce);
}

// A row collapses into a pile, and the pile is spread into a row.
TEST(PairFinder, FollowsAChangingScene) {
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
        return finder.algorithm();
    };
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(wayIn(row), PairSearch::SweepAndPrune);
        EXPECT_EQ(wayIn(square(40)), PairSearch::Grid);
    }
}

// Trials of the two other algorithms may cost 1/16 of the work since their last trials. The first
// trials cost half as much again, since their cost is estimated.
TEST(PairFinder, TrialsOfOtherAlgorithmsCostLittle) {
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
    EXPECT_EQ(chosen.algorithm(), PairSearch::Grid);
    EXPECT_GT(chosen.work(), grid.work());
    EXPECT_LT(static_cast<double>(chosen.work()), 1.1 * static_cast<double>(grid.work()));
}

TEST(PairFinder, KeepsAFixedAlgorithm) {
    const std::vector<Octagon> pile = square(10);
    for (const PairSearch way :
         {PairSearch::BruteForce, PairSearch::Grid, PairSearch::SweepAndPrune}) {
        PairFinder finder;
        finder.use(way);
        std::vector<BoundsPair> pairs;
        for (int i = 0; i < 100; ++i) {
            pairs.clear();
            findPairs(finder, pile, AllMoved(pile.size()), pairs);
            ASSERT_EQ(finder.algorithm(), way);
        }
        EXPECT_EQ(pairs, byBruteForce(pile));
    }
}

} // namespace
} // namespace kodo
