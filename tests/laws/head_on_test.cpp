// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::slippery;

// Rounding only. Distances of metres have 24 bits in float; velocities come from two products and a
// quotient.
constexpr Real kRounding = byPrecision(1e-6, 1e-12);

struct Pair {
    World world;
    BodyId first;
    BodyId second;

    Pair(Real massRatio, Real v1, Real v2, Real restitution) {
        // Balls of equal size; the second has massRatio times the mass of the first.
        const Real radius = Real(0.5);
        BodyDef def = support::ballDef({-2, 0}, radius, slippery(restitution));
        def.density = massRatio < 1 ? 1 : 1 / massRatio;
        def.velocity = {v1, 0};
        first = world.add(def);
        def.position = {2, 0};
        def.density = massRatio < 1 ? massRatio : 1;
        def.velocity = {v2, 0};
        second = world.add(def);
    }
    void run(Real seconds) { support::run(world, static_cast<int>(seconds * 60)); }
};

// v1' = (m1 - m2) / (m1 + m2) v,  v2' = 2 m1 / (m1 + m2) v.
TEST(HeadOn, ElasticFollowsTheTextbookAtAnyMassRatio) {
    for (const double ratio : {1.0, 2.0, 10.0, 1e3, 1e6, 1e9, 0.5, 0.1, 1e-3, 1e-6, 1e-9}) {
        SCOPED_TRACE(testing::Message() << "m2 / m1 = " << ratio);
        Pair pair(static_cast<Real>(ratio), 3, 0, 1);
        pair.run(2);
        const auto r = static_cast<long double>(ratio);
        EXPECT_TRUE(
            near(pair.world[pair.first].velocity().x, 3 * (1 - r) / (1 + r), 3 * kRounding));
        EXPECT_TRUE(near(pair.world[pair.second].velocity().x, 6 / (1 + r), 6 * kRounding));
        EXPECT_EQ(pair.world[pair.first].velocity().y, 0);
    }
}

// There is no restitution threshold: 0.004 m/s bounces as exactly as 400 m/s.
TEST(HeadOn, SlowIsAsExactAsFast) {
    for (const Real speed : {Real(0.004), Real(0.4), Real(4), Real(400)}) {
        SCOPED_TRACE(speed);
        Pair pair(1, speed, -speed, 1);
        pair.run(2 / speed + 1);
        EXPECT_TRUE(near(pair.world[pair.first].velocity().x, -speed, kRounding * speed));
        EXPECT_TRUE(near(pair.world[pair.second].velocity().x, speed, kRounding * speed));
    }
}

// With loss the relative speed is scaled by e, and momentum is conserved.
TEST(HeadOn, InelasticScalesTheRelativeSpeedByTheRestitution) {
    for (const Real e : {Real(0), Real(0.3), Real(0.7)}) {
        SCOPED_TRACE(e);
        Pair pair(3, 4, -1, e);
        pair.run(2);
        const Real v1 = pair.world[pair.first].velocity().x;
        const Real v2 = pair.world[pair.second].velocity().x;
        EXPECT_TRUE(near(v2 - v1, 5 * static_cast<long double>(e), 8 * kRounding));
        EXPECT_TRUE(near(v1 + 3 * v2, 1, 16 * kRounding));
    }
}

// An oblique impact keeps the tangential velocities, the momentum and the energy.
TEST(HeadOn, AGlancingElasticHitKeepsMomentumAndEnergy) {
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE(i);
        Pair pair(2, 3, 0, 1);
        pair.world[pair.first].setPosition({-2, static_cast<Real>(i) / 41});
        const support::Totals before = support::totalsOf(pair.world);
        pair.run(2);
        const support::Totals after = support::totalsOf(pair.world);
        EXPECT_NE(pair.world[pair.second].velocity(), Vec2{});
        EXPECT_TRUE(near(after.momentum, before.momentum, 4 * kRounding));
        EXPECT_TRUE(support::nearShare(after.kinetic, before.kinetic, 2 * kRounding));
    }
}

} // namespace
} // namespace kodo
