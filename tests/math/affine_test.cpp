// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

namespace kodo {
namespace {

using support::kEpsilon;
using support::near;

TEST(Affine, DefaultIsTheIdentity) {
    EXPECT_EQ(Affine{} * (Vec2{3, 4}), (Vec2{3, 4}));
    EXPECT_EQ(Affine{}.determinant(), 1);
}

TEST(Affine, ScalesAndMirrors) {
    EXPECT_EQ(Affine::scale(2, -3) * (Vec2{1, 1}), (Vec2{2, -3}));
    EXPECT_EQ(Affine::scale(2, -3).determinant(), -6);
}

// B2: compose.
TEST(Affine, ProductAppliesTheRightFactorFirst) {
    const Affine turn = Affine::from(Transform{{1, 0}, {0, 1}});
    const Affine stretch = Affine::scale(2, 1);
    EXPECT_EQ((turn * stretch) * (Vec2{3, 4}), turn * (stretch * (Vec2{3, 4})));
    EXPECT_EQ((turn * stretch) * (Vec2{3, 4}), (Vec2{-3, 6}));
    EXPECT_EQ((stretch * turn) * (Vec2{3, 4}), (Vec2{-6, 3}));
}

TEST(Affine, AgreesWithTheTransformItIsMadeFrom) {
    support::RandomNumbers random(9);
    for (int i = 0; i < 1000; ++i) {
        const Transform t = random.pose(10);
        const Vec2 p = random.point(10);
        EXPECT_TRUE(near(Affine::from(t) * p, t * p, 40 * kEpsilon));
    }
}

// B2: invert. The error grows with the stretch. Columns of 1..3 with |determinant| > 0.5 keep it
// below some hundred roundings of 10.
TEST(Affine, InverseUndoesTheMap) {
    support::RandomNumbers random(10);
    int tried = 0;
    for (int i = 0; i < 10000; ++i) {
        const Affine map{random.point(3), random.point(3), random.point(10)};
        if (std::abs(map.determinant()) < Real(0.5)) {
            continue;
        }
        ++tried;
        const Vec2 p = random.point(10);
        const auto inverse = map.inverse();
        ASSERT_TRUE(inverse.has_value());
        EXPECT_TRUE(near(*inverse * (map * p), p, 4000 * kEpsilon));
    }
    EXPECT_GT(tried, 5000);
}

// B2: a singular map has no inverse; the result is never NaN.
TEST(Affine, HasNoInverseIfSingular) {
    EXPECT_FALSE(Affine::scale(0, 1).inverse().has_value());
    EXPECT_FALSE((Affine{{1, 2}, {2, 4}, {5, 6}}.inverse().has_value()));
    EXPECT_FALSE((Affine{{0, 0}, {0, 0}, {}}.inverse().has_value()));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_FALSE((Affine{{nan, 0}, {0, 1}, {}}.inverse().has_value()));
}

// A small scale is not singular.
TEST(Affine, InvertsATinyScale) {
    const auto inverse = Affine::scale(Real(1e-6), Real(1e-6)).inverse();
    ASSERT_TRUE(inverse.has_value());
    EXPECT_TRUE(support::nearShare(inverse->x.x, 1e6L, 4 * kEpsilon));
}

// B2: the determinant may exceed the range of Real although the inverse does not. Then there is an
// inverse. If the inverse exceeds the range, there is none, and never a NaN.
TEST(Affine, HasAnInverseExactlyWhenItIsRepresentable) {
    const Real large = support::byPrecision(1e25, 1e200);
    for (const auto& [sx, sy] : {std::pair(large, large), std::pair(1 / large, 1 / large),
                                 std::pair(large, 1 / large), std::pair(-large, Real(3))}) {
        SCOPED_TRACE(testing::Message() << sx << ", " << sy);
        const auto inverse =
            (Affine::from(Transform{{}, {Real(0.6), Real(0.8)}}) * Affine::scale(sx, sy)).inverse();
        ASSERT_TRUE(inverse.has_value());
        EXPECT_TRUE(support::nearShare(inverse->x.x * sx, 0.6L, 8 * kEpsilon));
        EXPECT_TRUE(support::nearShare(inverse->y.x * sx, 0.8L, 8 * kEpsilon));
        EXPECT_TRUE(support::nearShare(inverse->x.y * sy, -0.8L, 8 * kEpsilon));
        EXPECT_TRUE(support::nearShare(inverse->y.y * sy, 0.6L, 8 * kEpsilon));
    }
    const Real infinite = std::numeric_limits<Real>::infinity();
    const Real least = std::numeric_limits<Real>::denorm_min();
    for (const Affine& map :
         {Affine::scale(infinite, infinite), Affine::scale(infinite, 1),
          Affine{{infinite, 1}, {1, 1}, {}}, Affine::scale(least, least),
          Affine{{1, 0}, {0, 1}, {infinite, 0}},
          Affine{{1 / large, 0}, {0, 1}, {support::byPrecision(1e30, 1e150), 0}}}) {
        EXPECT_FALSE(map.inverse().has_value());
    }
}

} // namespace
} // namespace kodo
