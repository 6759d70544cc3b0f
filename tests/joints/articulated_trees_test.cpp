// SPDX-License-Identifier: MIT
#include "joints/articulated_trees.hpp"

#include <joints/rig.hpp>

#include <algorithm>

namespace kodo {
namespace {

using joints::gapOf;
using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

BodyDef plank(Vec2 center, Rot rotation) {
    BodyDef def = support::boxDef(center, Real(0.5), Real(0.125));
    def.rotation = rotation;
    def.flags = kNeverSleep;
    return def;
}

/// `count` planks of 0.5 m hang from the post and carry a ball of `ratio` times the mass of a
/// plank.
struct Hoist : Rig {
    std::vector<JointId> pins;
    BodyId ball;

    Hoist(int count, double ratio) {
        BodyId last = post;
        Vec2 anchor{};
        for (int i = 0; i < count; ++i) {
            const BodyId next =
                world.add(plank({0, Real(-0.25) - static_cast<Real>(i) / 2}, {0, -1}));
            pins.push_back(world.add(RevoluteJoint{
                .ends = {.a = last, .b = next, .anchorA = anchor, .anchorB = {Real(-0.25), 0}}}));
            last = next;
            anchor = {Real(0.25), 0};
        }
        const Real end = Real(-0.5) * static_cast<Real>(count);
        BodyDef def = support::ballDef({0, end - Real(0.5)}, Real(0.5));
        def.flags = kNeverSleep;
        def.density =
            static_cast<Real>(ratio) * world[last].mass() / (Real(0.25) * std::numbers::pi_v<Real>);
        ball = world.add(def);
        pins.push_back(world.add(RevoluteJoint{
            .ends = {.a = last, .b = ball, .anchorA = anchor, .anchorB = {0, Real(0.5)}}}));
    }
    Real widest() const {
        Real gap = 0;
        for (const JointId pin : pins) {
            gap =
                std::max(gap, length(gapOf(world, std::get<RevoluteJoint>(world.joint(pin)).ends)));
        }
        return gap;
    }
};

// F1: a chain of 100 links holds a ball of 1e3 and 1e4 times the mass of a link. Its 50 m stretch
// by less than 1 mm, and the top joint carries the whole weight.
TEST(ArticulatedTrees, AChainOfAHundredHoldsTenThousandTimesItsLink) {
    for (const double ratio : {1e3, 1e4}) {
        SCOPED_TRACE(ratio);
        Hoist hoist(100, ratio);
        run(hoist.world, 300);
        for (int i = 0; i < 60; ++i) {
            hoist.world.step(kDt);
            ASSERT_TRUE(near(hoist.world[hoist.ball].position(), Vec2{0, Real(-50.5)}, 0.001));
        }
        const double weight =
            hoist.weightOf(hoist.ball) * (1 + 100 / ratio); // of the ball and a hundred links
        EXPECT_TRUE(nearShare(hoist.world.jointForce(hoist.pins[0]).y, weight, 0.01));
    }
}

// F1: an impulse in the middle makes the loaded chain swing. It holds together and never exceeds
// the energy of that impulse, 5 m/s of one link.
TEST(ArticulatedTrees, AnImpulseOnALoadedChainAddsNoFurtherEnergy) {
    Hoist hoist(20, 1e3);
    run(hoist.world, 60);
    const BodyId middle = std::get<RevoluteJoint>(hoist.world.joint(hoist.pins[10])).ends.a;
    const Real mass = hoist.world[middle].mass();
    hoist.world[middle].applyImpulse({5 * mass, 0});
    const long double given = static_cast<long double>(mass) * 25 / 2;
    for (int i = 0; i < 300; ++i) {
        hoist.world.step(kDt);
        ASSERT_LT(hoist.widest(), Real(0.005)) << "step " << i;
        ASSERT_LT(support::totalsOf(hoist.world).kinetic, given) << "step " << i;
    }
}

/// A random tree of planks in free space. A revolute or fixed joint connects each plank to an
/// earlier one, with coinciding anchors.
struct Tree {
    World world;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    Tree(std::uint64_t seed, int count) {
        support::RandomNumbers random(seed);
        for (int i = 0; i < count; ++i) {
            BodyDef def = plank({}, random.rotation());
            def.density = random.between(0.1, 10);
            def.velocity = random.point(3);
            def.angularVelocity = random.between(-3, 3);
            const Vec2 own{Real(-0.25), 0};
            if (i == 0) {
                bodies.push_back(world.add(def));
                continue;
            }
            const BodyId to = bodies[random.below(bodies.size())];
            const Vec2 at{random.between(-0.25, 0.25), 0};
            def.position = joints::placeOf(world, to, at) - def.rotation * own;
            const BodyId next = world.add(def);
            const JointEnds ends{.a = i % 2 == 0 ? to : next,
                                 .b = i % 2 == 0 ? next : to,
                                 .anchorA = i % 2 == 0 ? at : own,
                                 .anchorB = i % 2 == 0 ? own : at};
            const Rot turn = world[ends.b].rotation() * world[ends.a].rotation().inverse();
            joints.push_back(i % 3 == 0
                                 ? world.add(FixedJoint{.ends = ends, .reference = turn.angle()})
                                 : world.add(RevoluteJoint{.ends = ends}));
            bodies.push_back(next);
        }
    }
    /// Separation speed of the anchors of a joint (m/s), plus the relative spin of a fixed joint
    /// (rad/s).
    Real slip(JointId id) const {
        const JointDef& def = world.joint(id);
        const auto* weld = std::get_if<FixedJoint>(&def);
        const JointEnds& ends = weld != nullptr ? weld->ends : std::get<RevoluteJoint>(def).ends;
        const BodyView a = world[ends.a];
        const BodyView b = world[ends.b];
        const Vec2 apart = b.velocityAt(joints::placeOf(world, ends.b, ends.anchorB)) -
                           a.velocityAt(joints::placeOf(world, ends.a, ends.anchorA));
        const Real turn = b.angularVelocity() - a.angularVelocity();
        return length(apart) + (weld != nullptr ? std::abs(turn) : 0);
    }
};

// F1: one step stops the relative velocities at all joints of a tree of forty bodies, and conserves
// both momenta. Only one set of joint impulses does both.
TEST(ArticulatedTrees, SatisfyAllJointsInOneStep) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Tree tree(seed, 40);
        for (const BodyId id : tree.bodies) { // their overlaps are not under test
            tree.world[id].setFlags(kDisabled | kNeverSleep);
        }
        const support::Totals before = support::totalsOf(tree.world);
        tree.world.step(Real(1e-4)); // short, so that lever arms stay constant
        const support::Totals after = support::totalsOf(tree.world);
        for (const JointId id : tree.joints) {
            // After the solve they rotate by up to 1e-3 rad, at up to 10 rad/s.
            EXPECT_LT(tree.slip(id), Real(0.01));
        }
        EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(1e-4, 1e-12)));
        EXPECT_TRUE(near(after.spin, before.spin, byPrecision(1e-4, 1e-10))); // arms of some 10 m
        EXPECT_LT(after.kinetic, before.kinetic);
    }
}

