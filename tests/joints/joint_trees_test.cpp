// SPDX-License-Identifier: MIT
#include <kodo/joints/joint_trees.hpp>

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
    def.flags = kNeverRest;
    return def;
}

/// `count` planks of 0.5 m that hang from the post, and a ball that is so many times as heavy as
/// one of them.
struct Hoist : Rig {
    std::vector<JointId> pins;
    BodyId ball;

    Hoist(int count, double ratio) {
        BodyId last = post;
        Vec2 anchor{};
        for (int i = 0; i < count; ++i) {
            const BodyId next =
                world.add(plank({0, Real(-0.25) - static_cast<Real>(i) / 2}, {0, -1}));
            pins.push_back(world.add(Pin{
                .ends = {.a = last, .b = next, .anchorA = anchor, .anchorB = {Real(-0.25), 0}}}));
            last = next;
            anchor = {Real(0.25), 0};
        }
        const Real end = Real(-0.5) * static_cast<Real>(count);
        BodyDef def = support::ballDef({0, end - Real(0.5)}, Real(0.5));
        def.flags = kNeverRest;
        def.density =
            static_cast<Real>(ratio) * world[last].mass() / (Real(0.25) * std::numbers::pi_v<Real>);
        ball = world.add(def);
        pins.push_back(world.add(
            Pin{.ends = {.a = last, .b = ball, .anchorA = anchor, .anchorB = {0, Real(0.5)}}}));
    }
    Real widest() const {
        Real gap = 0;
        for (const JointId pin : pins) {
            gap = std::max(gap, length(gapOf(world, std::get<Pin>(world.joint(pin)).ends)));
        }
        return gap;
    }
};

// F1: a chain of a hundred holds a ball a thousand times as heavy as one of its links, and ten
// thousand times: 50 m become longer by less than 1 mm in all, and the topmost pin carries
// everything.
TEST(JointTrees, AChainOfAHundredHoldsAThousandfoldWeight) {
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

// F1: struck in the middle such a chain swings, holds together, and gains no energy: 5 m/s of one
// link is all there is.
TEST(JointTrees, AChainUnderAThousandfoldWeightMayBeStruck) {
    Hoist hoist(20, 1e3);
    run(hoist.world, 60);
    const BodyId middle = std::get<Pin>(hoist.world.joint(hoist.pins[10])).ends.a;
    const Real mass = hoist.world[middle].mass();
    hoist.world[middle].applyImpulse({5 * mass, 0});
    const long double given = static_cast<long double>(mass) * 25 / 2;
    for (int i = 0; i < 300; ++i) {
        hoist.world.step(kDt);
        ASSERT_LT(hoist.widest(), Real(0.005)) << "step " << i;
        ASSERT_LT(support::totalsOf(hoist.world).kinetic, given) << "step " << i;
    }
}

/// A random tree of planks in free space: each is pinned or welded to one before it, by a point of
/// both that lies in one place.
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
            joints.push_back(i % 3 == 0 ? world.add(Weld{.ends = ends, .reference = turn.angle()})
                                        : world.add(Pin{.ends = ends}));
            bodies.push_back(next);
        }
    }
    /// How fast the two anchors of a joint part (m/s), and how fast a weld turns (rad/s).
    Real slip(JointId id) const {
        const JointDef& def = world.joint(id);
        const auto* weld = std::get_if<Weld>(&def);
        const JointEnds& ends = weld != nullptr ? weld->ends : std::get<Pin>(def).ends;
        const BodyView a = world[ends.a];
        const BodyView b = world[ends.b];
        const Vec2 apart = b.velocityAt(joints::placeOf(world, ends.b, ends.anchorB)) -
                           a.velocityAt(joints::placeOf(world, ends.a, ends.anchorA));
        const Real turn = b.angularVelocity() - a.angularVelocity();
        return length(apart) + (weld != nullptr ? std::abs(turn) : 0);
    }
};

// F1: of all impulses those of the joints alone are found, which stop every anchor at once: after
// one step no joint of a tree of forty slips, and the momenta of the whole are what they were. Both
// together have one solution.
TEST(JointTrees, StopAllJointsAtOnce) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Tree tree(seed, 40);
        for (const BodyId id : tree.bodies) { // they overlap, and that is not what is asked
            tree.world[id].setFlags(kDisabled | kNeverRest);
        }
        const support::Totals before = support::totalsOf(tree.world);
        tree.world.step(Real(1e-4)); // hardly moves, so that the arms are those of now
        const support::Totals after = support::totalsOf(tree.world);
        for (const JointId id : tree.joints) {
            // They turn by up to 1e-3 rad after they were solved, with up to 10 rad/s.
            EXPECT_LT(tree.slip(id), Real(0.01));
        }
        EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(1e-4, 1e-12)));
        EXPECT_TRUE(near(after.spin, before.spin, byPrecision(1e-4, 1e-10))); // arms of some 10 m
        EXPECT_LT(after.kinetic, before.kinetic);
    }
}

