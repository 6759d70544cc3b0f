// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/tuning.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace apart {

/// Sets up states that normal play takes long to reach.
struct GameTestAccess {
    static kodo::World& world(Game& game) { return game.state_.world; }
    static std::vector<Weld>& welds(Game& game) { return game.state_.paddle.welds; }
    static void setMeter(Game& game, kodo::Real meter) { game.state_.paddle.field.meter = meter; }
    static void countHit(Game& game) { ++game.state_.counts.hits; }             // as by a serve
    static void beginBlow(Game& game) { game.state_.counts.hit(game.ticks()); } // by a filled ball
    static void idle(Game& game) { apart::watchProgress(game.state_); } // one tick without damage
    static void progress(Game& game) { game.state_.clock.progress(); } // as after damage to a block
    static void letGo(Game& game, std::size_t index) {
        apart::letGo(game.state_, index, LetGo::Why::Fatigue);
    }
    /// Begins a power as if its part had been caught.
    static void give(Game& game, Power power, kodo::Vec2 origin = {0, 9}) {
        apart::beginPower(game.state_, power, {}, origin);
        apart::refreshPowers(game.state_);
    }
    static void breakShard(Game& game, std::size_t index, kodo::Vec2 point) {
        apart::breakShard(game.state_, index, point, 0);
    }
    static void weldWings(Game& game) { apart::weldWings(game.state_); }

    /// Removes all balls but the first, which flies with this state.
    static kodo::BodyId shoot(Game& game, kodo::Vec2 from, kodo::Vec2 velocity) {
        while (game.state_.balls.size() > 1) {
            game.state_.world.remove(game.state_.balls.back().body);
            game.state_.balls.pop_back();
        }
        Ball& ball = game.state_.balls.front();
        ball.riding = false;
        ball.hollow = false;
        ball.heading = normalize(velocity);
        kodo::BodyRef body = game.state_.world[ball.body];
        body.setType(kodo::BodyType::Dynamic);
        body.setPosition(from);
        body.setVelocity(velocity);
        return ball.body;
    }
    static void breakBlock(Game& game, std::size_t index, kodo::Vec2 point, kodo::Vec2 impact) {
        apart::breakBlock(game.state_, index, point, impact);
    }
    /// Breaks a block by an impact from below, without events.
    static void breakBlock(Game& game, std::size_t index, kodo::Vec2 impact) {
        const kodo::Vec2 center = game.state_.world[game.state_.blocks[index].body].position();
        breakBlock(game, index, center - kodo::Vec2{kCellWidth / 8, kCellHeight / 2}, impact);
    }
};

/// Parses a level. Throws if it is invalid.
inline Level levelFrom(const std::string& text) {
    const Read<Level> level = parseLevel(text, "test", "test.toml");
    if (const auto* problem = std::get_if<FileProblem>(&level)) {
        throw std::runtime_error(problem->text());
    }
    return std::get<Level>(level);
}

/// A level from its grid, with one letter per kind. g w b s X: glass, wood, brick, stone, steel. W
/// L S: brick that welds, launches, splits. `head` and `tail` are additional TOML lines.
inline Level levelOf(const std::string& grid, int ballSpeed = 12000, const std::string& head = "",
                     const std::string& tail = "") {
    std::string text =
        "format = 1\ntitle = \"t\"\nidea = \"i\"\nball-speed = " + std::to_string(ballSpeed) +
        "\n" + head + "grid = '''\n" + grid + "'''\n";
    const std::vector<std::pair<std::string, std::string>> legend = {
        {"g", "stuff = \"glass\""},
        {"w", "stuff = \"wood\""},
        {"b", "stuff = \"brick\""},
        {"s", "stuff = \"stone\""},
        {"X", "stuff = \"steel\""},
        {"W", "stuff = \"brick\"\npower = \"weld\""},
        {"L", "stuff = \"brick\"\npower = \"launch\""},
        {"S", "stuff = \"brick\"\npower = \"split\""}};
    for (const auto& [letter, lines] : legend) {
        text += "[legend." + letter + "]\n" + lines + "\n";
    }
    return levelFrom(text + tail);
}

/// A level with one additional letter in the legend; `lines` is the content of its table.
inline Level levelWith(const std::string& grid, const std::string& letter,
                       const std::string& lines) {
    return levelOf(grid, 12000, "", "[legend." + letter + "]\n" + lines + "\n");
}

/// `count` empty rows of a grid.
inline std::string emptyRows(int count) {
    std::string rows;
    for (int i = 0; i < count; ++i) {
        rows += "...............\n";
    }
    return rows;
}

/// The first event of this type in the last tick, or nullptr.
template <typename T>
const T* eventOf(const Game& game) {
    for (const Event& event : game.events()) {
        if (const T* found = std::get_if<T>(&event)) {
            return found;
        }
    }
    return nullptr;
}

/// Plays until an event of this type occurs and returns it. Empty after `mostTicks` ticks.
template <typename T>
std::optional<T> playUntil(Game& game, const Input& input, int mostTicks) {
    for (int i = 0; i < mostTicks; ++i) {
        game.tick(input);
        if (const T* found = eventOf<T>(game)) {
            return *found;
        }
    }
    return std::nullopt;
}

/// Position (m) of a paddle that catches a part falling at x = 0 beside the ball riding on it.
inline constexpr kodo::Real kCatchX = kodo::Real(-1.2);

inline Input towards(kodo::Real x) {
    Input input;
    input.target = static_cast<std::int16_t>(x * 1000);
    return input;
}

/// Plays ticks without input.
inline void playOn(Game& game, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        game.tick({});
    }
}

/// A game with a broken power block in the middle of the lowest row, glass and brick above it, and
/// the paddle below.
inline Game dropped(const std::string& block) {
    const std::string row = std::string(7, '.') + block + std::string(7, '.') + "\n";
    Game game(levelOf("ggggggggggggggg\nbbbbbbbbbbbbbbb\n" + emptyRows(12) + row), 1);
    for (int tick = 0; tick < 60; ++tick) {
        game.tick(towards(kCatchX));
    }
    GameTestAccess::breakBlock(game, game.blocks().size() - 1, {0, 0});
    return game;
}

} // namespace apart
