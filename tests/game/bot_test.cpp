// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;

constexpr std::uint32_t kFiveMinutes = 5 * 60 * kTicksPerSecond;

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
