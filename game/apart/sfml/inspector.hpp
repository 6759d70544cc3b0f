// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/stage.hpp>

namespace apart {

/// Debug overlay: the world as the engine sees it, and frame times.
class Inspector {
public:
    void toggle() { on_ = !on_; }
    /// Must be called once a frame with the durations (s) of the last frame and of its game ticks.
    void measure(double frameSeconds, double gameSeconds);
    /// Draws on the last picture, which shows this game.
    void draw(SfmlCanvas& canvas, const ShownGame& shown) const;

private:
    bool on_ = false;
    double frame_ = 0.016; // s, smoothed
    double game_ = 0;      // s, smoothed
};

} // namespace apart