// A tree in free flight keeps its joints closed and its momentum.
TEST(ArticulatedTrees, HoldTogetherInFreeFlight) {
    for (const std::uint64_t seed : {5u, 6u}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Tree tree(seed, 20);
        for (const BodyId id : tree.bodies) {
            tree.world[id].setFlags(kDisabled | kNeverSleep);
        }
        const support::Totals before = support::totalsOf(tree.world);
        for (int i = 0; i < 300; ++i) {
            tree.world.step(kDt);
            for (const JointId id : tree.joints) {
                const auto ends = [](const auto& kind) -> JointEnds {
                    if constexpr (requires { kind.ends; }) {
                        return kind.ends;
                    } else {
                        return {};
                    }
                };
                const Vec2 gap = gapOf(tree.world, std::visit(ends, tree.world.joint(id)));
                ASSERT_LT(length(gap), Real(0.002)) << "step " << i;
            }
        }
        EXPECT_TRUE(near(support::totalsOf(tree.world).momentum, before.momentum,
                         byPrecision(1e-3, 1e-11)));
    }
}

// Joints that close a loop are soft, and hold a hanging ring of planks.
TEST(ArticulatedTrees, ARingOfPlanksHolds) {
    Rig rig;
    std::vector<BodyId> ring;
    std::vector<JointId> pins;
    constexpr int kCount = 8;
    const auto corner = [](int i) {
        return Real(0.6) *
               Rot::fromAngle(static_cast<Real>(i) * std::numbers::pi_v<Real> / 4).xAxis();
    };
    for (int i = 0; i < kCount; ++i) {
        const Vec2 side = corner(i + 1) - corner(i);
        const Vec2 along = normalize(side);
        BodyDef def =
            support::boxDef(Real(0.5) * (corner(i) + corner(i + 1)), length(side), Real(0.05));
        def.rotation = {along.x, along.y};
        ring.push_back(rig.world.add(def));
    }
    const Real half = length(corner(1) - corner(0)) / 2;
    for (std::size_t i = 0; i < kCount; ++i) {
        pins.push_back(rig.world.add(RevoluteJoint{.ends = {.a = ring[i],
                                                            .b = ring[(i + 1) % kCount],
                                                            .anchorA = {half, 0},
                                                            .anchorB = {-half, 0}}}));
    }
    pins.push_back(rig.world.add(RevoluteJoint{
        .ends = {.a = rig.post, .b = ring[1], .anchorA = corner(2), .anchorB = {half, 0}}}));
    rig.settle(600);
    for (const JointId pin : pins) {
        EXPECT_LT(length(gapOf(rig.world, std::get<RevoluteJoint>(rig.world.joint(pin)).ends)),
                  Real(0.005));
    }
    EXPECT_TRUE(
        nearShare(rig.world.jointForce(pins.back()).y, kCount * rig.weightOf(ring[0]), 0.02));
}

