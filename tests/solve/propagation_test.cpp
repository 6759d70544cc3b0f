// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <scenes/impacts.hpp>
#include <support/near.hpp>

#include <gtest/gtest.h>
#include <solve/solver_scenes.hpp>

#include <limits>

namespace {

using namespace kodo;
using strategies::kStep;
using strategies::propagation;
using support::byPrecision;
using support::near;
using support::nearShare;

scenes::KodoScene after(const scenes::SceneDef& scene, const StepSettings& settings,
                        double seconds) {
    scenes::KodoScene result = inKodo(scene, settings);
    for (int i = 0; i < static_cast<int>(seconds * 60 + 0.5); ++i) {
        result.world.step(kStep);
    }
    return result;
}

// W4 [Guendelman03]: a lying body does not bounce, however elastic it is, since collisions use the
// velocity before gravity. A solver that integrates first makes it bounce.
TEST(Propagation, ALosslessBlockStaysOnARampWithinTheFrictionCone) {
    const scenes::SceneDef scene = strategies::lossless(scenes::boxOnSlope(0.8));
    const scenes::KodoScene end = after(scene, thesis2006(), 10);
    EXPECT_LT(strategies::farthestMove(end, scene), Real(0.01));
    EXPECT_LT(strategies::fastest(end), Real(0.05));
}

// W4: a = g (sin - mu cos) = 2 m/s^2. Bodies in contact move by their new velocity, so after n
// steps the distance is a t (t + h) / 2, not a t^2 / 2 [Thesis06, eq. 4.8].
TEST(Propagation, ALosslessBlockSlidesDownASteepRampByCoulombsLaw) {
    const scenes::SceneDef scene = strategies::lossless(scenes::boxOnSlope(0.5));
    const scenes::KodoScene end = after(scene, thesis2006(), 2);
    const double expected = 2 * 2.0 * (2.0 + 1.0 / 60) / 2;
    EXPECT_TRUE(nearShare(strategies::farthestMove(end, scene), expected, 0.005));
}

double slideDistance(const StepSettings& settings, double restitution) {
    scenes::SceneDef scene = scenes::slidingBox(0.5);
    for (scenes::BodyDef& body : scene.bodies) {
        body.material.restitution = restitution;
    }
    const scenes::KodoScene end = after(scene, settings, 3);
    EXPECT_LT(strategies::fastest(end), Real(0.01));
    return static_cast<double>(end.world[end.ids[1]].position().x);
}

// S3: v^2 / (2 mu g) = 2.5 m. The thesis calls both dependences weaknesses of its friction.
TEST(Propagation, SlidingDistanceDependsNeitherOnPassesNorOnRestitution) {
    const double few = slideDistance(propagation(4, 0), 0);
    const double many = slideDistance(propagation(40, 0), 0);
    const double elastic = slideDistance(propagation(10, 0), 0.9);
    const double shocked = slideDistance(propagation(4, 4), 0);
    EXPECT_TRUE(nearShare(few, many, 0.01));
    EXPECT_TRUE(nearShare(elastic, many, 0.01));
    EXPECT_TRUE(nearShare(shocked, many, 0.01));
    EXPECT_TRUE(nearShare(many, 2.5, 0.02)); // up to a part of the last step's distance
}

// A box that falls along a wall is in free flight. A speed towards the wall that is mere underflow
// does not count as contact.
TEST(Propagation, ABoxThatTouchesAWallWithoutImpulseFallsFreely) {
    constexpr Real kLeast = std::numeric_limits<Real>::denorm_min();
    const auto fallenAlongAWall = [](Real towards) {
        World world({.gravity = {0, -10}, .settings = thesis2006()});
        BodyDef wall{.shape = Box{1, 100}, .position = {Real(1), 0}};
        wall.type = BodyType::Kinematic;
        world.add(wall);
        const BodyId box = world.add({.shape = Box{1, 1}, .velocity = {towards, 0}});
        for (int i = 0; i < 30; ++i) {
            world.step(kStep);
        }
        EXPECT_EQ(world.collisions().size(), 1u);
        return world[box].position().y;
    };
    EXPECT_EQ(fallenAlongAWall(64 * kLeast), fallenAlongAWall(0));
    EXPECT_TRUE(near(fallenAlongAWall(0), -10 * 0.5 * 0.5 / 2, byPrecision(1e-5, 1e-14)));
}

// Free flight is exact, and a bounce inverts the velocity: energy is conserved.
TEST(Propagation, ConservesTheEnergyOfALosslessBall) {
    StepSettings settings = thesis2006();
    scenes::KodoScene scene = inKodo(scenes::bouncingBall(1), settings);
    const BodyView ball = scene.world[scene.ids[1]];
    const auto energy = [&] { return 10 * ball.center().y + lengthSquared(ball.velocity()) / 2; };
    const Real before = energy();
    Real highest = 0;
    for (int i = 0; i < 3600; ++i) {
        scene.world.step(kStep);
        highest = i > 3000 ? std::max(highest, ball.center().y) : highest;
    }
    EXPECT_TRUE(nearShare(energy(), before, byPrecision(1e-3, 1e-9)));
    EXPECT_TRUE(near(highest, 5.5, 0.02)); // the apex lies between two steps
}

TEST(Propagation, ABouncingBallFallsAsleepWithoutASpeedThreshold) {
    const scenes::KodoScene end = after(scenes::bouncingBall(0.5), thesis2006(), 10);
    EXPECT_TRUE(near(end.world[end.ids[1]].position().y, 0.5, 0.002));
    EXPECT_NE(end.world[end.ids[1]].flags() & kAsleep, 0u);
}

// S4, F4: separation displaces bodies without changing velocities. Heavier bodies move less, so the
// common centre of mass stays. Locked bodies do not move.
TEST(Propagation, SeparationAddsNoEnergy) {
    World world{{.settings = thesis2006()}};
    BodyDef def;
    def.shape = Box{1, 1};
    const BodyId light = world.add(def);
    def.position = {Real(0.8), 0};
    def.density = 3;
    const BodyId heavy = world.add(def);
    for (int i = 0; i < 60; ++i) {
        world.step(kStep);
        EXPECT_EQ(world[light].velocity(), Vec2{});
        EXPECT_EQ(world[heavy].velocity(), Vec2{});
    }
    const Real gap = world[heavy].position().x - world[light].position().x;
    EXPECT_TRUE(near(gap, 1, 0.002)); // up to the permitted overlap
    EXPECT_TRUE(near(world[light].position().x + 3 * world[heavy].position().x, 2.4,
                     byPrecision(1e-5, 1e-13)));
}

TEST(Propagation, SeparationDoesNotMoveAKinematicBody) {
    World world{{.settings = propagation(4, 4)}};
    BodyDef def;
    def.shape = Box{1, 1};
    def.type = BodyType::Kinematic;
    const BodyId locked = world.add(def);
    def.type = BodyType::Dynamic;
    def.position = {Real(0.8), 0};
    const BodyId free = world.add(def);
    for (int i = 0; i < 60; ++i) {
        world.step(kStep);
    }
    EXPECT_EQ(world[locked].position(), Vec2{});
    EXPECT_TRUE(near(world[free].position().x, 1, 0.002));
    EXPECT_EQ(world[free].velocity(), Vec2{});
}

TEST(Propagation, SeparationRespectsThePushSpeed) {
    StepSettings settings = thesis2006();
    settings.propagation().pushSpeed = Real(0.6); // 1 cm a step
    World world{{.settings = settings}};
    BodyDef def;
    def.shape = Box{1, 1};
    const BodyId left = world.add(def);
    def.position = {Real(0.5), 0};
    const BodyId right = world.add(def);
    world.step(kStep);
    const Real gap = world[right].position().x - world[left].position().x;
    EXPECT_TRUE(near(gap, 0.51, 1e-4));
}

// S1, S2: J = m (1 + e) v, in the impact group.
TEST(Propagation, RecordsTheImpactImpulseOfABallOnAWall) {
    for (const int substeps : {1, 4}) {
        StepSettings settings = thesis2006();
        settings.propagation().substeps = substeps;
        World world{{.settings = settings}};
        BodyDef def;
        def.shape = Box{1, 10};
        def.type = BodyType::Kinematic;
        def.material = withFriction(0, Real(0.5));
        world.add(def);
        def.shape = Circle{Real(0.5)};
        def.type = BodyType::Dynamic;
        def.position = {3, 0};
        def.velocity = {-4, 0};
        const BodyId ball = world.add(def);
        const Real expected = world[ball].mass() * Real(1.5) * 4;
        int hits = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(kStep);
            for (const CollisionRecord& record : world.collisions()) {
                if (record.totalImpulse > 0) {
                    ++hits;
                    EXPECT_TRUE(nearShare(record.maxImpulse, expected, 1e-5));
                    EXPECT_TRUE(nearShare(record.totalImpulse, expected, 1e-5));
                    EXPECT_TRUE(nearShare(record.approachSpeed, 4, 1e-5));
                    EXPECT_TRUE(near(record.point.x, 0.5, 0.04)); // half of a displacement
                }
            }
        }
        EXPECT_EQ(hits, 1);
        EXPECT_TRUE(near(world[ball].velocity(), Vec2{2, 0}, 1e-5));
    }
}

