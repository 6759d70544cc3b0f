// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/controls.hpp>
#include <kodo_sfml/window.hpp>

#include <SFML/Window/Event.hpp>

#include <array>
#include <optional>

namespace apart {

/// Keys and mouse of a window. Keys are followed by their events, so that only those count that
/// were pressed in it.
class SfmlControls : public Controls {
public:
    SfmlControls(kodo_sfml::Window& window, const SfmlCanvas& canvas)
        : window_(window), canvas_(canvas) {}

    Signals poll() override;
    void capture(bool on) override;
    /// F3 was pressed since the last call: show how the engine sees the game, or stop it.
    bool takeInspect();

private:
    void take(const sf::Event& event, Signals& signals);
    void press(sf::Keyboard::Key key, Signals& signals);
    void hold(sf::Keyboard::Key key, bool down);
    void hold(sf::Mouse::Button button, bool down);
    void move(sf::Vector2i place, Signals& signals);
    void recentre();

    kodo_sfml::Window& window_;
    const SfmlCanvas& canvas_;
    std::array<bool, 8> held_{};    // by kHeldKeys
    std::array<bool, 2> buttons_{}; // left, right
    Vec2 pointer_;                  // m
    bool focused_ = false;          // has been, at some time
    bool captured_ = false;
    sf::Vector2i last_;                     // pixels; where the mouse was
    std::optional<sf::Vector2i> recentred_; // pixels; where it was put and has not been seen yet
    bool inspect_ = false;
};

} // namespace apart
