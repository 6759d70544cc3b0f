// SPDX-License-Identifier: MIT
#include <apart/core/flight.hpp>
#include <support/near.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

// One block in the middle of row 5: x = 0, y from 13.2 to 14. A distant glass block keeps the game
// running.
const std::string kBrick = "g..............\n" + emptyRows(4) + ".......b.......\n";
constexpr Real kUnderside = Real(13.2);

kodo::Real ballMass() {
    return kodo::massOf(kodo::Circle{kBallRadius}, kBallDensity).mass;
}

/// A ball just below the block, x (m) off its centre, flying up.
Game shotAtBlock(const std::string& grid, Real x, Real speed) {
    Game game(levelOf(grid, static_cast<int>(speed * 1000)), 1);
    GameTestAccess::shoot(game, {x, kUnderside - Real(0.6)}, {0, speed});
    return game;
}

TEST(Blocks, BreakAtThePointOfImpactIfTheImpulseExceedsTheirStrength) {
    Game game = shotAtBlock(kBrick, Real(0.5), 12);
    const auto broke = playUntil<Broke>(game, {}, 30);
    ASSERT_TRUE(broke);
    EXPECT_TRUE(near(broke->point, Vec2{Real(0.5), kUnderside}, 0.01)); // the engine's slop is 4 mm
    EXPECT_TRUE(near(broke->impulse, 2 * ballMass() * 12, 0.01 * 24));  // head-on, e = 1: 2 m v
    EXPECT_EQ(game.blocksLeft(), 1);
    EXPECT_EQ(static_cast<std::size_t>(broke->shards), game.shards().size());
    EXPECT_GE(broke->shards, 2);
    EXPECT_EQ(game.score(), broke->points);
}

// A force presses in every substep: the pieces receive F t of the whole tick, not of one substep.
TEST(Blocks, BreakUnderALoadByItsImpulseOfTheWholeTick) {
    constexpr Real kLoad = 3000; // N; 25 N s in a tick, 5 in a substep, against a strength of 3
    Game game(levelOf("g..............\n" + emptyRows(4) + ".......g.......\n"), 1);
    const kodo::BodyId ball =
        GameTestAccess::shoot(game, {0, kUnderside - kBallRadius}, {0, Real(1e-3)});
    GameTestAccess::world(game)[ball].applyForce({0, kLoad});
    game.tick({});
    const Broke* broke = eventOf<Broke>(game);
    ASSERT_NE(broke, nullptr);
    // Momentum of the ball is F t - J: 0.25 N s for a ball of 1 kg that is left with 0.25 m/s.
    EXPECT_TRUE(near(broke->impulse, kLoad * kTickSeconds, 0.01 * 25));
}

TEST(Blocks, CrackUnderASmallerImpulse) {
    Game game = shotAtBlock(kBrick, 0, 4);
    const auto cracked = playUntil<Cracked>(game, {}, 60);
    ASSERT_TRUE(cracked);
    const Real impact = 2 * ballMass() * 4;
    EXPECT_TRUE(near(cracked->impulse, impact, Real(0.01) * impact));
    EXPECT_TRUE(near(cracked->strengthLeft, (12 - impact) / 12, 0.02));
    EXPECT_EQ(game.blocksLeft(), 2);
    GameTestAccess::shoot(game, {0, kUnderside - Real(0.6)}, {0, 4});
    EXPECT_TRUE(playUntil<Broke>(game, {}, 60)); // 4 N s of strength left, 8 N s of impulse
}

TEST(Blocks, OfSteelNeverBreak) {
    Game game = shotAtBlock("g..............\n" + emptyRows(4) + ".......X.......\n", 0, 40);
    EXPECT_FALSE(playUntil<Broke>(game, {}, 30));
    EXPECT_EQ(game.blocksAtStart(), 1); // steel does not count
}

TEST(Blocks, GiveTheirPiecesTheImpulseBeyondTheirMount) {
    Game game = shotAtBlock(kBrick, Real(0.5), 12);
    const auto broke = playUntil<Broke>(game, {}, 30);
    ASSERT_TRUE(broke);
    Vec2 momentum;
    Real mass = 0;
    for (const Shard& shard : game.shards()) {
        momentum += game.world()[shard.body].mass() * game.world()[shard.body].velocity();
        mass += game.world()[shard.body].mass();
    }
    const Vec2 passed = impulseOnPieces({0, broke->impulse}, 12, mass);
    EXPECT_TRUE(near(momentum, passed, 1e-4)); // a dozen floats of about 1
    EXPECT_GT(passed.y, 0);
}

