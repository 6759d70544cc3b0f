// SPDX-License-Identifier: MIT
// Gears, racks, pulleys, friction by a motor joint, and filters.
#include <support/solver.hpp>

#include <joints/rig.hpp>

#include <cmath>

namespace kodo {
namespace {

using joints::kG;
using joints::Rig;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;
using support::settingsOf;

/// Two wheels of 1 m and 0.5 m on a carrier.
struct Gears {
    World world;
    BodyId carrier;
    BodyId a;
    BodyId b;
    JointId gear;

    Gears(BodyType type, double ratio, const StepSettings& settings)
        : world({.settings = settings}) {
        carrier = world.add({.shape = Box{4, Real(0.5)}, .type = type});
        a = world.add(support::ballDef({-1, 0}, 1));
        b = world.add(support::ballDef({Real(0.5), 0}, Real(0.5)));
        world.add(RevoluteJoint{.ends = {.a = carrier, .b = a, .anchorA = {-1, 0}}});
        world.add(RevoluteJoint{.ends = {.a = carrier, .b = b, .anchorA = {Real(0.5), 0}}});
        gear = world.add(GearJoint{.ends = {.a = a, .b = b}, .ratio = static_cast<Real>(ratio)});
    }
    /// rad/s, relative to the carrier.
    double speedOf(BodyId id) const {
        return static_cast<double>(world[id].angularVelocity() - world[carrier].angularVelocity());
    }
};

// F1: the speeds of two gears have their ratio: of teeth, of a belt, and of equal wheels. Angles
// keep it too, over hundreds of turns.
TEST(GearJoint, SpeedsAndAnglesHaveTheirRatio) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double ratio : {-2.0, 0.5, 1.0, -0.1}) {
            Gears gears(BodyType::Static, ratio, settingsOf(solver));
            gears.world[gears.a].setAngularVelocity(10);
            run(gears.world, 10); // joints are soft: the teeth mesh within steps
            const double w = gears.speedOf(gears.a);
            // momentum about the axles: I_a w + r I_b r w = I_a 10
            const auto ia = static_cast<double>(gears.world[gears.a].inertia());
            const auto ib = static_cast<double>(gears.world[gears.b].inertia());
            EXPECT_TRUE(nearShare(w, 10 * ia / (ia + ratio * ratio * ib), 1e-3)) << ratio;
            run(gears.world, 3000);
            EXPECT_TRUE(nearShare(gears.speedOf(gears.b), ratio * gears.speedOf(gears.a), 1e-4));
            const Rot turnA = gears.world[gears.a].rotation();
            const Rot turnB = gears.world[gears.b].rotation();
            if (ratio == 1.0) {
                EXPECT_TRUE(near((turnB * turnA.inverse()).angle(), 0, Real(0.01)));
            } else if (ratio == -2.0) {
                EXPECT_TRUE(near((turnB * turnA * turnA).angle(), 0, Real(0.02)));
            }
        }
    }
}

// F1: on a free carrier the gears conserve momentum, angular momentum and, without friction,
// energy; the ratio is that of the speeds relative to the carrier.
TEST(GearJoint, ConservesAngularMomentumOnAFreeCarrier) {
    for (const support::Solver solver : support::kSolvers) {
        StepSettings settings = settingsOf(solver);
        settings.leaveOut = Feature::Sleep;
        Gears gears(BodyType::Dynamic, -2, settings);
        gears.world.add(FilterJoint{.ends = {.a = gears.a, .b = gears.b}});
        gears.world[gears.a].setAngularVelocity(4);
        const support::Totals before = support::totalsOf(gears.world);
        gears.world.step(kDt);
        const support::Totals meshed = support::totalsOf(gears.world);
        run(gears.world, 600);
        const support::Totals after = support::totalsOf(gears.world);
        EXPECT_TRUE(nearShare(after.spin, before.spin, 1e-4L));
        EXPECT_TRUE(near(after.momentum.x, before.momentum.x, 1e-4L));
        EXPECT_LT(after.kinetic, 1.001L * meshed.kinetic);
        EXPECT_GT(after.kinetic, 0.97L * meshed.kinetic);
        EXPECT_TRUE(nearShare(gears.speedOf(gears.b), -2 * gears.speedOf(gears.a), 1e-3));
    }
}

