// SPDX-License-Identifier: MIT
#include <kodo/math/rot.hpp>
#include <support/draws.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::kEpsilon;
using support::near;

Real norm(Rot q) {
    return length(Vec2{q.c, q.s});
}

TEST(Rot, StartsUnturned) {
    EXPECT_EQ(Rot{} * (Vec2{3, 4}), (Vec2{3, 4}));
    EXPECT_EQ(Rot{}.angle(), 0);
}

TEST(Rot, TurnsCounterClockwise) {
    const Rot quarter{0, 1};
    EXPECT_EQ(quarter * (Vec2{1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(quarter.xAxis(), (Vec2{0, 1}));
    EXPECT_EQ(quarter.yAxis(), (Vec2{-1, 0}));
    EXPECT_TRUE(near(Rot::fromAngle(std::numbers::pi_v<Real> / 2) * (Vec2{1, 0}), Vec2{0, 1},
                     2 * kEpsilon));
}

// B1: into and out of an orientation. Two products and a sum each way, of numbers up to 100.
TEST(Rot, UnrotateUndoesRotate) {
    support::RandomNumbers random(4);
    for (int i = 0; i < 10000; ++i) {
        const Rot q = random.rotation();
        const Vec2 v = random.point(100);
        EXPECT_TRUE(near(unrotate(q, q * v), v, 600 * kEpsilon));
        EXPECT_EQ(unrotate(q, v), q.inverse() * v);
    }
}

TEST(Rot, AnglesAddWhenRotationsMultiply) {
    support::RandomNumbers random(5);
    for (int i = 0; i < 10000; ++i) {
        const Real a = random.between(-1.5, 1.5);
        const Real b = random.between(-1.5, 1.5);
        const Rot q = Rot::fromAngle(a) * Rot::fromAngle(b);
        EXPECT_TRUE(near(q.angle(), static_cast<long double>(a) + static_cast<long double>(b),
                         10 * kEpsilon)); // the angles reach 3, whose last place is 2 epsilon
    }
}

TEST(Rot, AngleUndoesFromAngle) {
    for (int i = -3141; i <= 3141; ++i) {
        const Real angle = static_cast<Real>(i) / 1000;
        EXPECT_TRUE(near(Rot::fromAngle(angle).angle(), angle, 6 * kEpsilon));
    }
}

TEST(Rot, NormalizeBringsBackToUnitLength) {
    EXPECT_TRUE(near(norm(normalize(Rot{3, 4})), 1, 2 * kEpsilon));
    EXPECT_TRUE(near(normalize(Rot{3, 4}).c, 0.6L, kEpsilon));
}

// B3: ten million turns by an uneven angle. 1e-6 is what the thesis's user may rely on; what
// each turn adds is taken out again, so only the last rounding is left.
TEST(Rot, StaysUnitLengthOverTenMillionTurns) {
    Rot q;
    for (int i = 0; i < support::draws(10000000); ++i) {
        q = turned(q, Real(0.0123));
    }
    EXPECT_TRUE(near(norm(q), 1, 4 * kEpsilon));
}

// Three hundred steps of 0.01 rad: the error of an angle grows by a rounding with each turn.
TEST(Rot, TurnsByAsMuchAsItIsTold) {
    Rot q;
    for (int i = 0; i < 300; ++i) {
        q = turned(q, Real(0.01));
    }
    EXPECT_TRUE(near(q.angle(), 300 * static_cast<long double>(Real(0.01)),
                     byPrecision(300 * 1e-7, 300 * 2e-16)));
}

TEST(Rot, TurnsByALargeAngleExactlyOnTheCircle) {
    const Rot q = turned(Rot{}, Real(7));
    EXPECT_TRUE(near(q.c, std::cos(7.0L), 4 * kEpsilon));
    EXPECT_TRUE(near(q.s, std::sin(7.0L), 4 * kEpsilon));
}

// By however large an angle, up to the highest speed: then the direction means little, but it still
// is one. From a vector that is as far off the circle as a snapshot may hold, three turns lead
// back.
TEST(Rot, TurnsOntoTheCircleFromWhereverItIs) {
    for (const Real radians : {Real(1e5), Real(-1e6), Real(1e7)}) {
        EXPECT_TRUE(near(norm(turned(Rot{}, radians)), 1, 1e-6)) << radians;
    }
    Rot q{Real(1.001), 0};
    for (int i = 0; i < 3; ++i) {
        q = turned(q, Real(0.1));
    }
    EXPECT_TRUE(near(norm(q), 1, 4 * kEpsilon));
}

} // namespace
} // namespace kodo
