// SPDX-License-Identifier: MIT
// The wheel joint: axle on a line, suspension, limits, motor.
#include <support/solver.hpp>

#include <joints/rig.hpp>

#include <cmath>

namespace kodo {
namespace {

using joints::kG;
using joints::kPi;
using joints::Rig;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;
using support::settingsOf;

// F1: without a spring the axle slides along its line, also an inclined one, and the wheel rotates
// freely: a groove. The joint carries m g cos.
TEST(WheelJoint, SlidesAlongItsLineAndRotatesFreely) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig(support::kEarth, settingsOf(solver));
        const BodyId pin = rig.addBob({0, 0});
        const Vec2 axis{Real(0.8), Real(0.6)};
        const JointId groove =
            rig.world.add(WheelJoint{.ends = {.a = rig.post, .b = pin}, .axis = axis});
        rig.world[pin].setAngularVelocity(3);
        run(rig.world, 60);
        const JointState state = rig.world.jointState(groove);
        // A substep moves with the velocity at its end, which adds a share of h / t.
        EXPECT_TRUE(nearShare(state.translation, -kG * 0.6 / 2, 0.02));
        EXPECT_TRUE(nearShare(state.speed, -kG * 0.6, 1e-3));
        EXPECT_TRUE(near(dot(perp(axis), rig.world[pin].position()), 0, Real(1e-4)));
        EXPECT_TRUE(near(state.angularSpeed, 3, Real(1e-4)));
        EXPECT_TRUE(nearShare(length(rig.world.jointForce(groove)), 0.8 * rig.weightOf(pin), 1e-3));
    }
}

// F1: a car on two wheels sinks by g / omega^2 of its share of the load, and stays level.
TEST(WheelJoint, ACarRestsOnItsSuspension) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = settingsOf(solver)});
        support::addFloor(world);
        const BodyId body = world.add(support::boxDef({0, 1}, 3, Real(0.5)));
        std::vector<JointId> axles;
        for (const Real x : {Real(-1), Real(1)}) {
            const BodyId wheel = world.add(support::ballDef({x, Real(0.4)}, Real(0.4)));
            axles.push_back(
                world.add(WheelJoint{.ends = {.a = body, .b = wheel, .anchorA = {x, Real(-0.6)}},
                                     .hertz = 4,
                                     .damping = Real(0.7)}));
        }
        run(world, 300);
        const auto wheelMass = static_cast<double>(world[world.bodies()[2]].mass());
        const auto mass = static_cast<double>(world[body].mass());
        // Stiffness is that of the reduced mass of body and wheel; a wheel carries half of the
        // body.
        const double stiffness = 64 * kPi * kPi * mass * wheelMass / (mass + wheelMass);
        // Propagation solves contacts after springs; what they give back stretches springs by 2 %.
        const double share = solver == support::Solver::Soft ? 1e-3 : 0.025;
        for (const JointId axle : axles) {
            EXPECT_TRUE(
                nearShare(world.jointState(axle).translation, mass * kG / 2 / stiffness, share));
        }
        EXPECT_TRUE(near(world[body].rotation().s, 0, Real(1e-3)));
    }
}

// F1: limits stop the axle and hold the load.
TEST(WheelJoint, StopsAtItsLimits) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig(support::kEarth, settingsOf(solver));
        const BodyId load = rig.addBob({0, 0});
        const JointId wheel = rig.world.add(
            WheelJoint{.ends = {.a = rig.post, .b = load}, .limits = Range{-1, Real(0.5)}});
        Real lowest = 0;
        for (int step = 0; step < 240; ++step) {
            rig.world.step(kDt);
            lowest = std::min(lowest, rig.world.jointState(wheel).translation);
        }
        EXPECT_TRUE(near(lowest, -1, Real(0.006)));
        EXPECT_TRUE(near(rig.world.jointState(wheel).translation, -1, Real(2e-3)));
        EXPECT_TRUE(nearShare(rig.world.jointForce(wheel).y, rig.weightOf(load), 0.01));
    }
}

