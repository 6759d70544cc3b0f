// SPDX-License-Identifier: MIT
// Powers beyond the three of the thesis, each an effect of bodies and forces.
#include <support/near.hpp>

#include <array>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

std::string nameOf(Power power) {
    return std::string(kPowerNames[static_cast<std::size_t>(power)]);
}

/// A game with a broken power block in the middle of the lowest row, glass and brick above it, and
/// the paddle below.
Game dropped(Power power) {
    Game game(levelWith("ggggggggggggggg\nbbbbbbbbbbbbbbb\n" + emptyRows(12) + ".......p.......\n",
                        "p", "stuff = \"brick\"\npower = \"" + nameOf(power) + "\""),
              1);
    for (int tick = 0; tick < 60; ++tick) {
        game.tick(towards(kCatchX));
    }
    GameTestAccess::breakBlock(game, game.blocks().size() - 1, {0, 0});
    return game;
}

/// A game in which a power has just begun.
Game given(Power power, const std::string& grid = "g..............\n") {
    Game game(levelOf(grid), 1);
    GameTestAccess::give(game, power);
    return game;
}

kodo::BodyView firstBall(const Game& game) {
    return game.world()[game.balls()[0].body];
}

class LastingPower : public testing::TestWithParam<Power> {};

TEST_P(LastingPower, IsCaughtAsABodyAndEndsInTime) {
    Game game = dropped(GetParam());
    ASSERT_EQ(game.parts().size(), 1u);
    EXPECT_GT(game.world()[game.parts()[0].body].mass(), Real(0.3));
    EXPECT_EQ(game.state().secondsLeft(GetParam()), 0);

    const auto began = playUntil<PowerBegan>(game, towards(kCatchX), 240);

    ASSERT_TRUE(began);
    EXPECT_EQ(began->power, GetParam());
    EXPECT_NE(eventOf<Caught>(game), nullptr);
    EXPECT_EQ(game.parts().size(), 0u);
    EXPECT_GT(game.state().secondsLeft(GetParam()), 7);
    while (game.ticks() + 1 < began->untilTick) {
        game.tick(towards(kCatchX));
        ASSERT_EQ(eventOf<PowerEnded>(game), nullptr);
    }
    game.tick(towards(kCatchX));
    ASSERT_NE(eventOf<PowerEnded>(game), nullptr);
    EXPECT_EQ(eventOf<PowerEnded>(game)->power, GetParam());
    EXPECT_EQ(game.state().secondsLeft(GetParam()), 0);
    EXPECT_TRUE(game.effects().empty());
}

INSTANTIATE_TEST_SUITE_P(All, LastingPower,
                         testing::Values(Power::Heavy, Power::Lopsided, Power::Egg, Power::Rough,
                                         Power::Magnet, Power::Spring, Power::Well, Power::Wind),
                         [](const auto& power) { return nameOf(power.param); });

TEST(HeavyBall, HitsWithAnImpulseProportionalToItsMass) {
    Game game = given(Power::Heavy, "g..............\n" + emptyRows(4) + ".......s.......\n");
    const kodo::BodyId ball = game.balls()[0].body;
    const Real mass = massOf(kodo::Circle{kBallRadius}, kBallDensity).mass;
    EXPECT_TRUE(near(game.world()[ball].mass(), kHeavyFactor * mass, 1e-4));
    GameTestAccess::shoot(game, {0, Real(12.5)}, {0, 12});
    const auto broke = playUntil<Broke>(game, {}, 30); // 72 N s against a strength of 30
    ASSERT_TRUE(broke);
    EXPECT_TRUE(near(broke->impulse, 2 * kHeavyFactor * mass * 12, 1));
}

TEST(BallPowers, ChangeEveryBallAndRestoreItAfterwards) {
    Game game = given(Power::Egg);
    EXPECT_EQ(game.state().ballKind(), BallKind::Egg);
    EXPECT_EQ(game.balls()[0].kind, BallKind::Egg);
    GameTestAccess::give(game, Power::Heavy); // only one kind at a time
    EXPECT_EQ(game.state().ballKind(), BallKind::Heavy);
    EXPECT_EQ(game.effects().size(), 1u);
    const auto changed = playUntil<BallChanged>(game, {}, static_cast<int>(kEffectTicks));
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->kind, BallKind::Round);
    EXPECT_EQ(game.balls()[0].body, changed->now);
    EXPECT_FALSE(game.world().contains(changed->before));
    EXPECT_TRUE(game.serving()); // still rides
}