// A chain between two posts closes a loop through immovable bodies. Overstretched, it cannot close
// its joints, and its motion stays bounded.
TEST(ArticulatedTrees, ATautChainBetweenTwoPostsStaysBounded) {
    Rig rig;
    BodyId last = rig.post;
    Vec2 anchor{};
    for (int i = 0; i < 10; ++i) {
        const BodyId next = rig.world.add(plank({Real(0.25) + static_cast<Real>(i) / 2, 0}, {}));
        rig.world.add(RevoluteJoint{
            .ends = {.a = last, .b = next, .anchorA = anchor, .anchorB = {Real(-0.25), 0}}});
        last = next;
        anchor = {Real(0.25), 0};
    }
    const BodyId far = rig.world.add({.shape = Box{1, 1},
                                      .position = {Real(5.2), 0},
                                      .type = BodyType::Static,
                                      .flags = kDisabled});
    rig.world.add(RevoluteJoint{.ends = {.a = last, .b = far, .anchorA = anchor}}); // 20 cm too far
    for (int i = 0; i < 600; ++i) {
        rig.world.step(kDt);
        for (const BodyId id : rig.world.bodies()) {
            ASSERT_LT(length(rig.world[id].velocity()), 20) << "step " << i;
            ASSERT_TRUE(near(rig.world[id].position().y, 0, 1)) << "step " << i;
        }
    }
}

/// Steps for 5 s. Expects no gain of energy, and no joint gap of `widest` (m) or more.
void expectSoundFlight(World& world, const std::vector<JointEnds>& ties, Real widest) {
    const long double before = support::totalsOf(world).kinetic;
    for (int step = 0; step < 300; ++step) {
        world.step(kDt);
        ASSERT_LT(support::totalsOf(world).kinetic, before * 1.001L) << "step " << step;
        for (const JointEnds& ends : ties) {
            ASSERT_LT(length(gapOf(world, ends)), widest) << "step " << step;
        }
    }
}

