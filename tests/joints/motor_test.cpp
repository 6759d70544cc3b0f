// SPDX-License-Identifier: MIT
#include <joints/rig.hpp>

namespace kodo {
namespace {

using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

// F1: the joint drives the body to its target pose and holds it there.
TEST(MotorJoint, DrivesToItsTargetPose) {
    Rig rig(Vec2{});
    const BodyId box = rig.world.add(support::boxDef({4, 1}, 1, 1));
    const JointId motor =
        rig.world.add(MotorJoint{.ends = {.a = rig.post, .b = box, .anchorA = {1, 2}},
                                 .reference = 1,
                                 .force = 50,
                                 .torque = 20,
                                 .hertz = 2});
    run(rig.world, 300);
    EXPECT_TRUE(near(rig.world[box].position(), Vec2{1, 2}, Real(1e-3)));
    EXPECT_TRUE(near(rig.world[box].rotation().angle(), 1, Real(1e-3)));
    EXPECT_TRUE(near(length(rig.world.jointForce(motor)), 0, Real(0.01)));
}

// F1: force and torque are limited. Far from the target the full force acts: a = F / m.
TEST(MotorJoint, IsLimitedByItsForceAndTorque) {
    Rig rig(Vec2{});
    const BodyId box = rig.world.add(support::boxDef({100, 0}, 1, 1));
    const JointId motor = rig.world.add(MotorJoint{
        .ends = {.a = rig.post, .b = box}, .reference = 3, .force = 4, .torque = Real(0.25)});
    run(rig.world, 60);
    EXPECT_TRUE(near(rig.world[box].velocity(), Vec2{-4, 0}, byPrecision(1e-4, 1e-10)));
    EXPECT_TRUE(near(rig.world.jointForce(motor), Vec2{-4, 0}, byPrecision(1e-4, 1e-10)));
    EXPECT_TRUE(near(rig.world[box].angularVelocity(), 1.5, byPrecision(1e-5, 1e-10)));
    EXPECT_TRUE(near(rig.world.jointTorque(motor), 0.25, byPrecision(1e-6, 1e-10)));
}

// F1: a sufficient force limit holds a weight, and the joint force equals it.
TEST(MotorJoint, HoldsAWeightBelowItsForce) {
    for (const double share : {0.9, 1.1}) {
        Rig rig;
        const BodyId bob = rig.addBob({});
        const double weight = rig.weightOf(bob);
        const JointId motor = rig.world.add(MotorJoint{.ends = {.a = rig.post, .b = bob},
                                                       .force = static_cast<Real>(share * weight)});
        run(rig.world, 120);
        if (share > 1) {
            EXPECT_TRUE(near(rig.world[bob].position(), Vec2{}, Real(2e-3)));
            EXPECT_TRUE(nearShare(rig.world.jointForce(motor).y, weight, 1e-3));
        } else {
            EXPECT_LT(rig.world[bob].position().y, -1); // a = g / 10 for 2 s
        }
    }
}

/// A cart with two driven wheels.
struct Cart {
    World world{{.gravity = support::kEarth}};
    BodyId chassis;
    BodyId wheels[2];
    JointId axles[2];

    explicit Cart(Real torque) {
        support::addFloor(world, withFriction(1));
        chassis = world.add(support::boxDef({0, Real(0.6)}, 2, Real(0.4)));
        for (const int i : {0, 1}) {
            const Real x = i == 0 ? Real(-0.8) : Real(0.8);
            wheels[i] = world.add(support::ballDef({x, Real(0.4)}, Real(0.4), withFriction(1)));
            axles[i] = world.add(
                RevoluteJoint{.ends = {.a = chassis, .b = wheels[i], .anchorA = {x, Real(-0.2)}},
                              .motorSpeed = -10,
                              .motorTorque = torque});
        }
    }
};

// F1: a driven wheel rolls without slipping, v = w r, up to the motor speed relative to the
// chassis.
TEST(RevoluteJoint, MotorWheelsDriveACart) {
    Cart cart(Real(1));
    run(cart.world, 600);
    const Real speed = cart.world[cart.chassis].velocity().x;
    const Real spin = cart.world[cart.wheels[0]].angularVelocity();
    EXPECT_TRUE(nearShare(spin, -10, 0.01));
    EXPECT_TRUE(nearShare(speed, Real(0.4) * 10, 0.01));
    EXPECT_GT(cart.world[cart.chassis].position().x, 10);
    EXPECT_TRUE(near(cart.world[cart.chassis].rotation().s, 0, Real(0.01)));
}

// F1: during acceleration, F = 2 T / r moves the cart and spins its wheels: a = F / (m + 2 I /
// r^2).
TEST(RevoluteJoint, MotorWheelsAccelerateACartByTheirTorque) {
    Cart cart(Real(0.5));
    run(cart.world, 30); // it settles on its wheels first
    const Real before = cart.world[cart.chassis].velocity().x;
    run(cart.world, 30);
    const Real gained = cart.world[cart.chassis].velocity().x - before;
    const double r = 0.4;
    const double wheel = static_cast<double>(cart.world[cart.wheels[0]].mass());
    const double inertia = static_cast<double>(cart.world[cart.wheels[0]].inertia());
    const double mass = static_cast<double>(cart.world[cart.chassis].mass()) + 2 * wheel;
    const double a = 2 * 0.5 / r / (mass + 2 * inertia / (r * r));
    EXPECT_TRUE(nearShare(gained, a / 2, 0.02));
}

} // namespace
} // namespace kodo
