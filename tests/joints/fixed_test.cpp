// SPDX-License-Identifier: MIT
#include <joints/rig.hpp>

#include <vector>

namespace kodo {
namespace {

using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

// F1: the joint of a cantilever beam holds the force m g and the torque m g L / 2.
TEST(FixedJoint, HoldsABeamByItsEnd) {
    Rig rig;
    const BodyId beam = rig.world.add(support::boxDef({1, 0}, 2, Real(0.25)));
    const JointId weld =
        rig.world.add(FixedJoint{.ends = {.a = rig.post, .b = beam, .anchorB = {-1, 0}}});
    run(rig.world, 120);
    const double weight = rig.weightOf(beam);
    EXPECT_TRUE(
        near(rig.world.jointForce(weld), Vec2{0, static_cast<Real>(weight)}, weight * 2e-4));
    EXPECT_TRUE(nearShare(rig.world.jointTorque(weld), weight, 2e-4)); // 1 m
    // No deflection: wall and beam close no loop, so the joint is solved directly.
    EXPECT_TRUE(near(rig.world[beam].position(), Vec2{1, 0}, Real(1e-5)));
    EXPECT_TRUE(near(rig.world[beam].rotation().s, 0, Real(1e-5)));
}

// F1: after an off-centre impulse, two joined bodies move like one welded body: v = J / M, w = d J
// / I.
TEST(FixedJoint, MakesTwoBodiesMoveAsOne) {
    World world;
    const BodyId a = world.add(support::boxDef({0, 0}, 1, 1));
    const BodyId b = world.add(support::boxDef({1, 0}, 1, 1));
    world.add(FixedJoint{
        .ends = {.a = a, .b = b, .anchorA = {Real(0.5), 0}, .anchorB = {Real(-0.5), 0}}});
    world[a].applyImpulse({0, 2}, {0, 0}); // half a metre from the common centre
    run(world, 60);
    const Real spin = Real(-0.5) * 2 / (Real(2) * 5 / 12);
    // 300 substeps are rounded. In double, only the error of the rotating joint remains: light
    // trees are relaxed once a step.
    EXPECT_TRUE(near(world[a].angularVelocity(), spin, byPrecision(2e-5, 3e-6)));
    EXPECT_TRUE(near(world[b].angularVelocity(), spin, byPrecision(2e-5, 3e-6)));
    const Vec2 centre = Real(0.5) * (world[a].velocity() + world[b].velocity());
    EXPECT_TRUE(near(centre, Vec2{0, 1}, byPrecision(1e-5, 1e-12)));
    EXPECT_TRUE(near(length(world[b].position() - world[a].position()), 1, Real(1e-3)));
    EXPECT_TRUE(near((world[b].rotation() * world[a].rotation().inverse()).s, 0, Real(1e-3)));
}

// F1: the joint holds its reference angle, also beyond half a turn.
TEST(FixedJoint, HoldsItsReferenceAngle) {
    for (const Real reference : {Real(0.5), Real(-2), Real(7)}) {
        Rig rig;
        BodyDef def = support::boxDef({0, 0}, 2, Real(0.25));
        def.rotation = Rot::fromAngle(reference);
        def.position = def.rotation * Vec2{1, 0};
        const BodyId beam = rig.world.add(def);
        rig.world.add(FixedJoint{.ends = {.a = rig.post, .b = beam, .anchorB = {-1, 0}},
                                 .reference = reference});
        run(rig.world, 120);
        const Rot off = rig.world[beam].rotation() * def.rotation.inverse();
        EXPECT_TRUE(near(off.s, 0, Real(1e-3))) << reference;
        EXPECT_GT(off.c, 0) << reference;
    }
}

// F1: five beams in a row make a cantilever of 5 m without sag. The root joint carries the whole
// weight.
TEST(FixedJoint, ARowOfFiveHoldsAsACantilever) {
    Rig rig;
    BodyId last = rig.post;
    Vec2 anchor{};
    JointId root;
    for (int i = 0; i < 5; ++i) {
        const BodyId beam =
            rig.world.add(support::boxDef({static_cast<Real>(i) + Real(0.5), 0}, 1, Real(0.25)));
        const JointId weld = rig.world.add(FixedJoint{
            .ends = {.a = last, .b = beam, .anchorA = anchor, .anchorB = {Real(-0.5), 0}}});
        root = i == 0 ? weld : root;
        last = beam;
        anchor = {Real(0.5), 0};
    }
    rig.settle(900);
    const double weight = 5 * rig.weightOf(last);
    EXPECT_TRUE(nearShare(rig.world.jointForce(root).y, weight, 0.02));
    EXPECT_TRUE(nearShare(rig.world.jointTorque(root), 2.5 * weight, 0.02));
    EXPECT_TRUE(near(rig.world[last].position().y, 0, 1e-4));
}

// F1: a closed ring of welded boxes that hangs from a wall, released at rest without stress, gains
// no energy. The welds of a loop are solved one by one. With the angle after the point, rings of
// small boxes gained up to 1e12 of their height energy.
TEST(FixedJoint, AHangingRingOfSmallBoxesGainsNoEnergy) {
    for (const int rate : {30, 60, 120}) {
        for (const int count : {8, 12}) {
            for (const Real size : {Real(0.2), Real(0.5), Real(0.9)}) {
                for (const Real ratio : {Real(1), Real(rate < 60 ? 1 : 30)}) {
                    SCOPED_TRACE(testing::Message() << rate << " Hz, " << count << " boxes of "
                                                    << size << " m, mass ratio " << ratio);
                    Rig rig;
                    const Real radius = static_cast<Real>(count / (2 * joints::kPi)); // m
                    std::vector<BodyId> boxes;
                    for (int i = 0; i < count; ++i) {
                        const Rot turned =
                            Rot::fromAngle(static_cast<Real>(-2 * joints::kPi * i / count));
                        boxes.push_back(rig.world.add({.shape = Box{size, size * Real(0.3)},
                                                       .position = turned * Vec2{0, radius},
                                                       .rotation = turned,
                                                       .density = i % 2 == 1 ? ratio : Real(1),
                                                       .flags = kDisabled | kNeverSleep}));
                    }
                    const auto join = [&](BodyId a, BodyId b, Vec2 place) {
                        const auto local = [&](BodyId id) {
                            return rig.world[id].rotation().inverse() *
                                   (place - rig.world[id].position());
                        };
                        const Rot turn =
                            rig.world[b].rotation() * rig.world[a].rotation().inverse();
                        rig.world.add(FixedJoint{.ends = {a, b, local(a), local(b)},
                                                 .reference = turn.angle()});
                    };
                    for (int i = 0; i < count; ++i) {
                        const BodyId a = boxes[static_cast<std::size_t>(i)];
                        const BodyId b = boxes[static_cast<std::size_t>((i + 1) % count)];
                        join(a, b, Real(0.5) * (rig.world[a].position() + rig.world[b].position()));
                    }
                    join(rig.post, boxes[0], {0, radius});
                    const double start = joints::energyOf(rig.world);
                    double mass = 0;
                    for (const BodyId id : boxes) {
                        mass += static_cast<double>(rig.world[id].mass());
                    }
                    const double fall = joints::kG * mass * static_cast<double>(radius);
                    for (int step = 0; step < 4 * rate; ++step) {
                        rig.world.step(1 / static_cast<Real>(rate));
                        ASSERT_LT(joints::energyOf(rig.world), start + 0.02 * fall)
                            << "step " << step;
                    }
                    EXPECT_TRUE(rig.world.frozenBodies().empty());
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
