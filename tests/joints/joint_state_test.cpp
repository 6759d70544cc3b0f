// SPDX-License-Identifier: MIT
// What a joint tells: state, user data, the joints of a body; and changes of one number.
#include <joints/rig.hpp>

namespace kodo {
namespace {

using joints::Rig;
using support::kDt;
using support::near;
using support::run;

// F1: angle, length and translation of a joint, and their speeds, are those of its bodies.
TEST(JointState, IsThatOfTheBodies) {
    World world;
    const BodyId a = world.add(support::boxDef({1, 2}, 1, 1));
    const BodyId b = world.add({.shape = Box{1, 1},
                                .position = {4, 6},
                                .rotation = Rot::fromAngle(1),
                                .velocity = {3, 4},
                                .angularVelocity = 2});
    const JointEnds ends{.a = a, .b = b};
    const JointState slider = world.jointState(world.add(
        PrismaticJoint{.ends = ends, .axis = {Real(0.8), Real(0.6)}, .reference = Real(0.25)}));
    EXPECT_EQ(slider.anchorA, (Vec2{1, 2}));
    EXPECT_EQ(slider.anchorB, (Vec2{4, 6}));
    EXPECT_TRUE(near(slider.angle, Real(0.75), Real(1e-6)));
    EXPECT_EQ(slider.angularSpeed, 2);
    EXPECT_TRUE(near(slider.length, 5, Real(1e-6)));
    EXPECT_TRUE(near(slider.lengthSpeed, 5, Real(1e-6)));
    EXPECT_TRUE(near(slider.translation, Real(4.8), Real(1e-6)));
    EXPECT_TRUE(near(slider.speed, Real(4.8), Real(1e-6)));

    const JointState pulley =
        world.jointState(world.add(PulleyJoint{ends, {1, 5}, {4, 16}, 100, 2}));
    EXPECT_TRUE(near(pulley.length, 3 + 2 * 10, Real(1e-5)));
    EXPECT_TRUE(near(pulley.lengthSpeed, -2 * 4, Real(1e-5)));
    const JointState mouse =
        world.jointState(world.add(MouseJoint{.body = b, .target = {4, 9}, .force = 1}));
    EXPECT_EQ(mouse.anchorA, (Vec2{4, 9}));
    EXPECT_TRUE(near(mouse.lengthSpeed, -4, Real(1e-6)));
}

// F1: the speeds are the rates of change of angle, length and translation, also about a body that
// rotates.
TEST(JointState, SpeedsAreRatesOfChange) {
    World world;
    const BodyId a = world.add(support::boxDef({0, 0}, 1, 1));
    const BodyId b = world.add(support::ballDef({2, 1}, Real(0.25)));
    world[a].setAngularVelocity(Real(0.7));
    world[b].setVelocity({1, 2});
    world[b].setAngularVelocity(-1);
    // hertz 0 and the smallest force: the joint changes nothing that is measured
    const JointId joint =
        world.add(WheelJoint{.ends = {.a = a, .b = b}, .axis = normalize(Vec2{2, 1})});
    const Real dt = Real(1e-3);
    world.step(dt);
    const JointState before = world.jointState(joint);
    world.step(dt);
    const JointState after = world.jointState(joint);
    EXPECT_TRUE(near((after.angle - before.angle) / dt, after.angularSpeed, Real(0.01)));
    EXPECT_TRUE(near((after.length - before.length) / dt, after.lengthSpeed, Real(0.01)));
    EXPECT_TRUE(near((after.translation - before.translation) / dt, after.speed, Real(0.01)));
}

// F1: the joints of a body are listed in the order of their ids, with their user data.
TEST(JointState, ABodyListsItsJoints) {
    Rig rig;
    const BodyId one = rig.addBob({0, -1});
    const BodyId other = rig.addBob({0, -2});
    JointEnds ends{.a = rig.post, .b = one};
    ends.userData = 42;
    const JointId first = rig.world.add(RevoluteJoint{.ends = ends});
    const JointId second = rig.world.add(FilterJoint{.ends = {.a = other, .b = one}});
    const JointId third = rig.world.add(MouseJoint{.body = other, .force = 1, .userData = 7});
    EXPECT_EQ(rig.world.joints(one), (std::vector<JointId>{first, second}));
    EXPECT_EQ(rig.world.joints(other), (std::vector<JointId>{second, third}));
    EXPECT_EQ(std::get<RevoluteJoint>(rig.world.joint(first)).ends.userData, 42u);
    EXPECT_EQ(std::get<MouseJoint>(rig.world.joint(third)).userData, 7u);
    rig.world.remove(second);
    EXPECT_EQ(rig.world.joints(one), std::vector<JointId>{first});
    rig.world.remove(one);
    EXPECT_THROW((void)rig.world.joints(one), BadBodyId);
    EXPECT_TRUE(rig.world.joints(rig.post).empty());
}

// F1: user data counts in the hash of the state, and is in a snapshot.
TEST(JointState, UserDataIsState) {
    Rig rig;
    const JointId pin =
        rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = rig.addBob({0, -1})}});
    const std::uint64_t plain = rig.world.stateHash();
    rig.world.changeJoint<RevoluteJoint>(pin, [](auto& joint) { joint.ends.userData = 1; });
    EXPECT_NE(rig.world.stateHash(), plain);
    const World read = fromBytes(toBytes(rig.world));
    EXPECT_EQ(std::get<RevoluteJoint>(read.joint(pin)).ends.userData, 1u);
    rig.world.changeJoint<RevoluteJoint>(pin, [](auto& joint) { joint.ends.userData = 0; });
    EXPECT_EQ(rig.world.stateHash(), plain);
}

