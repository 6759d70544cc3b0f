// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using Wide = BasicVec2<long double>;

// About eight roundings of numbers of about 10 m.
constexpr Real kExact = byPrecision(4e-6, 1e-14);

Wide wide(Vec2 v) {
    return {static_cast<long double>(v.x), static_cast<long double>(v.y)};
}

/// Fraction at which a ray meets a circle: the smaller root f of |from + f way - center| = radius.
std::optional<long double> onCircle(Wide from, Wide way, Wide center, long double radius) {
    const Wide m = from - center;
    const long double a = dot(way, way);
    const long double b = dot(m, way);
    const long double discriminant = b * b - a * (dot(m, m) - radius * radius);
    if (discriminant < 0) {
        return std::nullopt;
    }
    return (-b - std::sqrt(discriminant)) / a;
}

// Rays at a disc from all sides, against the quadratic formula in long double. Grazing rays are
// skipped, since the root magnifies rounding there.
TEST(Casts, ARayHitsADiscAtTheExactPoint) {
    constexpr std::uint64_t kSeed = 15;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        World world;
        const Vec2 center = random.point(3);
        const Real radius = random.between(0.2, 2);
        const BodyId disc = world.add(support::ballDef(center, radius));
        const Vec2 from = center + Real(8) * random.rotation().xAxis();
        const Vec2 to = center + random.point(2) - (from - center);
        const auto hit = rayCast(world, from, to);
        const Wide way = wide(to) - wide(from);
        const auto exact =
            onCircle(wide(from), way, wide(center), static_cast<long double>(radius));
        const long double offset =
            std::abs(cross(wide(center) - wide(from), way)) / std::sqrt(dot(way, way));
        if (std::abs(offset / static_cast<long double>(radius) - 1) < 0.05L) {
            continue;
        }
        ASSERT_EQ(hit.has_value(), exact.has_value()) << i;
        if (hit) {
            ++hits;
            EXPECT_EQ(hit->body, disc);
            EXPECT_TRUE(near(hit->point, wide(from) + *exact * way, 4 * kExact)) << i;
            EXPECT_TRUE(near(hit->fraction, *exact, kExact)) << i;
        }
    }
    EXPECT_GT(hits, 200);
}

// A tangent ray hits; at one epsilon further out it misses. A ray that starts inside hits at
// fraction 0 without a normal.
TEST(Casts, ATangentRayHitsAndARayFromInsideHasNoNormal) {
    World world;
    world.add(support::ballDef({2, 0}, 1));
    const auto tangent = rayCast(world, {-4, 1}, {8, 1});
    ASSERT_TRUE(tangent);
    EXPECT_TRUE(near(tangent->point, Vec2{2, 1}, kExact));
    EXPECT_EQ(tangent->normal, (Vec2{0, 1}));
    EXPECT_FALSE(rayCast(world, {-4, 1 + support::kEpsilon}, {8, 1 + support::kEpsilon}));
    const auto inside = rayCast(world, {Real(2.5), 0}, {9, 0});
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->fraction, 0);
    EXPECT_EQ(inside->normal, Vec2{});
}

// Rays at a rotated box hit the face whose slab they enter last.
TEST(Casts, ARayHitsARotatedBoxOnItsFace) {
    for (const double degrees : {0.0, 17.0, 45.0, 80.0}) {
        SCOPED_TRACE(degrees);
        World world;
        BodyDef def = support::boxDef({1, 2}, 4, 2);
        def.rotation = Rot::fromAngle(static_cast<Real>(degrees * 3.14159265358979 / 180));
        world.add(def);
        // Towards the middle of the right face, from 5 m away, at an oblique angle.
        const Vec2 face = def.position + def.rotation * Vec2{2, Real(0.25)};
        const Vec2 from = face + def.rotation * Vec2{5, 1};
        const auto hit = rayCast(world, from, face - (from - face));
        ASSERT_TRUE(hit);
        EXPECT_TRUE(near(hit->fraction, 0.5L, kExact));
        EXPECT_TRUE(near(hit->point, face, kExact));
        EXPECT_TRUE(near(hit->normal, def.rotation.xAxis(), kExact));
    }
}

// Casting a disc at a disc equals casting a ray at a disc with the sum of both radii.
TEST(Casts, ADiscAtADiscEqualsARayAtTheSumOfTheirRadii) {
    constexpr std::uint64_t kSeed = 16;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < 200; ++i) {
        World world;
        world.add(support::ballDef({}, Real(0.75)));
        const Vec2 from = Real(6) * random.rotation().xAxis();
        const Vec2 move = Real(-2) * from + random.point(0.8); // well inside both discs
        const auto hit = shapeCast(world, Circle{Real(0.5)}, {from, {}}, move);
        const auto exact = onCircle(wide(from), wide(move), {}, 1.25L);
        ASSERT_TRUE(hit && exact) << i;
        EXPECT_TRUE(near(hit->fraction, *exact, kExact)) << i;
        const Wide center = wide(from) + *exact * wide(move);
        EXPECT_TRUE(near(hit->normal, center / 1.25L, kExact)) << i;
    }
}

} // namespace
} // namespace kodo
