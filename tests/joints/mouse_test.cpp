// SPDX-License-Identifier: MIT
#include <support/sleeping.hpp>

#include <joints/rig.hpp>

namespace kodo {
namespace {

using joints::kG;
using joints::kPi;
using joints::Rig;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

// F1: the joint pulls its anchor to the target. Under gravity the anchor hangs g / (2 pi f)^2
// below.
TEST(MouseJoint, PullsItsAnchorToTheTarget) {
    Rig rig;
    const BodyId box = rig.world.add(support::boxDef({0, 0}, 2, 1));
    const JointId hand =
        rig.world.add(MouseJoint{.body = box, .anchor = {1, 0}, .target = {3, 5}, .force = 500});
    rig.settle(900);
    const double sag = kG / std::pow(2 * kPi * 5, 2);
    const Vec2 grabbed = joints::placeOf(rig.world, box, {1, 0});
    EXPECT_TRUE(near(grabbed, Vec2{3, static_cast<Real>(5 - sag)}, Real(2e-3)));
    EXPECT_TRUE(near(rig.world[box].center().x, 3, Real(0.05))); // hangs straight down
    EXPECT_TRUE(nearShare(rig.world.jointForce(hand).y, rig.weightOf(box), 1e-2));
}

// F1: the force is limited: it cannot lift a larger weight.
TEST(MouseJoint, CannotLiftAWeightAboveItsForce) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({3, Real(0.5)}, 1, 1)); // 10 N
    world.add(MouseJoint{.body = box, .target = {3, 5}, .force = 9});
    run(world, 120);
    EXPECT_TRUE(near(world[box].position(), Vec2{3, Real(0.5)}, Real(0.01)));
}

TEST(MouseJoint, ANewTargetWakesItsBody) {
    Rig rig;
    const BodyId box = rig.world.add(support::boxDef({0, 0}, 1, 1));
    const JointId hand =
        rig.world.add(MouseJoint{.body = box, .target = {0, 0}, .force = 500, .damping = 1});
    ASSERT_LE(support::stepsUntilAsleep(rig.world, box, 900), 900);
    MouseJoint moved = std::get<MouseJoint>(rig.world.joint(hand));
    moved.target = {2, 0};
    rig.world.setJoint(hand, moved);
    run(rig.world, 120);
    EXPECT_TRUE(near(rig.world[box].position().x, 2, Real(0.01)));
    rig.world.remove(hand); // removal wakes it as well
    run(rig.world, 30);
    EXPECT_LT(rig.world[box].position().y, -1);
}

} // namespace
} // namespace kodo
