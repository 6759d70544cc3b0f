// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <cmath>
#include <limits>

namespace kodo {
namespace {

// A disc of radius r at distance D fills the angle 2 asin(r / D). The part of the impulse towards
// the disc is the integral of d(a) cos(a), with d(a) = D cos(a) - sqrt(r^2 - D^2 sin^2(a)).
TEST(Explosion, PushesADiscByTheIntegralOverItsAngle) {
    for (const Real distance : {Real(1.5), Real(3), Real(8)}) {
        World world;
        const BodyId disc = world.add({.shape = Circle{1}, .position = {0, distance}});
        const auto hits = explode(world, {.radius = 20, .impulse = 5});
        ASSERT_EQ(hits.size(), 1u);
        const double D = static_cast<double>(distance);
        const double edge = std::asin(1 / D);
        double expected = 0;
        double width = 0;
        for (int i = 0; i < 20000; ++i) {
            const double a = edge * ((i + 0.5) / 10000 - 1);
            const double d = D * std::cos(a) - std::sqrt(1 - D * D * std::sin(a) * std::sin(a));
            expected += 5 * d * std::cos(a) * edge / 10000;
            width += d * edge / 10000;
        }
        EXPECT_NEAR(hits[0].impulse.y, expected, 0.01 * expected); // 32 rays
        EXPECT_NEAR(hits[0].width, width, 0.01 * width);
        EXPECT_NEAR(hits[0].impulse.x, 0, 1e-4 * expected);
        EXPECT_NEAR(hits[0].point.y, distance - 1, 0.01);
        EXPECT_NEAR(world[disc].velocity().y * world[disc].mass(), hits[0].impulse.y,
                    1e-4 * expected);
    }
}

TEST(Explosion, IsFullWithinTheRadiusAndFallsToZeroBehind) {
    const auto impulseAt = [](Real distance) {
        World world;
        // A thin plate across the rays: its width is the same at each distance.
        world.add({.shape = Box{Real(0.02), Real(0.2)}, .position = {distance, 0}});
        const auto hits = explode(world, {.radius = 2, .falloff = 4, .impulse = 10});
        return hits.empty() ? Real(0) : length(hits[0].impulse);
    };
    EXPECT_NEAR(impulseAt(Real(1.9)), 2, 0.02); // 10 N s/m times 0.2 m
    EXPECT_NEAR(impulseAt(4), 1, 0.02);
    EXPECT_NEAR(impulseAt(5), 0.5, 0.02);
    EXPECT_EQ(impulseAt(Real(6.1)), 0);
}

TEST(Explosion, SparesWhatIsBehindACoverAndHalfOfWhatIsHalfBehind) {
    World world;
    world.add({.shape = Box{Real(0.2), 2}, .position = {1, 1}, .type = BodyType::Static});
    const BodyId hidden = world.add({.shape = Box{1, 1}, .position = {3, 2}});
    const BodyId half = world.add({.shape = Box{1, 1}, .position = {3, 0}});
    const BodyId open = world.add({.shape = Box{1, 1}, .position = {-3, 0}});
    const auto hits = explode(world, {.radius = 10});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].body, half);
    EXPECT_EQ(hits[1].body, open);
    EXPECT_NEAR(hits[0].width / hits[1].width, 0.5, 0.04);
    EXPECT_EQ(world[hidden].velocity(), Vec2{});
    EXPECT_NE(world[half].angularVelocity(), 0);
    EXPECT_NEAR(world[open].angularVelocity(), 0, 1e-3);
}

TEST(Explosion, IgnoresSensorsAndWhatContainsItAndTheFilterSpares) {
    World world;
    const BodyId bomb = world.add({.shape = Circle{Real(0.3)}});
    world.add({.shape = Box{1, 4}, .position = {1, 0}, .type = BodyType::Static, .flags = kSensor});
    const BodyId crate = world.add({.shape = Box{1, 1}, .position = {3, 0}, .flags = 2});
    world.add({.shape = Box{1, 1}, .position = {-3, 0}, .flags = 4});
    const auto hits = explode(world, {.radius = 5, .which = {.flags = kMatchAny, .required = 2}});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].body, crate);
    EXPECT_EQ(world[bomb].velocity(), Vec2{});
}

