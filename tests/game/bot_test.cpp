// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;

constexpr std::uint32_t kFiveMinutes = 5 * 60 * kTicksPerSecond;

/// What a ball may never do, looked for after each tick.
struct Watch {
    std::uint32_t slowTicks = 0; // in a row
    std::uint32_t longestSlow = 0;

    void look(const Game& game) {
        Real slowest = game.ballSpeed();
        for (const Ball& ball : game.balls()) {
            if (!ball.riding) {
                slowest = std::min(slowest, length(game.world()[ball.body].velocity()));
            }
        }
        slowTicks = slowest < game.ballSpeed() / 2 ? slowTicks + 1 : 0;
        longestSlow = std::max(longestSlow, slowTicks);
        if (const BallLost* lost = eventOf<BallLost>(game)) {
            EXPECT_LT(lost->point.y, 0) << "it left the field other than below";
            EXPECT_LT(std::abs(lost->point.x), kFieldWidth / 2);
        }
    }
};

TEST(Bot, ClearsEveryLevelInFiveMinutesAndNoBallHaltsOrEscapes) {
    std::uint32_t ticks = 0;
    for (const std::string& name : levelNames()) {
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            SCOPED_TRACE(name + ", seed " + std::to_string(seed));
            Game game(std::get<Level>(loadLevel(name)), seed);
            Watch watch;
            while (game.result() == Result::Playing && game.ticks() < kFiveMinutes) {
                game.tick(bot(game));
                watch.look(game);
            }
            EXPECT_EQ(game.result(), Result::Won) << game.blocksLeft() << " blocks left";
            EXPECT_LT(watch.longestSlow, 60u); // half a second between rubble and paddle
            ticks += game.ticks();
        }
    }
    EXPECT_GE(ticks, 100000u);
}

TEST(Bot, IsAFunctionOfTheGame) {
    Game game(std::get<Level>(loadLevel("first_light")), 1);
    for (int tick = 0; tick < 500; ++tick) {
        const Game copy = game;
        ASSERT_EQ(bot(game), bot(copy));
        game.tick(bot(game));
    }
}

TEST(Game, IsLostByAPlayerWhoIsAbsent) {
    Game game(std::get<Level>(loadLevel("first_light")), 1);
    Input launch = towards(-10);
    launch.launch = true;
    while (game.result() == Result::Playing && game.ticks() < kFiveMinutes) {
        game.tick(launch);
    }
    EXPECT_EQ(game.result(), Result::Lost);
}

} // namespace