TEST(Propagation, RecordsTheWeightOfALyingBox) {
    scenes::KodoScene scene = inKodo(scenes::stack(1), thesis2006());
    scene.world.step(kStep);
    ASSERT_EQ(scene.world.collisions().size(), 1u);
    const CollisionRecord& record = scene.world.collisions()[0];
    EXPECT_TRUE(nearShare(record.totalImpulse, 10.0 / 60, 1e-4)); // m g dt
    EXPECT_TRUE(nearShare(record.maxImpulse, 10.0 / 60, 1e-3));
    EXPECT_TRUE(nearShare(record.maxPointImpulse(), 5.0 / 60, 1e-3)); // one of two corners
}

TEST(Propagation, AFastBallDoesNotTunnelThroughAThinFloor) {
    World world{{.gravity = {0, -10}, .settings = thesis2006()}};
    BodyDef def;
    def.shape = Box{20, Real(0.02)};
    def.type = BodyType::Kinematic;
    world.add(def);
    def = {};
    def.shape = Circle{Real(0.1)};
    def.position = {0, 20};
    def.velocity = {0, -200};
    def.material = withFriction(0, Real(0.5));
    const BodyId ball = world.add(def);
    for (int i = 0; i < 300; ++i) {
        world.step(kStep);
        ASSERT_GT(world[ball].position().y, 0);
    }
}

