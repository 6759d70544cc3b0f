// SPDX-License-Identifier: MIT
#include <kodo/world/world.hpp>
#include <support/scenes.hpp>

#include <algorithm>

namespace kodo {
namespace {

using support::byPrecision;
using support::kDt;
using support::kEarth;
using support::near;

Heightmap flatMap(std::size_t heights) {
    return {{0, 0}, 1, std::vector<Real>(heights, 0)};
}

/// What happened to a body on its way over ground.
struct Ride {
    Real slowest;  // m/s, along x
    Real steepest; // the largest |x| of a normal
    int contacts = 0;
    Real highest; // m, of the centre
    Real lowest;
    Real end; // m, where it got
};

Ride ride(World& world, BodyId body, Real until) {
    const Real start = world[body].velocity().x;
    const Real height = world[body].position().y;
    Ride ride{start, 0, 0, height, height, 0};
    for (int i = 0; i < 6000 && world[body].center().x < until; ++i) {
        world.step(kDt);
        ride.slowest = std::min(ride.slowest, world[body].velocity().x);
        ride.highest = std::max(ride.highest, world[body].position().y);
        ride.lowest = std::min(ride.lowest, world[body].position().y);
        for (const CollisionRecord& record : world.collisions()) {
            if (record.phase != TouchPhase::End) {
                ride.steepest = std::max(ride.steepest, std::abs(record.normal.x));
                ++ride.contacts;
            }
        }
    }
    ride.end = world[body].center().x;
    return ride;
}

class FlushJoints : public testing::TestWithParam<Shape> {};

// F2: 100 joints, no friction: no normal tilts and no speed is lost. The promise is 0.1 %; what is
// left is rounding. Steps are 0.05 m long, so every part of a joint is met.
TEST_P(FlushJoints, AreNotFelt) {
    World world({.gravity = kEarth});
    world.add({.shape = flatMap(120), .material = support::slippery(), .flags = kLocked});
    const BodyId body = world.add({.shape = GetParam(),
                                   .position = {5, Real(0.5)},
                                   .velocity = {3, 0},
                                   .material = support::slippery()});
    const Ride found = ride(world, body, Real(106.5));
    EXPECT_GT(found.end, 106);
    EXPECT_GT(found.contacts, 1000);
    EXPECT_LE(found.steepest, 4 * support::kEpsilon);
    EXPECT_GT(found.slowest, 3 * Real(0.999));
    EXPECT_TRUE(near(found.slowest, 3, byPrecision(1e-4, 1e-12)));
    // As deep as it rests, and never thrown up.
    EXPECT_LT(found.highest, Real(0.5) + Real(1e-5));
    EXPECT_GT(found.lowest, Real(0.5) - world.tolerances().slop);
    RecordProperty("speedLost", std::to_string(3 - found.slowest));
}

INSTANTIATE_TEST_SUITE_P(Ground, FlushJoints,
                         testing::Values(Shape(Box{1, 1}), Shape(Box{Real(2.7), 1}),
                                         Shape(Box{Real(0.25), 1}), Shape(Circle{Real(0.5)}),
                                         Shape(Polygon{{{Real(-0.3), Real(-0.5)},
                                                        {Real(0.4), Real(-0.5)},
                                                        {0, Real(0.5)}}})));

// F2: fast and bouncing bodies are swept; the sweep must not stop at a joint either.
TEST(Ground, FastBodiesCrossJointsInOneStep) {
    for (const Shape& shape : {Shape(Box{1, 1}), Shape(Circle{Real(0.5)})}) {
        World world({.gravity = kEarth});
        world.add({.shape = flatMap(1200), .material = support::slippery(1), .flags = kLocked});
        const BodyId body = world.add({.shape = shape,
                                       .position = {5, Real(0.5)},
                                       .velocity = {200, 0},
                                       .material = support::slippery(1)});
        for (int i = 0; i < 300; ++i) {
            world.step(kDt);
            ASSERT_TRUE(near(world[body].center().x, 5 + (i + 1) * 200 * static_cast<double>(kDt),
                             byPrecision(0.01, 1e-8)))
                << "held up at step " << i;
        }
        EXPECT_TRUE(near(world[body].velocity().x, 200, byPrecision(0.01, 1e-9)));
    }
}

// F2: a ball that slides through a smooth valley and up the other side keeps its energy, as it does
// on a curve; each joint bends by less than a degree. The chords of a circle of radius R and their
// joints take no more than a step's forces: 1 % allowed.
TEST(Ground, AValleyOfManyCellsActsAsACurve) {
    World world({.gravity = kEarth});
    Heightmap valley{{-8, 0}, Real(0.125), {}};
    for (int i = 0; i <= 128; ++i) {
        const Real x = -8 + Real(0.125) * static_cast<Real>(i);
        valley.heights.push_back(x * x / 16);
    }
    world.add({.shape = valley, .material = support::slippery(), .flags = kLocked});
    const BodyId ball = world.add(
        {.shape = Circle{Real(0.5)}, .position = {-4, Real(1.5)}, .material = support::slippery()});
    support::run(world, 120);
    Real lowest = 100;
    Real farthest = -100;
    for (int i = 0; i < 600; ++i) {
        world.step(kDt);
        lowest = std::min(lowest, world[ball].center().y);
        farthest = std::max(farthest, world[ball].center().x);
    }
    EXPECT_TRUE(near(lowest, 0.5, 0.01)) << "it rolls through the bottom";
    EXPECT_GT(farthest, Real(3.4)) << "and nearly as high up as it came from";
    EXPECT_LT(farthest, Real(4.1));
}

// C1, P1: a plane carries everything, far out as well as at its origin.
TEST(Ground, APlaneCarriesEverything) {
    World world({.gravity = kEarth});
    world.add({.shape = Plane{{0, 1}, 0}, .flags = kLocked});
    const Shape shapes[] = {Shape(Circle{Real(0.5)}), Shape(Box{1, 1}),
                            Shape(Polygon{{{-1, Real(-0.5)}, {1, Real(-0.5)}, {0, Real(0.5)}}}),
                            Shape(Segment{{-1, Real(-0.5)}, {1, Real(-0.5)}, false, {}, {}}),
                            Shape(Point{{0, Real(-0.5)}})};
    std::vector<BodyId> bodies;
    Real x = 0;
    for (const Shape& shape : shapes) {
        for (const Real far : {Real(0), Real(1000)}) {
            bodies.push_back(world.add({.shape = shape, .position = {far + x, 1}}));
        }
        x += 4;
    }
    support::run(world, 240);
    for (const BodyId body : bodies) {
        EXPECT_TRUE(near(world[body].position().y, 0.5, world.tolerances().slop * 2));
        EXPECT_LT(length(world[body].velocity()), Real(0.01));
    }
}

// What has no thickness sinks in by a hair, and does not fall through for being behind the line.
TEST(Ground, OneSidedGroundCarriesWhatHasNoThickness) {
    const Shape grounds[] = {Shape(flatMap(10)), Shape(Segment{{-5, 0}, {5, 0}, true, {}, {}})};
    const Shape thin[] = {Shape(Point{}),
                          Shape(Segment{{Real(-0.2), 0}, {Real(0.2), 0}, false, {}, {}})};
    for (const Shape& ground : grounds) {
        for (const Shape& shape : thin) {
            World world({.gravity = kEarth});
            world.add({.shape = ground, .flags = kLocked});
            const BodyId body = world.add({.shape = shape, .position = {Real(0.3), Real(0.1)}});
            support::run(world, 240);
            EXPECT_TRUE(near(world[body].position().y, 0, world.tolerances().slop));
            EXPECT_LT(length(world[body].velocity()), Real(0.01));
        }
    }
}

// R1: a particle has mass and no inertia. It flies, bounces and is pushed like anything else.
TEST(Ground, AParticleBouncesOnAPlane) {
    World world({.gravity = kEarth});
    world.add({.shape = Plane{}, .material = support::slippery(1), .flags = kLocked});
    const BodyId particle = world.add(
        {.shape = Point{}, .position = {0, 2}, .material = support::slippery(1), .density = 3});
    EXPECT_EQ(world[particle].mass(), 3);
    EXPECT_EQ(world[particle].inertia(), 0);
    Real highest = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(kDt);
        ASSERT_GT(world[particle].position().y, Real(-0.02));
        highest = i > 60 ? std::max(highest, world[particle].position().y) : 0;
    }
    EXPECT_TRUE(near(highest, 2, 0.05));
    EXPECT_EQ(world[particle].angularVelocity(), 0);
}

// R8: half of everything cannot fall.
TEST(Ground, NeedsALock) {
    World world;
    EXPECT_EQ(check(BodyDef{.shape = Plane{}})->field, "flags");
    EXPECT_THROW(world.add({.shape = flatMap(3)}), BadDefinition);
    EXPECT_THROW(world.add({.shape = flatMap(3), .flags = kLockMove}), BadDefinition);
    EXPECT_NO_THROW(world.add({.shape = flatMap(3), .flags = kLocked}));
}

} // namespace
} // namespace kodo
