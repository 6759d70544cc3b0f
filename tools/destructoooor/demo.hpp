// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/window.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <string>

#include "panel.hpp"

namespace destructoooor {

/// Controls the sandbox by keys and mouse, and draws it.
class Demo {
public:
    explicit Demo(const std::string& fontFile); // throws std::runtime_error

    Sandbox& sandbox() { return sandbox_; }
    bool wantsToQuit() const { return quit_; }

    void take(const sf::Event& event);
    /// Runs the steps of this time (s), but only a few per call.
    void advance(double seconds);
    void draw(kodo_sfml::Painter& painter, kodo_sfml::Size pixels);

private:
    void press(sf::Keyboard::Key key);
    void click(const sf::Event::MouseButtonEvent& button);
    void stepOnce();
    kodo_sfml::Camera camera() const;

    sf::Font font_;
    Sandbox sandbox_;
    Panel panel_;
    kodo_sfml::WorldLook look_;
    Primitive primitive_ = Primitive::Box;
    kodo::Real size_ = 1; // m
    kodo_sfml::Size pixels_{1280, 800};
    double owed_ = 0;             // s, not simulated yet
    double stepMilliseconds_ = 0; // moving average
    bool paused_ = false;
    bool quit_ = false;
};

} // namespace destructoooor
