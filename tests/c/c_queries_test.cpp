// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
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

TEST(CQueries, SpansOfARayEndWhereItLeaves) {
    const Row row;
    std::array<kodo_RaySpan, 3> spans{};
    std::size_t count = 0;
    EXPECT_OK(kodo_raySpans(row.world, kRay, nullptr, spans.data(), spans.size(), &count));
    ASSERT_EQ(3u, count);
    EXPECT_TRUE(kodo_sameBody(row.ids[1], spans[1].entry.body));
    EXPECT_NEAR(0.65, spans[1].entry.fraction, 1e-5);
    EXPECT_NEAR(0.75, spans[1].exitFraction, 1e-5);
    EXPECT_NEAR(2.5, spans[1].exitPoint.x, 1e-5);
    EXPECT_NEAR(1, spans[1].exitNormal.x, 1e-5);
}

TEST(CQueries, ATurningCastMeetsWhatItSweepsOver) {
    const Row row;
    kodo_CastDef cast = kodo_castDef();
    cast.shape = kodo_capsule(kodo_vec2(0, 0), kodo_vec2(0, 3), kodo_Real(0.1));
    kodo_Query query = kodo_query();
    query.except = row.ids.data();
    query.exceptCount = 1;
    kodo_QueryHit hit{};
    EXPECT_OK(kodo_castShape(row.world, &cast, &query, &hit));
    EXPECT_FALSE(hit.found);
    cast.angle = -2; // clockwise, from upright to the right
    EXPECT_OK(kodo_castShape(row.world, &cast, &query, &hit));
    EXPECT_TRUE(kodo_sameBody(row.ids[1], hit.body));
    // The capsule meets the disc at 2 m when 2 cos(a) = 0.5 + 0.1.
    EXPECT_NEAR(std::acos(0.3) / 2, hit.fraction, 2e-3);
    kodo::World other = cppWorld(0);
    for (int i = 0; i < 3; ++i) {
        other.add({.position = {static_cast<kodo::Real>(2 * i), 0}});
    }
    const auto expected = kodo::shapeCast(
        other,
        kodo::ShapeCast{.shape = kodo::Capsule{{0, 0}, {0, 3}, kodo::Real(0.1)}, .angle = -2}, {},
        std::vector{other.bodies()[0]});
    EXPECT_EQ(expected->fraction, hit.fraction);
}

TEST(CQueries, ACastDoesWithTheStartWhatItIsTold) {
    const Row row;
    kodo_CastDef cast = kodo_castDef();
    cast.start.position = kodo_vec2(kodo_Real(-0.9), 0);
    cast.displacement = kodo_vec2(kodo_Real(0.5), 0);
    kodo_QueryHit hit{};
    EXPECT_OK(kodo_castShape(row.world, &cast, nullptr, &hit));
    EXPECT_TRUE(hit.found);
    EXPECT_EQ(0, hit.normal.x);
    cast.atStart = KODO_START_NORMAL;
    EXPECT_OK(kodo_castShape(row.world, &cast, nullptr, &hit));
    EXPECT_NEAR(-1, hit.normal.x, 1e-5);
    cast.atStart = KODO_START_IGNORE;
    EXPECT_OK(kodo_castShape(row.world, &cast, nullptr, &hit));
    EXPECT_FALSE(hit.found);
    cast.atStart = 3;
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_castShape(row.world, &cast, nullptr, &hit));
    cast = {};
    EXPECT_EQ(KODO_WRONG_USE, kodo_castShape(row.world, &cast, nullptr, &hit));
}

TEST(CQueries, ContactsAreThoseNearerThanTheMargin) {
    const Row row;
    const kodo_Shape disc = kodo_circle(kodo_Real(0.5));
    kodo_NearShape placed{&disc, {{kodo_Real(-1.2), 0}, {1, 0}}, 1};
    std::array<kodo_QueryContact, 3> contacts{};
    std::size_t count = 0;
    EXPECT_OK(kodo_collide(row.world, &placed, nullptr, contacts.data(), 3, &count));
    ASSERT_EQ(1u, count);
    EXPECT_TRUE(kodo_sameBody(row.ids[0], contacts[0].body));
    EXPECT_NEAR(0.2, contacts[0].separation, 1e-5);
    EXPECT_NEAR(-0.6, contacts[0].point.x, 1e-5);
    EXPECT_NEAR(-1, contacts[0].normal.x, 1e-5);
    placed.margin = kodo_Real(0.1);
    EXPECT_OK(kodo_collide(row.world, &placed, nullptr, nullptr, 0, &count));
    EXPECT_EQ(0u, count);
}

TEST(CQueries, DistancesOfGivenBodies) {
    const Row row;
    kodo_QueryPoint closest{};
    EXPECT_OK(kodo_closestPointOf(row.world, row.ids[2], kodo_vec2(0, 0), &closest));
    EXPECT_TRUE(closest.found);
    EXPECT_NEAR(3.5, closest.distance, 1e-5);
    EXPECT_NEAR(3.5, closest.point.x, 1e-5);
    kodo_ClosestPoints points{};
    EXPECT_OK(kodo_distance(row.world, row.ids[0], row.ids[2], &points));
    EXPECT_NEAR(3, points.distance, 1e-5);
    EXPECT_NEAR(0.5, points.onA.x, 1e-5);
    EXPECT_NEAR(3.5, points.onB.x, 1e-5);
    EXPECT_NEAR(1, points.normal.x, 1e-5);
    EXPECT_EQ(KODO_BAD_ID, kodo_distance(row.world, row.ids[0], {}, &points));
}

TEST(CQueries, SensorsMayBeLeftOut) {
    const Row row;
    EXPECT_OK(kodo_setFlags(row.world, row.ids[0], KODO_SENSOR));
    kodo_Query query = kodo_query();
    query.which.flags = KODO_NO_SENSORS;
    kodo_QueryHit hit{};
    EXPECT_OK(kodo_rayCast(row.world, kRay, &query, &hit));
    EXPECT_TRUE(kodo_sameBody(row.ids[1], hit.body));
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
