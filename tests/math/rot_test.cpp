// SPDX-License-Identifier: MIT
#include <kodo/math.hpp>
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

TEST(Rot, DefaultIsTheIdentity) {
    EXPECT_EQ(Rot{} * (Vec2{3, 4}), (Vec2{3, 4}));
    EXPECT_EQ(Rot{}.angle(), 0);
}

TEST(Rot, RotatesCounterClockwise) {
    const Rot quarter{0, 1};
    EXPECT_EQ(quarter * (Vec2{1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(quarter.xAxis(), (Vec2{0, 1}));
    EXPECT_EQ(quarter.yAxis(), (Vec2{-1, 0}));
    EXPECT_TRUE(near(Rot::fromAngle(std::numbers::pi_v<Real> / 2) * (Vec2{1, 0}), Vec2{0, 1},
                     2 * kEpsilon));
}

// B1: into and out of an orientation. Each direction has two products and a sum of numbers up to
// 100.
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

TEST(Rot, NormalizeGivesUnitLength) {
    EXPECT_TRUE(near(norm(normalize(Rot{3, 4})), 1, 2 * kEpsilon));
    EXPECT_TRUE(near(normalize(Rot{3, 4}).c, 0.6L, kEpsilon));
}

// B3: ten million rotations by an uneven angle. The thesis permits an error of 1e-6. Each rotation
// corrects the length, so only the last rounding remains.
TEST(Rot, KeepsUnitLengthOverTenMillionRotations) {
    Rot q;
    for (int i = 0; i < support::draws(10000000); ++i) {
        q = turned(q, Real(0.0123));
    }
    EXPECT_TRUE(near(norm(q), 1, 4 * kEpsilon));
}

// 300 steps of 0.01 rad: each rotation adds a rounding to the error of the angle.
TEST(Rot, SmallRotationsAddUp) {
    Rot q;
    for (int i = 0; i < 300; ++i) {
        q = turned(q, Real(0.01));
    }
    EXPECT_TRUE(near(q.angle(), 300 * static_cast<long double>(Real(0.01)),
                     byPrecision(300 * 1e-7, 300 * 2e-16)));
}

TEST(Rot, RotationByALargeAngleIsExact) {
    const Rot q = turned(Rot{}, Real(7));
    EXPECT_TRUE(near(q.c, std::cos(7.0L), 4 * kEpsilon));
    EXPECT_TRUE(near(q.s, std::sin(7.0L), 4 * kEpsilon));
}

// Angles up to those of the highest speed: the direction is then inaccurate, but its length is 1.
// Three rotations correct a vector that is as far off the unit circle as a snapshot permits.
TEST(Rot, RotationRestoresUnitLength) {
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