// A7: unruly balls.
TEST(LopsidedBall, HasAnOffCentreMassAndSpinsAfterAnImpact) {
    Game game = given(Power::Lopsided);
    const kodo::BodyView ball = firstBall(game);
    EXPECT_GT(length(ball.center() - ball.position()), kBallRadius / 5);
    EXPECT_TRUE(near(ball.mass(), massOf(kodo::Circle{kBallRadius}, kBallDensity).mass, 1e-4));
    GameTestAccess::shoot(game, {-6, 16}, {0, 12});
    ASSERT_TRUE(playUntil<Struck>(game, {}, 60)); // the top wall, without friction; the core does
                                                  // not matter
    EXPECT_GT(std::abs(firstBall(game).angularVelocity()), Real(0.5));
}

TEST(EggBall, IsNotMirroredAtAWall) {
    Game game = given(Power::Egg);
    const kodo::BodyId ball = GameTestAccess::shoot(game, {-6, 16}, {0, 12});
    GameTestAccess::world(game)[ball].setRotation(kodo::Rot::fromAngle(Real(0.6)));
    ASSERT_TRUE(playUntil<Struck>(game, {}, 60));
    EXPECT_GT(std::abs(game.world()[ball].angularVelocity()), 1);
    EXPECT_LT(game.balls()[0].heading.y, 0);
}

TEST(RoughBall, TakesSpinFromAMovingPaddle) {
    for (const Power power : {Power::Rough, Power::Heavy}) { // heavy balls have the usual friction
        Game game = given(power);
        for (int tick = 0; tick < 30; ++tick) {
            game.tick(towards(-6));
        }
        Input right;
        right.paddle = 127;
        for (int tick = 0; tick < 12; ++tick) {
            game.tick(right);
        }
        const Real x = game.world()[game.paddle()].position().x;
        GameTestAccess::shoot(game, {x + 2, 3}, {0, -12});
        ASSERT_TRUE(playUntil<Struck>(game, right, 30));
        const Real spin = std::abs(firstBall(game).angularVelocity());
        EXPECT_EQ(spin > 3, power == Power::Rough) << spin;
    }
}

TEST(Magnet, PullsABallThatWouldMissThePaddle) {
    for (const bool magnet : {true, false}) {
        Game game(levelOf("g..............\n"), 1);
        if (magnet) {
            GameTestAccess::give(game, Power::Magnet);
        }
        GameTestAccess::shoot(game, {3, 5}, {0, -12}); // the rim ends at 2
        const auto struck = playUntil<Struck>(game, {}, 60);
        EXPECT_EQ(struck.has_value(), magnet);
        if (magnet) {
            EXPECT_LT(game.ledger().fieldImpulseX, 0); // booked; the paddle received the opposite
                                                       // impulse
        }
    }
}

TEST(SpringPaddle, JumpsOnTheButtonAndAcceleratesTheBall) {
    std::array<Real, 2> speeds{};
    for (const bool leaps : {false, true}) {
        Game game = given(Power::Spring);
        EXPECT_EQ(game.state().paddleKind(), PaddleKind::Recoiling);
        GameTestAccess::shoot(game, {0, Real(3.2)}, {0, -12});
        Input input;
        Real highest = 0;
        for (int tick = 0; tick < 20; ++tick) {
            input.launch = leaps && tick == 6;
            game.tick(input);
            EXPECT_EQ(eventOf<Leapt>(game) != nullptr, input.launch);
            highest = std::max(highest, game.sway().lift);
            Real& fastest = speeds[leaps ? 1 : 0];
            fastest = std::max(fastest, length(firstBall(game).velocity()));
        }
        EXPECT_EQ(highest > Real(0.3), leaps);
    }
    EXPECT_GT(speeds[1], speeds[0] + 6);
}

// The spring adds recoil and takes no degree of freedom away.
TEST(SpringPaddle, LeavesATiltingPaddleItsTilt) {
    struct Motion {
        Real tilt = 0;
        Real lift = 0;
    };
    const auto struck = [](const std::string& paddle, bool spring) {
        Game game(levelOf("g..............\n", 12000, "paddle = \"" + paddle + "\"\n"), 1);
        if (spring) {
            GameTestAccess::give(game, Power::Spring);
        }
        GameTestAccess::shoot(game, {Real(1.5), 3}, {0, -12});
        EXPECT_TRUE(playUntil<Struck>(game, {}, 30));
        for (int tick = 0; tick < 10; ++tick) {
            game.tick({});
        }
        return Motion{game.sway().tilt, game.sway().lift};
    };
    for (const bool loose : {false, true}) {
        const Motion plain = struck(loose ? "loose" : "tilting", false);
        const Motion sprung = struck(loose ? "loose" : "tilting", true);
        EXPECT_LT(plain.tilt, Real(-0.05));
        // The same impulse drives both springs, which are independent of each other.
        EXPECT_TRUE(near(sprung.tilt, plain.tilt, 1e-6));
        EXPECT_TRUE(near(sprung.lift, struck("recoiling", false).lift, 1e-6));
    }
    EXPECT_EQ(struck("steady", true).tilt, 0);
}

