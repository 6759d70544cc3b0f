// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/painter.hpp>

#include <optional>
#include <span>
#include <vector>

#include "knobs.hpp"

namespace destructoooor {

/// The column of sliders on the right of the window. Pixels, y down.
class Panel {
public:
    static constexpr float kWidth = 330;

    Panel();

    /// True if the position is on the panel; the scene must then ignore the press.
    bool press(kodo_sfml::Pixel pixel, Sandbox& sandbox);
    void drag(kodo_sfml::Pixel pixel, Sandbox& sandbox);
    void release() { held_.reset(); }
    /// Selects the next (1) or previous (-1) knob.
    void choose(int way);
    /// Changes the selected knob by one stride up (1) or down (-1).
    void turn(int way, Sandbox& sandbox);

    void setSize(kodo_sfml::Size pixels) { pixels_ = pixels; }
    void draw(kodo_sfml::Painter& painter, const sf::Font& font, const Sandbox& sandbox,
              std::span<const std::string> lines) const;

private:
    float left() const { return static_cast<float>(pixels_.x) - kWidth; }
    kodo_sfml::Rect track(std::size_t knob) const;
    void setFrom(float x, Sandbox& sandbox);

    std::vector<Knob> knobs_;
    kodo_sfml::Size pixels_{1, 1};
    std::size_t chosen_ = 3; // index in makeKnobs(): rest iterations
    std::optional<std::size_t> held_;
};

} // namespace destructoooor
