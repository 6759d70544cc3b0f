// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/controls.hpp>

#include <memory>
#include <optional>
#include <span>

namespace apart {

/// The first screen: the name of the game and a tile for each level.
class Title {
public:
    explicit Title(std::size_t levels) : levels_(levels) {}

    /// The level to play, once the player has chosen.
    std::optional<std::size_t> take(const Signals& signals);
    void choose(std::size_t level) { chosen_ = level; }
    std::size_t chosen() const { return chosen_; }

    void draw(Canvas& canvas, const Level& chosen, double seconds) const;
    /// Where the tile of a level can be clicked.
    Aabb tile(std::size_t level) const;

private:
    void move(int step);
    void drawName(Canvas& canvas, double seconds) const;
    void drawTiles(Canvas& canvas) const;

    std::size_t levels_ = 0;
    std::size_t chosen_ = 0;
};

} // namespace apart
