// SPDX-License-Identifier: MIT
#include <kodo/bodies/form.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

namespace kodo {
namespace {

using support::kEpsilon;
using support::near;
using support::nearShare;

std::shared_ptr<const Form> formOf(const Shape& shape, Real density = 1) {
    BodyDef def;
    def.shape = shape;
    def.density = density;
    return makeForm(partsOf(def));
}

TEST(Form, OfAPrimitiveHasOnePart) {
    const auto form = formOf(Box{2, 4, {1, 0}}, 3);
    ASSERT_EQ(form->parts.size(), 1u);
    EXPECT_EQ(form->mass.mass, 24);
    EXPECT_EQ(form->mass.center, (Vec2{1, 0}));
    EXPECT_EQ(form->area, 8);
    EXPECT_EQ(form->inside, 1);
    EXPECT_TRUE(near(form->reach, std::sqrt(5.0L), 4 * kEpsilon));
    // Outlines are kept about the centre of mass.
    EXPECT_EQ(form->parts[0].convex.vertices[0], (Vec2{-1, -2}));
}

TEST(Form, OfACompoundAddsItsParts) {
    const auto form = formOf(Compound{{Circle{1, {-3, 0}}, Circle{1, {3, 0}}}}, 2);
    ASSERT_EQ(form->parts.size(), 2u);
    const long double one = 2 * std::numbers::pi_v<long double>;
    EXPECT_TRUE(nearShare(form->mass.mass, 2 * one, 4 * kEpsilon));
    EXPECT_TRUE(near(form->mass.center, Vec2{}, 4 * kEpsilon));
    EXPECT_TRUE(nearShare(form->mass.inertia, 2 * (one / 2 + one * 9), 8 * kEpsilon));
    EXPECT_TRUE(nearShare(form->area, one, 4 * kEpsilon));
    EXPECT_EQ(form->reach, 4);
    EXPECT_EQ(form->swing, 4);
    EXPECT_EQ(form->inside, 1);
}

// Every outline lies within the reach, and a disc of the inner radius within every part.
TEST(Form, ReachAndInsideAreBounds) {
    support::RandomNumbers random(201);
    for (int i = 0; i < 500; ++i) {
        Compound compound;
        for (std::size_t k = 0; k < 1 + random.below(4); ++k) {
            compound.parts.push_back(
                support::randomPrimitive(random, support::kAllKinds[random.below(3)]));
        }
        const auto form = formOf(compound);
        for (const Part& part : form->parts) {
            for (const Vec2 vertex : part.convex.vertices) {
                ASSERT_LE(length(vertex) + part.convex.radius, form->reach * (1 + 4 * kEpsilon));
            }
            ASSERT_LE(part.convex.swing(), form->swing);
            ASSERT_LE(form->inside, part.convex.inside);
            ASSERT_GT(part.convex.inside, 0);
        }
    }
}

TEST(Form, PartsCarryMaterialAndDensity) {
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
