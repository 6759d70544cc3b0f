// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/random_shapes.hpp>
#include <support/sleeping.hpp>

#include <cmath>
#include <limits>

namespace kodo {
namespace {

TEST(RaySpans, LeaveADiscAtTheSecondRoot) {
    World world;
    const BodyId disc = world.add({.shape = Circle{2}, .position = {5, 0}});
    const auto spans = raySpans(world, {0, 1}, {10, 1});
    ASSERT_EQ(spans.size(), 1u);
    const double half = std::sqrt(3); // of the chord at height 1
    EXPECT_EQ(spans[0].entry.body, disc);
    EXPECT_NEAR(spans[0].entry.fraction, (5 - half) / 10, 1e-6);
    EXPECT_NEAR(spans[0].exitFraction, (5 + half) / 10, 1e-6);
    EXPECT_NEAR(spans[0].exitPoint.x, 5 + half, 1e-5);
    EXPECT_NEAR(spans[0].exitNormal.x, half / 2, 1e-6);
    EXPECT_NEAR(spans[0].exitNormal.y, 0.5, 1e-6);
    const auto inside = raySpans(world, {4, 0}, {6, 0});
    ASSERT_EQ(inside.size(), 1u);
    EXPECT_EQ(inside[0].exitFraction, 1);
    EXPECT_EQ(inside[0].exitNormal, Vec2{});
}

// The sum of the spans in boxes side by side is the way through all of them.
TEST(RaySpans, EndWithoutNormalWhereTheRayEndsWithin) {
    World world;
    world.add({.shape = Circle{1}});
    const auto spans = raySpans(world, {-3, 0}, {0, 0});
    ASSERT_EQ(spans.size(), 1u);
    EXPECT_EQ(spans[0].entry.normal, (Vec2{-1, 0}));
    EXPECT_EQ(spans[0].exitFraction, 1);
    EXPECT_EQ(spans[0].exitPoint, Vec2{});
    EXPECT_EQ(spans[0].exitNormal, Vec2{});
}

TEST(RaySpans, OfFlushBoxesJoin) {
    World world;
    for (int i = 0; i < 10; ++i) {
        world.add({.shape = Box{1, 4}, .position = {static_cast<Real>(i), 0}});
    }
    world.add({.shape = Segment{{20, -2}, {20, 2}, true}, .type = BodyType::Static});
    Real inside = 0;
    const auto spans = raySpans(world, {-5, -1}, {25, 1});
    for (const RaySpan& span : spans) {
        EXPECT_GE(span.exitFraction, span.entry.fraction);
        inside += 30 * (span.exitFraction - span.entry.fraction);
    }
    ASSERT_EQ(spans.size(), 11u);
    EXPECT_EQ(spans[10].exitFraction, spans[10].entry.fraction); // the segment has no inside
    EXPECT_NEAR(inside, 10, 1e-4);
}

TEST(Queries, MayLeaveOutPartsThatAreSensors) {
    World world;
    const BodyId body = world.add({.shape = Compound{{Circle{1}, Circle{1, {5, 0}}}}});
    Part part = world[body].part(0);
    part.filter = CollisionFilter{kSensor};
    world[body].setPart(0, part);
    EXPECT_EQ(rayCast(world, {-5, 0}, {9, 0})->part, 0);
    EXPECT_EQ(rayCast(world, {-5, 0}, {9, 0}, {.flags = kNoSensors})->part, 1);
    world[body].setFlags(kSensor);
    EXPECT_TRUE(overlap(world, Circle{9}, {}, {.flags = kNoSensors}).empty());
    EXPECT_EQ(overlap(world, Circle{9}, {}).size(), 1u);
    EXPECT_THROW(overlap(world, Circle{9}, {}, {.flags = kSensor}), BadDefinition);
    EXPECT_THROW(world.applyForceToAll({1, 0}, {.flags = kNoSensors}), BadDefinition);
}

/// The first of many poses along the way at which the shape overlaps the target.
Real sampled(const World& world, const ShapeCast& cast, int count) {
    for (int i = 0; i <= count; ++i) {
        const Real t = static_cast<Real>(i) / static_cast<Real>(count);
        const Transform at{cast.start.position + t * cast.displacement,
                           turned(cast.start.rotation, t * cast.angle)};
        if (!overlap(world, cast.shape, at).empty()) {
            return t;
        }
    }
    return 2;
}

TEST(TurningCast, MeetsWhatFineSamplingMeets) {
    int hits = 0;
    for (int seed = 0; seed < support::draws(60); ++seed) {
        support::RandomNumbers random(static_cast<std::uint64_t>(seed) + 1);
        World world;
        world.add({.shape = Box{random.between(0.5, 3), random.between(0.5, 3)},
                   .position = random.point(1),
                   .rotation = random.rotation(),
                   .type = BodyType::Static});
        const ShapeCast cast{.shape = Box{random.between(2, 4), Real(0.2)},
                             .start = {{-5, random.between(-3, 3)}, random.rotation()},
                             .displacement = {10, random.between(-3, 3)},
                             .angle = random.between(-12, 12)};
        constexpr int kSamples = 4000;
        const Real expected = sampled(world, cast, kSamples);
        const auto hit = shapeCast(world, cast);
        hits += hit ? 1 : 0;
        if (!hit) {
            EXPECT_EQ(expected, 2) << seed;
            continue;
        }
        // Speeds up to 10 + 12 * 2 m per way, and a stop at slop / 4 before.
        EXPECT_LE(hit->fraction, expected + Real(1e-6)) << seed;
        if (expected <= 1) {
            EXPECT_NEAR(hit->fraction, expected, 0.02) << seed;
        }
        const Transform at{cast.start.position + hit->fraction * cast.displacement,
                           turned(cast.start.rotation, hit->fraction * cast.angle)};
        EXPECT_TRUE(overlap(world, cast.shape, at).empty()) << seed;
        const auto touch = collide(world, cast.shape, at, world.tolerances().slop);
        ASSERT_EQ(touch.size(), 1u) << seed;
        EXPECT_NEAR(length(hit->normal), 1, 1e-5);
    }
    EXPECT_GT(hits, support::draws(60) / 2);
}

// A bar that turns in place meets a disc at a known angle.
TEST(TurningCast, OfABarMeetsADiscAtItsAngle) {
    World world;
    world.add({.shape = Circle{Real(0.5)}, .position = {0, 2}, .type = BodyType::Static});
    const auto hit = shapeCast(world, {.shape = Segment{{0, 0}, {3, 0}}, .angle = 3});
    ASSERT_TRUE(hit);
    const double expected = 1.5707963 - std::asin(0.5 / 2);
    EXPECT_NEAR(3 * hit->fraction, expected, 0.001); // slop / 4 of 1/256 m at 2 m
    EXPECT_FALSE(shapeCast(world, {.shape = Segment{{0, 0}, {3, 0}}, .angle = Real(1.2)}));
}

TEST(StartOverlap, IsReportedIgnoredOrTold) {
    World world;
    const BodyId first = world.add({.shape = Box{4, 2}, .type = BodyType::Static});
    const BodyId second = world.add({.shape = Box{1, 9}, .position = {9, 0}});
    ShapeCast cast{.shape = Circle{1}, .start = {{0, Real(1.5)}, {}}, .displacement = {20, 0}};
    EXPECT_EQ(shapeCast(world, cast)->body, first);
    EXPECT_EQ(shapeCast(world, cast)->normal, Vec2{});
    cast.atStart = StartOverlap::Ignore;
    EXPECT_EQ(shapeCast(world, cast)->body, second);
    EXPECT_NEAR(shapeCast(world, cast)->fraction, 7.5 / 20, 1e-6);
    cast.angle = 1; // the same for a shape that turns; a disc turns about its centre
    EXPECT_EQ(shapeCast(world, cast)->body, second);
    EXPECT_NEAR(shapeCast(world, cast)->fraction, 7.5 / 20, 1e-4);
    cast.angle = 0;
    cast.atStart = StartOverlap::Normal;
    cast.displacement = {20, -1};
    EXPECT_EQ(shapeCast(world, cast)->body, first);
    EXPECT_EQ(shapeCast(world, cast)->normal, (Vec2{0, 1}));
    cast.displacement = {20, 1}; // leads outwards
    EXPECT_EQ(shapeCast(world, cast)->body, second);
}

TEST(ShapeQueries, CollideGivesNormalAndSeparation) {
    World world;
    const BodyId floor = world.add({.shape = Plane{}, .type = BodyType::Static});
    const BodyId wall =
        world.add({.shape = Box{2, 8}, .position = {3, 4}, .type = BodyType::Static});
    const Transform at{{Real(1.6), Real(0.4)}, {}};
    const auto touches = collide(world, Circle{Real(0.5)}, at, Real(0.2));
    ASSERT_EQ(touches.size(), 2u);
    EXPECT_EQ(touches[0].body, floor);
    EXPECT_EQ(touches[0].normal, (Vec2{0, 1}));
    EXPECT_NEAR(touches[0].separation, -0.1, 1e-6);
    EXPECT_EQ(touches[1].body, wall);
    EXPECT_EQ(touches[1].normal, (Vec2{-1, 0}));
    EXPECT_NEAR(touches[1].separation, -0.1, 1e-6);
    EXPECT_TRUE(collide(world, Circle{Real(0.5)}, {{0, Real(0.8)}, {}}, Real(0.2)).empty());
}

// From all four sides, at two places: the middle of what two flat sides share. A tilted box still
// tells its corner.
TEST(ShapeQueries, TheHitOfAFlatContactIsItsMiddle) {
    for (const Vec2 place : {Vec2{0, 0}, Vec2{60, -40}}) {
        World world;
        world.add({.shape = Box{2, 2}, .position = place});
        for (const Primitive& shape :
             {Primitive(Box{1, 1}), Primitive(Capsule{{0, Real(-0.5)}, {0, Real(0.5)}, Real(0.5)}),
              Primitive(Polygon{{{Real(-0.5), Real(-0.5)},
                                 {Real(0.5), Real(-0.5)},
                                 {Real(0.5), Real(0.5)},
                                 {Real(-0.5), Real(0.5)}}})}) {
            for (int quarter = 0; quarter < 4; ++quarter) {
                const Rot turn = Rot::fromAngle(static_cast<Real>(quarter) * Real(1.57079633));
                const Vec2 from = place + turn * Vec2{-5, Real(0.8)}; // over the edge by 0.3
                const auto hit = std::visit(
                    [&](const auto& kind) {
                        return shapeCast(world, kind, {from, turn}, turn * Vec2{10, 0});
                    },
                    shape);
                ASSERT_TRUE(hit);
                const Vec2 middle = place + turn * Vec2{-1, Real(0.65)};
                EXPECT_NEAR(length(hit->point - middle), 0, 1e-3) << quarter;
            }
        }
        const auto corner =
            shapeCast(world, Box{1, 1}, {place + Vec2{-5, 0}, Rot::fromAngle(Real(0.1))}, {10, 0});
        ASSERT_TRUE(corner);
        EXPECT_GT(std::abs(corner->point.y - place.y), 0.4);
    }
}

TEST(ShapeQueries, DistancesOfGivenBodies) {
    World world;
    const BodyId a = world.add({.shape = Compound{{Circle{1, {-9, 0}}, Circle{1}}}});
    const BodyId b = world.add({.shape = Box{2, 2}, .position = {4, 0}});
    const QueryPoint near = closestPoint(world[a], {-4, 0});
    EXPECT_EQ(near.part, 1);
    EXPECT_NEAR(near.distance, 3, 1e-6);
    EXPECT_EQ(closestPoint(world[a], {Real(0.5), 0}).distance, 0);
    const ClosestPoints gap = distance(world[a], world[b]);
    EXPECT_NEAR(gap.distance, 2, 1e-6);
    EXPECT_EQ(gap.normal, (Vec2{1, 0}));
    EXPECT_NEAR(distance(world[b], world[a]).onA.x, 3, 1e-6);
    EXPECT_THROW(closestPoint(world[a], {std::numeric_limits<Real>::quiet_NaN(), 0}),
                 BadDefinition);
}

// Awake bodies that the region leaves outside keep their touches, which the region holds.
TEST(Touching, TellsWhatTouchesOutsideTheRegion) {
    World world{{.gravity = support::kEarth, .settings = {.leaveOut = Feature::Sleep}}};
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    support::run(world, 10);
    ASSERT_EQ(touching(world, box), std::vector{floor});
    world.setRegion(Aabb{{100, 0}, {101, 1}});
    support::run(world, 3);
    EXPECT_EQ(touching(world, box), std::vector{floor});
    EXPECT_EQ(touching(world, floor), std::vector{box});
    world.setRegion(std::nullopt);
    support::run(world, 3);
    EXPECT_EQ(touching(world, box), std::vector{floor});
}

// All pairs of begun and not ended records, while bodies fall, lie and sleep.
TEST(Touching, IsWhatBeganAndHasNotEndedAlsoAsleep) {
    World world{{.gravity = support::kEarth}};
    support::addFloor(world);
    const BodyId sensor = world.add(
        {.shape = Box{4, 3}, .position = {0, 1}, .type = BodyType::Static, .flags = kSensor});
    support::addHeap(world, 6, 30);
    std::vector<std::pair<BodyId, BodyId>> book; // one entry for each pair of parts
    std::size_t most = 0;
    for (int step = 0; step < 1200; ++step) {
        world.step(support::kDt);
        for (const CollisionRecord& record : world.endedCollisions()) {
            book.erase(std::find(book.begin(), book.end(), std::pair(record.a, record.b)));
        }
        for (const CollisionRecord& record : world.begunCollisions()) {
            book.push_back({record.a, record.b});
        }
        if (step % 40 != 39) {
            continue;
        }
        for (const BodyId id : world.bodies()) {
            std::vector<BodyId> expected;
            for (const auto& pair : book) {
                if (pair.first == id || pair.second == id) {
                    expected.push_back(pair.first == id ? pair.second : pair.first);
                }
            }
            std::sort(expected.begin(), expected.end());
            expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
            ASSERT_EQ(touching(world, id), expected) << "step " << step << " body " << id.index;
            most = std::max(most, expected.size());
        }
    }
    EXPECT_GT(most, 3u);
    EXPECT_GT(support::countAsleep(world), 20u);
    EXPECT_FALSE(touching(world, sensor).empty());
    world.setRegion(Aabb{{100, 0}, {101, 1}}); // parked contacts count as well
    world.step(support::kDt);
    EXPECT_FALSE(touching(world, sensor).empty());
    const BodyId gone = world.bodies().back();
    world.remove(gone);
    EXPECT_THROW(touching(world, gone), BadBodyId);
}

} // namespace
} // namespace kodo
