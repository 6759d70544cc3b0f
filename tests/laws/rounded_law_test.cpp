// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>
#include <support/sleeping.hpp>

namespace kodo::rounded_law_test {
namespace {

using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;

/// A capsule along its own x axis, 1 m between the centres of its ends.
BodyDef capsuleDef(Vec2 position, Real radius, const Material& material = withFriction(1)) {
    BodyDef def;
    def.shape = Capsule{{Real(-0.5), 0}, {Real(0.5), 0}, radius};
    def.position = position;
    def.material = material;
    return def;
}

/// T = 2 pi sqrt((m l^2 + I) / (m g l)) for small angles, hung at one end: a physical pendulum.
TEST(RoundedLaw, ACapsuleSwingsWithThePeriodOfItsInertia) {
    World world({.gravity = support::kEarth});
    const BodyId hook =
        world.add({.shape = Circle{Real(0.1)}, .type = BodyType::Static, .flags = kDisabled});
    BodyDef def = capsuleDef({}, Real(0.25));
    def.rotation = Rot::fromAngle(Real(-1.57079632679 + 0.05));
    def.position = def.rotation * Vec2{Real(0.5), 0};
    const BodyId rod = world.add(def);
    world.add(RevoluteJoint{.ends = {hook, rod, {}, {Real(-0.5), 0}}});
    // A rectangle of 1 by 0.5 m and two half discs of 0.25 m.
    const double disc = 3.14159265358979 / 16;
    const double inertia =
        0.5 * 1.25 / 12 + disc * (0.03125 + 0.25 + 4 * 0.25 / (3 * 3.14159265358979));
    const double mass = 0.5 + disc;
    EXPECT_TRUE(nearShare(world[rod].inertia(), inertia, 1e-5));
    const double period = 6.28318530717959 * std::sqrt((mass * 0.25 + inertia) / (mass * 10 * 0.5));
    int crossings = 0;
    double last = 0;
    const auto offset = [&] { return static_cast<double>(world[rod].position().x); };
    for (int i = 0; crossings < 20; ++i) {
        ASSERT_LT(i, 6000);
        const double before = offset();
        world.step(kDt / 4);
        if (before * offset() < 0) { // half a period after the crossing before
            ++crossings;
            last = (i + before / (before - offset())) / 240;
        }
    }
    EXPECT_TRUE(nearShare(last / 19.5, period / 2, 0.01));
}

TEST(RoundedLaw, ACapsuleOnItsSideRestsOnTwoPointsAndSleeps) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, withFriction(Real(0.5)));
    const BodyId body = world.add(capsuleDef({0, Real(0.3)}, Real(0.25)));
    const int steps = support::stepsUntilAsleep(world, body, 300);
    EXPECT_LE(steps, 300);
    EXPECT_TRUE(near(world[body].position(), Vec2{0, Real(0.25)}, 0.005));
    EXPECT_TRUE(near(world[body].rotation().s, 0, 1e-3));
}

// A ball of capsule form, of length zero, rolls as a disc does: 2/3 of its sliding speed.
TEST(RoundedLaw, ACapsuleOfLengthZeroRollsAsADisc) {
    World world({.gravity = support::kEarth});
    const Material material = withFriction(Real(0.3));
    support::addFloor(world, material);
    BodyDef def;
    def.shape = Capsule{{0, 0}, {0, 0}, Real(0.5)};
    def.position = {0, Real(0.5)};
    def.material = material;
    def.velocity = {6, 0};
    const BodyId ball = world.add(def);
    support::run(world, 180);
    EXPECT_TRUE(nearShare(world[ball].velocity().x, 4, 1e-3));
    EXPECT_TRUE(nearShare(world[ball].angularVelocity(), -8, 1e-3));
}

// A square with so large a radius that it is nearly a disc rolls over its round corners.
TEST(RoundedLaw, ARoundBoxRollsOverItsCornersAndKeepsItsHeight) {
    World world({.gravity = support::kEarth});
    const Material material = withFriction(1);
    support::addFloor(world, material);
    BodyDef def;
    def.shape = Box{Real(0.02), Real(0.02), {}, {}, Real(0.5)};
    def.position = {0, Real(0.51)};
    def.material = material;
    def.velocity = {3, 0};
    def.angularVelocity = -6;
    const BodyId body = world.add(def);
    for (int i = 0; i < 120; ++i) {
        world.step(kDt);
        EXPECT_GT(world[body].position().y, Real(0.5));
        EXPECT_LT(world[body].position().y, Real(0.53));
    }
    EXPECT_GT(world[body].position().x, 5);
}

