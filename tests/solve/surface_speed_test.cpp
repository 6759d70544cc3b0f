// SPDX-License-Identifier: MIT
// Surfaces that move along themselves, as belts do.
#include <kodo/snapshot.hpp>
#include <support/sleeping.hpp>
#include <support/solver.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::kDt;
using support::near;

Material beltOf(Real speed, Real friction) {
    Material material = withFriction(friction);
    material.surfaceSpeed = speed;
    return material;
}

WorldDef worldOf(support::Solver solver) {
    return {.gravity = support::kEarth, .settings = support::settingsOf(solver)};
}

struct Conveyed {
    World world;
    BodyId crate;
};

/// A flat crate on a belt. The friction of the contact is 0.3.
Conveyed crateOnBelt(support::Solver solver, Real speed, bool beltFirst, Real angle = 0) {
    World world(worldOf(solver));
    const Rot rotation = Rot::fromAngle(angle);
    const Vec2 up = rotation.yAxis();
    BodyDef crate = support::boxDef(Real(0.25) * up, 1, Real(0.5), withFriction(Real(0.3)));
    crate.rotation = rotation;
    const BodyDef belt{.shape = Box{2000, 1},
                       .position = Real(-0.5) * up,
                       .rotation = rotation,
                       .material = beltOf(speed, Real(0.3)),
                       .type = BodyType::Static};
    BodyId id;
    if (beltFirst) {
        world.add(belt);
        id = world.add(crate);
    } else {
        id = world.add(crate);
        world.add(belt);
    }
    return {std::move(world), id};
}

// v = mu g t up to the speed of the belt. A step more or less, since the crate settles first.
TEST(SurfaceSpeed, BringsACrateToTheSpeedOfTheBeltByFriction) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real speed : {Real(3), Real(-3)}) {
            for (const bool beltFirst : {true, false}) {
                auto [world, crate] = crateOnBelt(solver, speed, beltFirst);
                const Real sign = std::copysign(Real(1), speed);
                support::run(world, 30);
                EXPECT_TRUE(near(sign * world[crate].velocity().x, 1.5, 0.06))
                    << speed << ", belt first: " << beltFirst;
                support::run(world, 60);
                EXPECT_TRUE(near(world[crate].velocity().x, speed, 1e-3)) << speed;
                support::run(world, 60);
                EXPECT_TRUE(near(world[crate].velocity().x, speed, 1e-3)) << speed;
                EXPECT_TRUE(near(world[crate].position().y, 0.25, 0.005));
            }
        }
    }
}

// Uphill: a = g (mu cos - sin), against a slope of tan 0.1.
TEST(SurfaceSpeed, CarriesACrateUphill) {
    const Real angle = std::atan(Real(0.1));
    const Real acceleration = 10 * (Real(0.3) * std::cos(angle) - std::sin(angle));
    for (const support::Solver solver : support::kSolvers) {
        auto [world, crate] = crateOnBelt(solver, 3, true, angle);
        const Vec2 along = Rot::fromAngle(angle) * Vec2{1, 0};
        support::run(world, 60);
        EXPECT_TRUE(near(dot(along, world[crate].velocity()), acceleration, 0.06));
        support::run(world, 90);
        EXPECT_TRUE(near(dot(along, world[crate].velocity()), 3, 0.01));
    }
}

// The surface runs clockwise around the body, so below it to the left: the body drives to the
// right, and two surfaces of equal speeds that face each other add up.
TEST(SurfaceSpeed, DrivesTheBodyThatHasIt) {
    for (const support::Solver solver : support::kSolvers) {
        World world(worldOf(solver));
        support::addFloor(world, beltOf(1, Real(0.6)));
        const BodyId tank =
            world.add(support::boxDef({0, Real(0.25)}, 1, Real(0.5), beltOf(2, Real(0.6))));
        support::run(world, 120);
        EXPECT_TRUE(near(world[tank].velocity().x, 3, 1e-3));
    }
}

// A loose plank with a belt and the crate on it move against each other at the speed of the belt,
// and their momentum stays 0: 3 kg and 1 kg take 1/4 and 3/4 of 2 m/s.
TEST(SurfaceSpeed, ConservesMomentum) {
    for (const support::Solver solver : support::kSolvers) {
        World world(worldOf(solver));
        support::addFloor(world, support::slippery());
        const BodyId plank =
            world.add(support::boxDef({0, Real(0.125)}, 12, Real(0.25), beltOf(2, Real(0.5))));
        const BodyId crate =
            world.add(support::boxDef({0, Real(0.75)}, 1, 1, beltOf(0, Real(0.5))));
        support::run(world, 60);
        EXPECT_TRUE(near(world[crate].velocity().x, 1.5, 0.005));
        EXPECT_TRUE(near(world[plank].velocity().x, -0.5, 0.005));
    }
}