TEST(Propagation, ABoxSlidesOverFlushGroundWithoutGhostCollisions) {
    StepSettings settings = thesis2006();
    World world{{.gravity = {0, -10}, .settings = settings}};
    BodyDef def;
    def.shape = Box{1, 1};
    def.type = BodyType::Kinematic;
    def.material = withFriction(0);
    for (int i = 0; i < 30; ++i) {
        def.position = {static_cast<Real>(i), Real(-0.5)};
        world.add(def);
    }
    def.type = BodyType::Dynamic;
    def.position = {1, Real(0.5)};
    def.velocity = {5, 0};
    const BodyId box = world.add(def);
    for (int i = 0; i < 240; ++i) {
        world.step(kStep);
        ASSERT_TRUE(near(world[box].velocity(), Vec2{5, 0}, 0.01)) << "step " << i;
    }
}

TEST(Propagation, HoldsARevoluteJoint) {
    World world{{.gravity = {0, -10}, .settings = thesis2006()}};
    BodyDef def;
    def.shape = Box{1, 1};
    def.type = BodyType::Kinematic;
    const BodyId hook = world.add(def);
    def = {};
    def.position = {2, 0};
    const BodyId bob = world.add(def);
    RevoluteJoint pin;
    pin.ends.a = hook;
    pin.ends.b = bob;
    pin.ends.anchorB = {-2, 0};
    world.add(pin);
    for (int i = 0; i < 600; ++i) {
        world.step(kStep);
        ASSERT_TRUE(near(length(world[bob].position()), 2, 0.02));
    }
}

TEST(Propagation, AMovingPlatformCarriesAStackAlong) {
    World world{{.gravity = {0, -10}, .settings = propagation(4, 4)}};
    BodyDef def;
    def.shape = Box{10, 1};
    def.type = BodyType::Kinematic;
    def.velocity = {1, 0};
    world.add(def);
    def = {};
    def.shape = Box{1, 1};
    for (int i = 0; i < 5; ++i) {
        def.position = {0, Real(1 + i)};
        def.velocity = {1, 0};
        world.add(def);
    }
    for (int i = 0; i < 120; ++i) {
        world.step(kStep);
    }
    for (const BodyId id : world.bodies()) {
        EXPECT_TRUE(near(world[id].position().x, 2, 0.01));
    }
}

TEST(Propagation, ACopyContinuesWithTheSameBits) {
    for (const int shock : {0, 4}) {
        scenes::KodoScene scene = inKodo(strategies::circlePile(), propagation(6, shock));
        for (int i = 0; i < 60; ++i) {
            scene.world.step(kStep);
        }
        World copy = scene.world;
        for (int i = 0; i < 60; ++i) {
            scene.world.step(kStep);
            copy.step(kStep);
            ASSERT_EQ(scene.world.stateHash(), copy.stateHash()) << "step " << i;
        }
    }
}

TEST(Propagation, FrictionCanBeLeftOut) {
    StepSettings settings = thesis2006();
    settings.leaveOut = Feature::Friction;
    const scenes::KodoScene end = after(scenes::slidingBox(0.5), settings, 2);
    EXPECT_TRUE(near(end.world[end.ids[1]].velocity(), Vec2{5, 0}, 1e-4));
}

TEST(Propagation, RestitutionCanBeLeftOut) {
    StepSettings settings = thesis2006();
    settings.leaveOut = Feature::Restitution;
    const scenes::KodoScene end = after(scenes::bouncingBall(1), settings, 2);
    EXPECT_TRUE(near(end.world[end.ids[1]].position().y, 0.5, 0.002));
}

TEST(Propagation, RefusesPassesOutOfRange) {
    for (const auto& [contact, shock] : {std::pair{0, 0}, {1001, 0}, {10, -1}, {10, 1001}}) {
        StepSettings settings = propagation(contact, shock);
        EXPECT_TRUE(check(settings)) << contact << ", " << shock;
        World world;
        EXPECT_THROW(world.setSettings(settings), BadDefinition);
        EXPECT_EQ(world.settings(), StepSettings{});
    }
    EXPECT_FALSE(check(thesis2006()));
}

} // namespace
