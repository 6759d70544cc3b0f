// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <memory>
#include <numbers>
#include <ostream>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

constexpr double kPi = std::numbers::pi;

World worldWith(std::shared_ptr<const ForceField> field, CollisionFilter which = {}) {
    World world;
    world.addField({std::move(field), which});
    return world;
}

struct Given {
    const char* name;
    std::shared_ptr<const ForceField> field;
};

void PrintTo(const Given& given, std::ostream* out) {
    *out << given.name;
}

std::string nameOf(const testing::TestParamInfo<Given>& info) {
    return info.param.name;
}

/// A user-defined field that accelerates every body about its centre.
class Whirl final : public ForceField {
public:
    FieldForce at(const BodyView& body, Real) const override { return {{}, body.inertia()}; }
};

class EveryForceField : public testing::TestWithParam<Given> {};

// W2: every field, built-in or user-defined, acts exactly on the bodies whose flags its filter
// accepts: any, all, equal, no test.
TEST_P(EveryForceField, ActsOnlyOnBodiesItsFilterAccepts) {
    struct Row {
        CollisionFilter which;
        bool acts[4]; // on the flags 0, 01, 10, 11
    };
    const Row rows[] = {{{}, {true, true, true, true}},
                        {{kMatchAny, 0b01}, {false, true, false, true}},
                        {{kMatchAny, 0b11}, {false, true, true, true}},
                        {{kMatchAll, 0b11}, {false, false, false, true}},
                        {{kMatchEqual, 0b10}, {false, false, true, false}},
                        {{kMatchEqual, 0}, {true, false, false, false}}};
    for (const Row& row : rows) {
        World world = worldWith(GetParam().field, row.which);
        for (Flags flags = 0; flags < 4; ++flags) {
            BodyDef def = ballDef({3 * static_cast<Real>(flags) - 4, -2}, Real(0.5));
            def.velocity = {2, 1};
            def.angularVelocity = 1;
            def.flags = flags;
            world.add(def);
        }
        world.step(kDt);
        for (Flags flags = 0; flags < 4; ++flags) {
            const BodyView body = world[world.bodies()[flags]];
            const bool moved = body.velocity() != Vec2{2, 1} || body.angularVelocity() != 1;
            EXPECT_EQ(moved, row.acts[flags])
                << "required " << row.which.required << ", flags " << flags;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Fields, EveryForceField,
    testing::Values(
        Given{"Gravity", std::make_shared<Gravity>(Vec2{0, -10})},
        Given{"Drag", std::make_shared<Drag>(DragLaw{1, 1})},
        Given{"Wind", std::make_shared<Wind>(DragLaw{1, 0}, Vec2{5, 0})},
        Given{"Attractor", std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{}, 9)},
        Given{"Spring", std::make_shared<Attractor>(Attractor::Law::Linear, Vec2{}, 9)},
        Given{"Buoyancy", std::make_shared<Buoyancy>(Buoyancy::Fluid{2, 0}, Vec2{}, Vec2{0, -10})},
        Given{"UserDefined", std::make_shared<Whirl>()}),
    nameOf);

// W2: v = v0 / (1 + k v0 t) with k = c d / m. Backward Euler is of first order; of 60 steps, each
// slows by 2 % at the start.
TEST(FieldLaw, QuadraticDragSlowsAsOneOverTime) {
    World world = worldWith(std::make_shared<Drag>(DragLaw{0, Real(0.1)}));
    BodyDef def = ballDef({}, Real(0.5));
    def.velocity = {8, 6};
    const BodyId ball = world.add(def);
    run(world, 60);
    const double k = 0.1 / static_cast<double>(world[ball].mass());
    EXPECT_TRUE(nearShare(length(world[ball].velocity()), 10 / (1 + 10 * k), 0.01));
    EXPECT_TRUE(near(world[ball].velocity().x * 6, world[ball].velocity().y * 8, Real(1e-4)));
}

// W2: exponential decay, of first order in the time step: half the step, half the error.
TEST(FieldLaw, DragConvergesLinearlyWithTheTimeStep) {
    const auto error = [](int rate) {
        World world = worldWith(std::make_shared<Drag>(DragLaw{1, 0}));
        BodyDef def = ballDef({}, Real(0.5));
        def.velocity = {8, 0};
        const BodyId ball = world.add(def);
        run(world, rate, 1 / static_cast<Real>(rate));
        const double mass = static_cast<double>(world[ball].mass());
        return static_cast<double>(world[ball].velocity().x) - 8 * std::exp(-1 / mass);
    };
    EXPECT_TRUE(nearShare(error(30) / error(60), 2, 0.05));
    EXPECT_TRUE(nearShare(error(60) / error(120), 2, 0.05));
}

// W2: an ellipse. From r = 4 at 0.7 of the circular speed, the nearest distance is r = 4 * 0.49 /
// (2 - 0.49). The period is T = 2 pi sqrt(a^3 / mu) [Kepler].
TEST(FieldLaw, AnEllipticOrbitClosesAfterItsPeriod) {
    const double mu = 16;
    const double nearest = 4 * 0.49 / (2 - 0.49);
    const double period = 2 * kPi * std::sqrt(std::pow((4 + nearest) / 2, 3) / mu);
    World world = worldWith(
        std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{}, static_cast<Real>(mu)));
    BodyDef def = ballDef({4, 0}, Real(0.1));
    def.velocity = {0, Real(0.7) * 2};
    const BodyId planet = world.add(def);
    const int steps = 240;
    const auto dt = static_cast<Real>(period / steps);
    Real closest = 4;
    for (int orbit = 0; orbit < 5; ++orbit) {
        for (int step = 0; step < steps; ++step) {
            world.step(dt);
            closest = std::min(closest, length(world[planet].position()));
        }
        // A leapfrog integrator keeps the ellipse, but rotates it. It is late by (w dt)^2 / 24 at
        // its nearest point per orbit, where w dt = 0.07.
        EXPECT_TRUE(near(length(world[planet].position()), 4, 0.01)) << orbit;
        EXPECT_TRUE(near(world[planet].position().y, 0, 0.02 * (orbit + 1))) << orbit;
    }
    EXPECT_TRUE(nearShare(closest, nearest, 0.01));
}

