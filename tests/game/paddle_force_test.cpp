// SPDX-License-Identifier: MIT
// The paddle's force field.
#include <support/near.hpp>

#include <array>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

Input holding(Force force) {
    Input input;
    input.force = force;
    return input;
}

Game served(const std::string& rows) {
    Game game(levelOf("g..............\n" + rows), 1);
    GameTestAccess::countHit(game);
    return game;
}

Game fresh() {
    return served(emptyRows(4) + ".......b.......\n");
}

/// Speed of the first ball away from the centre of the paddle.
Real awaySpeed(const Game& game) {
    const kodo::BodyView ball = game.world()[game.balls()[0].body];
    return dot(ball.velocity(),
               normalize(ball.position() - game.world()[game.paddle()].position()));
}

TEST(Field, PullsAndPushesABall) {
    std::array<Real, 3> away{};
    for (const Force force : {Force::None, Force::Pull, Force::Push}) {
        Game game = fresh();
        GameTestAccess::shoot(game, {-6, 6}, {12, 0});
        for (int tick = 0; tick < 30; ++tick) {
            game.tick(holding(force));
            EXPECT_EQ(game.force(), force);
        }
        away[static_cast<std::size_t>(force)] = awaySpeed(game);
    }
    EXPECT_LT(away[1], away[0] - 2);
    EXPECT_GT(away[2], away[0] + 2);
}

/// Impulse (N s) towards the paddle that a ball at this distance (m) receives in a tick.
Real drawnFrom(Real distance, bool magnet) {
    Game game = fresh();
    if (magnet) {
        GameTestAccess::give(game, Power::Magnet);
    }
    const Vec2 direction = normalize(Vec2{-3, 4});
    const Vec2 center = game.world()[game.paddle()].position();
    GameTestAccess::shoot(game, center + distance * direction, {0, -12});
    game.tick(magnet ? Input{} : holding(Force::Pull));
    const Vec2 given{static_cast<Real>(game.ledger().fieldImpulseX),
                     static_cast<Real>(game.ledger().fieldImpulseY)};
    EXPECT_TRUE(near(cross(given, direction), 0, 1e-5)); // central
    return -dot(given, direction);
}

// m a (1 - r / R) t
TEST(Field, FallsLinearlyWithTheDistanceToZeroAtItsRange) {
    const Real mass = massOf(kodo::Circle{kBallRadius}, kBallDensity).mass;
    for (const Real distance : {Real(2), Real(4), Real(8), Real(12)}) {
        const Real share = 1 - distance / kForceReach;
        // Floats of up to 0.3 N s, from places of up to 16 m.
        EXPECT_TRUE(near(drawnFrom(distance, false),
                         mass * kForceAcceleration * share * kTickSeconds, 1e-6));
    }
    for (const Real share : {Real(0.6), Real(0.3), Real(0.01)}) {
        EXPECT_TRUE(near(drawnFrom((1 - share) * kMagnetReach, true),
                         mass * kMagnetAcceleration * share * kTickSeconds, 1e-6));
    }
    EXPECT_EQ(drawnFrom(Real(1.01) * kMagnetReach, true), 0);
}

TEST(Field, ActsOnShardsPartsAndLooseBlocks) {
    Game game = served(emptyRows(4) + "....b..W..b....\n");
    GameTestAccess::letGo(game, 1);
    GameTestAccess::breakBlock(game, 2, {0, 0});
    const kodo::BodyId loose = game.blocks()[1].body;
    const kodo::BodyId part = game.parts()[0].body;
    const kodo::BodyId shard = game.shards()[0].body;
    Game still = game;
    for (int tick = 0; tick < 10; ++tick) {
        game.tick(holding(Force::Push));
        still.tick({});
    }
    for (const kodo::BodyId body : {loose, part, shard}) {
        EXPECT_GT(game.world()[body].velocity().y, still.world()[body].velocity().y + 1);
    }
    const kodo::BodyId mounted = game.blocks()[2].body;
    EXPECT_EQ(game.world()[mounted].velocity(), Vec2{});
}

TEST(Field, BooksTheImpulseThatItGives) {
    Game game = fresh(); // the ball rides: the servo adds no impulse
    GameTestAccess::breakBlock(game, 1, {0, 0});
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    Game still = game;
    game.tick(holding(Force::Pull));
    still.tick({});
    Vec2 given; // momentum measured in the world
    for (const Shard& shard : game.shards()) {
        const kodo::BodyView body = game.world()[shard.body];
        given += body.mass() * (body.velocity() - still.world()[shard.body].velocity());
    }
    EXPECT_LT(given.y, Real(-0.1));
    EXPECT_TRUE(near(given.x, static_cast<Real>(game.ledger().fieldImpulseX), 1e-5));
    EXPECT_TRUE(near(given.y, static_cast<Real>(game.ledger().fieldImpulseY), 1e-5));
}

TEST(Field, SlowsAPaddleByItsReaction) {
    Game game = fresh();
    GameTestAccess::give(game, Power::Heavy); // 3 kg beside the paddle
    GameTestAccess::shoot(game, {6, Real(1.2)}, {0, Real(0.2)});
    game.tick(holding(Force::Pull));
    const double given = game.ledger().fieldImpulseX;
    EXPECT_LT(given, 0); // to the left
    // The drive compensates the reaction: its limit of kPaddleForce per tick is higher.
    EXPECT_LT(std::abs(given), static_cast<double>(kPaddleForce * kTickSeconds));
    EXPECT_TRUE(near(game.world()[game.paddle()].velocity().x, 0, 1e-4));
}

