// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "joints/joint_set.hpp"

#include <joints/rig.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace kodo {
namespace {

using joints::Rig;
using support::ballDef;
using support::boxDef;
using support::kDt;
using support::near;
using support::run;

/// One joint of every kind, in motion.
struct Everything : Rig {
    std::vector<BodyId> bodies;

    Everything() {
        BodyId last = post;
        for (int i = 0; i < 6; ++i) {
            bodies.push_back(
                world.add(boxDef({static_cast<Real>(i + 1), 0}, Real(0.8), Real(0.4))));
            const JointEnds ends{.a = last,
                                 .b = bodies.back(),
                                 .anchorA = {Real(0.5), 0},
                                 .anchorB = {Real(-0.5), 0}};
            switch (i) {
            case 0:
                world.add(RevoluteJoint{.ends = ends, .limits = Range{-2, 2}});
                break;
            case 1:
                world.add(FixedJoint{.ends = ends});
                break;
            case 2:
                world.add(DistanceJoint{
                    .ends = ends, .length = Real(0.2), .hertz = 3, .limits = Range{0, 1}});
                break;
            case 3:
                world.add(PrismaticJoint{.ends = ends, .limits = Range{-1, 1}});
                break;
            case 4:
                world.add(MotorJoint{.ends = ends, .force = 30, .torque = 3});
                break;
            default:
                world.add(MouseJoint{.body = bodies.back(), .target = {4, 3}, .force = 20});
            }
            last = bodies.back();
        }
    }
};

/// A revolute joint of two out of twelve bodies, sometimes with `collide`.
RevoluteJoint somePin(support::RandomNumbers& random) {
    const auto a = static_cast<std::uint32_t>(random.below(12));
    const auto b = static_cast<std::uint32_t>((a + 1 + random.below(11)) % 12);
    RevoluteJoint pin;
    pin.ends = {.a = {a, 0}, .b = {b, 0}};
    pin.ends.collide = random.below(3) == 0;
    return pin;
}

// Lists that are updated incrementally equal rebuilt ones.
TEST(JointSet, KeepsItsListsUpToDate) {
    support::RandomNumbers random(5);
    JointSet set;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<JointId> ids = set.ids();
        const std::size_t what = random.below(ids.size() > 40 ? 6 : 4);
        if (what < 3 || ids.empty()) {
            set.add(somePin(random));
        } else if (what == 3) {
            set.setDef(ids[random.below(ids.size())], somePin(random));
        } else {
            set.remove(ids[random.below(ids.size())]);
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> apart; // in both orders
        set.forEach([&](const JointSet::Joint& joint) {
            const JointEnds& ends = std::get<RevoluteJoint>(joint.def).ends;
            if (!ends.collide) {
                apart.insert({ends.a.index, ends.b.index});
                apart.insert({ends.b.index, ends.a.index});
            }
        });
        for (std::uint32_t a = 0; a < 12; ++a) {
            for (std::uint32_t b = 0; b < 12; ++b) {
                ASSERT_EQ(set.lists().exclude(a, b), apart.contains({a, b})) << i;
            }
        }
        const std::vector<JointId> now = set.ids();
        ASSERT_EQ(now.size(), set.size());
        for (std::size_t k = 1; k < now.size(); ++k) {
            ASSERT_LT(now[k - 1].index, now[k].index) << i;
        }
    }
}

// R2, F1: a copied World continues with the same bits, and so does a rewound one.
TEST(JointSet, ACopiedWorldContinuesWithTheSameBits) {
    Everything scene;
    run(scene.world, 45);
    World copy = scene.world;
    const World saved = scene.world;
    for (int step = 0; step < 300; ++step) {
        scene.world.step(kDt);
        copy.step(kDt);
        ASSERT_EQ(copy.stateHash(), scene.world.stateHash()) << step;
    }
    copy = saved;
    run(copy, 300);
    EXPECT_EQ(copy.stateHash(), scene.world.stateHash());
}

// Removal of all joints of the copy does not affect the original.
TEST(JointSet, ACopySharesNoJoint) {
    Everything scene;
    World copy = scene.world;
    for (const JointId id : copy.joints()) {
        copy.remove(id);
    }
    EXPECT_EQ(scene.world.joints().size(), 6u);
    run(copy, 60);
    run(scene.world, 60);
    EXPECT_LT(copy[scene.bodies[0]].position().y, -4);
    EXPECT_GT(scene.world[scene.bodies[0]].position().y, -2);
}

// Joint ids are in order and never reused. A joint is removed with either of its bodies.
TEST(JointSet, JointsAreRemovedWithTheirBodies) {
    Everything scene;
    const std::vector<JointId> before = scene.world.joints();
    ASSERT_EQ(before.size(), 6u);
    scene.world.remove(scene.bodies[2]);
    EXPECT_EQ(scene.world.joints(),
              (std::vector<JointId>{before[0], before[1], before[4], before[5]}));
    EXPECT_THROW(scene.world.joint(before[2]), BadDefinition);
    const JointId fresh = scene.world.add(DistanceJoint{
        .ends = {.a = scene.bodies[0], .b = scene.bodies[1]}, .limits = Range{0, 1000}});
    for (const JointId id : before) {
        EXPECT_NE(id, fresh);
    }
    run(scene.world, 60);
    scene.world.remove(scene.post);
    EXPECT_FALSE(scene.world.contains(before[0]));
}

// R5, F1: joints of a welded body move to the joined body, with reference and anchor converted.
// Joints between the two are removed.
TEST(JointSet, JointsMoveToTheJoinedBodyOfAWeld) {
    Rig rig;
    const BodyId rope = rig.world.add(boxDef({0, -1}, Real(0.25), 2));
    const BodyId body = rig.world.add(boxDef({1, -2}, 1, 1));
    BodyDef def = boxDef({0, -2}, 1, 1);
    def.rotation = Rot{0, 1};
    const BodyId part = rig.world.add(def);
    const JointId hung =
        rig.world.add(FixedJoint{.ends = {.a = rope, .b = part, .anchorA = {0, -1}},
                                 .reference = std::numbers::pi_v<Real> / 2});
    const JointId top =
        rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = rope, .anchorB = {0, 1}}});
    const JointId between = rig.world.add(RevoluteJoint{.ends = {.a = body, .b = part}});
    rig.world.weld(body, part);
    EXPECT_FALSE(rig.world.contains(between));
    ASSERT_TRUE(rig.world.contains(hung));
    EXPECT_EQ(secondBody(rig.world.joint(hung)), body);
    const FixedJoint weld = std::get<FixedJoint>(rig.world.joint(hung));
    EXPECT_TRUE(near(weld.ends.anchorB, Vec2{-1, 0}, 4 * support::kEpsilon));
    EXPECT_TRUE(near(weld.reference, 0, 4 * support::kEpsilon));
    EXPECT_TRUE(near(joints::gapOf(rig.world, weld.ends), Vec2{}, 8 * support::kEpsilon));
    run(rig.world, 10);
    EXPECT_TRUE(near(joints::gapOf(rig.world, weld.ends), Vec2{}, Real(1e-3)));
    EXPECT_TRUE(rig.world.contains(top));
}

