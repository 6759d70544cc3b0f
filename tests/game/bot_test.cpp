// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/paddle.hpp>

#include <algorithm>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;

constexpr std::uint32_t kFiveMinutes = 5 * 60 * kTicksPerSecond;

TEST(Bot, DependsOnTheGameStateAlone) {
    Game game(std::get<Level>(loadLevel("first_light")), 1);
    for (int tick = 0; tick < 500; ++tick) {
        const Game copy = game;
        ASSERT_EQ(bot(game), bot(copy));
        game.tick(bot(game));
    }
}

/// True if the skilled bot catches the part of a block with this power. The part falls at x = 6.4
/// while the ball is far away.
bool isCaught(const std::string& power) {
    const Level level = levelWith("b.............b\n" + emptyRows(11) + "...........P...\n", "P",
                                  "stuff = \"brick\"\npower = \"" + power + "\"");
    Game game(level, 1, Mode::Pure); // otherwise an idle ball would come back sooner
    GameTestAccess::shoot(game, {-8, 6}, {Real(0.5), game.state().ballSpeed()});
    const auto blocks = game.blocks();
    const auto part = std::find_if(blocks.begin(), blocks.end(), [](const Block& block) {
        return block.kind.power != Power::None;
    });
    GameTestAccess::breakBlock(game, static_cast<std::size_t>(part - blocks.begin()), {0, 13});
    for (int tick = 0; tick < 3 * kTicksPerSecond; ++tick) {
        game.tick(bot(game));
        if (eventOf<Caught>(game) != nullptr) {
            return true;
        }
    }
    return false;
}

TEST(Bot, CatchesGoodPowersAndAvoidsHarmfulOnes) {
    for (const char* power : {"heavy", "wings", "magnet", "spring", "weld", "launch"}) {
        EXPECT_TRUE(isCaught(power)) << power;
    }
    for (const char* power : {"lopsided", "egg", "wind"}) {
        EXPECT_FALSE(isCaught(power)) << power;
    }
}

// The ball bounces between paddle and steel without damage. After six seconds the bot uses the
// paddle's field.
TEST(Bot, PullsWithTheFieldAfterALongTimeWithoutDamage) {
    Game game(levelOf("b.............b\n" + emptyRows(3) + "....XXXXXXX....\n"), 1);
    GameTestAccess::shoot(game, {0, 6}, {0, game.state().ballSpeed()});
    bool drew = false;
    for (std::uint32_t tick = 0; tick < kShakeTicks; ++tick) {
        const Input input = bot(game);
        drew = drew || input.force == Force::Pull;
        EXPECT_TRUE(input.force == Force::None || game.state().patience() != Patience::Calm);
        GameTestAccess::shoot(game, {0, kFieldHeight - 6}, {0, game.state().ballSpeed()});
        game.tick(input);
    }
    EXPECT_TRUE(drew);
}

// A well bends the path of the ball; the bot still predicts its arrival.
TEST(Bot, PredictsTheArrivalOfABallOnACurvedPath) {
    const Level level = levelOf("b.............b\n", 12000, "",
                                "[[well]]\nx = 6000\ny = 9000\nstrength = 200000\n");
    Game game(level, 1);
    const kodo::BodyId ball = GameTestAccess::shoot(game, {0, 12}, {0, -12});
    const std::optional<Arrival> arrival = arrivalOf(game, game.balls()[0]);
    ASSERT_TRUE(arrival);
    EXPECT_GT(arrival->x, 1) << "it does not see the well";
    while (game.world()[ball].position().y > kPaddleY + domeHeight(0) + kBallRadius) {
        game.tick(towards(-10));
    }
    // The prediction uses steps twice as long as the game's, over one second.
    EXPECT_NEAR(game.world()[ball].position().x, arrival->x, 0.3);
}

TEST(Game, IsLostWithoutPaddleInput) {
    Game game(std::get<Level>(loadLevel("quarry")), 1);
    Input launch = towards(-10);
    launch.launch = true;
    while (game.result() == Result::Playing && game.ticks() < kFiveMinutes) {
        game.tick(launch);
    }
    EXPECT_EQ(game.result(), Result::Lost);
}

} // namespace