/// A game without damage for so long that blocks glow.
Game glowing(const std::string& tail = "") {
    Game game(levelOf("gggg...........\n" + emptyRows(4) + ".......s.......\n" + tail), 1);
    GameTestAccess::shoot(game, {8, 9}, {0, 12});
    for (std::uint32_t tick = 0; tick < kGlowTicks; ++tick) {
        GameTestAccess::idle(game);
    }
    return game;
}

/// Ticks of this force until a block is torn off; 0: never.
int ticksUntilTorn(Game& game, Force force, int most = 240) {
    for (int tick = 1; tick <= most; ++tick) {
        GameTestAccess::shoot(game, {8, 9}, {0, 12}); // resets the ball, so that it hits nothing
        game.tick(holding(force));
        const LetGo* let = eventOf<LetGo>(game);
        if (let != nullptr && let->why == LetGo::Why::Torn) {
            return tick;
        }
    }
    return 0;
}

TEST(Pull, TearsTheLowestBlockOffOnceBlocksGlow) {
    Game game = glowing();
    ASSERT_EQ(game.state().patience(), Patience::Glowing);
    const Vec2 block = game.world()[game.state().nextToFall()->body].position();
    const Real way = length(block - game.world()[game.paddle()].position());
    const Real gained = kForceAcceleration * (1 - way / kForceReach) * kTickSeconds;
    EXPECT_EQ(ticksUntilTorn(game, Force::Pull), static_cast<int>(kTornSpeed / gained) + 1);
    EXPECT_EQ(eventOf<LetGo>(game)->stuff, Stuff::Stone);
    EXPECT_EQ(game.state().patience(), Patience::Calm) << "one block for each wait";
    EXPECT_EQ(ticksUntilTorn(game, Force::Pull), 0);
}

TEST(Pull, TearsNoBlockOffDuringProgressAndPushingNeverDoes) {
    Game calm = glowing();
    GameTestAccess::progress(calm);
    EXPECT_EQ(ticksUntilTorn(calm, Force::Pull), 0);
    Game pushing = glowing();
    EXPECT_EQ(ticksUntilTorn(pushing, Force::Push), 0);
}

TEST(Pull, BooksTheImpulseThatAWeakMountAbsorbs) {
    Game game = glowing();
    GameTestAccess::shoot(game, {8, 9}, {0, 12});
    Game calm = game;
    GameTestAccess::progress(calm);
    game.tick(holding(Force::Pull));
    calm.tick(holding(Force::Pull));
    const Block* block = game.state().nextToFall();
    const Real mass = game.world()[block->body].mass();
    const double more = game.ledger().fieldImpulseY - calm.ledger().fieldImpulseY;
    EXPECT_TRUE(near(static_cast<Real>(more), -mass * game.state().tornShare() * kTornSpeed, 1e-3));
}

TEST(Meter, DrainsInUseAndRefillsWithTime) {
    Game game = fresh();
    EXPECT_EQ(game.meter(), 1);
    int lasts = 0;
    do {
        game.tick(holding(Force::Push));
        ++lasts;
    } while (game.force() == Force::Push && lasts < 1000);
    EXPECT_NEAR(lasts, kMeterSeconds * kTicksPerSecond, 2); // one tick of rounding, and the last
                                                            // tick
    for (int tick = 0; tick < 120; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(game.meter(), 1 / kRefillSeconds, 0.01));
}

TEST(Meter, MustReachAMinimumBeforeTheFieldStarts) {
    Game game = fresh();
    GameTestAccess::setMeter(game, kMeterStart / 2);
    game.tick(holding(Force::Pull));
    EXPECT_EQ(game.force(), Force::None);
    GameTestAccess::setMeter(game, kMeterStart);
    game.tick(holding(Force::Pull));
    EXPECT_EQ(game.force(), Force::Pull);
    ASSERT_NE(eventOf<ForceChanged>(game), nullptr);
    EXPECT_EQ(eventOf<ForceChanged>(game)->force, Force::Pull);
}

TEST(Meter, IsFilledByCaughtShards) {
    Game game = served(emptyRows(10) + ".......b.......\n");
    GameTestAccess::breakBlock(game, 1, {0, 0});
    GameTestAccess::setMeter(game, Real(0.6));
    Real before = game.meter();
    for (int tick = 0; tick < 200 && eventOf<ShardCaught>(game) == nullptr; ++tick) {
        before = game.meter();
        game.tick(holding(Force::Pull));
    }
    const ShardCaught* caught = eventOf<ShardCaught>(game);
    ASSERT_NE(caught, nullptr);
    const Real mass = (caught->meter - before + kTickSeconds / kMeterSeconds) / kMeterPerKilogram;
    EXPECT_GT(mass, Real(0.03)); // mass of the lightest brick shards
    EXPECT_GE(static_cast<Real>(game.ledger().removedMass), mass * Real(0.999));
    Game pushing = fresh(); // without a pull no shard is caught
    GameTestAccess::breakBlock(pushing, 1, {0, 0});
    EXPECT_FALSE(playUntil<ShardCaught>(pushing, {}, 200));
}

TEST(Meter, FillsFasterAfterALongTimeWithoutDamage) {
    Game game = fresh();
    GameTestAccess::shoot(game, {8, 9}, {0, 12});
    for (std::uint32_t tick = 0; tick < kGlowTicks / kLastHurry; ++tick) {
        GameTestAccess::idle(game);
    }
    ASSERT_EQ(game.state().patience(), Patience::Glowing);
    GameTestAccess::setMeter(game, 0);
    game.tick({});
    EXPECT_TRUE(near(game.meter(), kHurry * kTickSeconds / kRefillSeconds, 1e-6));
}

} // namespace
