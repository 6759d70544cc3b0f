// SPDX-License-Identifier: MIT
// A ball between the paddle and a wall.
#include <support/random_numbers.hpp>

#include <game/game_access.hpp>
#include <game/level_of_glass.hpp>

#include <algorithm>
#include <cmath>

namespace apart {
namespace {

using kodo::Real;
using kodo::Vec2;

std::int16_t thousandths(Real place) {
    return static_cast<std::int16_t>(1000 * place);
}

// The paddle rushes at a wall, with a ball at any height between: before, it left at up to
// 1,000 m/s, or 0.3 m inside the wall.
TEST(Jam, ABallBetweenPaddleAndWallStaysInsideAndKeepsItsSpeedBounded) {
    support::RandomNumbers random(53);
    Real fastest = 0;
    Real deepest = 0;
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed 53, trial " + std::to_string(trial));
        Game game(levelOfGlass({7}), 1);
        const Real side = random.below(2) == 0 ? Real(1) : Real(-1);
        const Real paddleAt = random.between(4, 9);
        for (int tick = 0; tick < 60; ++tick) {
            game.tick({.target = thousandths(side * paddleAt)});
        }
        const Real x = random.between(11.2, 11.7);
        const Real y = random.between(0.7, 2.2);
        const Real angle = random.between(0, 6.2);
        const kodo::BodyId ball =
            GameTestAccess::shoot(game, {side * x, y}, 12 * Vec2{std::cos(angle), std::sin(angle)});
        for (int tick = 0; tick < 60 && game.world().contains(ball); ++tick) {
            game.tick({.target = thousandths(32 * side)});
            if (game.world().contains(ball)) {
                const kodo::BodyView body = game.world()[ball];
                fastest = std::max(fastest, length(body.velocity()) / game.state().ballSpeed());
                deepest = std::max({deepest, body.bounds().upper.x - kFieldWidth / 2,
                                    -kFieldWidth / 2 - body.bounds().lower.x});
            }
        }
    }
    EXPECT_LE(fastest, kMostBallFactor * Real(1.001));
    EXPECT_LE(deepest, kMostPressed);
}

} // namespace
} // namespace apart
