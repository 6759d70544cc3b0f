// SPDX-License-Identifier: MIT
#include <kodo/query.hpp>
#include <support/scenes.hpp>

#include "world/except_list.hpp"
#include "world/world_impl.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace kodo {
namespace {

/// Boxes in a row along x, 2 m apart.
World rowOf(int count) {
    World world;
    for (int i = 0; i < count; ++i) {
        world.add({.shape = Box{1, 1}, .position = {Real(2 * i), 0}, .type = BodyType::Static});
    }
    return world;
}

// Regression: each body was searched in the whole list.
TEST(ExceptList, ALongOneIsSortedAfterAFewSearches) {
    const World world = rowOf(4000);
    std::vector<BodyId> ids = world.bodies();
    ids.pop_back();
    ExceptList list(world.impl().bodyData(), ids);
    for (std::uint32_t body = 0; body < 4000; ++body) {
        ASSERT_EQ(list.contains(body), body < 3999) << body;
    }
    EXPECT_LE(list.visits(), 4000u * 50);
}

TEST(ExceptList, OneSearchOfALongOneDoesNotSortIt) {
    const World world = rowOf(4000);
    const std::vector<BodyId> ids = world.bodies();
    ExceptList list(world.impl().bodyData(), ids);
    EXPECT_TRUE(list.contains(9));
    EXPECT_EQ(list.visits(), 10u);
    EXPECT_FALSE(list.contains(4000));
    EXPECT_EQ(list.visits(), 10u + 4000);
}

TEST(ExceptList, ContainsEachBodyOfItsIdsInEachLength) {
    World world = rowOf(100);
    const std::vector<BodyId> bodies = world.bodies();
    for (std::size_t length : {0u, 1u, 2u, 15u, 16u, 17u, 18u, 50u, 100u}) {
        std::vector<BodyId> ids;
        for (std::size_t i = 0; i < length; ++i) {
            ids.push_back(bodies[(i * 37 + 5) % 100]);
        }
        ExceptList list(world.impl().bodyData(), ids);
        for (int round = 0; round < 2; ++round) {
            for (const BodyId id : bodies) {
                EXPECT_EQ(list.contains(id.index),
                          std::find(ids.begin(), ids.end(), id) != ids.end())
                    << length << ", body " << id.index;
            }
        }
    }
}

// Ids of removed bodies, of other Worlds and of no body leave nothing out, however many they are.
TEST(ExceptList, IdsThatNameNoBodyAreIgnoredInEachLength) {
    World world = rowOf(1);
    const BodyId box = world.bodies()[0];
    const World other = rowOf(1);
    for (const std::size_t length : {1u, 100u}) {
        std::vector<BodyId> ids(length, other.bodies()[0]);
        ids.push_back({});
        ids.push_back({box.index, box.generation + 1, box.world});
        ids.push_back({1000, 1, box.world});
        for (int round = 0; round < 3; ++round) {
            const auto near =
                closestPoint(world, {5, 0}, std::numeric_limits<Real>::infinity(), {}, ids);
            ASSERT_TRUE(near) << length;
            EXPECT_EQ(near->body, box);
        }
        ExceptList list(world.impl().bodyData(), ids);
        for (int round = 0; round < 20; ++round) {
            EXPECT_FALSE(list.contains(0)) << length << ", " << round;
        }
    }
}

// All queries leave out the same bodies with a long list as without these bodies.
TEST(ExceptList, QueriesWithALongOneFindTheRest) {
    const World world = rowOf(200);
    const std::vector<BodyId> bodies = world.bodies();
    const std::vector<BodyId> ids(bodies.begin(), bodies.end() - 2);
    const std::vector<BodyId> rest(bodies.end() - 2, bodies.end());
    const Real infinity = std::numeric_limits<Real>::infinity();
    EXPECT_EQ(closestPoint(world, {0, 0}, infinity, {}, ids)->body, rest[0]);
    EXPECT_EQ(rayCast(world, {-9, 0}, {900, 0}, {}, ids)->body, rest[0]);
    EXPECT_EQ(rayCastAll(world, {-9, 0}, {900, 0}, {}, ids).size(), 2u);
    EXPECT_EQ(shapeCast(world, Circle{1}, {{-9, 0}, {}}, {900, 0}, {}, ids)->body, rest[0]);
    EXPECT_EQ(overlap(world, Aabb{{-9, -9}, {900, 9}}, {}, ids), rest);
    EXPECT_EQ(overlap(world, Box{1800, 1}, {{0, 0}, {}}, {}, ids), rest);
}

} // namespace
} // namespace kodo
