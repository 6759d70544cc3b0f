// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_controls.hpp>

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
constexpr std::array<Key, 4> kHeldKeys = {Key::Left, Key::A, Key::Right, Key::D};

} // namespace

Signals SfmlControls::poll() {
    Signals signals;
    while (const std::optional<sf::Event> event = window_.nextEvent()) {
        take(*event, signals);
    }
    signals.leftHeld = held_[0] || held_[1];
    signals.rightHeld = held_[2] || held_[3];
    signals.pointerNow = pointer_;
    return signals;
}

void SfmlControls::take(const sf::Event& event, Signals& signals) {
    switch (event.type) {
    case sf::Event::Closed:
        signals.closed = true;
        return;
    case sf::Event::LostFocus:
        signals.focusLost = true;
        held_ = {};
        return;
    case sf::Event::KeyPressed:
        hold(event.key.code, true);
        return press(event.key.code, signals);
    case sf::Event::KeyReleased:
        return hold(event.key.code, false);
    case sf::Event::MouseMoved:
        pointer_ = canvas_.camera().toWorld(
            {static_cast<float>(event.mouseMove.x), static_cast<float>(event.mouseMove.y)});
        signals.pointer = pointer_;
        return;
    case sf::Event::MouseButtonPressed:
        pointer_ = canvas_.camera().toWorld(
            {static_cast<float>(event.mouseButton.x), static_cast<float>(event.mouseButton.y)});
        signals.clicked = true;
        return;
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

bool SfmlControls::takeInspect() {
    return std::exchange(inspect_, false);
}

} // namespace apart
