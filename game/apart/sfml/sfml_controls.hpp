// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/controls.hpp>
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
    void setBindings(const Bindings& bindings) { bindings_ = bindings; }
    Signals poll() override;
    void capture(bool on) override;
    /// True if F3, which toggles the Inspector, was pressed since the last call.
    bool takeInspect();
    /// True if F11 or alt and enter were pressed since the last call.
    bool takeFullScreen();

private:
    void take(const sf::Event& event, Signals& signals);
    void press(sf::Keyboard::Key key, Signals& signals);
    void pressButton(unsigned button, Signals& signals);
    bool holds(Act act) const;
    void hold(sf::Keyboard::Key key, bool down);
    void hold(sf::Mouse::Button button, bool down);
    void move(sf::Vector2i place, Signals& signals);
    void recentre();
    void pollPad(Signals& signals);

    kodo_sfml::Window& window_;
    const SfmlCanvas& canvas_;
    Bindings bindings_;
    std::array<bool, kKeyNames.size()> held_{}; // by key
    std::array<bool, 2> buttons_{};             // left, right
    bool dragging_ = false;                     // the left one, of a free mouse
    Vec2 pointer_;                              // m
    bool focused_ = false;                      // at least once so far
    bool captured_ = false;
    sf::Vector2i last_;                     // pixels; last place of the mouse
    std::optional<sf::Vector2i> recentred_; // pixels; place set, while its event is pending
    bool inspect_ = false;
    bool fullScreen_ = false;
    std::array<int, 2> padTilt_{}; // -1, 0 or 1 along x and y of the directional pad
};

} // namespace apart
