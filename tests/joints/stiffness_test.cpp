// SPDX-License-Identifier: MIT
// Springs given in N/m and N m/rad.
#include <support/solver.hpp>

#include <joints/rig.hpp>

#include <cmath>
#include <numbers>

namespace kodo {
namespace {

using support::kDt;
using support::nearShare;
using support::run;
using support::settingsOf;

constexpr double kTwoPi = 2 * std::numbers::pi;

// A weight stretches a spring by m g / k, whatever the lever of its anchor.
TEST(SpringOf, AWeightStretchesByItsForcePerStiffness) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real stiffness : {Real(100), Real(2000)}) {
            World world({.gravity = {0, -10}, .settings = settingsOf(solver)});
            const BodyId hook = world.add({.type = BodyType::Static});
            const BodyId weight =
                world.add({.shape = Box{2, 1}, .position = {0, -3}, .density = 4}); // 8 kg
            DistanceJoint joint{.ends = {.a = hook, .b = weight}, .length = 3};
            const Spring spring = springOf(world, joint, stiffness, 60);
            joint.hertz = spring.hertz;
            joint.damping = spring.damping;
            world.add(joint);
            run(world, 600);
            const double stretch = -3 - static_cast<double>(world[weight].position().y);
            EXPECT_TRUE(nearShare(stretch, 8 * 10 / static_cast<double>(stiffness), 0.01));
        }
    }
}

// Two bodies vibrate with their reduced mass m1 m2 / (m1 + m2): half a period reverses the speed.
TEST(SpringOf, TwoBodiesHaveThePeriodOfTheirReducedMass) {
    World world;
    const BodyId a = world.add({.shape = Box{1, 1}, .mass = MassDef{2, {}, {}}});
    const BodyId b =
        world.add({.shape = Box{1, 1}, .position = {3, 0}, .mass = MassDef{6, {}, {}}});
    PrismaticJoint joint{.ends = {.a = a, .b = b}, .target = 3};
    const Spring spring = springOf(world, joint, 24); // reduced mass 1.5 kg: omega = 4 rad/s
    EXPECT_TRUE(nearShare(static_cast<double>(spring.hertz), 4 / kTwoPi, 1e-5));
    EXPECT_EQ(spring.damping, 0);
    joint.hertz = spring.hertz;
    world.add(joint);
    world[a].setVelocity({-3, 0});
    world[b].setVelocity({1, 0});
    run(world, static_cast<int>(kTwoPi / 4 / 2 * 60 + 0.5));
    EXPECT_NEAR(world[b].velocity().x, -1, Real(0.05));
}

// A torsion spring balances the torque k * angle. A critical damper has 2 sqrt(k I).
TEST(SpringOf, ATorsionSpringTurnsByTorquePerStiffness) {
    World world;
    const BodyId base = world.add({.type = BodyType::Static});
    const BodyId door = world.add({.shape = Box{2, Real(0.2)}, .position = {1, 0}});
    RevoluteJoint joint{.ends = {.a = base, .b = door, .anchorB = {-1, 0}}};
    const double inertia = static_cast<double>(world[door].inertia() + world[door].mass());
    const Spring spring = springOf(world, joint, 5, static_cast<Real>(2 * std::sqrt(5 * inertia)));
    EXPECT_TRUE(nearShare(static_cast<double>(spring.damping), 1, 1e-5));
    joint.hertz = spring.hertz;
    joint.damping = spring.damping;
    const JointId id = world.add(joint);
    for (int i = 0; i < 600; ++i) {
        world[door].applyTorque(2);
        world.step(kDt);
    }
    EXPECT_TRUE(nearShare(static_cast<double>(world.jointState(id).angle), 2.0 / 5, 0.01));
}

TEST(SpringOf, RefusesWhatHasNoSpring) {
    World world;
    const BodyId a = world.add({.type = BodyType::Static});
    const BodyId b = world.add({.type = BodyType::Static});
    const BodyId c = world.add({});
    EXPECT_THROW(springOf(world, DistanceJoint{.ends = {.a = a, .b = b}}, 1), BadDefinition);
    EXPECT_THROW(springOf(world, DistanceJoint{.ends = {.a = a, .b = c}}, 0), BadDefinition);
    EXPECT_THROW(springOf(world, DistanceJoint{.ends = {.a = a, .b = c}}, 1, -1), BadDefinition);
    EXPECT_THROW(springOf(world, PulleyJoint{.ends = {.a = a, .b = c}}, 1), BadDefinition);
    EXPECT_THROW(springOf(world, MouseJoint{.body = c}, 1), BadDefinition);
    EXPECT_THROW(springOf(world, DistanceJoint{.ends = {.a = a}}, 1), BadBodyId);
}

} // namespace
} // namespace kodo