// F1: the torque of a gear is that of its load: a motor on a turns b against a brake.
// The hands of a clock: their axles are one, so the line between these has no direction.
TEST(GearJoint, TurnsHandsOnOneAxle) {
    for (const StepSettings& settings : {balanced(), accurate(), thesis2006()}) {
        for (const double apart : {0.0, 1e-4, 1e-2}) { // m, between the axles
            for (const double rate : {30.0, 60.0, 240.0}) {
                World world({.settings = settings});
                const BodyId wall = world.add({.type = BodyType::Static, .flags = kDisabled});
                const Vec2 second{static_cast<Real>(apart), 0};
                const BodyId minute = world.add({.shape = Box{2, Real(0.1), {1, 0}},
                                                 .velocity = {0, -1},
                                                 .angularVelocity = -1});
                const BodyId hour = world.add({.shape = Box{1, Real(0.1), {Real(0.5), 0}},
                                               .position = second,
                                               .velocity = {0, Real(-0.5) / 12},
                                               .angularVelocity = Real(-1) / 12});
                world.add(RevoluteJoint{.ends = {.a = wall, .b = minute}});
                world.add(RevoluteJoint{.ends = {.a = wall, .b = hour, .anchorA = second}});
                world.add(GearJoint{.ends = {.a = minute, .b = hour}, .ratio = Real(1) / 12});
                run(world, static_cast<int>(10 * rate), static_cast<Real>(1 / rate));
                const double speed = static_cast<double>(world[minute].angularVelocity());
                EXPECT_NEAR(speed, -1, 0.03) << apart << " m, " << rate << " Hz";
                EXPECT_NEAR(static_cast<double>(world[hour].angularVelocity()), speed / 12, 0.005);
            }
        }
    }
}

TEST(GearJoint, CarriesTheTorqueOfItsLoad) {
    for (const support::Solver solver : support::kSolvers) {
        Gears gears(BodyType::Static, -2, settingsOf(solver));
        const JointId first = gears.world.joints()[0];
        gears.world.changeJoint<RevoluteJoint>(first, [](auto& joint) {
            joint.motorSpeed = 1;
            joint.motorTorque = 100;
        });
        for (int step = 0; step < 120; ++step) {
            gears.world[gears.b].applyTorque(3); // against its rotation
            gears.world.step(kDt);
        }
        EXPECT_TRUE(nearShare(gears.world.jointTorque(gears.gear), -3, 1e-3));
        EXPECT_TRUE(nearShare(gears.world.jointTorque(first), 6, 1e-3));
        gears.world.changeJoint<GearJoint>(gears.gear,
                                           [](auto& joint) { joint.ends.breakTorque = Real(2.9); });
        gears.world[gears.b].applyTorque(3);
        gears.world.step(kDt);
        EXPECT_FALSE(gears.world.contains(gears.gear));
    }
}

// F1: a pinion on a rack rolls without slip: v = 2/3 of the speed before, w = -v / r.
TEST(GearJoint, APinionRollsAlongItsRack) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig({}, settingsOf(solver));
        const BodyId pinion = rig.world.add(support::ballDef({0, 1}, Real(0.5)));
        const JointEnds ends{.a = rig.post, .b = pinion, .anchorA = {0, 1}};
        rig.world.add(WheelJoint{.ends = ends, .axis = {1, 0}});
        rig.world.add(GearJoint{.ends = ends, .ratio = Real(-0.5), .rack = Vec2{1, 0}});
        rig.world[pinion].setVelocity({Real(1.5), 0});
        run(rig.world, 120);
        EXPECT_TRUE(nearShare(rig.world[pinion].velocity().x, 1, 1e-3));
        EXPECT_TRUE(nearShare(rig.world[pinion].angularVelocity(), -2, 1e-3));
        const Real way = rig.world[pinion].position().x;
        EXPECT_TRUE(
            near((rig.world[pinion].rotation() * Rot::fromAngle(2 * way)).angle(), 0, Real(1e-3)));
    }
}

// F1: slip is state: a World that is read from bytes continues with the same bits.
TEST(GearJoint, ContinuesFromASnapshot) {
    Gears gears(BodyType::Dynamic, -2, {});
    gears.world.add(FilterJoint{.ends = {.a = gears.a, .b = gears.b}});
    gears.world[gears.a].setAngularVelocity(4);
    run(gears.world, 30);
    World read = fromBytes(toBytes(gears.world));
    EXPECT_EQ(read.stateHash(), gears.world.stateHash());
    run(gears.world, 30);
    run(read, 30);
    EXPECT_EQ(read.stateHash(), gears.world.stateHash());
}

/// Two boxes of 1 kg on a rope over two points.
struct Hoist {
    World world;
    BodyId a;
    BodyId b;
    JointId rope;

    Hoist(double ratio, const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        a = world.add(support::boxDef({-2, 0}, 1, 1));
        b = world.add(support::boxDef({2, 0}, 1, 1));
        rope = world.add(PulleyJoint{.ends = {.a = a, .b = b},
                                     .groundA = {-2, 5},
                                     .groundB = {2, 5},
                                     .length = 5 + 5 * static_cast<Real>(ratio),
                                     .ratio = static_cast<Real>(ratio)});
    }
};

