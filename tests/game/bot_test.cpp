// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/soak.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;

constexpr std::uint32_t kFiveMinutes = 5 * 60 * kTicksPerSecond;

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
            EXPECT_EQ(watch.escapes, 0u);
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

// A8: a slice of `apart-headless soak`, which plays ten million ticks.
TEST(Soak, FindsNoHaltNoEscapeNoBendAndNoEndlessWait) {
    std::vector<std::shared_ptr<const Level>> levels;
    for (const std::string& name : levelNames()) {
        levels.push_back(std::make_shared<const Level>(std::get<Level>(loadLevel(name))));
    }
    const SoakReport report = soak(levels, 300000, 11);
    for (const std::string& failure : report.failures) {
        ADD_FAILURE() << failure;
    }
    EXPECT_GE(report.games, 10u);
    EXPECT_GT(report.bounces, 1000u);
}

TEST(Watch, SeesWhatItLooksFor) {
    const Game fresh(levelOf("g..............\n"), 1);
    const auto watched = [&](kodo::Vec2 from, kodo::Vec2 velocity, auto disturb) {
        Game game = fresh;
        Watch watch;
        GameTestAccess::shoot(game, from, velocity);
        for (int tick = 0; tick < 30; ++tick) {
            disturb(GameTestAccess::world(game)[game.balls()[0].body]);
            game.tick({});
            watch.look(game);
        }
        return watch;
    };
    const auto none = [](kodo::BodyRef) {};
    const Watch good = watched({0, 9}, {0, 12}, none);
    EXPECT_EQ(good.escapes, 0u);
    EXPECT_EQ(good.longestSlow, 0u);
    EXPECT_LT(good.worstBend, kMostBend);
    EXPECT_EQ(good.longestWait, 30u);
    EXPECT_GT(watched({Real(12.5), 9}, {0, 12}, none).escapes, 0u);
    const Watch halted = watched({0, 9}, {0, 12}, [](kodo::BodyRef ball) {
        ball.setVelocity({0, 1});
    });
    EXPECT_GT(halted.longestSlow, 20u);
    const Watch bent = watched({0, 9}, {0, 12}, [](kodo::BodyRef ball) {
        ball.applyForce({Real(0.1), 0});
    });
    EXPECT_GT(bent.worstBend, kMostBend); // 1 % of the gravity of shards
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