struct BadJoint {
    const char* field;
    std::function<JointDef(JointEnds)> make;
};

// Invalid numbers are refused with the field named, and without any change. check() reports the
// same.
TEST(JointSet, RefusesInvalidNumbers) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto with = [](JointEnds ends, void (*change)(JointEnds&)) {
        change(ends);
        return RevoluteJoint{.ends = ends};
    };
    const BadJoint cases[] = {
        {"ends", [&](JointEnds e) { return with(e, [](JointEnds& x) { x.b = x.a; }); }},
        {"ends.anchorA",
         [&](JointEnds e) {
             return with(e,
                         [](JointEnds& x) { x.anchorA.x = std::numeric_limits<Real>::infinity(); });
         }},
        {"ends.breakForce",
         [&](JointEnds e) { return with(e, [](JointEnds& x) { x.breakForce = 0; }); }},
        {"ends.breakTorque",
         [&](JointEnds e) { return with(e, [](JointEnds& x) { x.breakTorque = -1; }); }},
        {"reference", [=](JointEnds e) { return FixedJoint{.ends = e, .reference = nan}; }},
        {"motorTorque", [](JointEnds e) { return RevoluteJoint{.ends = e, .motorTorque = -1}; }},
        {"limits.upper",
         [](JointEnds e) {
             return RevoluteJoint{.ends = e, .limits = Range{1, 0}};
         }},
        {"limits.lower",
         [](JointEnds e) {
             return DistanceJoint{.ends = e, .limits = Range{-1, 0}};
         }},
        {"hertz", [=](JointEnds e) { return DistanceJoint{.ends = e, .hertz = nan}; }},
        {"axis",
         [](JointEnds e) {
             return PrismaticJoint{.ends = e, .axis = {1, 1}};
         }},
        {"motorSpeed", [=](JointEnds e) { return PrismaticJoint{.ends = e, .motorSpeed = nan}; }},
        {"force", [](JointEnds e) { return MotorJoint{.ends = e, .force = -1}; }},
        {"hertz", [](JointEnds e) { return MotorJoint{.ends = e, .hertz = -1}; }},
        {"target",
         [=](JointEnds e) {
             return MouseJoint{.body = e.a, .target = {nan, 0}};
         }},
    };
    Everything scene;
    const std::uint64_t before = scene.world.stateHash();
    for (const BadJoint& bad : cases) {
        SCOPED_TRACE(bad.field);
        const JointDef def =
            bad.make({.a = scene.bodies[0], .b = scene.bodies[1], .anchorA = {1, 1}});
        ASSERT_TRUE(check(def));
        EXPECT_EQ(check(def)->field, bad.field);
        EXPECT_THROW(scene.world.add(def), BadDefinition);
    }
    EXPECT_EQ(scene.world.stateHash(), before);
    EXPECT_EQ(scene.world.joints().size(), 6u);
}

