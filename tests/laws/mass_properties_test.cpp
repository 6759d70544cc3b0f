// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// Closed forms of the mass properties read from a body. Rounding only.
constexpr Real kTextbookExact = byPrecision(2e-6, 1e-12);

BodyView bodyOf(World& world, const Shape& shape, Vec2 position = {}) {
    const BodyId id = world.add({.shape = shape, .position = position, .density = 2});
    return world[id];
}

TEST(MassProperties, OfADisc) {
    World world;
    const BodyView body = bodyOf(world, Circle{3});
    EXPECT_TRUE(nearShare(body.mass(), 18 * std::numbers::pi_v<long double>, kTextbookExact));
    EXPECT_TRUE(nearShare(body.inertia(), 81 * std::numbers::pi_v<long double>, kTextbookExact));
}

TEST(MassProperties, OfABox) {
    World world;
    const BodyView body = bodyOf(world, Box{3, 4});
    EXPECT_TRUE(nearShare(body.mass(), 24, kTextbookExact));
    EXPECT_TRUE(nearShare(body.inertia(), 24.0L * 25 / 12, kTextbookExact));
}

TEST(MassProperties, OfATriangle) {
    World world;
    const BodyView body = bodyOf(world, Polygon{{{0, 0}, {3, 0}, {0, 4}}});
    EXPECT_TRUE(nearShare(body.mass(), 12, kTextbookExact));
    EXPECT_TRUE(nearShare(body.inertia(), 12.0L * 50 / 36, kTextbookExact));
    EXPECT_TRUE(near(body.center(), Vec2{1, Real(4) / 3}, kTextbookExact));
}

// A 1000-gon equals a disc within (pi / 1000)^2. The reference is the closed form of the regular
// polygon.
TEST(MassProperties, OfRegularPolygons) {
    for (const int n : {5, 6, 12, 1000}) {
        SCOPED_TRACE(n);
        Polygon polygon;
        const long double step = 2 * std::numbers::pi_v<long double> / n;
        for (int i = 0; i < n; ++i) {
            polygon.corners.push_back(
                {static_cast<Real>(std::cos(step * i)), static_cast<Real>(std::sin(step * i))});
        }
        World world;
        const BodyView body = bodyOf(world, polygon);
        const long double mass = n * std::sin(step);
        EXPECT_TRUE(nearShare(body.mass(), mass, 4 * kTextbookExact));
        EXPECT_TRUE(nearShare(body.inertia(), mass * (2 + std::cos(step)) / 6, 4 * kTextbookExact));
    }
}

// R4: the parallel axis theorem, for an L of a 2 x 1 and a 1 x 1 box.
TEST(MassProperties, OfAnLCompound) {
    World world;
    const Compound ell{{Box{2, 1, {1, Real(0.5)}}, Box{1, 1, {Real(0.5), Real(1.5)}}}};
    const BodyView body = bodyOf(world, ell);
    EXPECT_TRUE(nearShare(body.mass(), 6, kTextbookExact));
    EXPECT_TRUE(near(body.center(), Vec2{Real(5) / 6, Real(5) / 6}, kTextbookExact));
    // 2 [10/12 + 2/12 + 2 (1/36 + 1/9) + 1/9 + 4/9]
    EXPECT_TRUE(nearShare(body.inertia(), 2 * (1 + 2.0L * 5 / 36 + 5.0L / 9), kTextbookExact));
}

// Mass properties do not depend on the position of the body.
TEST(MassProperties, DoNotDependOnThePosition) {
    World world;
    const Compound ell{{Box{2, 1, {1, Real(0.5)}}, Box{1, 1, {Real(0.5), Real(1.5)}}}};
    const BodyView here = bodyOf(world, ell);
    const BodyView there = bodyOf(world, ell, {1000, -1000});
    EXPECT_EQ(here.mass(), there.mass());
    EXPECT_EQ(here.inertia(), there.inertia());
}

// Shapes 1000 m from the origin of their frame keep their inertia: 1e-9 in double. In float the
// corners are rounded to 6e-5 m, which limits the relative accuracy to 1e-3.
TEST(MassProperties, AreAccurateForAShapeFarFromItsFrame) {
    World world;
    const auto at = [](Real x, Real y) { return Vec2{1000 + x, -1000 + y}; };
    const Compound ell{{Box{2, 1, at(1, Real(0.5))}, Box{1, 1, at(Real(0.5), Real(1.5))}}};
    const BodyView body = bodyOf(world, ell);
    EXPECT_TRUE(
        nearShare(body.inertia(), 2 * (1 + 2.0L * 5 / 36 + 5.0L / 9), byPrecision(1e-3, 1e-9)));
    const BodyView triangle = bodyOf(world, Polygon{{at(0, 0), at(3, 0), at(0, 4)}});
    EXPECT_TRUE(nearShare(triangle.inertia(), 12.0L * 50 / 36, byPrecision(1e-5, 1e-9)));
}

// At 1e6 m a corner is rounded to 1e-10 m in double. Float rejects such a position.
TEST(MassProperties, AreAccurateOrRefusedAtAMillionMetres) {
    World world;
    BodyDef def{.shape = Compound{{Box{2, 1, {Real(1e6) + 1, Real(-1e6) + Real(0.5)}},
                                   Box{1, 1, {Real(1e6) + Real(0.5), Real(-1e6) + Real(1.5)}}}},
                .density = 2};
    if (kMaxCoordinate < Real(1e6)) {
        EXPECT_THROW(world.add(def), BadDefinition);
        return;
    }
    const BodyView body = world[world.add(def)];
    EXPECT_TRUE(nearShare(body.mass(), 6, 1e-9L));
    EXPECT_TRUE(nearShare(body.inertia(), 2 * (1 + 2.0L * 5 / 36 + 5.0L / 9), 1e-6L));
}

// R4: mass and inertia scale with the density, for dynamic and static bodies.
TEST(MassProperties, AreProportionalToDensity) {
    World world;
    const BodyId light = world.add({.shape = Box{1, 2}, .density = Real(0.25)});
    const BodyId heavy = world.add({.shape = Box{1, 2}, .density = 8, .type = BodyType::Static});
    EXPECT_EQ(world[heavy].mass(), 32 * world[light].mass());
    EXPECT_TRUE(nearShare(world[heavy].inertia(), 32 * world[light].inertia(), kTextbookExact));
}

} // namespace
} // namespace kodo