// A tree keeps its joints together while it flies and flails, and its momenta.
TEST(JointTrees, HoldTogetherInFreeFlight) {
    for (const std::uint64_t seed : {5u, 6u}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Tree tree(seed, 20);
        for (const BodyId id : tree.bodies) {
            tree.world[id].setFlags(kDisabled | kNeverRest);
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

// Joints that close a loop are springs, as before: a ring of planks, hung by one of them, holds.
TEST(JointTrees, ARingHoldsToo) {
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
        pins.push_back(rig.world.add(Pin{.ends = {.a = ring[i],
                                                  .b = ring[(i + 1) % kCount],
                                                  .anchorA = {half, 0},
                                                  .anchorB = {-half, 0}}}));
    }
    pins.push_back(rig.world.add(
        Pin{.ends = {.a = rig.post, .b = ring[1], .anchorA = corner(2), .anchorB = {half, 0}}}));
    rig.settle(600);
    for (const JointId pin : pins) {
        EXPECT_LT(length(gapOf(rig.world, std::get<Pin>(rig.world.joint(pin)).ends)), Real(0.005));
    }
    EXPECT_TRUE(
        nearShare(rig.world.jointForce(pins.back()).y, kCount * rig.weightOf(ring[0]), 0.02));
}

// A chain between two posts is a loop through the ground. Pulled straight it can go nowhere, and
// its pulls stay bounded.
TEST(JointTrees, ATautChainBetweenTwoPostsStaysBounded) {
    Rig rig;
    BodyId last = rig.post;
    Vec2 anchor{};
    for (int i = 0; i < 10; ++i) {
        const BodyId next = rig.world.add(plank({Real(0.25) + static_cast<Real>(i) / 2, 0}, {}));
        rig.world.add(
            Pin{.ends = {.a = last, .b = next, .anchorA = anchor, .anchorB = {Real(-0.25), 0}}});
        last = next;
        anchor = {Real(0.25), 0};
    }
    const BodyId far = rig.world.add(
        {.shape = Box{1, 1}, .position = {Real(5.2), 0}, .flags = kLocked | kDisabled});
    rig.world.add(Pin{.ends = {.a = last, .b = far, .anchorA = anchor}}); // 20 cm too far
    for (int i = 0; i < 600; ++i) {
        rig.world.step(kDt);
        for (const BodyId id : rig.world.bodies()) {
            ASSERT_LT(length(rig.world[id].velocity()), 20) << "step " << i;
            ASSERT_TRUE(near(rig.world[id].position().y, 0, 1)) << "step " << i;
        }
    }
}

/// Steps for five seconds; no energy may be made, nor a pin give by as much as `widest` (m).
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

/// Of b relative to a.
Real angleBetween(const World& world, const JointEnds& ends) {
    return (world[ends.b].rotation() * world[ends.a].rotation().inverse()).angle();
}

// Boxes that fly and spin at random, each tied to one before it by a pin or weld that lies up to 2
// m outside of both: the jerk that joins their motions is no guide to what the joints do next. Pins
// hold to a few centimetres at 30 m/s.
TEST(JointTrees, OfBoxesOnLongArmsMakeNoEnergy) {
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
                world.add(Weld{.ends = ties.back(), .reference = angleBetween(world, ties.back())});
            } else {
                world.add(Pin{.ends = ties.back()});
            }
        }
        expectSoundFlight(world, ties, Real(0.03));
    }
}

// Planks that fly and spin at random, each pinned by an end to an end of one before it, half of
// them with limits. What strikes a limit turns its plank back at once, and what held the pin until
// then does not; pins hold to a centimetre.
TEST(JointTrees, OfPlanksWithLimitsMakeNoEnergy) {
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
                Pin pin{.ends = ends, .reference = angleBetween(world, ends)};
                if (random.below(2) == 0) {
                    pin.limits = Range{Real(-0.8), Real(0.8)};
                }
                world.add(pin);
                ties.push_back(ends);
            }
        }
        expectSoundFlight(world, ties, Real(0.01));
    }
}

} // namespace
} // namespace kodo