TEST(Wings, WidenThePaddleAsPartsOfItsBody) {
    Game game = dropped(Power::Wings);
    const Real width =
        game.world()[game.paddle()].bounds().upper.x - game.world()[game.paddle()].bounds().lower.x;
    const Real mass = game.world()[game.paddle()].mass();
    ASSERT_TRUE(playUntil<Welded>(game, towards(kCatchX), 240));
    const kodo::BodyView paddle = game.world()[game.paddle()];
    EXPECT_EQ(game.welds().size(), 2u);
    EXPECT_TRUE(near(paddle.bounds().upper.x - paddle.bounds().lower.x, width + 2, 0.01));
    EXPECT_GT(paddle.mass(), mass + Real(0.5));
    EXPECT_EQ(game.parts().size(), 0u);
}

TEST(Wings, AreKnockedOffByOneHardImpactAndFall) {
    Game game(levelOf("g..............\n"), 1);
    GameTestAccess::weldWings(game);
    game.tick({});
    const Real heavy = game.world()[game.paddle()].mass();
    GameTestAccess::give(game, Power::Heavy); // 72 N s against a strength of 48
    GameTestAccess::shoot(game, {Real(2.8), 3}, {0, -12});
    const auto off = playUntil<KnockedOff>(game, {}, 60);
    ASSERT_TRUE(off);
    EXPECT_GT(off->impulse, kKnockOffImpact);
    EXPECT_EQ(game.welds().size(), 1u);
    const Real lost = game.world()[off->shard].mass();
    EXPECT_TRUE(near(game.world()[game.paddle()].mass() + lost, heavy, 1e-4));
    const Real height = game.world()[off->shard].center().y;
    for (int tick = 0; tick < 60; ++tick) {
        game.tick({});
    }
    EXPECT_LT(game.world()[off->shard].center().y, height); // a falling body
}

TEST(Well, CurvesThePathOfABallUntilItEnds) {
    Game game = given(Power::Well); // at (0, 9)
    GameTestAccess::shoot(game, {-4, 5}, {0, 12});
    for (int tick = 0; tick < 60; ++tick) {
        game.tick({});
    }
    EXPECT_GT(game.balls()[0].heading.x, Real(0.2)); // towards the well
    while (game.state().secondsLeft(Power::Well) > 0) {
        game.tick({});
    }
    const Vec2 heading{Real(0.6), Real(0.8)};
    GameTestAccess::shoot(game, {-4, 5}, Real(12) * heading);
    for (int tick = 0; tick < 40; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(game.balls()[0].heading, heading, 1e-5)); // straight again
}

TEST(Wind, AcceleratesShardsMoreThanBalls) {
    Game game = given(Power::Wind, "g..............\n" + emptyRows(4) + ".......b.......\n");
    const Real side = game.state().windSpeed() > 0 ? Real(1) : Real(-1);
    EXPECT_TRUE(near(std::abs(game.state().windSpeed()), kWindSpeed, 1e-4));
    const kodo::BodyId ball = GameTestAccess::shoot(game, {0, 4}, {0, 12});
    GameTestAccess::breakBlock(game, 1, {0, 0});
    Real before = 0;
    for (const Shard& shard : game.shards()) {
        before += game.world()[shard.body].velocity().x;
    }
    for (int tick = 0; tick < 40; ++tick) {
        game.tick({});
    }
    Real after = 0;
    for (const Shard& shard : game.shards()) {
        after += game.world()[shard.body].velocity().x;
    }
    const Real gained = side * (after - before) / static_cast<Real>(game.shards().size());
    const Real ofBall = side * game.world()[ball].velocity().x;
    EXPECT_GT(gained, 3);
    EXPECT_GT(ofBall, Real(0.5));
    EXPECT_GT(gained, ofBall);
}

TEST(Powers, EndWhenALifeIsLost) {
    Game game = given(Power::Wind);
    GameTestAccess::give(game, Power::Egg);
    GameTestAccess::shoot(game, {8, 1}, {0, -12});
    ASSERT_TRUE(playUntil<LifeLost>(game, {}, 60));
    EXPECT_TRUE(game.effects().empty());
    EXPECT_EQ(game.state().windSpeed(), 0);
    EXPECT_EQ(game.balls()[0].kind, BallKind::Round);
}

} // namespace