/// rad, of b relative to a.
Real angleBetween(const World& world, const JointEnds& ends) {
    return (world[ends.b].rotation() * world[ends.a].rotation().inverse()).angle();
}

// Boxes with random motion, each connected to an earlier one by a revolute or fixed joint, up to 2
// m outside of both. The first impulses are a poor warm start. Gaps stay within a few centimetres
// at 30 m/s.
TEST(ArticulatedTrees, OfBoxesOnLongArmsGainNoEnergy) {
    constexpr std::uint64_t kSeed = 31;
    support::RandomNumbers random(kSeed);
    for (int tree = 0; tree < 100; ++tree) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", tree " << tree);
        World world;
        std::vector<BodyId> boxes;
        std::vector<JointEnds> ties;
        const std::uint64_t count = 2 + random.below(8);
        for (std::uint64_t i = 0; i < count; ++i) {
            BodyDef def = support::boxDef(random.point(2), random.between(0.1, 0.6),
                                          random.between(0.1, 0.6));
            def.rotation = random.rotation();
            def.density = random.between(0.2, 20);
            def.velocity = random.point(4);
            def.angularVelocity = random.between(-10, 10);
            def.flags = kDisabled;
            boxes.push_back(world.add(def));
            if (i == 0) {
                continue;
            }
            const BodyId other = boxes[random.below(i)];
            const Vec2 middle = Real(0.5) * (world[other].position() + def.position);
            const auto local = [&](BodyId id) {
                return unrotate(world[id].rotation(), middle - world[id].position());
            };
            ties.push_back(
                {.a = other, .b = boxes[i], .anchorA = local(other), .anchorB = local(boxes[i])});
            if (random.below(4) == 0) {
                world.add(
                    FixedJoint{.ends = ties.back(), .reference = angleBetween(world, ties.back())});
            } else {
                world.add(RevoluteJoint{.ends = ties.back()});
            }
        }
        expectSoundFlight(world, ties, Real(0.03));
    }
}

// Planks with random motion, each joined end to end to an earlier one, half of them with limits. A
// limit reverses its plank at once, so earlier joint impulses are a poor warm start. Trees without
// loads are soft: gaps stay within 3 cm.
TEST(ArticulatedTrees, OfPlanksWithLimitsGainNoEnergy) {
    constexpr std::uint64_t kSeed = 32;
    support::RandomNumbers random(kSeed);
    for (int tree = 0; tree < 200; ++tree) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", tree " << tree);
        World world;
        std::vector<BodyId> planks;
        std::vector<Real> halves;
        std::vector<JointEnds> ties;
        const std::uint64_t count = 2 + random.below(8);
        for (std::uint64_t i = 0; i < count; ++i) {
            const Real half = random.between(0.1, 0.4);
            BodyDef def = support::boxDef({}, 2 * half, random.between(0.08, 0.3));
            def.rotation = random.rotation();
            def.density = random.between(0.2, 5);
            def.velocity = random.point(4);
            def.angularVelocity = random.between(-10, 10);
            def.flags = kDisabled;
            JointEnds ends{.a = {}, .b = {}, .anchorA = {}, .anchorB = {-half, 0}};
            if (i > 0) {
                const std::uint64_t other = random.below(i);
                ends.a = planks[other];
                ends.anchorA = {random.below(2) == 0 ? halves[other] : -halves[other], 0};
                def.position =
                    joints::placeOf(world, ends.a, ends.anchorA) - def.rotation * ends.anchorB;
            }
            ends.b = world.add(def);
            planks.push_back(ends.b);
            halves.push_back(half);
            if (i > 0) {
                RevoluteJoint pin{.ends = ends, .reference = angleBetween(world, ends)};
                if (random.below(2) == 0) {
                    pin.limits = Range{Real(-0.8), Real(0.8)};
                }
                world.add(pin);
                ties.push_back(ends);
            }
        }
        expectSoundFlight(world, ties, Real(0.03));
    }
}

} // namespace
} // namespace kodo
