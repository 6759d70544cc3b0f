// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::near;

// As the World uses it for a length unit of 1 m. The search may stop half a target early.
constexpr Real kTarget = Real(1) / 1024;

Sweep resting(Vec2 position, Real angle = 0) {
    return {{position, Rot::fromAngle(angle)}, {}, 0};
}

Sweep moving(Vec2 position, Vec2 move, Real turn = 0) {
    return {{position, {}}, move, turn};
}

const Convex kBall = convexOf(Circle{Real(0.5)}, {});
const Convex kWall = convexOf(Box{1, 20}, {});

TEST(TimeOfImpact, OfABallFlyingAtAWall) {
    for (const Real speed : {Real(12), Real(100), Real(1e5)}) {
        const Real time =
            timeOfImpact(kWall, resting({10, 0}), kBall, moving({}, {speed, 0}), kTarget);
        // Surfaces are 9 m apart; the wanted gap is one target, up to one and a half.
        EXPECT_LE(time * speed, 9 - kTarget * Real(0.99));
        EXPECT_GE(time * speed, 9 - kTarget * 2);
    }
}

TEST(TimeOfImpact, IsNeverWhenTheyDoNotReachEachOther) {
    EXPECT_GE(timeOfImpact(kWall, resting({10, 0}), kBall, moving({}, {Real(8.9), 0}), kTarget), 1);
    EXPECT_GE(timeOfImpact(kWall, resting({10, 0}), kBall, moving({}, {-50, 0}), kTarget), 1);
    EXPECT_GE(timeOfImpact(kWall, resting({10, 0}), kBall, moving({}, {0, 50}), kTarget), 1);
}

// Ball of 0.5 m at a corner, its centre 0.3 m beyond the side: contact when the centre is 0.4 m
// short of the corner (3, 4, 5).
TEST(TimeOfImpact, OfABallAtACorner) {
    const Convex box = convexOf(Box{2, 2}, {});
    const Real time =
        timeOfImpact(box, resting({10, 0}), kBall, moving({0, Real(1.3)}, {20, 0}), kTarget);
    // Along the path the gap closes with 0.8 of the speed.
    EXPECT_TRUE(near(time * 20, 8.6L, 2 * kTarget / Real(0.8)));
}

// Both move; only their relative motion matters: 9 m of gap at 20 + 10 m a step.
TEST(TimeOfImpact, OfTwoMovers) {
    const Real time =
        timeOfImpact(kBall, moving({10, 0}, {-10, 3}), kBall, moving({}, {20, 3}), kTarget);
    EXPECT_TRUE(near(time * 30, 9, 2 * kTarget));
}

// A ball that passes a corner by 1 cm is not stopped there.
TEST(TimeOfImpact, IsNeverForAGrazingMiss) {
    const Convex box = convexOf(Box{2, 2}, {});
    const Sweep pass = moving({0, Real(1.51)}, {20, 0});
    EXPECT_GE(timeOfImpact(box, resting({10, 0}), kBall, pass, kTarget), 1);
    const Sweep graze = moving({0, Real(1.49)}, {20, 0});
    EXPECT_LT(timeOfImpact(box, resting({10, 0}), kBall, graze, kTarget), 1);
}

/// The first moment at which fine stepping sees them closer than the target.
Real byFineStepping(const Convex& a, const Sweep& sweepA, const Convex& b, const Sweep& sweepB,
                    int parts) {
    for (int i = 0; i <= parts; ++i) {
        const Real t = static_cast<Real>(i) / static_cast<Real>(parts);
        if (separation(a, sweepA.at(t), b, sweepB.at(t)).distance <= kTarget) {
            return t;
        }
    }
    return 2;
}

// A rod turning half a turn in one step sweeps over a small post, with the centre hardly moving.
TEST(TimeOfImpact, OfASpinningRod) {
    const Convex rod = convexOf(Box{4, Real(0.1)}, {});
    const Convex post = convexOf(Circle{Real(0.1)}, {});
    const Sweep spin = moving({}, {Real(0.1), 0}, Real(3.1));
    const Sweep still = resting({0, Real(1.7)});
    const Real expected = byFineStepping(rod, spin, post, still, 100000);
    const Real time = timeOfImpact(rod, spin, post, still, kTarget);
    ASSERT_LT(expected, 1);
    EXPECT_LE(time, expected + Real(2e-5)); // the width of a fine step
    const Real gap = separation(rod, spin.at(time), post, still.at(time)).distance;
    EXPECT_GT(gap, 0);
    EXPECT_LT(gap, 2 * kTarget);
}

