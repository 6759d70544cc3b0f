// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "broad/bounds_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace kodo {
namespace {

using support::RandomNumbers;

Aabb randomBox(RandomNumbers& random, double spread) {
    const Vec2 at = random.point(spread);
    return {at, at + Vec2{random.between(0, 2), random.between(0, 2)}};
}

std::set<std::uint32_t> found(const BoundsTree& tree, const Aabb& box) {
    std::set<std::uint32_t> bodies;
    tree.search([&](const Aabb& node) { return overlap(node, box) ? 0 : BoundsTree::kMissed; },
                [&](std::uint32_t body, std::uint32_t part) {
                    EXPECT_EQ(part, body + 7);
                    EXPECT_TRUE(bodies.insert(body).second);
                });
    return bodies;
}

// A map of boxes is the model, over random insertions, removals and bulk builds.
TEST(BoundsTree, FindsWhatAModelFinds) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        RandomNumbers random(seed);
        BoundsTree tree;
        std::map<std::uint32_t, std::pair<Aabb, std::uint32_t>> model; // body: box and node
        std::uint32_t next = 0;
        if (seed % 2 == 0) {
            std::vector<BoundsTree::Leaf> leaves;
            std::vector<std::uint32_t> nodes;
            for (; next < 100; ++next) {
                leaves.push_back({randomBox(random, 20), next, next + 7});
            }
            tree.build(leaves, nodes, leaves.size());
            for (std::uint32_t i = 0; i < next; ++i) {
                model[i] = {leaves[i].box, nodes[i]};
            }
        }
        for (int i = 0; i < 2000; ++i) {
            if (model.empty() || random.below(5) < (i < 1000 ? 3u : 2u)) {
                const Aabb box = randomBox(random, 20);
                model[next] = {box, tree.insert({box, next, next + 7})};
                ++next;
            } else if (random.below(2) == 0) {
                auto moved = model.lower_bound(static_cast<std::uint32_t>(random.below(next)));
                moved = moved == model.end() ? model.begin() : moved;
                const double far = random.below(4) == 0 ? 30 : 1;
                const Vec2 by = random.point(far);
                Aabb& box = moved->second.first;
                box = {box.lower + by, box.upper + by};
                tree.move(moved->second.second, box);
            } else {
                auto gone = model.lower_bound(static_cast<std::uint32_t>(random.below(next)));
                gone = gone == model.end() ? model.begin() : gone;
                ASSERT_EQ(tree.box(gone->second.second), gone->second.first);
                tree.remove(gone->second.second);
                model.erase(gone);
            }
            if (i % 20 == 0) {
                const Aabb box = randomBox(random, 20);
                std::set<std::uint32_t> expected;
                for (const auto& [body, leaf] : model) {
                    if (overlap(leaf.first, box)) {
                        expected.insert(body);
                    }
                }
                ASSERT_EQ(found(tree, box), expected);
            }
        }
        const std::size_t leaves = model.size();
        while (!model.empty()) {
            tree.remove(model.begin()->second.second);
            model.erase(model.begin());
        }
        EXPECT_TRUE(found(tree, {{-100, -100}, {100, 100}}).empty());
        EXPECT_LE(tree.capacity(), 2 * (leaves + 2000));
    }
}

// Insertions in order of x, the worst case of a tree without rotations, whose height would be n.
TEST(BoundsTree, StaysLowWhenLeavesComeInOrder) {
    BoundsTree tree;
    constexpr std::uint32_t kLeaves = 4096;
    for (std::uint32_t i = 0; i < kLeaves; ++i) {
        const Vec2 at{static_cast<Real>(i), 0};
        tree.insert({{at, at + Vec2{1, 1}}, i, i + 7});
    }
    EXPECT_LE(tree.height(), 5 * 12u); // 12 levels suffice
}

// Leaves that move at random for a long time: searches visit about as many as in a new tree.
TEST(BoundsTree, StaysGoodWhileLeavesMove) {
    RandomNumbers random(3);
    BoundsTree tree;
    std::vector<BoundsTree::Leaf> leaves;
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        leaves.push_back({randomBox(random, 100), i, i + 7});
    }
    tree.build(leaves, nodes, leaves.size());
    for (int round = 0; round < 300; ++round) {
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            Aabb& box = leaves[i].box;
            const Vec2 by = random.point(1);
            box = {box.lower + by, box.upper + by};
            tree.move(nodes[i], box);
        }
    }
    const auto entriesOf = [&](const BoundsTree& searched) {
        std::size_t entries = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec2 at = RandomNumbers(static_cast<std::uint64_t>(i)).point(100);
            searched.search(
                [&](const Aabb& node) {
                    ++entries;
                    return node.contains(at) ? 0 : BoundsTree::kMissed;
                },
                [](std::uint32_t, std::uint32_t) {});
        }
        return entries;
    };
    BoundsTree fresh;
    fresh.build(leaves, nodes, leaves.size());
    EXPECT_LT(entriesOf(tree), 2 * entriesOf(fresh));
}

} // namespace
} // namespace kodo
