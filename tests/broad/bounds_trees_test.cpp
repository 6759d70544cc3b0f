// SPDX-License-Identifier: MIT
#include "broad/bounds_trees.hpp"

#include <broad/bounds_scenes.hpp>
#include <broad/sweep_and_prune.hpp>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace kodo {
namespace {

using support::RandomNumbers;

constexpr std::array kAllRests{Rest::Static, Rest::Asleep, Rest::Moving};

Aabb randomBox(RandomNumbers& random, double spread) {
    const Vec2 at = random.point(spread);
    return {at, at + Vec2{random.between(0, 2), random.between(0, 2)}};
}

std::set<std::uint32_t> found(const BoundsTrees& trees, const Aabb& box) {
    std::set<std::uint32_t> leaves;
    trees.overlaps(box, [&](std::uint32_t leaf) { EXPECT_TRUE(leaves.insert(leaf).second); });
    std::set<std::uint32_t> entered;
    trees.search([&](const Aabb& node) { return overlap(node, box) ? 0 : BoundsTrees::kMissed; },
                 [&](std::uint32_t leaf) { EXPECT_TRUE(entered.insert(leaf).second); });
    EXPECT_EQ(leaves, entered);
    return leaves;
}

/// Boxes with their rest and mark, compared one by one.
struct Model {
    struct Leaf {
        Aabb box;
        Rest rest;
        bool marked = true;
    };
    std::map<std::uint32_t, Leaf> leaves;

    std::uint32_t any(RandomNumbers& random) const {
        const auto from = leaves.lower_bound(static_cast<std::uint32_t>(random.below(3000)));
        return from == leaves.end() ? leaves.begin()->first : from->first;
    }
    std::set<std::uint32_t> found(const Aabb& box) const {
        std::set<std::uint32_t> hits;
        for (const auto& [number, leaf] : leaves) {
            if (overlap(leaf.box, box)) {
                hits.insert(number);
            }
        }
        return hits;
    }
    using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;
    Pairs pairs(bool anyRest) const {
        Pairs pairs;
        for (auto a = leaves.begin(); a != leaves.end(); ++a) {
            for (auto b = std::next(a); b != leaves.end(); ++b) {
                const auto either = [&](Rest rest) {
                    return a->second.rest == rest || b->second.rest == rest;
                };
                if ((a->second.marked || b->second.marked) &&
                    overlap(a->second.box, b->second.box) &&
                    (either(Rest::Moving) || (anyRest && either(Rest::Asleep)))) {
                    pairs.insert({a->first, b->first});
                }
            }
        }
        return pairs;
    }
};

Model::Pairs pairsOf(BoundsTrees& trees, bool anyRest) {
    std::vector<BoundsTrees::NodePair> nodes;
    trees.findNodePairs(anyRest, nodes);
    Model::Pairs pairs;
    for (const BoundsTrees::NodePair& each : nodes) {
        trees.forPairs(each, [&](std::uint32_t i, std::uint32_t j) {
            EXPECT_TRUE(pairs.insert(std::minmax(i, j)).second);
        });
    }
    trees.clearMarks();
    return pairs;
}

void change(BoundsTrees& trees, Model& model, RandomNumbers& random, std::uint32_t& next) {
    const auto rest = [&] { return kAllRests[random.below(kRests)]; };
    switch (model.leaves.empty() ? 0 : random.below(9)) {
    case 0:
    case 1:
    case 2: {
        const Model::Leaf leaf{randomBox(random, 20), rest()};
        model.leaves[next] = leaf;
        trees.set(next++, leaf.rest, leaf.box);
        break;
    }
    case 3:
    case 4: { // moves; sometimes far, or into another tree
        const std::uint32_t moved = model.any(random);
        Model::Leaf& leaf = model.leaves[moved];
        const Vec2 by = random.point(random.below(4) == 0 ? 30 : 1);
        const Rest to = random.below(4) == 0 ? rest() : leaf.rest;
        leaf = {{leaf.box.lower + by, leaf.box.upper + by}, to};
        trees.set(moved, to, leaf.box);
        break;
    }
    case 5: {
        if (random.below(40) > 0) {
            break;
        }
        std::vector<BoundsTrees::Leaf> leaves;
        const Rest of = rest();
        for (std::uint64_t i = random.below(200); i > 0; --i) {
            leaves.push_back({randomBox(random, 20), next});
            model.leaves[next++] = {leaves.back().box, of};
        }
        trees.add(of, leaves);
        break;
    }
    default: {
        const std::uint32_t gone = model.any(random);
        ASSERT_EQ(trees.boxOf(gone), model.leaves[gone].box);
        ASSERT_EQ(trees.restOf(gone), model.leaves[gone].rest);
        trees.remove(gone);
        trees.remove(gone); // ignored
        model.leaves.erase(gone);
    }
    }
}

// A map of boxes is the model, over random additions, moves between trees and removals.
TEST(BoundsTrees, FindWhatAModelFinds) {
    std::size_t pairs = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        RandomNumbers random(seed);
        BoundsTrees trees;
        Model model;
        std::uint32_t next = 0;
        for (int i = 0; i < 2000; ++i) {
            change(trees, model, random, next);
            if (i % 20 == 0) {
                const Aabb box = randomBox(random, 20);
                ASSERT_EQ(found(trees, box), model.found(box));
            }
            if (i % 50 == 0) {
                const bool anyRest = random.below(2) == 0;
                const Model::Pairs expected = model.pairs(anyRest);
                pairs += expected.size();
                ASSERT_EQ(pairsOf(trees, anyRest), expected);
                for (auto& [number, leaf] : model.leaves) {
                    leaf.marked = false;
                }
            }
        }
        for (const auto& [number, leaf] : model.leaves) {
            trees.remove(number);
        }
        EXPECT_TRUE(found(trees, {{-100, -100}, {100, 100}}).empty());
        for (const Rest rest : kAllRests) {
            EXPECT_EQ(trees.size(rest), 0u);
            EXPECT_EQ(trees.height(rest), 0u);
        }
    }
    EXPECT_GT(pairs, 10000u);
}