// A4: pieces fall off the screen.
TEST(Shards, AreRemovedBelowTheScreen) {
    Game game = shotAtBlock(kBrick, Real(0.5), 12);
    ASSERT_TRUE(playUntil<Broke>(game, {}, 30));
    for (int tick = 0; tick < 500; ++tick) {
        GameTestAccess::shoot(game, {-9, 9}, {12, 0}); // away from the blocks
        game.tick(towards(-9));
    }
    EXPECT_EQ(game.shards().size(), 0u);
}

TEST(Shards, AreNeverMoreThanTheCap) {
    Game game(levelOf("ggggggggggggggg\nggggggggggggggg\nggggggggggggggg\n"), 1);
    while (game.blocks().size() > 1) {
        GameTestAccess::breakBlock(game, 0, {0, 24});
    }
    game.tick({});
    EXPECT_LE(game.shards().size(), kMostShards);
    EXPECT_GT(game.shards().size(), kMostShards / 2);
}

TEST(Serve, RidesOnThePaddleUntilItIsLaunchedAlongTheHeadingShown) {
    Game game(levelOf(kBrick), 5);
    EXPECT_TRUE(game.serving());
    for (int tick = 0; tick < 60; ++tick) {
        game.tick(towards(4));
    }
    EXPECT_TRUE(near(game.world()[game.balls()[0].body].position().x, 4, 0.01));
    const Vec2 heading = game.serveHeading();
    Input launch = towards(4);
    launch.launch = true;
    game.tick(launch);
    EXPECT_FALSE(game.serving());
    ASSERT_NE(eventOf<Served>(game), nullptr);
    const Vec2 velocity = game.world()[game.balls()[0].body].velocity();
    EXPECT_TRUE(near(normalize(velocity), heading, 1e-5));
    EXPECT_TRUE(near(length(velocity), 12, 1e-4));
}

TEST(Serve, IsTurnedByTheAimWhichHoldsUntilTheServe) {
    Game game(levelOf(kBrick), 5);
    Input aim;
    aim.aim = std::int16_t{-1000};
    game.tick(aim);
    const Vec2 heading = normalize(Vec2{-1, 1});
    EXPECT_TRUE(near(game.serveHeading(), heading, 1e-6));
    game.tick({});
    EXPECT_TRUE(near(game.serveHeading(), heading, 1e-6));
    Input launch;
    launch.launch = true;
    game.tick(launch);
    EXPECT_TRUE(near(normalize(game.world()[game.balls()[0].body].velocity()), heading, 1e-5));
    aim.aim = std::int16_t{1000};
    game.tick(aim); // no ball rides
    EXPECT_TRUE(near(game.serveHeading(), heading, 1e-6));
}

TEST(Serve, IsNotAimedFlatterThanSixtyDegreesFromTheVertical) {
    Game game(levelOf(kBrick), 5);
    Input aim;
    aim.aim = std::int16_t{30000};
    game.tick(aim);
    EXPECT_TRUE(near(game.serveHeading().y, Real(0.5), 1e-3));
}

TEST(Serve, ItsFirstLegEndsWhereTheBallFirstTouches) {
    for (const int slope : {-1500, -400, 0, 250, 1700}) {
        Game game(levelOf(kBrick), 5);
        Input aim;
        aim.aim = static_cast<std::int16_t>(slope);
        game.tick(aim);
        const std::vector<Vec2> leg = servePath(game);
        ASSERT_EQ(leg.size(), 2u);
        Input launch;
        launch.launch = true;
        game.tick(launch);
        while (eventOf<Struck>(game) == nullptr) {
            game.tick({});
        }
        // The cast ball is a tenth smaller, and a tick takes up to 0.23 m.
        const Vec2 place = game.world()[game.balls()[0].body].position();
        EXPECT_TRUE(near(place, leg[1], 0.3)) << slope;
    }
}

TEST(Serve, ItsFirstLegBendsInTheWind) {
    Level level = levelOf(kBrick);
    level.wind = 8000;
    Game game(level, 5);
    Input aim;
    aim.aim = std::int16_t{0};
    game.tick(aim);
    const std::vector<Vec2> leg = servePath(game);
    ASSERT_GT(leg.size(), 5u);
    EXPECT_GT(leg.back().x, leg.front().x + Real(0.5));
}

TEST(Serve, AssistedItsPathGoesOnAfterABounceAndTheBallIsSlower) {
    Game game(levelOf(kBrick), 5, Mode::Assisted);
    Input aim;
    aim.aim = std::int16_t{1500};
    game.tick(aim);
    const std::vector<Vec2> path = servePath(game);
    ASSERT_EQ(path.size(), 2u + kAssistedBounces);
    EXPECT_TRUE(near(path[1].x, kFieldWidth / 2 - kBallRadius, 0.1)) << "the right wall";
    const Vec2 before = normalize(path[1] - path[0]);
    const Vec2 after = normalize(path[2] - path[1]);
    EXPECT_TRUE(near(after, Vec2{-before.x, before.y}, 1e-2));
    Input launch;
    launch.launch = true;
    game.tick(launch);
    for (int tick = 0; tick < 10; ++tick) {
        game.tick({});
    }
    const Real speed = length(game.world()[game.balls()[0].body].velocity());
    EXPECT_TRUE(near(speed, kAssistedSpeed * 12, 0.2));
}

