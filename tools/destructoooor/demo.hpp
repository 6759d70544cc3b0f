// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/window.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <string>

#include "panel.hpp"

namespace destructoooor {

/// What keys and mouse do to the sandbox, and the picture of it.
class Demo {
public:
    explicit Demo(const std::string& fontFile); // throws std::runtime_error

    Sandbox& sandbox() { return sandbox_; }
    bool wantsToQuit() const { return quit_; }

    void take(const sf::Event& event);
    /// Runs as many steps as that many seconds hold, up to a few.
    void advance(double seconds);
    void draw(kodo_sfml::Painter& painter, sf::Vector2u pixels);

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
    sf::Vector2u pixels_{1280, 800};
    double owed_ = 0;             // s
    double stepMilliseconds_ = 0; // smoothed
    bool paused_ = false;
    bool quit_ = false;
};

} // namespace destructoooor
