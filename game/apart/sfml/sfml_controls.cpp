// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_controls.hpp>

#include <SFML/Window/Joystick.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace apart {

namespace {

using Key = sf::Keyboard::Key;

constexpr std::array<std::pair<Key, Command>, 17> kKeys = {{
    {Key::Space, Command::Launch},
    {Key::Enter, Command::Confirm},
    {Key::Escape, Command::Back},
    {Key::P, Command::Pause},
    {Key::Pause, Command::Pause},
    {Key::R, Command::Restart},
    {Key::N, Command::Next},
    {Key::M, Command::Mute},
    {Key::Up, Command::Up},
    {Key::W, Command::Up},
    {Key::Down, Command::Down},
    {Key::S, Command::Down},
    {Key::Left, Command::Left},
    {Key::A, Command::Left},
    {Key::Right, Command::Right},
    {Key::D, Command::Right},
    {Key::Tab, Command::Down},
}};
// Two keys each for left, right, pull and push.
constexpr std::array<Key, 8> kHeldKeys = {Key::Left, Key::A, Key::Right, Key::D,
                                          Key::Down, Key::S, Key::Up,    Key::W};

// Buttons of a gamepad in the order of most drivers: A B X Y, two shoulders, back, start.
constexpr std::array<Command, 8> kPadButtons = {Command::Launch,  Command::Back, Command::Next,
                                                Command::Mute,    Command::Up,   Command::Down,
                                                Command::Restart, Command::Pause};
constexpr unsigned kPadPull = 4; // held: the left shoulder pulls, the right one pushes
constexpr unsigned kPadPush = 5;
constexpr float kDeadZone = 0.2f; // share of the way of a stick

/// -1..1, from the end of the dead zone on.
Real beyondDeadZone(float share) {
    const float way = std::max(std::abs(share) - kDeadZone, 0.0f) / (1 - kDeadZone);
    return static_cast<Real>(share < 0 ? -way : way);
}

} // namespace

/// Sticks and held buttons of the first gamepad.
void SfmlControls::pollPad(Signals& signals) {
    constexpr unsigned kPad = 0;
    using sf::Joystick;
    if (!window_.hasFocus() || !Joystick::isConnected(kPad)) {
        return;
    }
    signals.stick = beyondDeadZone(Joystick::getAxisPosition(kPad, Joystick::X) / 100);
    signals.pullHeld = signals.pullHeld || Joystick::isButtonPressed(kPad, kPadPull);
    signals.pushHeld = signals.pushHeld || Joystick::isButtonPressed(kPad, kPadPush);
    const Real x = beyondDeadZone(Joystick::getAxisPosition(kPad, Joystick::PovX) / 100);
    const Real y = beyondDeadZone(Joystick::getAxisPosition(kPad, Joystick::PovY) / 100);
    signals.stick = x != 0 ? x : signals.stick;
    const std::array<int, 2> tilt = {x == 0 ? 0 : x < 0 ? -1 : 1, y == 0 ? 0 : y < 0 ? -1 : 1};
    if (tilt != padTilt_) { // a menu moves once per press
        padTilt_ = tilt;
        if (tilt[1] != 0) {
            signals.commands.push_back(tilt[1] < 0 ? Command::Up : Command::Down);
        } else if (tilt[0] != 0) {
            signals.commands.push_back(tilt[0] < 0 ? Command::Left : Command::Right);
        }
    }
}

Signals SfmlControls::poll() {
    Signals signals;
    while (const std::optional<sf::Event> event = window_.nextEvent()) {
        take(*event, signals);
    }
    signals.leftHeld = held_[0] || held_[1];
    signals.rightHeld = held_[2] || held_[3];
    signals.pullHeld = held_[4] || held_[5] || buttons_[0];
    signals.pushHeld = held_[6] || held_[7] || buttons_[1];
    signals.pointerNow = pointer_;
    pollPad(signals);
    recentre();
    return signals;
}

void SfmlControls::capture(bool on) {
    if (on == captured_) {
        return;
    }
    captured_ = on;
    buttons_ = {};
    recentred_.reset();
    last_ = window_.pointer();
    window_.setPointerVisible(!on);
}

