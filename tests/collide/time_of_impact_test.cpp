// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include "collide/time_of_impact.hpp"

#include <cmath>

namespace kodo::time_of_impact_test {
namespace {

using support::near;

// The target of a World with a length unit of 1 m. The search may stop half a target early.
constexpr Real kTarget = Real(1) / 1024;

MotionPath asleep(Vec2 position, Real angle = 0) {
    return {{position, Rot::fromAngle(angle)}, {}, 0};
}

MotionPath moving(Vec2 position, Vec2 move, Real turn = 0) {
    return {{position, {}}, move, turn};
}

const ConvexShape kBall = convexShapeOf(Circle{Real(0.5)}, {});
const ConvexShape kWall = convexShapeOf(Box{1, 20}, {});

TEST(TimeOfImpact, OfABallFlyingAtAWallIsTheClosedForm) {
    for (const Real speed : {Real(12), Real(100), Real(1e5)}) {
        const Real time =
            timeOfImpact(kWall, asleep({10, 0}), kBall, moving({}, {speed, 0}), kTarget);
        // The surfaces are 9 m apart. The final gap is 1 to 1.5 targets.
        EXPECT_LE(time * speed, 9 - kTarget * Real(0.99));
        EXPECT_GE(time * speed, 9 - kTarget * 2);
    }
}

TEST(TimeOfImpact, IsNoneIfTheyDoNotReachEachOther) {
    EXPECT_GE(timeOfImpact(kWall, asleep({10, 0}), kBall, moving({}, {Real(8.9), 0}), kTarget), 1);
    EXPECT_GE(timeOfImpact(kWall, asleep({10, 0}), kBall, moving({}, {-50, 0}), kTarget), 1);
    EXPECT_GE(timeOfImpact(kWall, asleep({10, 0}), kBall, moving({}, {0, 50}), kTarget), 1);
}

// A ball of 0.5 m at a corner, its centre 0.3 m beyond the side: contact when the centre is 0.4 m
// before the corner (3, 4, 5).
TEST(TimeOfImpact, OfABallAtACornerIsTheClosedForm) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const Real time =
        timeOfImpact(box, asleep({10, 0}), kBall, moving({0, Real(1.3)}, {20, 0}), kTarget);
    // Along the path the gap closes at 0.8 of the speed.
    EXPECT_TRUE(near(time * 20, 8.6L, 2 * kTarget / Real(0.8)));
}

// Only the relative motion matters: a gap of 9 m at 20 + 10 m per step.
TEST(TimeOfImpact, OfTwoMovingBallsDependsOnTheirRelativeVelocity) {
    const Real time =
        timeOfImpact(kBall, moving({10, 0}, {-10, 3}), kBall, moving({}, {20, 3}), kTarget);
    EXPECT_TRUE(near(time * 30, 9, 2 * kTarget));
}

// A ball that passes a corner at 1 cm does not stop there.
TEST(TimeOfImpact, IsNoneForAGrazingMiss) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const MotionPath pass = moving({0, Real(1.51)}, {20, 0});
    EXPECT_GE(timeOfImpact(box, asleep({10, 0}), kBall, pass, kTarget), 1);
    const MotionPath graze = moving({0, Real(1.49)}, {20, 0});
    EXPECT_LT(timeOfImpact(box, asleep({10, 0}), kBall, graze, kTarget), 1);
}

/// The first sample at which the separation is at most the target.
Real byFineStepping(const ConvexShape& a, const MotionPath& sweepA, const ConvexShape& b,
                    const MotionPath& sweepB, int parts) {
    for (int i = 0; i <= parts; ++i) {
        const Real t = static_cast<Real>(i) / static_cast<Real>(parts);
        if (separation(a, sweepA.at(t), b, sweepB.at(t)).distance <= kTarget) {
            return t;
        }
    }
    return 2;
}

// A rod rotates by half a turn in one step and hits a small post, while its centre hardly moves.
TEST(TimeOfImpact, OfASpinningRodAgreesWithFineSampling) {
    const ConvexShape rod = convexShapeOf(Box{4, Real(0.1)}, {});
    const ConvexShape post = convexShapeOf(Circle{Real(0.1)}, {});
    const MotionPath spin = moving({}, {Real(0.1), 0}, Real(3.1));
    const MotionPath still = asleep({0, Real(1.7)});
    const Real expected = byFineStepping(rod, spin, post, still, 100000);
    const Real time = timeOfImpact(rod, spin, post, still, kTarget);
    ASSERT_LT(expected, 1);
    EXPECT_LE(time, expected + Real(2e-5)); // two sampling intervals
    const Real gap = separation(rod, spin.at(time), post, still.at(time)).distance;
    EXPECT_GT(gap, 0);
    EXPECT_LT(gap, 2 * kTarget);
}

TEST(TimeOfImpact, IgnoresTheSpinOfACircleAboutItsCentre) {
    const Real time =
        timeOfImpact(kWall, asleep({10, 0}), kBall, moving({}, {20, 0}, 1000), kTarget);
    EXPECT_TRUE(near(time * 20, 9, 2 * kTarget));
}