// O1: the search of the thesis is the witness, over scenes in which some or all bounds move.
TEST(BoundsTrees, FindThePairsOfSortAndSweep) {
    RandomNumbers random(51);
    std::size_t count = 0;
    for (int scene = 0; scene < 100; ++scene) {
        SCOPED_TRACE(scene);
        std::vector<Octagon> bounds = bounds_scenes::randomScene(random, 1 + random.below(200));
        const std::uint64_t still = random.below(3); // of three
        BoundsTrees trees;
        SweepAndPrune witness;
        std::vector<std::uint8_t> moved(bounds.size(), 1);
        for (int frame = 0; frame < 4; ++frame) {
            for (std::uint32_t i = 0; i < bounds.size(); ++i) {
                if (moved[i] != 0) {
                    trees.set(i, Rest::Moving, bounds[i].box());
                }
            }
            Model::Pairs pairs;
            for (const auto& [i, j] : pairsOf(trees, false)) {
                if (overlap(bounds[i], bounds[j])) {
                    pairs.insert({i, j});
                }
            }
            Model::Pairs expected;
            for (const BoundsPair& pair : witness.pairs(bounds)) {
                if ((moved[pair.first] | moved[pair.second]) != 0) {
                    expected.insert({pair.first, pair.second});
                }
            }
            ASSERT_EQ(pairs, expected);
            count += pairs.size();
            for (std::size_t i = 0; i < bounds.size(); ++i) {
                moved[i] = random.below(3) < still ? 0 : 1;
                bounds[i] = moved[i] != 0 ? bounds[i].moved(random.point(0.5)) : bounds[i];
            }
        }
    }
    EXPECT_GT(count, 5000u);
}

// All leaves are equally deep, also if they come in order of x: a node that is split keeps half.
TEST(BoundsTrees, StayLowWhenLeavesComeInOrder) {
    BoundsTrees trees;
    constexpr std::uint32_t kLeaves = 4096;
    for (std::uint32_t i = 0; i < kLeaves; ++i) {
        const Vec2 at{static_cast<Real>(i), 0};
        trees.set(i, Rest::Static, {at, at + Vec2{1, 1}});
    }
    EXPECT_EQ(trees.size(Rest::Static), kLeaves);
    EXPECT_LE(trees.height(Rest::Static), 6u); // 4^6
    BoundsTrees sorted;
    std::vector<BoundsTrees::Leaf> leaves;
    for (std::uint32_t i = 0; i < kLeaves; ++i) {
        leaves.push_back({trees.boxOf(i), i});
    }
    sorted.add(Rest::Static, leaves);
    EXPECT_EQ(sorted.height(Rest::Static), 4u); // 8^4
}

// Leaves that come and go do not leave nodes behind: searches stay as they are in a new tree.
// Neither do leaves that move at random for a long time.
TEST(BoundsTrees, StayGoodWhileLeavesComeGoAndMove) {
    RandomNumbers random(3);
    BoundsTrees trees;
    std::vector<BoundsTrees::Leaf> leaves;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        leaves.push_back({randomBox(random, 100), i});
        trees.set(i, Rest::Moving, leaves.back().box);
    }
    const auto entriesOf = [&](const BoundsTrees& searched) {
        std::size_t entries = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec2 at = RandomNumbers(static_cast<std::uint64_t>(i)).point(100);
            searched.search(
                [&](const Aabb& node) {
                    ++entries;
                    return node.contains(at) ? 0 : BoundsTrees::kMissed;
                },
                [](std::uint32_t) {});
        }
        return entries;
    };
    for (int round = 0; round < 300; ++round) {
        for (BoundsTrees::Leaf& leaf : leaves) {
            const Vec2 by = random.point(1);
            leaf.box = {leaf.box.lower + by, leaf.box.upper + by};
            if (random.below(100) == 0) {
                leaf.box = randomBox(random, 100);
                trees.remove(leaf.number);
            }
            trees.set(leaf.number, Rest::Moving, leaf.box);
        }
        pairsOf(trees, false);
    }
    BoundsTrees fresh;
    fresh.add(Rest::Moving, leaves);
    EXPECT_LT(entriesOf(trees), 3 * entriesOf(fresh) / 2);
    EXPECT_LE(trees.height(Rest::Moving), fresh.height(Rest::Moving) + 1);
}

} // namespace
} // namespace kodo
