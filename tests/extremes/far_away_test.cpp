// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <numbers>

namespace kodo {
namespace {

/// A stack of three boxes and a rolling ball on a floor, at a given position.
struct StackAt {
    World world{{.gravity = support::kEarth}};
    std::vector<BodyId> bodies;
    Vec2 place;

    explicit StackAt(Vec2 at) : place(at) {
        world.add(
            {.shape = Box{40, 1}, .position = at + Vec2{0, Real(-0.5)}, .type = BodyType::Static});
        for (int i = 0; i < 3; ++i) {
            bodies.push_back(
                world.add(support::boxDef(at + Vec2{0, Real(0.5) + static_cast<Real>(i)}, 1, 1)));
        }
        BodyDef ball = support::ballDef(at + Vec2{4, Real(0.5)}, Real(0.5));
        ball.velocity = {2, 0};
        bodies.push_back(world.add(ball));
    }
    Vec2 position(std::size_t i) const { return world[bodies[i]].position() - place; }
};

/// m, spacing of adjacent numbers at that distance.
Real gridAt(Real distance) {
    return distance * support::kEpsilon;
}

// In double, motion at 1e7 m agrees with that at the origin within 1e-6 m: 300 steps, each rounded
// by 1e-9 m. In float, adjacent numbers at 1000 m differ by 6e-5 m, which gives a few tenths of a
// millimetre per second.
TEST(FarAway, MotionAgreesWithThatAtTheOrigin) {
    for (const Real far : {support::byPrecision(100, 1e5), support::byPrecision(1000, 1e7)}) {
        SCOPED_TRACE(far);
        StackAt here({0, 0});
        StackAt there({far, -far});
        support::run(here.world, 300);
        support::run(there.world, 300);
        const Real tolerance = support::byPrecision(100 * static_cast<double>(gridAt(far)), 1e-6);
        for (std::size_t i = 0; i < here.bodies.size(); ++i) {
            EXPECT_TRUE(support::near(there.position(i), here.position(i), tolerance)) << i;
        }
    }
}

/// m, height of a frictionless disc over a slope after 50 s, 100 m from the origin of the slope.
Real heightOnSlope(const Rot& slope, bool segment, Real spin) {
    const Vec2 along = slope.xAxis();
    const Vec2 up = slope.yAxis();
    Material smooth;
    smooth.staticFriction = smooth.kineticFriction = 0;
    World world({.gravity = Real(-10) * up});
    BodyDef ground{.shape = Plane{up, 0}, .type = BodyType::Static};
    if (segment) {
        ground.shape = Segment{Real(-200) * along, Real(200) * along, true};
    }
    world.add(ground);
    BodyDef ball = support::ballDef(Real(100) * along + Real(0.5) * up, Real(0.5), smooth);
    ball.angularVelocity = spin;
    const BodyId disc = world.add(ball);
    support::run(world, 3000);
    return dot(up, world[disc].position()) - Real(0.5);
}

// The spin of a disc does not lift or lower it: its contact has no lever arm, even far from the
// origin of the ground. A lever arm of 2e-6 m, a rounding at 100 m, would lift it by 5 mm in that
// time.
TEST(FarAway, ASpinningDiscOnASlopeKeepsItsHeight) {
    for (const Real degrees : {Real(6), Real(13), Real(22), Real(34)}) {
        const Rot slope = Rot::fromAngle(degrees * std::numbers::pi_v<Real> / 180);
        for (const bool segment : {false, true}) {
            SCOPED_TRACE(testing::Message() << degrees << (segment ? " segment" : " plane"));
            const Real still = heightOnSlope(slope, segment, 0);
            const Real spun = heightOnSlope(slope, segment, 50);
            EXPECT_TRUE(support::near(spun, still, support::byPrecision(2e-4, 1e-9)));
        }
    }
}

// At the limit no body falls through or is thrown out. Positions are no more accurate than the
// number spacing.
TEST(FarAway, AtTheLimitAStackStands) {
    const Real far = kMaxCoordinate - 100;
    StackAt scene({far, far});
    support::run(scene.world, 300);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 expected{0, Real(0.5) + static_cast<Real>(i)};
        EXPECT_TRUE(support::near(scene.position(i), expected, 8 * gridAt(far) + Real(0.05))) << i;
    }
}

// The limit of all positions scales with the length unit.
TEST(FarAway, TheLimitScalesWithTheLengthUnit) {
    for (const Real unit : {Real(0.001), Real(1), Real(1000)}) {
        SCOPED_TRACE(unit);
        World world({.lengthUnit = unit});
        const Real most = kMaxCoordinate * unit;
        BodyDef def;
        def.position = {most, -most};
        const BodyId body = world.add(def);
        EXPECT_FALSE(check(def, unit).has_value());
        EXPECT_NO_THROW(world[body].setPosition({-most, 0}));
        const Vec2 beyond{0, most * Real(1.01)};
        def.position = beyond;
        EXPECT_TRUE(check(def, unit).has_value());
        EXPECT_THROW(world.add(def), BadDefinition);
        EXPECT_THROW(world.clone(body, beyond), BadDefinition);
        EXPECT_THROW(world[body].setPosition(beyond), BadDefinition);
        EXPECT_THROW(world[body].applyForce({1, 0}, beyond), BadDefinition);
        EXPECT_THROW(world.add(MouseJoint{.body = body, .target = beyond, .force = 1}),
                     BadDefinition);
    }
}

} // namespace
} // namespace kodo