TEST(Explosion, ReachesAllSidesOfARingAroundIt) {
    World world;
    std::vector<Primitive> parts;
    for (int i = 0; i < 8; ++i) {
        const Rot turn = Rot::fromAngle(Real(0.7853982) * static_cast<Real>(i));
        parts.push_back(Box{Real(0.2), 2, turn * Vec2{2, 0}, turn});
    }
    const BodyId ring = world.add({.shape = Compound{parts}});
    const auto hits = explode(world, {.radius = 5, .impulse = 10});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].width, 12.2, 0.5); // about 2 pi 1.94 m
    // The sums of opposite sides differ by the width of a ray: 1 % of 10 N s/m times 12 m.
    EXPECT_LT(world[ring].mass() * length(world[ring].velocity()), 1.2);
}

// A part may be a sensor by its own filter; the rest of its body covers, and is pushed.
TEST(Explosion, AsksTheFilterOfEachPart) {
    const auto pushed = [](std::size_t sensor) {
        World world;
        const BodyId gate = world.add({.shape = Compound{{Box{Real(0.2), 4}, Box{1, 1, {0, 9}}}},
                                       .position = {1, 0},
                                       .type = BodyType::Static});
        Part part = world[gate].part(sensor);
        part.filter = CollisionFilter{kSensor};
        world[gate].setPart(sensor, part);
        world.add({.shape = Box{1, 1}, .position = {3, 0}});
        return explode(world, {.radius = 5}).size();
    };
    EXPECT_EQ(pushed(0), 1u);
    EXPECT_EQ(pushed(1), 0u);

    World world;
    const BodyId body = world.add({.shape = Compound{{Circle{4}, Box{1, 1}}}, .position = {3, 0}});
    Part aura = world[body].part(0);
    aura.filter = CollisionFilter{kSensor};
    world[body].setPart(0, aura);
    const auto hits = explode(world, {.radius = 5}); // within the aura
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].point.x, 2.5, 0.01);
}

// All impulses point away from the middle, so a body turns as much as its centre goes around it.
TEST(Explosion, GivesNoAngularMomentumAboutItsMiddle) {
    for (const Vec2 middle : {Vec2{0, 0}, Vec2{50, -30}}) {
        World world;
        const BodyId rod =
            world.add({.shape = Box{Real(0.2), 4}, .position = middle + Vec2{2, Real(1.5)}});
        ASSERT_EQ(explode(world, {.center = middle, .radius = 20, .impulse = 5}).size(), 1u);
        const BodyView body = world[rod];
        const Real turns = body.inertia() * body.angularVelocity();
        EXPECT_GT(std::abs(turns), 0.5);
        EXPECT_NEAR(turns, -body.mass() * cross(body.center() - middle, body.velocity()), 1e-3);
    }
}

TEST(Explosion, RefusesBadNumbers) {
    World world;
    const BodyId body = world.add({.position = {1, 0}});
    EXPECT_THROW(explode(world, {.radius = 0}), BadDefinition);
    EXPECT_THROW(explode(world, {.falloff = -1}), BadDefinition);
    EXPECT_THROW(explode(world, {.impulse = std::numeric_limits<Real>::quiet_NaN()}),
                 BadDefinition);
    EXPECT_THROW(explode(world, {.center = {std::numeric_limits<Real>::quiet_NaN(), 0}}),
                 BadDefinition);
    EXPECT_THROW(explode(world, {.which = {.required = 2}}), BadDefinition);
    EXPECT_EQ(world[body].velocity(), Vec2{});
}

} // namespace
} // namespace kodo