TEST(JointSet, RefusesRemovedBodiesAndOtherKinds) {
    Everything scene;
    const BodyId dead = scene.bodies[5];
    scene.world.remove(dead);
    EXPECT_THROW(scene.world.add(RevoluteJoint{.ends = {.a = scene.post, .b = dead}}), BadBodyId);
    EXPECT_THROW(scene.world.add(MouseJoint{.body = dead, .force = 1}), BadBodyId);
    const JointId pin = scene.world.joints()[0];
    const JointEnds ends = std::get<RevoluteJoint>(scene.world.joint(pin)).ends;
    EXPECT_THROW(scene.world.setJoint(pin, FixedJoint{.ends = ends}), BadDefinition);
    EXPECT_THROW(
        scene.world.setJoint(pin, RevoluteJoint{.ends = {.a = ends.a, .b = scene.bodies[3]}}),
        BadDefinition);
    const Everything elsewhere; // its ids differ in the World alone
    JointEnds foreign = ends;
    foreign.a = elsewhere.bodies[ends.a.index];
    EXPECT_THROW(scene.world.setJoint(pin, RevoluteJoint{.ends = foreign}), BadBodyId);
    EXPECT_EQ(std::get<RevoluteJoint>(scene.world.joint(pin)).ends.a.world, ends.a.world);
}

// A joint without a dynamic body is accepted and does nothing, until setType() makes one dynamic.
TEST(JointSet, KeepsAJointWithoutADynamicBodyForLater) {
    World world({.gravity = support::kEarth});
    const BodyId a = world.add({.shape = Box{1, 1}, .type = BodyType::Static});
    const BodyId b = world.add({.shape = Box{1, 1}, .position = {2, 0}, .type = BodyType::Static});
    const JointId pin =
        world.add(RevoluteJoint{.ends = {.a = a, .b = b, .anchorA = {1, 0}, .anchorB = {-1, 0}}});
    const JointId pull = world.add(MouseJoint{.body = b, .target = {9, 9}, .force = 100});
    support::run(world, 60);
    EXPECT_EQ(world[b].position(), (Vec2{2, 0}));
    EXPECT_EQ(world.jointForce(pin), Vec2{});
    EXPECT_EQ(world.jointForce(pull), Vec2{});
    world.remove(pull);
    world[b].setType(BodyType::Dynamic);
    support::run(world, 60);
    EXPECT_LT(world[b].position().y, Real(-0.1));
    EXPECT_TRUE(support::near(length(world[b].center() - Vec2{1, 0}), 1, Real(1e-2)));
}

// A motor speed without a torque or a force is accepted: 0 switches a motor off, as setJoint()
// does.
TEST(JointSet, TakesAMotorWithoutTorqueForNone) {
    const auto poseOf = [](Real speed, bool slides) {
        World world({.gravity = support::kEarth});
        const BodyId wall = world.add({.shape = Box{1, 4}, .type = BodyType::Static});
        const BodyId arm = world.add(support::boxDef({Real(1.5), 0}, 2, Real(0.2)));
        const JointEnds ends{.a = wall, .b = arm, .anchorA = {Real(0.5), 0}, .anchorB = {-1, 0}};
        if (slides) {
            world.add(PrismaticJoint{.ends = ends, .axis = {0, 1}, .motorSpeed = speed});
        } else {
            world.add(RevoluteJoint{.ends = ends, .motorSpeed = speed});
        }
        support::run(world, 60);
        return std::pair{world[arm].position(), world[arm].rotation()};
    };
    EXPECT_EQ(poseOf(5, false), poseOf(0, false));
    EXPECT_EQ(poseOf(5, true), poseOf(0, true));
    EXPECT_NE(poseOf(0, false).first, (Vec2{Real(1.5), 0}));
}

// Joints by body, after random changes, are those that a search of all joints finds.
TEST(JointLists, FindTheJointsOfABody) {
    support::RandomNumbers random(31);
    JointLists lists;
    std::vector<std::optional<std::pair<std::uint32_t, std::uint32_t>>> joints(60);
    for (int change = 0; change < 3000; ++change) {
        const auto joint = static_cast<std::uint32_t>(random.below(60));
        const auto a = static_cast<std::uint32_t>(random.below(12));
        const auto b = static_cast<std::uint32_t>(random.below(12));
        if (joints[joint]) {
            lists.remove(joint);
            joints[joint].reset();
        } else {
            lists.add(joint, a, b, true);
            joints[joint] = {a, b};
        }
        const auto body = static_cast<std::uint32_t>(random.below(13)); // 12 has none
        std::vector<std::uint32_t> expected;
        for (std::uint32_t index = 0; index < joints.size(); ++index) {
            if (joints[index] && (joints[index]->first == body || joints[index]->second == body)) {
                expected.push_back(index);
            }
        }
        ASSERT_EQ(lists.of(body), expected);
        ASSERT_EQ(lists.hasAny(body), !expected.empty());
    }
}

} // namespace
} // namespace kodo
