// SPDX-License-Identifier: MIT
#include <limits>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// Two discs in C and the same in C++.
struct Pair {
    CWorld world;
    kodo::World other = cppWorld();
    kodo_BodyId a = world.add(bodyAt(0, 0));
    kodo_BodyId b = world.add(bodyAt(2, 0));
    kodo::BodyId otherA = other.add({});
    kodo::BodyId otherB = other.add({.position = {2, 0}});

    kodo_JointEnds ends() const {
        return {a, b, {1, kodo_Real(0.5)}, {-1, kodo_Real(0.25)}, 1000, 2000, true, 9};
    }
    kodo::JointEnds otherEnds() const {
        return {otherA, otherB, {1, kodo::Real(0.5)}, {-1, kodo::Real(0.25)}, 1000, 2000, true, 9};
    }
    /// The joint of C is that of C++, also after it is read, removed and added again.
    void expectSame(const kodo_JointDef& def, const kodo::JointDef& expected) {
        const kodo_JointId id = world.add(def);
        other.add(expected);
        EXPECT_EQ(other.stateHash(), world.hash());
        kodo_JointDef read{};
        EXPECT_OK(kodo_joint(world, id, &read));
        EXPECT_EQ(def.kind, read.kind);
        EXPECT_OK(kodo_setJoint(world, id, &read));
        EXPECT_EQ(other.stateHash(), world.hash());

        world.step(5);
        for (int i = 0; i < 5; ++i) {
            other.step(kodo::Real(1) / 60);
        }
        EXPECT_EQ(other.stateHash(), world.hash());
        kodo_Load load{};
        EXPECT_OK(kodo_jointLoad(world, id, &load));
        const kodo::JointId otherId = other.joints().front();
        EXPECT_EQ(other.jointForce(otherId).x, load.force.x);
        EXPECT_EQ(other.jointForce(otherId).y, load.force.y);
        EXPECT_EQ(other.jointTorque(otherId), load.torque);
        kodo_JointState state{};
        EXPECT_OK(kodo_jointState(world, id, &state));
        const kodo::JointState otherState = other.jointState(otherId);
        EXPECT_EQ(otherState.anchorA.x, state.anchorA.x);
        EXPECT_EQ(otherState.anchorB.y, state.anchorB.y);
        EXPECT_EQ(otherState.angle, state.angle);
        EXPECT_EQ(otherState.angularSpeed, state.angularSpeed);
        EXPECT_EQ(otherState.length, state.length);
        EXPECT_EQ(otherState.lengthSpeed, state.lengthSpeed);
        EXPECT_EQ(otherState.translation, state.translation);
        EXPECT_EQ(otherState.speed, state.speed);
        kodo_JointId listed{};
        std::size_t count = 0;
        EXPECT_OK(kodo_jointsOf(world, a, &listed, 1, &count));
        EXPECT_EQ(1u, count);
        EXPECT_EQ(id.index, listed.index);

        EXPECT_OK(kodo_removeJoint(world, id));
        bool contained = true;
        EXPECT_OK(kodo_containsJoint(world, id, &contained));
        EXPECT_FALSE(contained);
    }
};

TEST(CJoints, ARevoluteJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_REVOLUTE_JOINT);
    def.revolute = {pair.ends(), kodo_Real(0.1), true, {-1, 2}, 3, 4, 5, 6, 7, 8};
    pair.expectSame(def, kodo::RevoluteJoint{pair.otherEnds(), kodo::Real(0.1), kodo::Range{-1, 2},
                                             3, 4, 5, 6, 7, 8});
}

TEST(CJoints, AFixedJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_FIXED_JOINT);
    def.fixed = {pair.ends(), kodo_Real(0.1), 2, 3};
    pair.expectSame(def, kodo::FixedJoint{pair.otherEnds(), kodo::Real(0.1), 2, 3});
}

TEST(CJoints, ADistanceJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_DISTANCE_JOINT);
    def.distance = {pair.ends(), kodo_Real(0.1), 2, 3, true, {0, 4}, 5, 6};
    pair.expectSame(
        def, kodo::DistanceJoint{pair.otherEnds(), kodo::Real(0.1), 2, 3, kodo::Range{0, 4}, 5, 6});
}

TEST(CJoints, APrismaticJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_PRISMATIC_JOINT);
    def.prismatic = {pair.ends(), {0, 1}, kodo_Real(0.1), true, {-1, 2}, 3, 4, 5, 6, 7};
    pair.expectSame(
        def, kodo::PrismaticJoint{
                 pair.otherEnds(), {0, 1}, kodo::Real(0.1), kodo::Range{-1, 2}, 3, 4, 5, 6, 7});
}

