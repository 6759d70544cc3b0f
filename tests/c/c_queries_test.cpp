// SPDX-License-Identifier: MIT
#include <array>
#include <limits>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// Three discs in a row, the second with category 1.
struct Row {
    CWorld world{kodo_Real(0)};
    std::array<kodo_BodyId, 3> ids{};

    Row() {
        for (std::size_t i = 0; i < 3; ++i) {
            kodo_BodyDef def = bodyAt(kodo_Real(2 * i), 0);
            def.flags = i == 1 ? 1 : 2;
            ids[i] = world.add(def);
        }
    }
};

constexpr kodo_Ray kRay{{-5, 0}, {5, 0}};

TEST(CQueries, ARayHitsTheFirstBodyThatTheQuerySelects) {
    const Row row;
    kodo_QueryHit hit{};
    EXPECT_OK(kodo_rayCast(row.world, kRay, nullptr, &hit));
    EXPECT_TRUE(hit.found);
    EXPECT_TRUE(kodo_sameBody(row.ids[0], hit.body));
    EXPECT_NEAR(-0.5, hit.point.x, 1e-5);
    EXPECT_NEAR(-1, hit.normal.x, 1e-5);
    EXPECT_NEAR(0.45, hit.fraction, 1e-5);

    kodo_Query query = kodo_query();
    query.except = row.ids.data();
    query.exceptCount = 2;
    EXPECT_OK(kodo_rayCast(row.world, kRay, &query, &hit));
    EXPECT_TRUE(kodo_sameBody(row.ids[2], hit.body));
    query.which = {KODO_MATCH_ANY, 1, 0};
    EXPECT_OK(kodo_rayCast(row.world, kRay, &query, &hit));
    EXPECT_FALSE(hit.found);
}

TEST(CQueries, AllPartsOnARayAreOrdered) {
    const Row row;
    std::array<kodo_QueryHit, 3> hits{};
    std::size_t count = 0;
    EXPECT_OK(kodo_rayCastAll(row.world, kRay, nullptr, hits.data(), hits.size(), &count));
    ASSERT_EQ(3u, count);
    EXPECT_TRUE(kodo_sameBody(row.ids[2], hits[2].body));
}

TEST(CQueries, AVisitEndsWhenTheFunctionSaysSo) {
    const Row row;
    int visits = 0;
    EXPECT_OK(kodo_visitRay(
        row.world, kRay, nullptr,
        [](void* context, const kodo_QueryHit* hit) {
            ++*static_cast<int*>(context);
            return hit->point.x < 1;
        },
        &visits));
    EXPECT_EQ(2, visits);
    const kodo_Shape box = kodo_box(10, 1);
    const kodo_PlacedShape placed{&box, {{0, 0}, {1, 0}}};
    EXPECT_OK(kodo_visitOverlaps(
        row.world, &placed, nullptr,
        [](void* context, kodo_BodyId) { return ++*static_cast<int*>(context) < 3; }, &visits));
    EXPECT_EQ(3, visits);
}

TEST(CQueries, AMovingShapeHitsTheFirstBody) {
    const Row row;
    const kodo_Shape disc = kodo_circle(kodo_Real(0.5));
    const kodo_PlacedShape start{&disc, {{-5, 0}, {1, 0}}};
    kodo_QueryHit hit{};
    EXPECT_OK(kodo_shapeCast(row.world, &start, kodo_vec2(10, 0), nullptr, &hit));
    EXPECT_TRUE(hit.found);
    EXPECT_NEAR(0.4, hit.fraction, 1e-3);
}

TEST(CQueries, OverlapsAreListedInTheOrderOfIds) {
    const Row row;
    std::array<kodo_BodyId, 3> ids{};
    std::size_t count = 0;
    EXPECT_OK(kodo_overlapBox(row.world, {{1, -1}, {9, 1}}, nullptr, ids.data(), 3, &count));
    ASSERT_EQ(2u, count);
    EXPECT_TRUE(kodo_sameBody(row.ids[1], ids[0]));
    const kodo_Shape disc = kodo_circle(1);
    const kodo_PlacedShape placed{&disc, {{0, 0}, {1, 0}}};
    EXPECT_OK(kodo_overlapShape(row.world, &placed, nullptr, ids.data(), 3, &count));
    EXPECT_EQ(1u, count);
}

TEST(CQueries, TheClosestPointIsThatOfTheClosestBody) {
    const Row row;
    kodo_QueryPoint closest{};
    const kodo_Real all = std::numeric_limits<kodo_Real>::infinity();
    EXPECT_OK(kodo_closestPoint(row.world, kodo_vec2(2, 3), all, nullptr, &closest));
    EXPECT_TRUE(closest.found);
    EXPECT_TRUE(kodo_sameBody(row.ids[1], closest.body));
    EXPECT_NEAR(2.5, closest.distance, 1e-5);
    EXPECT_OK(kodo_closestPoint(row.world, kodo_vec2(2, 3), 1, nullptr, &closest));
    EXPECT_FALSE(closest.found);
}

TEST(CQueries, PointsOfABodyAreThoseOfCpp) {
    const Row row;
    bool inside = false;
    EXPECT_OK(kodo_containsPoint(row.world, row.ids[0], kodo_vec2(0, kodo_Real(0.4)), &inside));
    EXPECT_TRUE(inside);
    EXPECT_OK(kodo_setAngularVelocity(row.world, row.ids[0], 2));
    kodo_Vec2 velocity{};
    EXPECT_OK(kodo_velocityAt(row.world, row.ids[0], kodo_vec2(0, kodo_Real(0.5)), &velocity));
    EXPECT_NEAR(-1, velocity.x, 1e-6);
}

} // namespace
