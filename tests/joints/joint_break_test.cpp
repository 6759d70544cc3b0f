// SPDX-License-Identifier: MIT
#include <support/sleeping.hpp>

#include <joints/rig.hpp>

namespace kodo {
namespace {

using joints::Rig;
using support::ballDef;
using support::boxDef;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

// F1: a revolute joint holds a load 1 % below its breakForce and breaks under one 1 % above.
TEST(JointBreak, HappensAboveTheBreakForce) {
    for (const double share : {0.99, 1.01}) {
        Rig rig;
        const BodyId bob = rig.addBob({0, -2});
        const double weight = rig.weightOf(bob);
        const JointId pin =
            rig.world.add(RevoluteJoint{.ends = {.a = rig.post,
                                                 .b = bob,
                                                 .anchorB = {0, 2},
                                                 .breakForce = static_cast<Real>(share * weight)}});
        bool broke = false;
        for (int step = 0; step < 300; ++step) {
            rig.world.step(kDt);
            if (!rig.world.brokenJoints().empty()) {
                broke = true;
                ASSERT_EQ(rig.world.brokenJoints().size(), 1u);
                const BrokenJoint& broken = rig.world.brokenJoints()[0];
                EXPECT_EQ(broken.id, pin);
                EXPECT_EQ(broken.a, rig.post);
                EXPECT_EQ(broken.b, bob);
                EXPECT_TRUE(nearShare(broken.force, weight, 0.01));
            }
        }
        EXPECT_EQ(broke, share < 1);
        EXPECT_EQ(rig.world.contains(pin), share > 1);
        EXPECT_EQ(rig.world[bob].position().y < -3, share < 1);
        EXPECT_TRUE(rig.world.brokenJoints().empty()); // reported once
    }
}

// F1: a fixed joint breaks by the torque of its load.
TEST(JointBreak, HappensAboveTheBreakTorque) {
    for (const double share : {0.98, 1.02}) {
        Rig rig;
        const BodyId beam = rig.world.add(boxDef({1, 0}, 2, Real(0.25)));
        const double torque = rig.weightOf(beam); // 1 m
        const JointId weld =
            rig.world.add(FixedJoint{.ends = {.a = rig.post,
                                              .b = beam,
                                              .anchorB = {-1, 0},
                                              .breakTorque = static_cast<Real>(share * torque)}});
        run(rig.world, 300);
        EXPECT_EQ(rig.world.contains(weld), share > 1) << share;
        EXPECT_EQ(rig.world[beam].position().y < -1, share < 1) << share;
    }
}

/// A ball of 1 kg hits a door of 2 m at 0.3 m from its hinge. True if the hinge of 100 N holds.
bool hingeSurvives(Real speed) {
    Rig rig(Vec2{});
    const BodyId door = rig.world.add(boxDef({0, -1}, Real(0.2), 2));
    const JointId hinge = rig.world.add(
        RevoluteJoint{.ends = {.a = rig.post, .b = door, .anchorB = {0, 1}, .breakForce = 100}});
    BodyDef ball = ballDef({Real(-0.4), Real(-0.3)}, Real(0.2));
    ball.density = 8;
    ball.velocity = {speed, 0};
    rig.world.add(ball);
    run(rig.world, 60);
    EXPECT_GT(length(rig.world[door].velocity()), 0);
    return rig.world.contains(hinge);
}

// F1: the hinge breaks under a fast impact near it. It takes two thirds of the impulse: about 40 N,
// as mean over a step, per m/s.
TEST(JointBreak, AFastImpactBreaksAHinge) {
    EXPECT_TRUE(hingeSurvives(Real(0.5)));
    EXPECT_FALSE(hingeSurvives(8));
}

// After the break, the excluded pair collides again, and the id is refused.
TEST(JointBreak, LetsItsBodiesCollideAgain) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId lower = world.add(boxDef({3, Real(0.5)}, 1, 1));
    const BodyId upper = world.add(boxDef({3, Real(1.5)}, 1, 1));
    const JointId joint = world.add(
        RevoluteJoint{.ends = {.a = lower, .b = upper, .anchorA = {0, 1}, .breakForce = 15}});
    world.step(kDt);
    EXPECT_EQ(support::recordOf(world, lower, upper), nullptr);
    world[upper].applyForce({0, 40}); // enough to overload it
    world.step(kDt);
    ASSERT_EQ(world.brokenJoints().size(), 1u);
    EXPECT_THROW(world.jointForce(joint), BadDefinition);
    EXPECT_THROW(world.remove(joint), BadDefinition);
    run(world, 120);
    EXPECT_TRUE(near(world[upper].position().y, Real(1.5), Real(0.02)));
    EXPECT_TRUE(support::isAsleep(world, upper));
}

// F1: a chain breaks at its weakest joint only.
TEST(JointBreak, AChainBreaksAtItsWeakestJoint) {
    Rig rig;
    std::vector<JointId> pins;
    BodyId last = rig.post;
    for (int i = 0; i < 10; ++i) {
        const BodyId link = rig.addBob({0, Real(-0.5) * static_cast<Real>(i + 1)});
        pins.push_back(rig.world.add(
            RevoluteJoint{.ends = {.a = last, .b = link, .anchorB = {0, Real(0.5)}}}));
        last = link;
    }
    rig.settle(600);
    for (std::size_t i = 0; i < 10; ++i) {
        // Joint i carries 10 - i balls. Each breakForce is 10 % above that weight, except for the
        // fifth.
        const double load = static_cast<double>(10 - i) * rig.weightOf(last);
        RevoluteJoint pin = std::get<RevoluteJoint>(rig.world.joint(pins[i]));
        pin.ends.breakForce = static_cast<Real>((i == 4 ? 0.9 : 1.1) * load);
        rig.world.setJoint(pins[i], pin);
    }
    run(rig.world, 120);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(rig.world.contains(pins[i]), i != 4) << i;
    }
}

} // namespace
} // namespace kodo