TEST(Prize, TouchesOfThePaddleWithinAQuarterOfASecondAreOneHit) {
    Counts counts;
    counts.hit(100);
    counts.hit(100 + kHitTicks - 1);
    counts.hit(100 + 2 * kHitTicks - 2);
    EXPECT_EQ(counts.hits, 1);
    counts.hit(100 + 3 * kHitTicks - 2);
    EXPECT_EQ(counts.hits, 2);
}

TEST(Prize, IsPaidForTheBestBlowAndDividedByWhatItLeft) {
    Game game(levelOf(emptyRows(5) + "...bbb.b.......\n"), 5);
    EXPECT_EQ(game.counts().prize(), 0);
    Input input;
    input.launch = true;
    game.tick(input);
    EXPECT_EQ(game.counts().hits, 1) << "a serve is a hit";
    GameTestAccess::breakBlock(game, 0, {0, 24});
    GameTestAccess::breakBlock(game, 0, {0, 24});
    game.tick({});
    EXPECT_EQ(game.counts().bestBlow, 2);
    EXPECT_EQ(game.counts().prize(), kPrizeFactor * 400 * 2 / 3) << "it left two blocks";
    for (std::uint32_t tick = 0; tick < kHitTicks; ++tick) {
        GameTestAccess::shoot(game, {0, 3}, {0, -12});
        game.tick({});
    }
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    EXPECT_EQ(game.counts().hits, 2);
    GameTestAccess::breakBlock(game, 0, {0, 24});
    game.tick({});
    EXPECT_EQ(game.counts().bestBlow, 2) << "a hit begins another blow";
    const std::int32_t before = game.score();
    GameTestAccess::breakBlock(game, 0, {0, 24});
    game.tick({});
    const auto* won = eventOf<Cleared>(game);
    ASSERT_NE(won, nullptr);
    EXPECT_EQ(won->prize, kPrizeFactor * 400 * 2 / 3);
    EXPECT_EQ(won->spared, 0);
    EXPECT_GE(game.score(), before + 100 + won->prize + won->lives);
}

TEST(Serve, DependsOnTheSeedAndIsNeitherSteepNorFlat) {
    const Level level = levelOf(kBrick);
    EXPECT_EQ(Game(level, 5).serveHeading(), Game(level, 5).serveHeading());
    EXPECT_NE(Game(level, 5).serveHeading(), Game(level, 6).serveHeading());
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const Vec2 heading = Game(level, seed).serveHeading();
        const Real slope = std::abs(heading.x / heading.y);
        EXPECT_GT(heading.y, 0);
        EXPECT_LE(slope, kServeSlope * Real(1.001));
        EXPECT_GE(slope, kServeSlope / 4 * Real(0.999));
    }
}

TEST(Lives, FallByOneWithTheLastBallAndANewBallIsServed) {
    Game game(levelOf(kBrick), 1);
    GameTestAccess::shoot(game, {8, 1}, {0, -12});
    ASSERT_TRUE(playUntil<LifeLost>(game, {}, 60));
    EXPECT_EQ(game.lives(), 2);
    EXPECT_TRUE(game.serving());
    EXPECT_EQ(game.result(), Result::Playing);
}

TEST(Lives, EndTheGameWhenNoneIsLeft) {
    Game game(levelOf(kBrick), 1);
    for (int life = 0; life < 3; ++life) {
        GameTestAccess::shoot(game, {8, 1}, {0, -12});
        ASSERT_TRUE(playUntil<LifeLost>(game, {}, 60));
    }
    EXPECT_NE(eventOf<Lost>(game), nullptr);
    EXPECT_EQ(game.result(), Result::Lost);
    EXPECT_EQ(game.lives(), 0);
    Input launch;
    launch.launch = true;
    const std::int32_t score = game.score();
    for (int tick = 0; tick < 100; ++tick) {
        game.tick(launch); // still allowed, without effect on the score
    }
    EXPECT_EQ(game.score(), score);
    EXPECT_EQ(game.balls().size(), 0u);
}