// F1: the motor reaches its speed with its torque: w = T t / I, and reacts on the other body.
TEST(WheelJoint, AMotorAcceleratesByItsTorqueUpToItsSpeed) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.settings = settingsOf(solver)});
        const BodyId body = world.add(support::boxDef({0, 0}, 2, 1));
        const BodyId wheel = world.add(support::ballDef({0, -1}, Real(0.5)));
        const Real inertia = world[wheel].inertia();
        const JointId axle =
            world.add(WheelJoint{.ends = {.a = body, .b = wheel, .anchorA = {0, -1}},
                                 .hertz = 4,
                                 .damping = 1,
                                 .motorSpeed = -9,
                                 .motorTorque = 4 * inertia});
        run(world, 60);
        EXPECT_TRUE(nearShare(world[wheel].angularVelocity(), -4, 1e-3));
        run(world, 180);
        EXPECT_TRUE(nearShare(world.jointState(axle).angularSpeed, -9, 1e-3));
        EXPECT_TRUE(near(support::totalsOf(world).spin, 0, 1e-4L));
    }
}

// F1: bodies of a wheel joint collide only if asked.
TEST(WheelJoint, ItsBodiesCollideOnlyIfAsked) {
    for (const bool collide : {false, true}) {
        World world;
        const BodyId body = world.add(support::boxDef({0, 0}, 2, 1));
        const BodyId wheel = world.add(support::ballDef({0, Real(-0.9)}, Real(0.5)));
        world.add(WheelJoint{
            .ends = {.a = body, .b = wheel, .anchorA = {0, Real(-0.9)}, .collide = collide}});
        run(world, 60);
        const Real gap = world[body].position().y - world[wheel].position().y;
        EXPECT_EQ(gap > Real(0.95), collide);
    }
}

// F1: the joint breaks above its force, and its torque is that of the motor.
TEST(WheelJoint, BreaksAboveItsForce) {
    for (const double share : {0.98, 1.02}) {
        Rig rig;
        const BodyId load = rig.addBob({0, 0});
        const JointId wheel = rig.world.add(
            WheelJoint{.ends = {.a = rig.post,
                                .b = load,
                                .breakForce = static_cast<Real>(share * rig.weightOf(load))},
                       .axis = {1, 0},
                       .hertz = 1});
        run(rig.world, 120);
        EXPECT_EQ(rig.world.contains(wheel), share > 1);
    }
}

// F1: energy is kept while a car body of any mass bounces on its springs.
TEST(WheelJoint, AnUndampedSuspensionGainsNoEnergy) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double hertz : {1.0, 8.0, 300.0}) {
            StepSettings settings = settingsOf(solver);
            settings.leaveOut = Feature::Sleep;
            World world({.settings = settings});
            const BodyId body = world.add(support::boxDef({0, 0}, 3, Real(0.5)));
            for (const Real x : {Real(-1), Real(1)}) {
                const BodyId wheel = world.add(support::ballDef({x, -1}, Real(0.3)));
                world.add(WheelJoint{.ends = {.a = body, .b = wheel, .anchorA = {x, -1}},
                                     .hertz = static_cast<Real>(hertz)});
            }
            world[body].setAngularVelocity(1);
            world[body].setVelocity({0, Real(0.5)});
            for (const JointId axle : world.joints()) {
                world[secondBody(world.joint(axle))].setVelocity({0, Real(-0.5)});
            }
            const auto start = static_cast<double>(support::totalsOf(world).kinetic);
            const support::Totals before = support::totalsOf(world);
            for (int step = 0; step < 1200; ++step) {
                world.step(kDt);
                ASSERT_LT(static_cast<double>(support::totalsOf(world).kinetic), 1.01 * start)
                    << hertz << " Hz, step " << step;
            }
            // Propagation removes errors by displacements, which have no momentum.
            const long double spin = support::totalsOf(world).spin;
            EXPECT_LT(spin, before.spin + 1e-3L);
            EXPECT_GT(spin, before.spin * (solver == support::Solver::Soft ? 0.999L : 0.9L));
        }
    }
}

} // namespace
} // namespace kodo
