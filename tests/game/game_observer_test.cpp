// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/game_observer.hpp>
#include <support/draws.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

/// A game whose ball flies through the middle of an empty field.
struct Flight {
    Flight() : game(levelOf(emptyRows(1) + "b.............b\n"), 1) {
        ball = GameTestAccess::shoot(game, {0, 8}, {3, game.state().ballSpeed()});
        tick();
    }
    void tick() {
        game.tick(towards(0));
        observer.observe(game);
    }
    kodo::BodyRef body() { return GameTestAccess::world(game)[ball]; }

    Game game;
    GameObserver observer;
    kodo::BodyId ball;
};

TEST(GameObserver, ReportsNoFaultInFreeFlight) {
    Flight flight;
    for (int i = 0; i < 60; ++i) {
        flight.tick();
    }
    EXPECT_EQ(flight.observer.observations().faults(), 0u);
    EXPECT_EQ(flight.observer.observations().freeTicks, 60u);
    EXPECT_EQ(flight.observer.observations().longestWait, 61u);
}

// 0.012 m/s^2 across the path: a thousandth of the acceleration of shards.
TEST(GameObserver, ReportsASlightlyCurvedPath) {
    Flight flight;
    for (int i = 0; i < 60; ++i) {
        flight.body().setVelocity(flight.body().velocity() + Vec2{0.0001f, 0});
        flight.tick();
    }
    EXPECT_EQ(flight.observer.observations().bends, 60u);
}

TEST(GameObserver, ReportsACrawlingBallOnce) {
    Flight flight;
    for (int i = 0; i < 130; ++i) {
        const Vec2 velocity = flight.body().velocity();
        flight.body().setVelocity((Real(0.1) / length(velocity)) * velocity);
        flight.tick();
    }
    EXPECT_EQ(flight.observer.observations().halts, 1u) << "one halt, however long";
    EXPECT_EQ(flight.observer.observations().bends, 0u);
}

TEST(GameObserver, ReportsABallOutsideTheField) {
    Flight flight;
    flight.game.tick(towards(0));
    flight.body().setPosition({0, kFieldHeight + Real(0.5)}); // the governor would move it back
    flight.observer.observe(flight.game);
    EXPECT_GE(flight.observer.observations().escapes, 1u);
}

// A8: the ball never halts.
// A short run of `apart-headless soak --ticks 10000000` over all levels and some generated ones. No
// ball stops, escapes, or bends its path without a contact.
TEST(Soak, NoBallStopsEscapesOrLeavesItsStraightPath) {
    std::vector<Level> levels;
    for (const std::string& name : levelNames()) {
        levels.push_back(std::get<Level>(loadLevel(name)));
    }
    for (std::uint32_t number = 1; number <= 6; ++number) {
        levels.push_back(endlessLevel({11, number}));
    }
    const std::uint32_t ticks = (support::kSanitized ? 4 : 30) * kTicksPerSecond;
    std::uint64_t freeTicks = 0;
    for (const Level& level : levels) {
        SCOPED_TRACE(level.name);
        Game game(level, 11);
        GameObserver observer;
        while (game.result() == Result::Playing && game.ticks() < ticks) {
            game.tick(bot(game));
            observer.observe(game);
        }
        EXPECT_EQ(observer.observations().halts, 0u);
        EXPECT_EQ(observer.observations().escapes, 0u);
        EXPECT_EQ(observer.observations().bends, 0u);
        freeTicks += observer.observations().freeTicks;
    }
    EXPECT_GE(freeTicks, ticks * levels.size() * 5 / 18) << "the balls were hardly in the air";
}

} // namespace