TEST(Lives, AreWorthPointsWhenTheLastBlockBreaks) {
    Game game(levelOf(emptyRows(5) + ".......g.......\n" + emptyRows(2) + "X..............\n"), 1);
    GameTestAccess::beginBlow(game);
    GameTestAccess::shoot(game, {0, kUnderside - Real(0.6)}, {0, 12});
    const auto cleared = playUntil<Cleared>(game, {}, 30);
    ASSERT_TRUE(cleared);
    EXPECT_EQ(game.result(), Result::Won);
    EXPECT_EQ(cleared->lives, 3 * kLifePoints);
    EXPECT_EQ(game.score(), kPoints[0] + cleared->lives + cleared->prize);
}

TEST(Combo, GrowsWithEachBlockUntilThePaddleIsHit) {
    Game game(levelOf("g.............g\n" + emptyRows(4) + ".....b...b.....\n"), 1);
    GameTestAccess::countHit(game);
    GameTestAccess::breakBlock(game, 2, {0, 24});
    const std::int32_t first = game.score();
    GameTestAccess::breakBlock(game, 2, {0, 24});
    EXPECT_EQ(game.counts().combo, 2);
    EXPECT_EQ(game.score(), 3 * first);
    GameTestAccess::shoot(game, {0, 3}, {0, -12});
    for (int tick = 0; tick < 20; ++tick) {
        game.tick({});
    }
    EXPECT_EQ(game.counts().combo, 0);
}

// Regression: a new ball continued the combo of the lost one.
TEST(Combo, EndsWhenALifeIsLost) {
    Game game(levelOf(kBrick), 1);
    GameTestAccess::countHit(game);
    GameTestAccess::breakBlock(game, 1, {0, 24});
    ASSERT_EQ(game.counts().combo, 1);
    GameTestAccess::shoot(game, {8, 1}, {0, -12});
    ASSERT_TRUE(playUntil<LifeLost>(game, {}, 60));
    EXPECT_EQ(game.counts().combo, 0);
}

TEST(Paddle, ReflectsTheBallAboutTheNormalOfItsDome) {
    for (const Real offset : {Real(-1.5), Real(-0.8), Real(0.8), Real(1.5)}) {
        Game game(levelOf(kBrick), 1);
        GameTestAccess::shoot(game, {offset, 3}, {0, -12});
        ASSERT_TRUE(playUntil<Struck>(game, {}, 30));
        // Normal of the dome at that position. Facets are 1/6 m wide, which gives an error of 1
        // degree or 0.018 rad. The outgoing direction has twice that error.
        const Real sine = offset / (kDomeRadius + kBallRadius);
        const Vec2 normal{sine, std::sqrt(1 - sine * sine)};
        const Vec2 out = Vec2{0, -1} - 2 * dot(Vec2{0, -1}, normal) * normal;
        EXPECT_TRUE(near(game.balls()[0].heading, out, 0.04)) << offset;
    }
}

TEST(Paddle, StaysInsideTheField) {
    Game game(levelOf(kBrick), 1);
    for (const Real x : {Real(-30), Real(30)}) {
        for (int tick = 0; tick < 200; ++tick) {
            game.tick(towards(x));
            const kodo::Aabb bounds = game.world()[game.paddle()].bounds();
            ASSERT_GE(bounds.lower.x, -kFieldWidth / 2 - Real(1e-3));
            ASSERT_LE(bounds.upper.x, kFieldWidth / 2 + Real(1e-3));
        }
    }
}

/// Fastest flight of a ball that hits nothing, above and just over the paddle, relative to the
/// speed of the level.
std::pair<Real, Real> idleSpeeds(Mode mode) {
    Game game(levelOf("b.............b\n"), 1, mode);
    const kodo::BodyId ball = GameTestAccess::shoot(game, {0, 6}, {0, game.state().ballSpeed()});
    std::pair<Real, Real> fastest;
    for (int tick = 0; tick < 3 * kTicksPerSecond; ++tick) {
        game.tick({});
        const Real share = length(game.world()[ball].velocity()) / game.state().ballSpeed();
        const Real height = game.world()[ball].position().y;
        fastest.first = std::max(fastest.first, height > kQuickHeight ? share : 0);
        fastest.second = std::max(fastest.second, height < Real(2.2) ? share : 0);
    }
    return fastest;
}

TEST(Game, AnIdleBallFliesFasterUntilItComesNearThePaddle) {
    const auto [high, low] = idleSpeeds(Mode::Standard);
    EXPECT_NEAR(high, kQuickFactor, kServoBand * kQuickFactor);
    EXPECT_LT(low, Real(1.3));
    const auto [pureHigh, pureLow] = idleSpeeds(Mode::Pure);
    EXPECT_NEAR(pureHigh, 1, kServoBand);
    EXPECT_NEAR(pureLow, 1, kServoBand);
}

} // namespace
