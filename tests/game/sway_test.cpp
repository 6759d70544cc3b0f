// SPDX-License-Identifier: MIT
// Paddles that tilt and sag.
#include <apart/core/bot.hpp>
#include <support/near.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

Game withPaddle(const std::string& paddle) {
    return Game(levelOf("g..............\n", 12000, "paddle = \"" + paddle + "\"\n"), 1);
}

/// The maximum sway after a ball falls onto the paddle at an offset from its centre.
Sway struckAt(Game& game, Real offset) {
    GameTestAccess::shoot(game, {offset, 3}, {0, -12});
    EXPECT_TRUE(playUntil<Struck>(game, {}, 30));
    Sway most;
    for (int tick = 0; tick < 20; ++tick) {
        game.tick({});
        most.tilt = std::abs(game.sway().tilt) > std::abs(most.tilt) ? game.sway().tilt : most.tilt;
        most.lift = std::min(most.lift, game.sway().lift);
    }
    return most;
}

TEST(SteadyPaddle, NeitherTiltsNorRecoils) {
    Game game = withPaddle("steady");
    const Sway most = struckAt(game, Real(1.5));
    EXPECT_EQ(most.tilt, 0);
    EXPECT_EQ(most.lift, 0);
}

TEST(TiltingPaddle, TiltsToTheSideOfTheImpactAndReturns) {
    for (const Real offset : {Real(-1.5), Real(1.5)}) {
        Game game = withPaddle("tilting");
        const Sway most = struckAt(game, offset);
        EXPECT_LT(most.tilt * offset, Real(-0.05)); // clockwise after an impact on the right
        EXPECT_LE(std::abs(most.tilt), kMostTilt);
        EXPECT_EQ(most.lift, 0);
        for (int tick = 0; tick < 120; ++tick) {
            game.tick({});
        }
        EXPECT_TRUE(near(game.sway().tilt, 0, 0.001));
        EXPECT_TRUE(near(game.world()[game.paddle()].rotation().s, 0, 0.001));
    }
}

TEST(TiltingPaddle, CollidesInItsTiltedPose) {
    Game game = withPaddle("tilting");
    struckAt(game, Real(1.5));
    const kodo::BodyView paddle = game.world()[game.paddle()];
    // The body lags its spring by one tick, in which it is moved there.
    EXPECT_TRUE(near(paddle.rotation().angle(), game.sway().tilt, 1e-3));
}

TEST(RecoilingPaddle, RecoilsByItsMassAndReturns) {
    Game light = withPaddle("recoiling");
    Game heavy = withPaddle("recoiling");
    GameTestAccess::weldWings(heavy);
    heavy.tick({});
    const Real lightSag = struckAt(light, 0).lift;
    const Real heavySag = struckAt(heavy, 0).lift;
    EXPECT_LT(lightSag, Real(-0.05));
    EXPECT_GT(heavySag, lightSag); // sags less
    EXPECT_EQ(light.sway().tilt, 0);
    for (int tick = 0; tick < 120; ++tick) {
        light.tick({});
    }
    EXPECT_TRUE(near(light.world()[light.paddle()].position().y, kPaddleY, 0.001));
}

TEST(LoosePaddle, TiltsAndRecoils) {
    Game game = withPaddle("loose");
    const Sway most = struckAt(game, 1);
    EXPECT_LT(most.tilt, Real(-0.03));
    EXPECT_LT(most.lift, Real(-0.05));
}

TEST(LoosePaddle, TakesTheImpulseAndTheAngularImpulse) {
    const kodo::Mass paddle{8, {}, 5};
    const Vec2 arm{Real(1.5), Real(0.25)};
    const Vec2 impulse{4, -16};
    const Sway before{.tiltSpeed = Real(0.5), .liftSpeed = -1};
    const Sway after = pushed(before, PaddleKind::Loose, paddle, arm, impulse);
    // I w' = I w + r x J and m v' = m v + J, of a few roundings each.
    EXPECT_TRUE(near(5 * after.tiltSpeed, 5 * before.tiltSpeed + cross(arm, impulse), 1e-5));
    EXPECT_TRUE(near(8 * after.liftSpeed, 8 * before.liftSpeed + impulse.y, 1e-5));
}

// The sway is integrated before the step, so after an impact its speed is that of the impulse.
TEST(TiltingPaddle, TakesTheAngularImpulseOfABall) {
    for (const Real offset : {Real(-1.5), Real(0.5), Real(1.5)}) {
        Game game = withPaddle("tilting");
        GameTestAccess::shoot(game, {offset, 3}, {0, -12});
        const auto struck = playUntil<Struck>(game, {}, 30);
        ASSERT_TRUE(struck);
        const kodo::BodyView paddle = game.world()[game.paddle()];
        const Vec2 impulse = -struck->impulse * struck->normal; // on the paddle
        const Real turn = cross(struck->point - paddle.center(), impulse);
        EXPECT_GT(std::abs(turn), 5);
        // Of 10 to 40 N m s, by floats.
        EXPECT_TRUE(near(paddle.inertia() * game.sway().tiltSpeed, turn, 1e-3));
    }
}

TEST(LoosePaddle, LetsNoBallTunnel) {
    // For two minutes the ball leaves the field only at the bottom.
    Game game(levelOf("ggggggggggggggg\nbbbWbbbSbbbLbbb\nsssssssssssssss\n", 16000,
                      "paddle = \"loose\"\n"),
              5);
    for (int tick = 0; tick < 14400 && game.result() == Result::Playing; ++tick) {
        const Vec2 paddle = game.world()[game.paddle()].position();
        std::vector<std::pair<kodo::BodyId, Vec2>> above;
        for (const Ball& ball : game.balls()) {
            const Vec2 place = game.world()[ball.body].position() - paddle;
            if (std::abs(place.x) < kPaddleFoot / 2 && place.y > 0) {
                above.emplace_back(ball.body, place);
            }
        }
        game.tick(bot(game));
        for (const auto& [ball, before] : above) {
            if (game.world().contains(ball)) {
                const Vec2 now =
                    game.world()[ball].position() - game.world()[game.paddle()].position();
                ASSERT_FALSE(std::abs(now.x) < kPaddleFoot / 2 && now.y < -kPaddleDepth)
                    << "through the paddle at tick " << game.ticks();
            }
        }
    }
}

} // namespace
