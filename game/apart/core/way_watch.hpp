// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <cstdint>

namespace apart {

inline constexpr std::uint32_t kAllWays = (1u << kMostWays) - 1;

/// True if a set of ways, a bit for each, holds the way of an index into Level::ways.
constexpr bool isWayIn(std::uint32_t ways, std::size_t index) {
    return (ways >> index & 1u) != 0;
}

/// Watches how the largest fall of a game began. Several balls count as one.
class WayWatch {
public:
    /// Call after each tick of the game.
    void update(const Game& game);
    /// The ways of Level::ways that agree with it, a bit for each index. 0 before a fall.
    std::uint32_t ways(const Level& level) const;

private:
    struct Blow {
        char struck = 0;   // letter of the block that was struck last; 0: none
        bool bank = false; // a wall or an obstruction was touched before the first block
        bool torn = false; // no blow: a mount was torn, or failed, or the ball was hollow
    };
    void follow(const Struck& struck);

    bool hasStruck_ = false; // a block, since the paddle
    bool touched_ = false;   // a wall or an obstruction, since the paddle
    Blow now_{};
    Blow start_{};   // of the current fall
    Blow largest_{}; // of the largest fall
    int blocks_ = 0; // of the current fall
    int most_ = 0;   // of the largest fall
};

} // namespace apart
