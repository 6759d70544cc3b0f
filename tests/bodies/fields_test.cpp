// SPDX-License-Identifier: MIT
#include <kodo/kodo.hpp>
#include <support/near.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace {

using namespace kodo;
using support::byPrecision;
using support::near;
using support::nearShare;

constexpr Real kStep = Real(1) / 60;
constexpr Real kPi = std::numbers::pi_v<Real>;
constexpr Flags kMarked = 1;

World worldWith(std::vector<FieldEntry> fields, Vec2 gravity = {}) {
    WorldDef def;
    def.gravity = gravity;
    World world(def);
    for (FieldEntry& entry : fields) {
        world.addField(std::move(entry));
    }
    return world;
}

BodyDef disc(Vec2 position, Vec2 velocity = {}) {
    BodyDef def;
    def.shape = Circle{Real(0.5)};
    def.position = position;
    def.velocity = velocity;
    return def;
}

void run(World& world, double seconds) {
    const auto steps = static_cast<int>(seconds / static_cast<double>(kStep) + 0.5);
    for (int i = 0; i < steps; ++i) {
        world.step(kStep);
    }
}

// W2: a user-defined field, filtered by flags.
class Push1N final : public ForceField {
public:
    FieldForce at(const BodyView&, Real) const override { return {{1, 0}, 2}; }
};

TEST(ForceField, UserDefinedActsOnBodiesItsFilterAccepts) {
    World world = worldWith({{std::make_shared<Push1N>(), {kMatchAny, kMarked}}});
    BodyDef def = disc({});
    def.flags = kMarked;
    const BodyId marked = world.add(def);
    const BodyId other = world.add(disc({10, 0}));
    world.step(kStep);
    const Real mass = world[marked].mass();
    EXPECT_TRUE(nearShare(world[marked].velocity().x, kStep / mass, 4 * support::kEpsilon));
    EXPECT_TRUE(nearShare(world[marked].angularVelocity(), 2 * kStep / world[marked].inertia(),
                          4 * support::kEpsilon));
    EXPECT_EQ(world[other].velocity(), Vec2{});
}

/// Counts its evaluations.
class CountedPull final : public ForceField {
public:
    CountedPull(bool steady, int& asked) : steady_(steady), asked_(asked) {}
    FieldForce at(const BodyView& body, Real) const override {
        ++asked_;
        return {body.mass() * Vec2{0, -10}};
    }
    bool steady() const override { return steady_; }

private:
    bool steady_;
    int& asked_;
};

// A steady field is evaluated again only after a change. The bodies fall identically.
TEST(ForceField, SteadyIsEvaluatedOnlyAfterAChange) {
    int steady = 0;
    int each = 0;
    World first = worldWith({{std::make_shared<CountedPull>(true, steady)}});
    World second = worldWith({{std::make_shared<CountedPull>(false, each)}});
    for (World* const world : {&first, &second}) {
        const BodyId body = world->add(disc({}));
        run(*world, 1);
        (*world)[body].applyForce({1, 0}); // acts in one step only
        run(*world, 1);
        (*world)[body].setFlags(kMarked);
        run(*world, 1);
        world->add(disc({10, 0}));
        run(*world, 1);
        world->addField(
            {std::make_shared<CountedPull>(world == &first, world == &first ? steady : each)});
        run(*world, 1);
    }
    EXPECT_EQ(steady, 1 + 2 + 1 + 2 + 4);
    EXPECT_EQ(each, 3 * 60 + 2 * 60 + 4 * 60);
    EXPECT_EQ(first.stateHash(), second.stateHash());
}

TEST(ForceField, GravityAndAnAppliedForceAddUp) {
    World world = worldWith({}, {0, -10});
    const BodyId body = world.add(disc({}));
    world[body].applyForce({0, 10 * world[body].mass()});
    world.step(kStep);
    EXPECT_TRUE(near(world[body].velocity(), Vec2{}, byPrecision(1e-7, 1e-15)));
}

// v_t = m g / (c d) for linear drag, sqrt(m g / (c d)) for quadratic drag. Implicit drag converges
// exactly to it for any time step.
TEST(Drag, LimitsAFallToTheTerminalSpeed) {
    for (const Real dt : {Real(1) / 240, Real(1) / 60, Real(1) / 4}) {
        World linear = worldWith({{std::make_shared<Drag>(DragLaw{2, 0})}}, {0, -10});
        World quadratic = worldWith({{std::make_shared<Drag>(DragLaw{0, 2})}}, {0, -10});
        const BodyId a = linear.add(disc({}));
        const BodyId b = quadratic.add(disc({}));
        for (int i = 0; i < 4800; ++i) {
            linear.step(dt);
            quadratic.step(dt);
        }
        const Real expected = linear[a].mass() * 10 / 2; // d = 1 m
        // The speed stops rising in float when the gain of a step is less than half of its last
        // bit.
        const Real close = byPrecision(1e-4, 1e-9);
        EXPECT_TRUE(nearShare(-linear[a].velocity().y, expected, close));
        EXPECT_TRUE(nearShare(-quadratic[b].velocity().y, std::sqrt(expected), close));
    }
}