// A disc that falls upright on a belt of speed s is, as seen from the belt, one of speed -s: after
// an impact that makes it roll it has s / 3, and spins by 2 s / 3 counter-clockwise.
TEST(SurfaceSpeed, TurnsADiscInAnImpact) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.settings = support::settingsOf(solver)});
        Material rubber = withFriction(1, Real(0.5));
        const BodyId disc = world.add(support::ballDef({0, 2}, 1, rubber));
        rubber.surfaceSpeed = 3;
        support::addFloor(world, rubber);
        world[disc].setVelocity({0, -2});
        for (int step = 0; step < 120 && world[disc].velocity().y < 0; ++step) {
            world.step(kDt);
        }
        EXPECT_TRUE(near(world[disc].velocity().y, 1, 1e-3));
        EXPECT_TRUE(near(world[disc].velocity().x, 1, 1e-3));
        EXPECT_TRUE(near(world[disc].angularVelocity(), 2, 1e-3));
    }
}

// As above, where two contacts share the impact: halves of the belt that meet below the disc.
TEST(SurfaceSpeed, TurnsADiscInASimultaneousImpact) {
    World world;
    Material rubber = withFriction(1, Real(0.5));
    const BodyId disc = world.add(support::ballDef({0, 2}, 1, rubber));
    rubber.surfaceSpeed = 3;
    for (const Real x : {Real(-10), Real(10)}) {
        world.add({.shape = Box{20, 1},
                   .position = {x, Real(-0.5)},
                   .material = rubber,
                   .type = BodyType::Static});
    }
    world[disc].setVelocity({0, -2});
    for (int step = 0; step < 120 && world[disc].velocity().y < 0; ++step) {
        world.step(kDt);
    }
    EXPECT_TRUE(near(world[disc].velocity().y, 1, 1e-3));
    EXPECT_TRUE(near(world[disc].velocity().x, 1, 1e-3));
}

TEST(SurfaceSpeed, HasNoEffectWithoutFriction) {
    for (const support::Solver solver : support::kSolvers) {
        WorldDef def = worldOf(solver);
        def.settings.leaveOut = Feature::Friction;
        World world(def);
        support::addFloor(world, beltOf(3, Real(0.6)));
        const BodyId crate = world.add(support::boxDef({0, Real(0.25)}, 1, Real(0.5)));
        support::run(world, 30);
        EXPECT_EQ(world[crate].velocity().x, 0);
    }
}

// Rolling resistance off and a belt on, and both: each brakes or drives as it does alone.
TEST(SurfaceSpeed, ActsBesideRollingResistanceAndWithoutIt) {
    for (const Features leaveOut : {Features{}, Features{Feature::RollingResistance}}) {
        WorldDef def = support::withoutSleep();
        def.settings.leaveOut = def.settings.leaveOut | leaveOut;
        World world(def);
        support::addFloor(world, beltOf(3, Real(0.6)));
        Material soft = withFriction(Real(0.6));
        soft.rollingResistance = Real(0.5);
        const BodyId ball = world.add(support::ballDef({0, Real(0.5)}, Real(0.5), soft));
        support::run(world, 240);
        const bool rolls = leaveOut == Features{Feature::RollingResistance};
        EXPECT_TRUE(near(world[ball].velocity().x, rolls ? 1 : 3, 0.02));
    }
}

// A crate that a stop holds back on a belt is at rest, and stays awake as long as the belt runs.
TEST(SurfaceSpeed, KeepsWhatTouchesItAwake) {
    for (const support::Solver solver : support::kSolvers) {
        World world(worldOf(solver));
        const BodyId belt = support::addFloor(world, beltOf(1, Real(0.3)));
        support::addWall(world, Real(0.75), 1, {});
        const BodyId crate = world.add(support::boxDef({0, Real(0.25)}, 1, Real(0.5)));
        const BodyId upper = world.add(support::boxDef({0, Real(0.75)}, 1, Real(0.5)));
        support::run(world, 600);
        EXPECT_FALSE(support::isAsleep(world, crate));
        EXPECT_FALSE(support::isAsleep(world, upper));
        world[belt].setMaterial(withFriction(Real(0.3)));
        EXPECT_LE(support::stepsUntilAsleep(world, upper, 600), 600);
        world[belt].setMaterial(beltOf(-1, Real(0.3)));
        support::run(world, 60);
        EXPECT_LT(world[crate].velocity().x, Real(-0.9)); // woken, and carried away
    }
}

TEST(SurfaceSpeed, ContinuesFromASnapshotAndCountsInTheHash) {
    for (const support::Solver solver : support::kSolvers) {
        auto [world, crate] = crateOnBelt(solver, 3, true);
        auto [still, other] = crateOnBelt(solver, 0, true);
        EXPECT_NE(world.stateHash(), still.stateHash());
        support::run(world, 20);
        World restored = fromBytes(toBytes(world));
        support::run(world, 60);
        support::run(restored, 60);
        EXPECT_EQ(world.stateHash(), restored.stateHash());
        EXPECT_GT(restored[crate].velocity().x, Real(2.9));
    }
}

} // namespace
} // namespace kodo
