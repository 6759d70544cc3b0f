// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include "bodies/body_geometry.hpp"

namespace kodo {
namespace {

using support::kEpsilon;
using support::near;
using support::nearShare;

std::shared_ptr<const BodyGeometry> formOf(const Shape& shape, Real density = 1) {
    BodyDef def;
    def.shape = shape;
    def.density = density;
    return makeGeometry(partsOf(def));
}

TEST(BodyGeometry, OfAPrimitiveHasOnePart) {
    const auto geometry = formOf(Box{2, 4, {1, 0}}, 3);
    ASSERT_EQ(geometry->parts.size(), 1u);
    EXPECT_EQ(geometry->mass.mass, 24);
    EXPECT_EQ(geometry->mass.center, (Vec2{1, 0}));
    EXPECT_EQ(geometry->area, 8);
    EXPECT_EQ(geometry->coreRadius, 1);
    EXPECT_TRUE(near(geometry->boundingRadius, std::sqrt(5.0L), 4 * kEpsilon));
    // Vertices are relative to the centre of mass.
    EXPECT_EQ(geometry->parts[0].convex.vertices[0], (Vec2{-1, -2}));
}

TEST(BodyGeometry, OfACompoundAddsUpItsParts) {
    const auto geometry = formOf(Compound{{Circle{1, {-3, 0}}, Circle{1, {3, 0}}}}, 2);
    ASSERT_EQ(geometry->parts.size(), 2u);
    const long double one = 2 * std::numbers::pi_v<long double>;
    EXPECT_TRUE(nearShare(geometry->mass.mass, 2 * one, 4 * kEpsilon));
    EXPECT_TRUE(near(geometry->mass.center, Vec2{}, 4 * kEpsilon));
    EXPECT_TRUE(nearShare(geometry->mass.inertia, 2 * (one / 2 + one * 9), 8 * kEpsilon));
    EXPECT_TRUE(nearShare(geometry->area, one, 4 * kEpsilon));
    EXPECT_EQ(geometry->boundingRadius, 4);
    EXPECT_EQ(geometry->rotationReach, 4);
    EXPECT_EQ(geometry->coreRadius, 1);
}

// The bounding radius contains every shape. The core radius is at most that of every part.
TEST(BodyGeometry, BoundingRadiusAndCoreRadiusAreBounds) {
    support::RandomNumbers random(201);
    for (int i = 0; i < 500; ++i) {
        Compound compound;
        for (std::size_t k = 0; k < 1 + random.below(4); ++k) {
            compound.parts.push_back(
                support::randomPrimitive(random, support::kAllKinds[random.below(3)]));
        }
        const auto geometry = formOf(compound);
        for (const Part& part : geometry->parts) {
            for (const Vec2 vertex : part.convex.vertices) {
                ASSERT_LE(length(vertex) + part.convex.radius,
                          geometry->boundingRadius * (1 + 4 * kEpsilon));
            }
            ASSERT_LE(part.convex.rotationReach(), geometry->rotationReach);
            ASSERT_LE(geometry->coreRadius, part.convex.coreRadius);
            ASSERT_GT(part.convex.coreRadius, 0);
        }
    }
}

TEST(BodyGeometry, PartsHaveMaterialAndDensity) {
    BodyDef def;
    def.shape = Compound{{Circle{1}, Box{1, 1}}};
    def.material = withFriction(Real(0.1), Real(0.9));
    def.density = 7;
    for (const Part& part : partsOf(def)) {
        EXPECT_EQ(part.material, def.material);
        EXPECT_EQ(part.density, 7);
    }
}

} // namespace
} // namespace kodo
