// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <memory>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kDt;
using support::kEpsilon;
using support::near;

// R3: F = m a for one step; then the force is forgotten.
TEST(Force, ActsForOneStep) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2)); // 4 kg
    world[box].applyForce({8, -4});
    world[box].applyForce({4, 0});
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{3 * kDt, -1 * kDt}, 4 * kEpsilon));
    const Vec2 velocity = world[box].velocity();
    world.step(kDt);
    EXPECT_EQ(world[box].velocity(), velocity);
}

// R3, Eq 4.6: a force at a point turns as well as pushes: torque = r x F.
TEST(Force, AtAPointAddsTorque) {
    World world;
    const BodyId box = world.add(boxDef({10, 10}, 2, 2)); // I = 4 * 8 / 12
    world[box].applyForce({0, 6}, {11, 10});
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{0, Real(1.5) * kDt}, 4 * kEpsilon));
    EXPECT_TRUE(near(world[box].angularVelocity(), 6 / (32.0L / 12) * static_cast<long double>(kDt),
                     4 * kEpsilon));
}

TEST(Force, TorqueTurnsOnly) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2));
    world[box].applyTorque(8);
    world.step(kDt);
    EXPECT_EQ(world[box].velocity(), Vec2{});
    EXPECT_TRUE(near(world[box].angularVelocity(), 3 * kDt, 4 * kEpsilon));
}

// R3: dv = J / m, dw = r x J / I, at once.
TEST(Force, AnImpulseActsAtOnce) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2));
    world[box].applyImpulse({0, 8});
    EXPECT_EQ(world[box].velocity(), (Vec2{0, 2}));
    world[box].applyImpulse({4, 0}, {0, 1});
    EXPECT_EQ(world[box].velocity(), (Vec2{1, 2}));
    EXPECT_TRUE(near(world[box].angularVelocity(), -1.5L, 4 * kEpsilon));
}

// R3: whatever point and force, momentum and angular momentum grow by J and r x J.
TEST(Force, RandomImpulsesAddUp) {
    constexpr std::uint64_t kSeed = 121;
    support::RandomNumbers random(kSeed);
    World world;
    const BodyId box = world.add(boxDef({1, 2}, 3, 1));
    BasicVec2<long double> momentum;
    long double spin = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec2 impulse = random.point(1);
        const Vec2 point = random.point(3);
        world[box].applyImpulse(impulse, point);
        momentum += BasicVec2<long double>{static_cast<long double>(impulse.x),
                                           static_cast<long double>(impulse.y)};
        spin += static_cast<long double>(cross(point, impulse));
    }
    const support::Totals totals = support::totalsOf(world);
    // 100 impulses of up to 4 N s m, each rounded.
    EXPECT_TRUE(near(totals.momentum, momentum, 200 * kEpsilon)) << "seed " << kSeed;
    EXPECT_TRUE(near(totals.spin, spin, 800 * kEpsilon)) << "seed " << kSeed;
}

// W2: gravity is a field like any other: it can be read, removed and put back.
TEST(Force, GravityIsTheFirstField) {
    World world({.gravity = {0, -10}});
    ASSERT_EQ(world.fields().size(), 1u);
    const BodyId light = world.add(ballDef({}, Real(0.1)));
    const BodyId heavy = world.add(ballDef({50, 0}, 3));
    support::run(world, 60);
    EXPECT_TRUE(near(world[light].velocity(), Vec2{0, -10}, 100 * kEpsilon));
    EXPECT_TRUE(near(world[heavy].velocity(), Vec2{0, -10}, 100 * kEpsilon));
    EXPECT_TRUE(World().fields().empty());
}

// W2: a field restricted by flags.
TEST(Force, AFieldActsOnWhatItsFilterAccepts) {
    World world;
    world.addField({std::make_shared<Gravity>(Vec2{0, -6}), {kMatchAny, 0b10}});
    BodyDef def = ballDef({}, 1);
    def.flags = 0b01;
    const BodyId spared = world.add(def);
    def.position.x = 10;
    def.flags = 0b11;
    const BodyId pulled = world.add(def);
    world.step(kDt);
    EXPECT_EQ(world[spared].velocity(), Vec2{});
    EXPECT_TRUE(near(world[pulled].velocity(), Vec2{0, -6 * kDt}, 4 * kEpsilon));
}

/// Drives every body to the right with a force that grows with its mass squared, and spins it.
class OddField final : public ForceField {
public:
    Push at(const Bodies& bodies, std::uint32_t body, Real) const override {
        const Real mass = bodies.form(body).mass.mass;
        return {{mass * mass, 0}, 3};
    }
};

// W2: one written by the user, beside the others; each adds its part.
TEST(Force, AUserWritesAField) {
    World world({.gravity = support::kEarth});
    world.addField({std::make_shared<OddField>()});
    const BodyId box = world.add(boxDef({}, 2, 2));
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{4 * kDt, -10 * kDt}, 4 * kEpsilon));
    EXPECT_TRUE(near(world[box].angularVelocity(), 3 * kDt * Real(12) / 32, 4 * kEpsilon));
}

// W2: a force on all bodies, or on those that match.
TEST(Force, OnAllOrOnThoseThatMatch) {
    World world;
    BodyDef def = boxDef({}, 1, 1);
    def.flags = 1;
    const BodyId one = world.add(def);
    def.position.x = 5;
    def.flags = 2;
    const BodyId two = world.add(def);
    world.applyForceToAll({6, 0});
    world.applyForceToAll({6, 0}, {kMatchAny, 2});
    world.applyTorqueToAll(1, {kMatchAny, 1});
    world.step(kDt);
    EXPECT_TRUE(near(world[one].velocity().x, 6 * kDt, 4 * kEpsilon));
    EXPECT_TRUE(near(world[two].velocity().x, 12 * kDt, 4 * kEpsilon));
    EXPECT_TRUE(near(world[one].angularVelocity(), 6 * kDt, 4 * kEpsilon));
    EXPECT_EQ(world[two].angularVelocity(), 0);
}

// A copy of a world shares the fields, which cannot change, and nothing else.
TEST(Force, ACopySharesItsFieldsOnly) {
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(ballDef({}, 1));
    World copy = world;
    copy.addField({std::make_shared<Gravity>(Vec2{0, 10})});
    world.step(kDt);
    copy.step(kDt);
    EXPECT_LT(world[ball].velocity().y, 0);
    EXPECT_EQ(copy[ball].velocity().y, 0);
}

} // namespace
} // namespace kodo
