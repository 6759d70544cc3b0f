// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/held_keys.hpp>
#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/controls/controls.hpp>
#include <kodo_sfml/window.hpp>

#include <SFML/Window/Event.hpp>

#include <array>
#include <optional>

namespace apart {

/// Keys and mouse of a window, and a gamepad. The state of keys follows events, so that only keys
/// pressed in the window count.
class SfmlControls : public Controls {
public:
    SfmlControls(kodo_sfml::Window& window, const SfmlCanvas& canvas)
        : window_(window), canvas_(canvas) {}

    /// Keys and buttons of the player; the current ones until the next call.
    void setBindings(const Bindings& bindings) { keys_.setBindings(bindings); }
    Signals poll() override;
    void capture(bool on) override;
    /// True if F3, which toggles the Inspector, was pressed since the last call.
    bool takeInspect();
    /// True if F11 or alt and enter were pressed since the last call.
    bool takeFullScreen();

private:
    void take(const sf::Event& event, Signals& signals);
    void hold(sf::Mouse::Button button, bool down);
    void move(sf::Vector2i place, Signals& signals);
    void recentre();
    void pollPad(Signals& signals);

    kodo_sfml::Window& window_;
    const SfmlCanvas& canvas_;
    HeldKeys keys_;
    std::array<bool, 2> buttons_{}; // left, right
    bool dragging_ = false;         // the left one, of a free mouse
    Vec2 pointer_;                  // m
    bool focused_ = false;          // at least once so far
    bool captured_ = false;
    sf::Vector2i last_;                     // pixels; last place of the mouse
    std::optional<sf::Vector2i> recentred_; // pixels; place set, while its event is pending
    bool inspect_ = false;
    bool fullScreen_ = false;
};

} // namespace apart