// v = v0 exp(-c d t / m). The error of backward Euler is t c d / m * dt c d / (2 m), here 0.5 %.
TEST(Drag, SlowsDownExponentially) {
    World world = worldWith({{std::make_shared<Drag>(DragLaw{Real(0.5), 0})}});
    const BodyId body = world.add(disc({}, {8, 0}));
    run(world, 1);
    const double rate = 0.5 / static_cast<double>(world[body].mass());
    EXPECT_TRUE(nearShare(world[body].velocity().x, 8 * std::exp(-rate), 0.005));
}

TEST(Drag, NeverReversesABodyAtAnyStrength) {
    for (const Real strength : {Real(1), Real(1e3), Real(1e9)}) {
        World world = worldWith({{std::make_shared<Drag>(DragLaw{strength, strength})}});
        BodyDef def = disc({}, {100, -50});
        def.angularVelocity = 20;
        const BodyId body = world.add(def);
        Vec2 before = def.velocity;
        Real spin = def.angularVelocity;
        for (int i = 0; i < 100; ++i) {
            world.step(kMaxTimeStep);
            const Vec2 now = world[body].velocity();
            EXPECT_TRUE(now.x >= 0 && now.x <= before.x && now.y <= 0 && now.y >= before.y);
            EXPECT_TRUE(world[body].angularVelocity() >= 0 &&
                        world[body].angularVelocity() <= spin);
            before = now;
            spin = world[body].angularVelocity();
        }
    }
}

TEST(Drag, SlowsSpinExponentially) {
    World world = worldWith({{std::make_shared<Drag>(DragLaw{Real(0.5), 0})}});
    BodyDef def = disc({});
    def.angularVelocity = 8;
    const BodyId body = world.add(def);
    run(world, 1);
    // c d r^2 / I, with d = 1 and r = 0.5.
    const double rate = 0.5 * 0.25 / static_cast<double>(world[body].inertia());
    EXPECT_TRUE(nearShare(world[body].angularVelocity(), 8 * std::exp(-rate), 0.02));
}

TEST(Wind, AcceleratesALightBodyToItsSpeed) {
    World world = worldWith({{std::make_shared<Wind>(DragLaw{5, 5}, Vec2{3, 0})}});
    const BodyId body = world.add(disc({}));
    run(world, 10);
    EXPECT_TRUE(near(world[body].velocity(), Vec2{3, 0}, 1e-4));
}

TEST(Wind, HasNoEffectOutsideItsRegion) {
    const Aabb region{{-1, -1}, {1, 1}};
    World world = worldWith({{std::make_shared<Wind>(DragLaw{5, 0}, Vec2{3, 0}, region)}});
    const BodyId inside = world.add(disc({0, 0}));
    const BodyId outside = world.add(disc({0, 5}));
    run(world, 1);
    EXPECT_GT(world[inside].velocity().x, 0);
    EXPECT_EQ(world[outside].velocity(), Vec2{});
}

// Speed sqrt(strength / r), period 2 pi r / v. A leapfrog integrator keeps the radius and is late
// by a fraction of (w dt)^2 / 24. Euler's method would spiral outwards [Thesis06, fig. 4.6].
TEST(Attractor, KeepsACircularOrbit) {
    const Real strength = 16;
    const Real radius = 4;
    World world =
        worldWith({{std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{}, strength)}});
    const BodyId body = world.add(disc({radius, 0}, {0, std::sqrt(strength / radius)}));
    const double period = 2 * 3.14159265 * 4 / 2;
    for (int orbit = 0; orbit < 20; ++orbit) {
        run(world, period);
        EXPECT_TRUE(nearShare(length(world[body].position()), radius, 1e-3)) << orbit;
    }
}

TEST(Attractor, WithALinearLawGivesAllOscillationsOnePeriod) {
    const Real strength = 4; // period pi
    World world =
        worldWith({{std::make_shared<Attractor>(Attractor::Law::Linear, Vec2{1, 0}, strength)}});
    BodyDef def = disc({2, 5});
    def.flags = kDisabled; // both pass the centre at the same time
    const BodyId near1 = world.add(def);
    def.position = {11, -5};
    const BodyId far = world.add(def);
    run(world, 3.14159265);
    EXPECT_TRUE(near(world[near1].position(), Vec2{2, 5}, 0.01 * 5));
    EXPECT_TRUE(near(world[far].position(), Vec2{11, -5}, 0.01 * 11));
}

TEST(Attractor, IsFiniteAtItsCentre) {
    for (const Real softening : {Real(0), Real(0.5)}) {
        World world = worldWith({{std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{},
                                                              Real(10), softening)}});
        const BodyId body = world.add(disc({}));
        world.step(kStep);
        EXPECT_EQ(world[body].velocity(), Vec2{});
    }
}

