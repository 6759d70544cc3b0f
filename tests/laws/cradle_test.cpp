// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;
using support::slippery;

/// Ball 0 moves at 2 m/s towards a row of four resting balls. `gap` is the distance between
/// neighbours relative to the diameter of 1 m.
struct Cradle {
    World world;
    std::vector<BodyId> balls;

    explicit Cradle(Real gap) {
        for (int i = 0; i < 5; ++i) {
            BodyDef def =
                support::ballDef({static_cast<Real>(i) * (1 + gap), 0}, Real(0.5), slippery(1));
            if (i == 0) {
                def.position.x = -1;
                def.velocity = {2, 0};
            }
            balls.push_back(world.add(def));
        }
    }
    Real speed(std::size_t i) const { return world[balls[i]].velocity().x; }
};

// With gaps the impacts are sequential, each one exact.
TEST(Cradle, WithGapsTransfersTheImpulseExactly) {
    Cradle cradle(Real(0.05));
    const support::Totals before = support::totalsOf(cradle.world);
    support::run(cradle.world, 300);
    const Real tolerance = byPrecision(2e-6, 1e-9);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(near(cradle.speed(i), 0, tolerance)) << i;
    }
    EXPECT_TRUE(near(cradle.speed(4), 2, tolerance));
    const support::Totals after = support::totalsOf(cradle.world);
    EXPECT_TRUE(nearShare(after.kinetic, before.kinetic, tolerance));
    EXPECT_TRUE(near(after.momentum, before.momentum, tolerance));
}

// Without gaps the impulse passes through the row within one step. The last ball leaves with at
// least 99 % of the speed, without energy loss.
TEST(Cradle, WithoutGapsTransfersTheImpulseThroughTheRow) {
    Cradle cradle(0);
    const support::Totals before = support::totalsOf(cradle.world);
    support::run(cradle.world, 300);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(near(cradle.speed(i), 0, Real(0.02))) << i;
    }
    EXPECT_TRUE(nearShare(cradle.speed(4), 2, 0.01L));
    const support::Totals after = support::totalsOf(cradle.world);
    EXPECT_TRUE(nearShare(after.kinetic, before.kinetic, byPrecision(4e-6, 1e-6)));
    EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(4e-6, 1e-9)));
}

// Two balls in give two balls out.
TEST(Cradle, TwoBallsInGiveTwoBallsOut) {
    Cradle cradle(Real(0.05));
    cradle.world[cradle.balls[1]].setPosition({Real(-0.1), 0});
    cradle.world[cradle.balls[0]].setPosition({Real(-1.2), 0});
    cradle.world[cradle.balls[1]].setVelocity({2, 0});
    support::run(cradle.world, 300);
    const Real tolerance = byPrecision(4e-6, 1e-9);
    EXPECT_TRUE(near(cradle.speed(3), 2, tolerance));
    EXPECT_TRUE(near(cradle.speed(4), 2, tolerance));
    EXPECT_TRUE(near(cradle.speed(2), 0, tolerance));
}

} // namespace
} // namespace kodo