// One ball stops on its path (at another body); the other moves on.
TEST(TimeOfImpact, RespectsAStopOnThePath) {
    MotionPath ahead = moving({7, 0}, {10, 0});
    ahead.stopAt = Real(0.5); // at x = 12 from then on
    const Real time = timeOfImpact(kBall, ahead, kBall, moving({}, {20, 0}), kTarget);
    EXPECT_TRUE(near(time * 20, 11, 2 * kTarget));
    ahead.stopAt = 1; // no stop: contact after 6 m of relative displacement
    const Real later = timeOfImpact(kBall, ahead, kBall, moving({}, {20, 0}), kTarget);
    EXPECT_TRUE(near(later * 10, 6, 2 * kTarget));
}

// Random pairs and paths: the result may be early by the tolerance of the target, but never late
// and never in overlap.
TEST(TimeOfImpact, IsNeverLateOnRandomPaths) {
    constexpr std::uint64_t kSeed = 101;
    support::RandomNumbers random(kSeed);
    int hits = 0;
    for (int i = 0; i < 800; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        const ConvexShape a = convexShapeOf(
            support::randomPrimitive(random, support::kAllKinds[random.below(3)]), {});
        const ConvexShape b = convexShapeOf(
            support::randomPrimitive(random, support::kAllKinds[random.below(3)]), {});
        const MotionPath sweepA{random.pose(3), random.point(4), random.between(-2, 2)};
        const MotionPath sweepB{random.pose(3), random.point(4), random.between(-2, 2)};
        if (separation(a, sweepA.start, b, sweepB.start).distance < Real(0.05)) {
            continue;
        }
        const Real expected = byFineStepping(a, sweepA, b, sweepB, 2000);
        const Real time = timeOfImpact(a, sweepA, b, sweepB, kTarget);
        ASSERT_LE(std::min(time, Real(1.5)), expected + Real(1e-5));
        if (time < 1) {
            ++hits;
            ASSERT_GT(separation(a, sweepA.at(time), b, sweepB.at(time)).distance, 0);
        }
    }
    EXPECT_GT(hits, 50);
}

// The target of a World with a length unit of 1 m in float, and the rounding of a path of up to 10
// m.
constexpr Real kCloseTarget = Real(5) / 1024 / 1024;
constexpr Real kRounding = support::byPrecision(2e-5, 1e-13);

// The search after an early stop must advance as far as any other. If the short path up to the stop
// limits it, it exhausts its rounds in double and ends up to 3 m early.
TEST(TimeOfImpact, EndsInContactAfterAnEarlyStop) {
    const ConvexShape box = convexShapeOf(Box{1, 1}, {});
    const ConvexShape ball = convexShapeOf(Circle{Real(0.5)}, {});
    support::RandomNumbers random(214);
    const int sweeps = support::draws(200000);
    int hits = 0;
    for (int i = 0; i < sweeps; ++i) {
        SCOPED_TRACE(testing::Message() << "path " << i);
        const ConvexShape& other = random.below(2) == 0 ? box : ball;
        const double turn = random.below(2) == 0 ? 0 : 0.6;
        MotionPath a{random.pose(4), random.point(4), random.between(-turn, turn)};
        MotionPath b{{a.start.position + random.point(4), random.rotation()},
                     random.point(4),
                     random.between(-turn, turn)};
        a.stopAt = std::pow(Real(10), random.between(-12, 0));
        b.stopAt = std::sqrt(random.between(0, 1)); // with all digits of a Real
        const auto gapAt = [&](Real t) {
            return separation(box, a.at(t), other, b.at(t)).distance;
        };
        if (gapAt(0) < Real(0.05)) {
            continue;
        }
        if (const Real t = timeOfImpact(box, a, other, b, kCloseTarget); t <= 1) {
            ASSERT_LT(gapAt(t), Real(1e-3));
            ++hits;
        }
    }
    EXPECT_GT(hits, sweeps / 50);
}

// Polygons that tumble as in a heap stop in contact. With axes that do not rotate, one in ten
// exhausts its rounds and stops in the air.
TEST(TimeOfImpact, EndsInContactForRotatingPolygons) {
    support::RandomNumbers random(213);
    const int sweeps = support::draws(20000);
    int hits = 0;
    for (int i = 0; i < sweeps; ++i) {
        SCOPED_TRACE(testing::Message() << "path " << i);
        const ConvexShape shapeA = support::randomFewCorners(random);
        const ConvexShape shapeB = support::randomFewCorners(random);
        const MotionPath a{random.pose(4), random.point(0.5), random.between(-0.6, 0.6)};
        const MotionPath b{{a.start.position + random.point(4), random.rotation()},
                           random.point(0.5),
                           random.between(-0.6, 0.6)};
        const auto gapAt = [&](Real t) {
            return separation(shapeA, a.at(t), shapeB, b.at(t)).distance;
        };
        if (gapAt(0) < 2 * kCloseTarget) {
            continue;
        }
        if (const Real t = timeOfImpact(shapeA, a, shapeB, b, kCloseTarget); t <= 1) {
            ASSERT_TRUE(near(gapAt(t), kCloseTarget, kCloseTarget + kRounding));
            ++hits;
        }
    }
    EXPECT_GT(hits, sweeps / 50);
}

} // namespace
} // namespace kodo::time_of_impact_test
