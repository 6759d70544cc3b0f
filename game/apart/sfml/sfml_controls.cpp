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

static_assert(kKeyNames.size() == static_cast<std::size_t>(Key::KeyCount));
static_assert(kKeyNames[static_cast<std::size_t>(Key::Space)] == "space" &&
              kKeyNames[static_cast<std::size_t>(Key::Down)] == "down" &&
              kKeyNames[static_cast<std::size_t>(Key::F3)] == "F3" &&
              kKeyNames[static_cast<std::size_t>(Key::Pause)] == "pause");

/// The meaning of a key that is the same for every player. In menus it precedes the bound one, so
/// that no binding makes a menu unusable; in a game it holds for keys that are not bound.
struct Fixed {
    Key key;
    Command command;
    bool inGames = true;
};
constexpr std::array<Fixed, 13> kFixedKeys = {{
    {Key::Enter, Command::Confirm},
    {Key::Escape, Command::Back},
    {Key::Up, Command::Up},
    {Key::Down, Command::Down},
    {Key::Left, Command::Left},
    {Key::Right, Command::Right},
    {Key::Tab, Command::Down},
    {Key::N, Command::Next},
    {Key::Space, Command::Launch, false},
    {Key::W, Command::Up, false},
    {Key::S, Command::Down, false},
    {Key::A, Command::Left, false},
    {Key::D, Command::Right, false},
}};
// The same of the buttons of a gamepad, in the order of most drivers: A B X Y, two shoulders, back,
// start.
constexpr std::array<Command, 8> kFixedButtons = {Command::Launch,  Command::Back, Command::Next,
                                                  Command::Mute,    Command::Up,   Command::Down,
                                                  Command::Restart, Command::Pause};
constexpr std::array<Command, kActs> kCommands = {Command::Left,    Command::Right,  Command::Down,
                                                  Command::Up,      Command::Launch, Command::Pause,
                                                  Command::Restart, Command::Mute};

std::optional<Command> fixedCommand(Key key, bool inGames) {
    const auto found = std::find_if(kFixedKeys.begin(), kFixedKeys.end(),
                                    [&](const Fixed& fixed) { return fixed.key == key; });
    const bool holds = found != kFixedKeys.end() && (found->inGames || !inGames);
    return holds ? std::optional(found->command) : std::nullopt;
}

std::optional<Command> fixedCommand(unsigned button) {
    return button < kFixedButtons.size() ? std::optional(kFixedButtons[button]) : std::nullopt;
}

constexpr float kDeadZone = 0.2f; // share of the way of a stick

/// -1..1, from the end of the dead zone on.
Real beyondDeadZone(float share) {
    const float way = std::max(std::abs(share) - kDeadZone, 0.0f) / (1 - kDeadZone);
    return static_cast<Real>(share < 0 ? -way : way);
}

kodo_draw::Pixel pixelOf(sf::Vector2i place) {
    return {static_cast<float>(place.x), static_cast<float>(place.y)};
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
    const auto pressed = [&](Act act) {
        const int button = bindings_.at(act, Bindings::kPadColumn);
        return button >= 0 && Joystick::isButtonPressed(kPad, static_cast<unsigned>(button));
    };
    signals.pullHeld = signals.pullHeld || pressed(Act::Pull);
    signals.pushHeld = signals.pushHeld || pressed(Act::Push);
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
    signals.leftHeld = holds(Act::Left);
    signals.rightHeld = holds(Act::Right);
    signals.pullHeld = holds(Act::Pull) || buttons_[0];
    signals.pushHeld = holds(Act::Push) || buttons_[1];
    signals.pointerNow = pointer_;
    signals.dragging = dragging_ && !captured_;
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
    pointer_ = canvas_.camera().toWorld(pixelOf(place));
    if (!captured_) {
        signals.pointer = pointer_;
        return;
    }
    if (recentred_ == place) {
        recentred_.reset(); // event of putPointer(), not of the player
    } else {
        signals.moved += pointer_.x - canvas_.camera().toWorld(pixelOf(last_)).x;
    }
    last_ = place;
}

/// SFML reports positions of the mouse, not displacements. Recentring keeps the pointer away from
/// the border of the window, so that displacements are not limited. Until its event arrives,
/// positions still refer to the old place. If the system refuses it, no event arrives, and the
/// border of the screen limits the displacement.
void SfmlControls::recentre() {
    const kodo_draw::Size size = window_.size();
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
        dragging_ = false;
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
        return pressButton(event.joystickButton.button, signals);
    case sf::Event::MouseMoved:
        return move({event.mouseMove.x, event.mouseMove.y}, signals);
    case sf::Event::MouseButtonPressed:
        move({event.mouseButton.x, event.mouseButton.y}, signals);
        signals.clicked = signals.clicked || event.mouseButton.button == sf::Mouse::Left;
        dragging_ = dragging_ || event.mouseButton.button == sf::Mouse::Left;
        return hold(event.mouseButton.button, captured_);
    case sf::Event::MouseWheelScrolled:
        signals.commands.push_back(event.mouseWheelScroll.delta > 0 ? Command::Up : Command::Down);
        return;
    case sf::Event::MouseButtonReleased:
        dragging_ = dragging_ && event.mouseButton.button != sf::Mouse::Left;
        return hold(event.mouseButton.button, false);
    default:
        return;
    }
}

void SfmlControls::press(Key key, Signals& signals) {
    if (key == Key::F3) {
        inspect_ = true;
    }
    const Press pressed{false, static_cast<int>(key)};
    signals.presses.push_back(pressed);
    const std::optional<Act> act = bindings_.actOf(pressed);
    const std::optional<Command> bound =
        act ? std::optional(kCommands[static_cast<std::size_t>(*act)]) : std::nullopt;
    const std::optional<Command> fixed = fixedCommand(key, captured_);
    if (const auto command = captured_ ? (bound ? bound : fixed) : (fixed ? fixed : bound)) {
        signals.commands.push_back(*command);
    }
}

void SfmlControls::pressButton(unsigned button, Signals& signals) {
    const Press pressed{true, static_cast<int>(button)};
    signals.presses.push_back(pressed);
    const std::optional<Act> act = bindings_.actOf(pressed);
    const std::optional<Command> bound =
        act ? std::optional(kCommands[static_cast<std::size_t>(*act)]) : std::nullopt;
    const std::optional<Command> fixed = fixedCommand(button);
    if (const auto command = captured_ ? (bound ? bound : fixed) : (fixed ? fixed : bound)) {
        signals.commands.push_back(*command);
    }
}

bool SfmlControls::holds(Act act) const {
    for (std::size_t column = 0; column < Bindings::kPadColumn; ++column) {
        const int key = bindings_.at(act, column);
        if (key >= 0 && held_[static_cast<std::size_t>(key)]) {
            return true;
        }
    }
    return false;
}

void SfmlControls::hold(Key key, bool down) {
    if (key >= 0 && static_cast<std::size_t>(key) < held_.size()) {
        held_[static_cast<std::size_t>(key)] = down;
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