TEST(TimeOfImpact, KnowsThatACircleAboutItsCentreDoesNotSpin) {
    const Real time =
        timeOfImpact(kWall, resting({10, 0}), kBall, moving({}, {20, 0}, 1000), kTarget);
    EXPECT_TRUE(near(time * 20, 9, 2 * kTarget));
}

// One of them stops on the way (at another body): the other comes on alone.
TEST(TimeOfImpact, RespectsWhereOneStops) {
    Sweep ahead = moving({7, 0}, {10, 0});
    ahead.stopAt = Real(0.5); // stands at x = 12 from then on
    const Real time = timeOfImpact(kBall, ahead, kBall, moving({}, {20, 0}), kTarget);
    EXPECT_TRUE(near(time * 20, 11, 2 * kTarget));
    ahead.stopAt = 1; // now it keeps running and is caught up with after 6 m of relative way
    const Real later = timeOfImpact(kBall, ahead, kBall, moving({}, {20, 0}), kTarget);
    EXPECT_TRUE(near(later * 10, 6, 2 * kTarget));
}

// Random pairs and motions: it may come early by the slack of the target, but never late, and never
// inside.
TEST(TimeOfImpact, IsNeverLateOnRandomSweeps) {
    constexpr std::uint64_t kSeed = 101;
    support::RandomNumbers random(kSeed);
    int hits = 0;
    for (int i = 0; i < 800; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        const Convex a =
            convexOf(support::randomPrimitive(random, support::kAllKinds[random.below(3)]), {});
        const Convex b =
            convexOf(support::randomPrimitive(random, support::kAllKinds[random.below(3)]), {});
        const Sweep sweepA{random.pose(3), random.point(4), random.between(-2, 2)};
        const Sweep sweepB{random.pose(3), random.point(4), random.between(-2, 2)};
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

// As a World sweeps for a length unit of 1 m in float, and what a way of up to 10 m is rounded by.
constexpr Real kCloseTarget = Real(5) / 1024 / 1024;
constexpr Real kRounding = support::byPrecision(2e-5, 1e-13);

// Of the way that is left after an early stop no less is looked at than of any other. When the
// short way up to the stop decided how far to look next, 41 of these ran out of rounds in double,
// and were stopped up to 3 m apart.
TEST(TimeOfImpact, LooksFarAfterAnEarlyStop) {
    const Convex box = convexOf(Box{1, 1}, {});
    const Convex ball = convexOf(Circle{Real(0.5)}, {});
    support::RandomNumbers random(214);
    const int sweeps = support::draws(200000);
    int hits = 0;
    for (int i = 0; i < sweeps; ++i) {
        SCOPED_TRACE(testing::Message() << "sweep " << i);
        const Convex& other = random.below(2) == 0 ? box : ball;
        const double turn = random.below(2) == 0 ? 0 : 0.6;
        Sweep a{random.pose(4), random.point(4), random.between(-turn, turn)};
        Sweep b{{a.start.position + random.point(4), random.rotation()},
                random.point(4),
                random.between(-turn, turn)};
        a.stopAt = std::pow(Real(10), random.between(-12, 0));
        b.stopAt = std::sqrt(random.between(0, 1)); // with all the digits that a Real has
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

// Polygons that tumble as in a heap are stopped where they touch. Told by axes that do not turn,
// 1 of 10 ran out of rounds, and was stopped in the air.
TEST(TimeOfImpact, StopsWhatTurnsWhereItTouches) {
    support::RandomNumbers random(213);
    const int sweeps = support::draws(20000);
    int hits = 0;
    for (int i = 0; i < sweeps; ++i) {
        SCOPED_TRACE(testing::Message() << "sweep " << i);
        const Convex shapeA = support::randomFewCorners(random);
        const Convex shapeB = support::randomFewCorners(random);
        const Sweep a{random.pose(4), random.point(0.5), random.between(-0.6, 0.6)};
        const Sweep b{{a.start.position + random.point(4), random.rotation()},
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
} // namespace kodo