// W2: a repulsive field reverses a body at the distance where its energy is used up: v^2 / 2 = mu /
// r - mu / R.
TEST(FieldLaw, ARepulsiveFieldReversesABodyAtTheClosedFormDistance) {
    World world =
        worldWith(std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{}, Real(-8)));
    BodyDef def = ballDef({8, 0}, Real(0.1));
    def.velocity = {-2, 0};
    const BodyId ball = world.add(def);
    Real closest = 8;
    for (int step = 0; step < 1200 && world[ball].position().x < Real(8.01); ++step) {
        world.step(kDt);
        closest = std::min(closest, world[ball].position().x);
    }
    EXPECT_TRUE(nearShare(closest, 8.0 / 3, 2e-3));            // 8 / r = 2 + 1
    EXPECT_TRUE(nearShare(world[ball].velocity().x, 2, 1e-2)); // outwards, at the start
}

// W2: wind across a fall. With linear drag both axes are independent: v_x approaches the speed of
// the wind, and v_y approaches m g / (c d).
TEST(FieldLaw, AFallInWindReachesBothTerminalVelocities) {
    World world({.gravity = support::kEarth});
    world.addField({std::make_shared<Wind>(DragLaw{2, 0}, Vec2{3, 0})});
    const BodyId ball = world.add(ballDef({}, Real(0.5)));
    run(world, 900);
    const Real fall = 10 * world[ball].mass() / 2;
    EXPECT_TRUE(near(world[ball].velocity(), Vec2{3, -fall}, byPrecision(1e-3, 1e-9)));
}

// W2, Archimedes: a floating body displaces fluid of its own mass. Discs of several densities; the
// area of the circular segment is solved by bisection.
TEST(FieldLaw, ADiscFloatsAtTheDepthOfItsDensity) {
    for (const double density : {0.2, 0.5, 0.8}) {
        World world({.gravity = support::kEarth});
        world.addField(
            {std::make_shared<Buoyancy>(Buoyancy::Fluid{1, 4}, Vec2{0, 1}, support::kEarth)});
        BodyDef def = ballDef({0, 1}, Real(0.5));
        def.density = static_cast<Real>(density);
        const BodyId disc = world.add(def);
        run(world, 1800);
        double low = -0.5; // height of the centre over the surface
        double high = 0.5;
        while (high - low > 1e-9) {
            const double middle = (low + high) / 2;
            const double angle = std::acos(2 * middle);
            const double wet = 0.25 * (angle - std::sin(angle) * std::cos(angle));
            (wet > density * kPi / 4 ? low : high) = middle;
        }
        EXPECT_TRUE(near(world[disc].position().y, 1 + low, 1e-3)) << density;
    }
}

// W2: a boat of two parts with a heavy keel floats upright and displaces its own mass.
TEST(FieldLaw, ACompoundWithAKeelFloatsUpright) {
    World world({.gravity = support::kEarth});
    world.addField({std::make_shared<Buoyancy>(Buoyancy::Fluid{2, 6}, Vec2{}, support::kEarth)});
    BodyDef hull = boxDef({0, 0}, 2, 1);
    hull.density = Real(0.5);
    hull.rotation = Rot::fromAngle(Real(0.5));
    const BodyId boat = world.add(hull);
    world.weld(boat, Box{Real(0.25), 1, {0, -1}}, Material{}, Real(4)); // a keel of 1 kg
    run(world, 2400);
    EXPECT_TRUE(near(world[boat].rotation().s, 0, Real(1e-3)));
    // 2 kg displace 1 m^2: the keel's 0.25 and 0.75 of the hull's 2 m of width.
    EXPECT_TRUE(near(world[boat].position().y, 0.5 - 0.375, 1e-3));
}

} // namespace
} // namespace kodo