void SfmlControls::move(sf::Vector2i place, Signals& signals) {
    pointer_ = canvas_.camera().toWorld(sf::Vector2f(place));
    if (!captured_) {
        signals.pointer = pointer_;
        return;
    }
    if (recentred_ == place) {
        recentred_.reset(); // event of putPointer(), not of the player
    } else {
        const sf::Vector2f from(last_);
        signals.moved += pointer_.x - canvas_.camera().toWorld(from).x;
    }
    last_ = place;
}

/// SFML reports positions of the mouse, not displacements. Recentring keeps the pointer away from
/// the border of the window, so that displacements are not limited. Until its event arrives,
/// positions still refer to the old place. If the system refuses it, no event arrives, and the
/// border of the screen limits the displacement.
void SfmlControls::recentre() {
    const sf::Vector2u size = window_.size();
    const sf::Vector2i middle(static_cast<int>(size.x / 2), static_cast<int>(size.y / 2));
    const bool far =
        std::abs(last_.x - middle.x) > middle.x / 2 || std::abs(last_.y - middle.y) > middle.y / 2;
    if (captured_ && window_.hasFocus() && far && !recentred_) {
        recentred_ = middle;
        window_.putPointer(middle);
    }
}

void SfmlControls::take(const sf::Event& event, Signals& signals) {
    switch (event.type) {
    case sf::Event::Closed:
        signals.closed = true;
        return;
    case sf::Event::GainedFocus:
        focused_ = true;
        return;
    case sf::Event::LostFocus:
        signals.focusLost = focused_; // some systems send it before any gain
        held_ = {};
        buttons_ = {};
        return;
    case sf::Event::KeyPressed:
        signals.anyKey = true;
        if (event.key.code == Key::F11 || (event.key.alt && event.key.code == Key::Enter)) {
            fullScreen_ = true;
            return;
        }
        hold(event.key.code, true);
        return press(event.key.code, signals);
    case sf::Event::KeyReleased:
        return hold(event.key.code, false);
    case sf::Event::JoystickButtonPressed:
        signals.anyKey = true;
        if (event.joystickButton.button < kPadButtons.size()) {
            signals.commands.push_back(kPadButtons[event.joystickButton.button]);
        }
        return;
    case sf::Event::MouseMoved:
        return move({event.mouseMove.x, event.mouseMove.y}, signals);
    case sf::Event::MouseButtonPressed:
        move({event.mouseButton.x, event.mouseButton.y}, signals);
        signals.clicked = signals.clicked || event.mouseButton.button == sf::Mouse::Left;
        return hold(event.mouseButton.button, captured_);
    case sf::Event::MouseWheelScrolled:
        signals.commands.push_back(event.mouseWheelScroll.delta > 0 ? Command::Up : Command::Down);
        return;
    case sf::Event::MouseButtonReleased:
        return hold(event.mouseButton.button, false);
    default:
        return;
    }
}

void SfmlControls::press(Key key, Signals& signals) {
    if (key == Key::F3) {
        inspect_ = true;
    }
    for (const auto& [known, command] : kKeys) {
        if (known == key) {
            signals.commands.push_back(command);
        }
    }
}

void SfmlControls::hold(Key key, bool down) {
    for (std::size_t i = 0; i < kHeldKeys.size(); ++i) {
        if (kHeldKeys[i] == key) {
            held_[i] = down;
        }
    }
}

void SfmlControls::hold(sf::Mouse::Button button, bool down) {
    if (button == sf::Mouse::Left || button == sf::Mouse::Right) {
        buttons_[button == sf::Mouse::Left ? 0 : 1] = down;
    }
}

bool SfmlControls::takeFullScreen() {
    const bool taken = std::exchange(fullScreen_, false);
    if (taken) { // the new window has no state of held keys
        held_ = {};
        buttons_ = {};
        recentred_.reset();
        focused_ = false;
    }
    return taken;
}

bool SfmlControls::takeInspect() {
    return std::exchange(inspect_, false);
}

} // namespace apart