TEST(CJoints, AMotorJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_MOTOR_JOINT);
    def.motor = {pair.ends(), kodo_Real(0.1), 2, 3, 4, 5};
    pair.expectSame(def, kodo::MotorJoint{pair.otherEnds(), kodo::Real(0.1), 2, 3, 4, 5});
}

TEST(CJoints, AMouseJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_MOUSE_JOINT);
    def.mouse = {pair.a, {0, kodo_Real(0.25)}, {1, 2}, 30, 4, 5, 6};
    pair.expectSame(def, kodo::MouseJoint{pair.otherA, {0, kodo::Real(0.25)}, {1, 2}, 30, 4, 5, 6});
}

TEST(CJoints, AWheelJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_WHEEL_JOINT);
    EXPECT_EQ(1, def.wheel.axis.y);
    def.wheel = {pair.ends(), {1, 0}, true, {-1, 2}, 3, 4, 5, 6};
    pair.expectSame(def,
                    kodo::WheelJoint{pair.otherEnds(), {1, 0}, kodo::Range{-1, 2}, 3, 4, 5, 6});
}

TEST(CJoints, APulleyJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_PULLEY_JOINT);
    EXPECT_EQ(1, def.pulley.ratio);
    def.pulley = {pair.ends(), {1, 5}, {2, 6}, 20, 2};
    pair.expectSame(def, kodo::PulleyJoint{pair.otherEnds(), {1, 5}, {2, 6}, 20, 2});
}

TEST(CJoints, AGearJointIsThatOfCpp) {
    Pair gears;
    kodo_JointDef def = kodo_jointDef(KODO_GEAR_JOINT);
    EXPECT_EQ(-1, def.gear.ratio);
    EXPECT_FALSE(def.gear.hasRack);
    def.gear.ends = gears.ends();
    def.gear.ratio = 2;
    gears.expectSame(def, kodo::GearJoint{gears.otherEnds(), 2, {}});
    Pair rack;
    def.gear = {rack.ends(), 2, true, {0, 1}};
    rack.expectSame(def, kodo::GearJoint{rack.otherEnds(), 2, kodo::Vec2{0, 1}});
}

TEST(CJoints, AFilterJointIsThatOfCpp) {
    Pair pair;
    kodo_JointDef def = kodo_jointDef(KODO_FILTER_JOINT);
    def.filter.ends = pair.ends();
    def.filter.ends.collide = false;
    def.filter.ends.breakForce = def.filter.ends.breakTorque =
        std::numeric_limits<kodo_Real>::infinity();
    kodo::JointEnds ends = pair.otherEnds();
    ends.collide = false;
    ends.breakForce = ends.breakTorque = kodo::kUnbreakable;
    pair.expectSame(def, kodo::FilterJoint{ends});
}

TEST(CJoints, DefaultsAreThoseOfCpp) {
    const kodo_JointDef revolute = kodo_jointDef(KODO_REVOLUTE_JOINT);
    EXPECT_EQ(std::numeric_limits<kodo_Real>::infinity(), revolute.revolute.ends.breakForce);
    EXPECT_FALSE(revolute.revolute.hasLimits);
    EXPECT_EQ(kodo::DistanceJoint{}.length, kodo_jointDef(KODO_DISTANCE_JOINT).distance.length);
    EXPECT_EQ(1, kodo_jointDef(KODO_PRISMATIC_JOINT).prismatic.axis.x);
    EXPECT_EQ(kodo::MotorJoint{}.hertz, kodo_jointDef(KODO_MOTOR_JOINT).motor.hertz);
    EXPECT_EQ(kodo::MouseJoint{}.damping, kodo_jointDef(KODO_MOUSE_JOINT).mouse.damping);
}

TEST(CJoints, ABrokenJointIsListedWithItsLoad) {
    const CWorld world;
    kodo_BodyDef hook = bodyAt(0, 0);
    hook.type = KODO_STATIC;
    kodo_JointDef def = kodo_jointDef(KODO_FIXED_JOINT);
    def.fixed.ends.a = world.add(hook);
    def.fixed.ends.b = world.add(bodyAt(0, -2));
    def.fixed.ends.anchorA.y = -1;
    def.fixed.ends.anchorB.y = 1;
    def.fixed.ends.breakForce = kodo_Real(0.1); // N; the disc weighs 8 N
    const kodo_JointId id = world.add(def);
    world.step();
    kodo_BrokenJoint broken{};
    std::size_t count = 0;
    EXPECT_OK(kodo_brokenJoints(world, &broken, 1, &count));
    ASSERT_EQ(1u, count);
    EXPECT_EQ(id.index, broken.id.index);
    EXPECT_TRUE(kodo_sameBody(def.fixed.ends.b, broken.b));
    EXPECT_GT(broken.force, kodo_Real(0.1));
    EXPECT_OK(kodo_joints(world, nullptr, 0, &count));
    EXPECT_EQ(0u, count);
}

} // namespace