// F1: a = g (r^2 m_a - r m_b ...): with equal masses, a falls at g r (r - 1) / (1 + r^2), and the
// rope pulls b by r times its force on a.
TEST(PulleyJoint, AcceleratesByItsRatio) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double ratio : {1.0, 2.0, 0.5}) {
            Hoist hoist(ratio, settingsOf(solver));
            run(hoist.world, 30);
            const double fall = kG * ratio * (ratio - 1) / (1 + ratio * ratio); // m/s^2
            EXPECT_TRUE(near(hoist.world[hoist.a].velocity().y, -fall / 2, 0.01)) << ratio;
            EXPECT_TRUE(near(hoist.world[hoist.b].velocity().y, fall / ratio / 2, 0.01)) << ratio;
            const double pull = (kG - fall) * ratio; // N
            EXPECT_TRUE(nearShare(hoist.world.jointForce(hoist.rope).y, pull, 0.01)) << ratio;
            EXPECT_TRUE(
                near(hoist.world.jointState(hoist.rope).length, 5 + 5 * ratio, 2e-3 * ratio));
        }
    }
}

// F1: the rope pulls alone: lifted, it is slack and carries nothing.
TEST(PulleyJoint, IsSlackWhereItsBodiesAreLifted) {
    Hoist hoist(1, {});
    hoist.world[hoist.a].applyImpulse({0, 3});
    hoist.world[hoist.b].applyImpulse({0, 3});
    run(hoist.world, 12);
    EXPECT_LT(hoist.world.jointState(hoist.rope).length, Real(9.7));
    EXPECT_EQ(hoist.world.jointForce(hoist.rope), (Vec2{0, 0}));
    EXPECT_TRUE(near(hoist.world[hoist.a].velocity().y, 1, Real(1e-3)));
}

// F1: in a swing of both loads energy is not gained.
TEST(PulleyJoint, GainsNoEnergyInASwing) {
    for (const support::Solver solver : support::kSolvers) {
        StepSettings settings = settingsOf(solver);
        settings.leaveOut = Feature::Sleep;
        Hoist hoist(1, settings);
        hoist.world[hoist.a].setVelocity({2, 0});
        const double start = joints::energyOf(hoist.world);
        for (int step = 0; step < 240; ++step) {
            hoist.world.step(kDt);
            ASSERT_LT(joints::energyOf(hoist.world), start + 0.05) << step;
        }
    }
}

// F1: a motor joint with hertz 0 is friction on a plane seen from above: m v / F and I w / T
// seconds to a stop, whatever the direction, and no force pulls the body back.
TEST(FrictionByAMotorJoint, StopsABodyInMvOverF) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig({}, settingsOf(solver));
        const BodyId puck = rig.addBob({0, 0});
        const Real mass = rig.world[puck].mass();
        const JointId drag = rig.world.add(MotorJoint{.ends = {.a = rig.post, .b = puck},
                                                      .force = 2 * mass,
                                                      .torque = rig.world[puck].inertia(),
                                                      .hertz = 0});
        rig.world[puck].setVelocity({3, 4});
        rig.world[puck].setAngularVelocity(2);
        run(rig.world, 60);
        EXPECT_TRUE(near(length(rig.world[puck].velocity()), 3, Real(2e-3)));
        EXPECT_TRUE(near(rig.world[puck].angularVelocity(), 1, Real(2e-3)));
        EXPECT_TRUE(nearShare(length(rig.world.jointForce(drag)), 2 * mass, 1e-3));
        run(rig.world, 120);
        EXPECT_LT(length(rig.world[puck].velocity()), Real(1e-6));
        EXPECT_TRUE(nearShare(length(rig.world[puck].position()), 25.0 / 4, 0.01));
    }
}

// F1: a filter joint keeps two bodies from colliding, until it is removed, and moves neither.
TEST(FilterJoint, KeepsTwoBodiesFromColliding) {
    World world;
    const BodyId a = world.add(support::ballDef({0, 0}, Real(0.5)));
    const BodyId b = world.add(support::ballDef({Real(0.5), 0}, Real(0.5)));
    const JointId filter = world.add(FilterJoint{.ends = {.a = a, .b = b}});
    run(world, 30);
    EXPECT_TRUE(world.collisions().empty());
    EXPECT_EQ(world[b].position().x, Real(0.5));
    EXPECT_EQ(world.jointForce(filter), (Vec2{0, 0}));
    world.remove(filter);
    run(world, 30);
    EXPECT_GT(world[b].position().x - world[a].position().x, Real(0.9));
}

} // namespace
} // namespace kodo