// Half of a box, and half of one that stands on its corner, below a line through the centre.
TEST(Submerged, OfAPolygonIsTheClippedPolygon) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const Transform flat{{0, 0}, {}};
    const Submerged half = submerged(box, flat, {0, 0}, {0, 1});
    EXPECT_TRUE(near(half.area, 2, byPrecision(1e-6, 1e-14)));
    EXPECT_TRUE(near(half.centroid, Vec2{0, Real(-0.5)}, byPrecision(1e-6, 1e-14)));

    const Transform onCorner{{0, 0}, Rot::fromAngle(kPi / 4)};
    const Submerged triangle = submerged(box, onCorner, {5, 0}, {0, 1});
    EXPECT_TRUE(near(triangle.area, 2, byPrecision(1e-6, 1e-14)));
    // A third of the height of the triangle, which is half of the diagonal.
    EXPECT_TRUE(
        near(triangle.centroid, Vec2{0, -std::sqrt(Real(2)) / 3}, byPrecision(1e-6, 1e-14)));

    EXPECT_EQ(submerged(box, {{0, 3}, {}}, {0, 0}, {0, 1}).area, 0);
    EXPECT_TRUE(
        near(submerged(box, {{0, -3}, {}}, {0, 0}, {0, 1}).area, 4, byPrecision(1e-6, 1e-14)));
}

// Against 20,000 thin slices.
TEST(Submerged, OfACircleIsTheSegmentBelowTheLine) {
    const Real radius = Real(0.8);
    const ConvexShape circle = convexShapeOf(Circle{radius}, {});
    for (int i = -9; i <= 9; ++i) {
        const double depth = 0.08 * i; // of the centre below the surface
        double area = 0;
        double moment = 0;
        constexpr int kSlices = 20000;
        for (int k = 0; k < kSlices; ++k) {
            const double y = -0.8 + (k + 0.5) * 1.6 / kSlices;
            const double slice = y < depth ? 2 * std::sqrt(0.64 - y * y) * 1.6 / kSlices : 0;
            area += slice;
            moment += slice * y;
        }
        const Submerged wet =
            submerged(circle, {{3, static_cast<Real>(-depth)}, {}}, {0, 0}, {0, 1});
        EXPECT_TRUE(near(wet.area, area, 2e-4)) << depth;
        EXPECT_TRUE(near(wet.centroid, Vec2{3, static_cast<Real>(moment / area - depth)}, 1e-3));
    }
}

World pool(Real drag) {
    const Buoyancy::Fluid water{2, drag};
    return worldWith({{std::make_shared<Buoyancy>(water, Vec2{0, 1}, Vec2{0, -10})}}, {0, -10});
}

// Archimedes: a box of density 0.5 in a fluid of density 2 floats with a quarter submerged.
TEST(Buoyancy, FloatsABoxAtTheDepthOfItsOwnMass) {
    World world = pool(8);
    BodyDef def;
    def.shape = Box{2, 1};
    def.density = Real(0.5);
    def.position = {0, 3};
    const BodyId body = world.add(def);
    run(world, 20);
    EXPECT_TRUE(near(world[body].position(), Vec2{0, Real(1.25)}, 1e-3)); // surface at y = 1
    EXPECT_TRUE(near(world[body].velocity(), Vec2{}, 1e-3));
}

TEST(Buoyancy, FloatsADiscOfHalfItsDensityHalfSubmerged) {
    World world = pool(8);
    const BodyId body = world.add(disc({0, 0}));
    run(world, 20);
    EXPECT_TRUE(near(world[body].position(), Vec2{0, 1}, 1e-3));
}

TEST(Buoyancy, TurnsAnUprightLongBoxOntoItsSide) {
    World world = pool(4);
    BodyDef def;
    def.shape = Box{Real(0.5), 3};
    def.rotation = Rot::fromAngle(Real(0.1));
    def.position = {0, 1};
    const BodyId body = world.add(def);
    run(world, 30);
    EXPECT_TRUE(near(std::abs(world[body].rotation().s), 1, 1e-3)); // lies on its side
}

TEST(Buoyancy, LetsAHeavierBodySinkAtTheTerminalSpeed) {
    World world = pool(4);
    BodyDef def = disc({0, -5});
    def.density = 3;
    const BodyId body = world.add(def);
    run(world, 10);
    // (3 - 2) A g = 4 A v
    EXPECT_TRUE(nearShare(-world[body].velocity().y, 2.5, 1e-4));
}

TEST(Buoyancy, LetsABoxOscillateWithThePeriodOfASpring) {
    World world = pool(0);
    BodyDef def;
    def.shape = Box{1, 1};
    def.flags = kLockRotate;
    def.position = {0, Real(1.1)}; // floats at 1
    const BodyId body = world.add(def);
    // m x'' = -2 w g x: w^2 = 20 / 1.
    run(world, 2 * 3.14159265 / std::sqrt(20.0));
    EXPECT_TRUE(near(world[body].position().y, 1.1, 1e-3));
}

} // namespace
