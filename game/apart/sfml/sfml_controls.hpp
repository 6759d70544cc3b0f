// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/controls.hpp>
#include <kodo_sfml/window.hpp>

#include <SFML/Window/Event.hpp>

namespace apart {

/// Keys and mouse of a window. Keys are followed by their events, so that only those count that
/// were pressed in it.
class SfmlControls : public Controls {
public:
    SfmlControls(kodo_sfml::Window& window, const SfmlCanvas& canvas)
        : window_(window), canvas_(canvas) {}

    Signals poll() override;
    /// F3 was pressed since the last call: show how the engine sees the game, or stop it.
    bool takeInspect();

private:
    void take(const sf::Event& event, Signals& signals);
    void press(sf::Keyboard::Key key, Signals& signals);
    void hold(sf::Keyboard::Key key, bool down);

    kodo_sfml::Window& window_;
    const SfmlCanvas& canvas_;
    std::array<bool, 4> held_{}; // left, A, right, D
    Vec2 pointer_;               // m
    bool inspect_ = false;
};

} // namespace apart