TEST(RoundedLaw, AStackOfRoundBoxesRestsAndSleeps) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, withFriction(Real(0.6)));
    std::vector<BodyId> stack;
    for (int i = 0; i < 8; ++i) {
        BodyDef def;
        def.shape = Box{Real(0.8), Real(0.8), {}, {}, Real(0.1)};
        def.position = {Real(0.01) * static_cast<Real>(i % 2), Real(0.5) + static_cast<Real>(i)};
        def.material = withFriction(Real(0.6));
        stack.push_back(world.add(def));
    }
    support::run(world, 300);
    EXPECT_EQ(support::countAsleep(world), stack.size());
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const Vec2 expected{Real(0.01) * static_cast<Real>(i % 2),
                            Real(0.5) + static_cast<Real>(i)};
        EXPECT_TRUE(near(world[stack[i]].position(), expected, 0.05)) << i;
        EXPECT_TRUE(near(world[stack[i]].rotation().s, 0, 0.01)) << i;
    }
}

// v = v0 - mu g t, and it stops after v0^2 / (2 mu g).
TEST(RoundedLaw, ARoundBoxSlidesToTheDistanceOfCoulombFriction) {
    World world({.gravity = support::kEarth});
    const Material material = withFriction(Real(0.3));
    support::addFloor(world, material);
    BodyDef def;
    def.shape = Box{Real(1.6), Real(0.3), {}, {}, Real(0.1)};
    def.position = {0, Real(0.25)};
    def.material = material;
    def.velocity = {6, 0};
    const BodyId body = world.add(def);
    support::run(world, 180);
    EXPECT_TRUE(near(world[body].velocity(), Vec2{}, 1e-3));
    EXPECT_TRUE(nearShare(world[body].position().x, 6, 0.03));
    EXPECT_TRUE(near(world[body].position().y, 0.25, 0.005));
}

// A capsule that falls on its side at restitution 1: two points at once, no spin, all energy back.
TEST(RoundedLaw, ACapsuleBouncesWithoutLosingEnergy) {
    for (const Real tilt : {Real(0), Real(0.4), Real(1.57079632679)}) {
        World world({.gravity = {0, 0}});
        support::addFloor(world, support::slippery(1));
        BodyDef def = capsuleDef({0, 2}, Real(0.25), support::slippery(1));
        def.rotation = Rot::fromAngle(tilt);
        def.velocity = {0, -4};
        const BodyId body = world.add(def);
        const auto energy = [&] {
            const Real v = length(world[body].velocity());
            const Real w = world[body].angularVelocity();
            return (world[body].mass() * v * v + world[body].inertia() * w * w) / 2;
        };
        const Real before = energy();
        support::run(world, 60);
        EXPECT_TRUE(nearShare(energy(), before, byPrecision(1e-4, 1e-9))) << tilt;
        EXPECT_GT(world[body].velocity().y, 0) << tilt;
        if (tilt == 0) {
            EXPECT_TRUE(near(world[body].angularVelocity(), 0, 1e-4));
        }
    }
}

// Concentric shapes with a radius part, whatever their kinds.
TEST(RoundedLaw, ConcentricRoundShapesPart) {
    const Shape shapes[] = {Capsule{{Real(-0.5), 0}, {Real(0.5), 0}, Real(0.25)},
                            Box{Real(0.5), Real(0.5), {}, {}, Real(0.25)}, Circle{Real(0.4)},
                            Capsule{{0, 0}, {Real(1e-3), 0}, 1},
                            Polygon{{{0, 0}, {1, 0}, {0, 1}}, Real(1e-3)}};
    for (const Shape& a : shapes) {
        for (const Shape& b : shapes) {
            World world({.gravity = {0, 0}});
            BodyDef def;
            def.shape = a;
            const BodyId first = world.add(def);
            def.shape = b;
            const BodyId second = world.add(def);
            support::run(world, 600);
            const Separation gap =
                separation(world[first].part(0).convex, world[first].massFrame(),
                           world[second].part(0).convex, world[second].massFrame());
            EXPECT_GT(gap.distance, Real(-0.05)) << a.index() << ' ' << b.index();
        }
    }
}

} // namespace
} // namespace kodo::rounded_law_test
