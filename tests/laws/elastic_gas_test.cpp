// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::slippery;

BodyId addSide(World& world, Real x, Real y, Real width, Real height) {
    return world.add({.shape = Box{width, height},
                      .position = {x, y},
                      .material = slippery(1),
                      .flags = kLocked});
}

/// 50 balls of 0.3 m on 12 x 12 m.
void addBalls(World& world, support::RandomNumbers& random) {
    for (int i = 0; i < 50; ++i) {
        BodyDef def = support::ballDef(
            {static_cast<Real>(i % 8) * Real(1.4) - 5, static_cast<Real>(i / 8) * Real(1.6) - 5},
            Real(0.3), slippery(1));
        def.velocity = random.point(5);
        world.add(def);
    }
}

/// The same in a closed room.
void addGas(World& world, std::uint64_t seed) {
    addSide(world, 0, Real(-6.5), 14, 1);
    addSide(world, 0, Real(6.5), 14, 1);
    addSide(world, Real(-6.5), 0, 1, 14);
    addSide(world, Real(6.5), 0, 1, 14);
    support::RandomNumbers random(seed);
    addBalls(world, random);
}

// Without loss, gravity or friction the energy of the gas stays within 1 % and no ball
// escapes, in 1e5 steps. What pushes a ball along a normal pushes it through its centre, so none
// ever turns, not by a rounding.
TEST(ElasticGas, KeepsItsEnergyAndItsBalls) {
    constexpr std::uint64_t kSeed = 161;
    World world;
    addGas(world, kSeed);
    const long double before = support::totalsOf(world).kinetic;
    for (int i = 0; i < 100; ++i) {
        support::run(world, 1000);
        const long double now = support::totalsOf(world).kinetic;
        ASSERT_TRUE(support::nearShare(now, before, 0.01L)) << "seed " << kSeed << ", " << i;
    }
    for (const BodyId id : world.bodies()) {
        if ((world[id].flags() & kLocked) == 0) {
            EXPECT_LT(std::abs(world[id].position().x), Real(6.01));
            EXPECT_LT(std::abs(world[id].position().y), Real(6.01));
            EXPECT_EQ(world[id].angularVelocity(), 0);
        }
    }
}

// The same in a box that floats freely, of twice the mass of the gas: for 2e4 steps, some
// 1e4 blows, momentum stays to rounding, energy within 1 %, and angular momentum within a
// thousandth: a ball that is stopped at a wall gives up the rest of its step, so it is hit a little
// beside its way.
TEST(ElasticGas, InAFloatingBoxKeepsAllThreeSums) {
    constexpr std::uint64_t kSeed = 163;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    World world;
    const BodyId box =
        world.add({.shape = Compound{{Box{14, 1, {0, Real(-6.5)}}, Box{14, 1, {0, Real(6.5)}},
                                      Box{1, 12, {Real(-6.5), 0}}, Box{1, 12, {Real(6.5), 0}}}},
                   .material = slippery(1),
                   .density = Real(0.5)});
    addBalls(world, random);
    const support::Totals before = support::totalsOf(world);
    for (int i = 0; i < 20; ++i) {
        support::run(world, 1000);
        const support::Totals now = support::totalsOf(world);
        ASSERT_TRUE(support::nearShare(now.kinetic, before.kinetic, 0.01L)) << i;
    }
    const support::Totals after = support::totalsOf(world);
    using support::byPrecision;
    EXPECT_TRUE(support::near(after.momentum, before.momentum, byPrecision(1e-4, 1e-11)));
    EXPECT_TRUE(support::nearShare(after.spin, before.spin, 1e-3L));
    for (const BodyId id : world.bodies()) {
        const Vec2 inside =
            unrotate(world[box].rotation(), world[id].position() - world[box].position());
        EXPECT_LT(std::max(std::abs(inside.x), std::abs(inside.y)), Real(6.01)) << id.index;
    }
}

// In free space: a swarm that falls together keeps momentum and angular momentum to
// rounding, and its energy.
TEST(ElasticGas, InFreeSpaceKeepsAllThreeSums) {
    constexpr std::uint64_t kSeed = 162;
    support::RandomNumbers random(kSeed);
    World world;
    for (int i = 0; i < 64; ++i) {
        const Vec2 place{static_cast<Real>(i % 8) * 2 - 7, static_cast<Real>(i / 8) * 2 - 7};
        BodyDef def = support::ballDef(place, random.between(0.3, 0.8), slippery(1));
        def.velocity = Real(-0.5) * place + random.point(1);
        world.add(def);
    }
    const support::Totals before = support::totalsOf(world);
    std::size_t hits = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(support::kDt);
        hits += world.collisions().size();
    }
    const support::Totals after = support::totalsOf(world);
    EXPECT_GT(hits, 100u) << "seed " << kSeed;
    using support::byPrecision;
    // Some hundred hits, each rounds momenta of some 5 kg m/s.
    EXPECT_TRUE(support::near(after.momentum, before.momentum, byPrecision(1e-4, 1e-12)));
    // At arms of some 20 m. Balls that are hit again while they are near each other go by the
    // normal of that moment: one of 3 cm before would turn the pair by up to 0.1 kg m^2/s with each
    // blow of 5 N s.
    EXPECT_TRUE(support::near(after.spin, before.spin, byPrecision(5e-3, 1e-9)));
    EXPECT_TRUE(support::nearShare(after.kinetic, before.kinetic, byPrecision(1e-4, 1e-9)));
}

} // namespace
} // namespace kodo
