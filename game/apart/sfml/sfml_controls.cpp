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

kodo_draw::Pixel pixelOf(sf::Vector2i place) {
    return {static_cast<float>(place.x), static_cast<float>(place.y)};
}

} // namespace

/// The first gamepad is that of the first player; all others are as one.
void SfmlControls::pollPad(Signals& signals) {
    using sf::Joystick;
    std::array<Pad, kSeats> pads;
    std::size_t seat = 0;
    for (unsigned i = 0; window_.hasFocus() && i < Joystick::Count; ++i) {
        if (!Joystick::isConnected(i)) {
            continue;
        }
        const auto axis = [i](Joystick::Axis of) { return Joystick::getAxisPosition(i, of) / 100; };
        Pad pad{.stickX = axis(Joystick::X),
                .stickY = axis(Joystick::Y),
                .padX = axis(Joystick::PovX),
                .padY = axis(Joystick::PovY),
                .triggers = {axis(Joystick::Z), axis(Joystick::R)}};
        for (unsigned button = 0; button < static_cast<unsigned>(kMostButtons); ++button) {
            pad.held |= Joystick::isButtonPressed(i, button) ? 1u << button : 0u;
        }
        pads[seat] = pads[seat].joined(pad);
        seat = kSeats - 1;
    }
    keys_.take(pads, signals);
}

Signals SfmlControls::poll() {
    Signals signals;
    while (const std::optional<sf::Event> event = window_.nextEvent()) {
        take(*event, signals);
    }
    keys_.addHeld(buttons_, signals);
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
    keys_.setInGame(on);
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
        keys_.releaseAll();
        buttons_ = {};
        dragging_ = false;
        return;
    case sf::Event::KeyPressed:
        signals.anyKey = true;
        if (event.key.code == Key::F11 || (event.key.alt && event.key.code == Key::Enter)) {
            fullScreen_ = true;
            return;
        }
        inspect_ = inspect_ || event.key.code == Key::F3;
        return keys_.press(event.key.code, signals);
    case sf::Event::KeyReleased:
        return keys_.release(event.key.code);
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

void SfmlControls::hold(sf::Mouse::Button button, bool down) {
    if (button == sf::Mouse::Left || button == sf::Mouse::Right) {
        buttons_[button == sf::Mouse::Left ? 0 : 1] = down;
    }
}

bool SfmlControls::takeFullScreen() {
    const bool taken = std::exchange(fullScreen_, false);
    if (taken) { // the new window has no state of held keys
        keys_.releaseAll();
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
