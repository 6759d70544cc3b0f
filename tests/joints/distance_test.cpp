// SPDX-License-Identifier: MIT
#include <support/swings.hpp>

#include <joints/rig.hpp>

#include <algorithm>

namespace kodo {
namespace {

using joints::kG;
using joints::kPi;
using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

// F1: a spring of f Hz oscillates at f with the reduced mass of its bodies, and keeps its
// amplitude.
TEST(DistanceJoint, OscillatesAtItsFrequency) {
    for (const double hertz : {0.5, 1.0, 2.0}) {
        for (const bool both : {false, true}) {
            Rig rig(Vec2{});
            const BodyId left = both ? rig.addBob({0, 0}) : rig.post;
            const BodyId right = rig.addBob({Real(2.2), 0});
            rig.world.add(DistanceJoint{
                .ends = {.a = left, .b = right}, .length = 2, .hertz = static_cast<Real>(hertz)});
            support::Swings swings(static_cast<double>(kDt));
            while (swings.count() < 5) {
                rig.world.step(kDt);
                const Vec2 apart = rig.world[right].position() - rig.world[left].position();
                swings.see(static_cast<double>(apart.x) - 2);
            }
            EXPECT_TRUE(nearShare(swings.period(), 1 / hertz, 0.01)) << hertz << " " << both;
            swings.forgetPeak();
            for (int step = 0; step < static_cast<int>(60 / hertz); ++step) {
                rig.world.step(kDt);
                const Vec2 apart = rig.world[right].position() - rig.world[left].position();
                swings.see(static_cast<double>(apart.x) - 2);
            }
            EXPECT_GT(swings.peak(), 0.198) << hertz << " " << both;
            EXPECT_LT(swings.peak(), 0.202) << hertz << " " << both;
        }
    }
}

// F1: a weight stretches its spring by m g / k with k = m (2 pi f)^2, and the joint force is its
// weight.
TEST(DistanceJoint, StretchesUnderAWeightByHookesLaw) {
    for (const double hertz : {1.0, 3.0}) {
        Rig rig;
        const BodyId bob = rig.addBob({0, -2});
        const JointId spring = rig.world.add(DistanceJoint{.ends = {.a = rig.post, .b = bob},
                                                           .length = 2,
                                                           .hertz = static_cast<Real>(hertz),
                                                           .damping = 1});
        run(rig.world, 900);
        const double stretch = kG / std::pow(2 * kPi * hertz, 2);
        // It falls asleep when its remaining motion is below a quarter of the slop, 1 mm.
        EXPECT_TRUE(
            near(rig.world[bob].position(), Vec2{0, static_cast<Real>(-2 - stretch)}, Real(2e-4)));
        EXPECT_TRUE(nearShare(rig.world.jointForce(spring).y, rig.weightOf(bob), 1e-3));
    }
}

// F1: at critical damping and above there is no overshoot; below it there is.
TEST(DistanceJoint, OvershootsByItsDampingRatio) {
    for (const double damping : {0.2, 1.0, 3.0}) {
        Rig rig(Vec2{});
        const BodyId bob = rig.addBob({3, 0});
        rig.world.add(DistanceJoint{.ends = {.a = rig.post, .b = bob},
                                    .length = 2,
                                    .hertz = 1,
                                    .damping = static_cast<Real>(damping)});
        double nearest = 10;
        for (int step = 0; step < 300; ++step) {
            rig.world.step(kDt);
            nearest = std::min(nearest, static_cast<double>(rig.world[bob].position().x));
        }
        if (damping < 1) { // overshoot exp(-pi z / sqrt(1 - z^2)) of the distance
            const double past = std::exp(-kPi * damping / std::sqrt(1 - damping * damping));
            EXPECT_TRUE(near(nearest, 2 - past, 0.01));
        } else {
            EXPECT_GT(nearest, 1.999);
        }
    }
}

// F1: hertz 0 with equal limits makes a rod. A ball on a circular path keeps distance and speed;
// the force is m v^2 / r.
TEST(DistanceJoint, WithEqualLimitsIsARod) {
    Rig rig(Vec2{});
    const BodyId ball = rig.addBob({3, 0});
    rig.world[ball].setVelocity({0, 4});
    const JointId rod = rig.world.add(
        DistanceJoint{.ends = {.a = rig.post, .b = ball}, .length = 3, .limits = Range{3, 3}});
    for (int step = 0; step < 600; ++step) {
        rig.world.step(kDt);
        ASSERT_TRUE(near(length(rig.world[ball].position()), 3, Real(2e-3)));
    }
    EXPECT_TRUE(nearShare(length(rig.world[ball].velocity()), 4, 0.01));
    const Real pull = rig.world[ball].mass() * 16 / 3;
    EXPECT_TRUE(nearShare(length(rig.world.jointForce(rod)), pull, 0.02));
}

// F1: an upper limit alone makes a rope: free fall while slack, then it holds. Jointed bodies move
// with the velocity at the end of each substep, so they lead the parabola by g t h / 2 = 8 mm.
TEST(DistanceJoint, WithAnUpperLimitIsARope) {
    Rig rig;
    const BodyId bob = rig.addBob({0, -1});
    const JointId rope =
        rig.world.add(DistanceJoint{.ends = {.a = rig.post, .b = bob}, .limits = Range{0, 3}});
    run(rig.world, 30); // 1.25 m
    const double h = 1.0 / 60 / rig.world.settings().soft().substeps;
    EXPECT_TRUE(near(rig.world[bob].position().y, -2.25 - 10 * 0.5 * h / 2, 1e-4));
    EXPECT_EQ(rig.world.jointForce(rope), Vec2{});
    Real lowest = 0;
    for (int step = 0; step < 600; ++step) {
        rig.world.step(kDt);
        lowest = std::min(lowest, rig.world[bob].position().y);
    }
    EXPECT_GT(lowest, Real(-3.005)); // it reaches its limit at 6 m/s
    EXPECT_TRUE(near(rig.world[bob].position(), Vec2{0, -3}, Real(1e-3)));
    EXPECT_TRUE(nearShare(rig.world.jointForce(rope).y, rig.weightOf(bob), 1e-3));
}

// F1: a lower limit alone makes a strut.
TEST(DistanceJoint, WithALowerLimitIsAStrut) {
    Rig rig(Vec2{});
    const BodyId a = rig.addBob({0, 0});
    const BodyId b = rig.addBob({4, 0});
    rig.world[b].setVelocity({-3, 0});
    rig.world.add(DistanceJoint{.ends = {.a = a, .b = b}, .limits = Range{2, 1000}});
    for (int step = 0; step < 120; ++step) {
        rig.world.step(kDt);
        ASSERT_GT(length(rig.world[b].position() - rig.world[a].position()), Real(1.99));
    }
    // Inelastic impact: both continue at half the speed.
    EXPECT_TRUE(near(rig.world[a].velocity(), Vec2{Real(-1.5), 0}, 0.01));
    EXPECT_TRUE(near(rig.world[b].velocity(), Vec2{Real(-1.5), 0}, 0.01));
}

// Coinciding anchors still have a direction.
TEST(DistanceJoint, IsFiniteIfItsAnchorsCoincide) {
    Rig rig(Vec2{});
    const BodyId bob = rig.addBob({0, 0});
    rig.world.add(
        DistanceJoint{.ends = {.a = rig.post, .b = bob}, .length = 1, .hertz = 2, .damping = 1});
    run(rig.world, 300);
    EXPECT_TRUE(near(length(rig.world[bob].position()), 1, Real(1e-3)));
}

// Two ropes hold a plate with a box of 300 times its density on a light one. The solver divides the
// substeps for that pile, and the impulses of the ropes with them; each step starts with those of
// the step before. Halved once a step, they let the pile fall through the plate.
TEST(DistanceJoint, RopesHoldAHeavyBoxOnALightOne) {
    for (const StepSettings& settings : {balanced(), accurate()}) {
        for (const Real rate : {Real(30), Real(60), Real(120)}) {
            SCOPED_TRACE(rate);
            Rig rig(support::kEarth, settings);
            const BodyId plate = rig.world.add({.shape = Box{2, Real(0.2)}, .position = {0, -3}});
            std::vector<JointId> ropes;
            for (const Real x : {Real(-1), Real(1)}) {
                ropes.push_back(rig.world.add(DistanceJoint{
                    .ends = {.a = rig.post, .b = plate, .anchorA = {x, 0}, .anchorB = {x, 0}},
                    .limits = Range{0, 3}}));
            }
            double weight = rig.weightOf(plate);
            for (const bool heavy : {false, true}) {
                const BodyId box = rig.world.add({.shape = Box{1, Real(0.5)},
                                                  .position = {0, Real(heavy ? -2.15 : -2.65)},
                                                  .density = Real(heavy ? 300 : 1),
                                                  .flags = kNeverSleep});
                weight += rig.weightOf(box);
            }
            run(rig.world, static_cast<int>(2 * rate), 1 / rate);
            for (int step = 0; step < static_cast<int>(rate); ++step) {
                rig.world.step(1 / rate);
                const double force = static_cast<double>(rig.world.jointForce(ropes[0]).y +
                                                         rig.world.jointForce(ropes[1]).y);
                ASSERT_TRUE(nearShare(force, weight, 0.01)) << step; // what is left of the landing
            }
        }
    }
}

} // namespace
} // namespace kodo
