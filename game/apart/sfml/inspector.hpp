// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/sfml/sfml_canvas.hpp>

namespace apart {

/// Shows over the game how the engine sees it, and what a frame costs.
class Inspector {
public:
    void toggle() { on_ = !on_; }
    /// Once a frame: how long the last one took, and the part of it that played the game (s).
    void measure(double frameSeconds, double gameSeconds);
    void draw(SfmlCanvas& canvas, const Game& game) const;

private:
    bool on_ = false;
    double frame_ = 0.016; // s, smoothed
    double game_ = 0;      // s, smoothed
};

} // namespace apart
