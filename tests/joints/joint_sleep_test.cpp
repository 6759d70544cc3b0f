// SPDX-License-Identifier: MIT
#include <support/sleeping.hpp>

#include <joints/rig.hpp>

namespace kodo {
namespace {

using joints::gapOf;
using joints::Rig;
using support::ballDef;
using support::boxDef;
using support::isAsleep;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

/// A ragdoll of six boxes with five limited hinges.
std::vector<BodyId> addMan(World& world, Vec2 place) {
    const auto limb = [&](Vec2 at, Real width, Real height) {
        return world.add(boxDef(place + at, width, height));
    };
    const BodyId trunk = limb({0, 0}, Real(0.4), 1);
    const BodyId head = limb({0, Real(0.7)}, Real(0.3), Real(0.3));
    const auto hinge = [&](BodyId b, Vec2 onTrunk, Vec2 onLimb) {
        world.add(RevoluteJoint{.ends = {.a = trunk, .b = b, .anchorA = onTrunk, .anchorB = onLimb},
                                .limits = Range{Real(-0.8), Real(0.8)}});
    };
    std::vector<BodyId> man{trunk, head};
    hinge(head, {0, Real(0.5)}, {0, Real(-0.2)});
    for (const Real side : {Real(-1), Real(1)}) {
        const BodyId arm = limb({side * Real(0.5), Real(0.4)}, Real(0.6), Real(0.2));
        hinge(arm, {side * Real(0.2), Real(0.4)}, {side * Real(-0.3), 0});
        const BodyId leg = limb({side * Real(0.12), Real(-0.95)}, Real(0.2), Real(0.9));
        hinge(leg, {side * Real(0.12), Real(-0.5)}, {0, Real(0.45)});
        man.push_back(arm);
        man.push_back(leg);
    }
    return man;
}

// F1, O3: jointed bodies fall asleep in the same step, and an impulse on one of them wakes all.
TEST(JointSleep, JointedBodiesFallAsleepAndWakeTogether) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> man = addMan(world, {3, 4});
    ASSERT_LE(support::stepsUntilAsleep(world, man[0], 3600), 3600);
    for (const BodyId id : man) {
        EXPECT_TRUE(isAsleep(world, id));
    }
    world.step(kDt);
    EXPECT_EQ(stepStats(world).bodies, 0u);
    world[man[5]].applyImpulse({0, Real(0.2)});
    world.step(kDt);
    for (const BodyId id : man) {
        EXPECT_FALSE(isAsleep(world, id));
    }
}

// F1, O3: a pendulum never falls asleep at a turning point, at any amplitude.
TEST(JointSleep, NeverBeginsAtTheTurningPointOfAPendulum) {
    for (const Real angle : {Real(1.5), Real(0.3), Real(0.05), Real(0.01)}) {
        Rig rig;
        BodyDef def = ballDef({}, Real(0.25));
        def.rotation = Rot::fromAngle(angle);
        def.position = def.rotation * Vec2{0, -2};
        const BodyId bob = rig.world.add(def);
        rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = bob, .anchorB = {0, 2}}});
        for (int step = 0; step < 600; ++step) {
            rig.world.step(kDt);
            ASSERT_FALSE(isAsleep(rig.world, bob)) << angle << ", step " << step;
        }
    }
}

// F1: a sleeping joint still reports its force.
TEST(JointSleep, KeepsTheReportedForce) {
    Rig rig;
    const BodyId bob = rig.addBob({0, -2});
    const JointId pin =
        rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = bob, .anchorB = {0, 2}}});
    ASSERT_LE(support::stepsUntilAsleep(rig.world, bob, 120), 120);
    run(rig.world, 60);
    EXPECT_TRUE(nearShare(rig.world.jointForce(pin).y, rig.weightOf(bob), 1e-3));
}

// O3: joints between sleeping bodies are not solved. Each is solved again once one of its bodies is
// active, even if that is only the post.
TEST(JointSleep, JointsOfSleepingBodiesAreNotSolved) {
    Rig rig;
    std::vector<BodyId> bobs;
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<Real>(i);
        bobs.push_back(rig.addBob({x, -2}));
        rig.world.add(RevoluteJoint{
            .ends = {.a = rig.post, .b = bobs.back(), .anchorA = {x, 0}, .anchorB = {0, 2}}});
    }
    rig.world.step(kDt);
    EXPECT_EQ(stepStats(rig.world).joints, 100u);
    run(rig.world, 240);
    ASSERT_EQ(stepStats(rig.world).bodies, 0u);
    EXPECT_EQ(stepStats(rig.world).joints, 0u);
    rig.world[bobs[70]].applyImpulse({Real(0.1), 0});
    rig.world.step(kDt);
    EXPECT_EQ(stepStats(rig.world).joints, 1u);
    rig.world.remove(bobs[70]);
    EXPECT_EQ(stepStats(rig.world).joints, 0u);
    rig.world[rig.post].setVelocity({Real(0.1), 0});
    rig.world.step(kDt);
    EXPECT_EQ(stepStats(rig.world).joints, 99u);
    EXPECT_EQ(stepStats(rig.world).bodies, 100u);
    run(rig.world, 10);
    for (const JointId id : rig.world.joints()) {
        EXPECT_LT(length(gapOf(rig.world, std::get<RevoluteJoint>(rig.world.joint(id)).ends)),
                  rig.world.tolerances().slop);
    }
}

// F1: a body driven by a motor stays awake while it moves.
TEST(JointSleep, AMotorKeepsItsBodyAwake) {
    Rig rig;
    const BodyId wheel = rig.addBob({});
    rig.world.add(RevoluteJoint{
        .ends = {.a = rig.post, .b = wheel}, .motorSpeed = Real(0.05), .motorTorque = 10});
    run(rig.world, 600);
    EXPECT_FALSE(isAsleep(rig.world, wheel));
    EXPECT_TRUE(nearShare(rig.world[wheel].rotation().angle(), 0.5, 0.01));
}

} // namespace
} // namespace kodo