// F1: after a weld, axis and rack of a joint have the same direction in the world.
TEST(JointState, AxisAndRackKeepTheirDirectionInAWeld) {
    World world;
    const BodyId base = world.add(support::boxDef({0, 0}, 1, 1));
    const BodyId rail =
        world.add({.shape = Box{1, 1}, .position = {1, 0}, .rotation = Rot::fromAngle(Real(0.5))});
    const BodyId wheel = world.add(support::ballDef({4, 0}, Real(0.5)));
    const JointEnds ends{.a = rail, .b = wheel};
    const JointId axle = world.add(WheelJoint{.ends = ends, .axis = {1, 0}});
    const JointId teeth = world.add(GearJoint{.ends = ends, .ratio = 1, .rack = Vec2{0, 1}});
    const Vec2 before = world.jointState(axle).anchorA;
    world.weld(base, rail);
    const auto& moved = std::get<WheelJoint>(world.joint(axle));
    EXPECT_TRUE(near(moved.axis, Rot::fromAngle(Real(0.5)).xAxis(), Real(1e-6)));
    const auto& gear = std::get<GearJoint>(world.joint(teeth));
    EXPECT_TRUE(near(*gear.rack, perp(moved.axis), Real(1e-6)));
    EXPECT_TRUE(near(world.jointState(axle).anchorA, before, Real(1e-6)));
}

// F1: a change of one number keeps the others and wakes the bodies; a bad one changes nothing.
TEST(JointState, OneNumberIsChanged) {
    Rig rig(Vec2{});
    const BodyId drum = rig.addBob({0, 0});
    const JointId hinge = rig.world.add(
        RevoluteJoint{.ends = {.a = rig.post, .b = drum}, .motorSpeed = 0, .motorTorque = 9});
    run(rig.world, 120);
    EXPECT_TRUE((rig.world[drum].flags() & kAsleep) != 0);
    rig.world.changeJoint<RevoluteJoint>(hinge, [](auto& joint) { joint.motorSpeed = 3; });
    run(rig.world, 30);
    EXPECT_TRUE(near(rig.world.jointState(hinge).angularSpeed, 3, Real(1e-3)));
    const std::uint64_t before = rig.world.stateHash();
    const auto spoil = [](RevoluteJoint& joint) { joint.motorTorque = -1; };
    EXPECT_THROW(rig.world.changeJoint<RevoluteJoint>(hinge, spoil), BadDefinition);
    EXPECT_THROW(rig.world.changeJoint<WheelJoint>(hinge, [](auto&) {}), BadDefinition);
    EXPECT_EQ(rig.world.stateHash(), before);
}

} // namespace
} // namespace kodo
