// SPDX-License-Identifier: MIT
#include <apart/front/held_keys.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;

namespace {

constexpr int keyOf(std::string_view name) {
    for (std::size_t i = 0; i < kKeyNames.size(); ++i) {
        if (kKeyNames[i] == name) {
            return static_cast<int>(i);
        }
    }
    return kNoKey;
}

/// The meaning of a key that is the same for every player. In menus it precedes the bound one, so
/// that no binding makes a menu unusable; in a game it holds for keys that are not bound.
struct Fixed {
    int key;
    Command command;
    bool inGames = true;
};
constexpr std::array<Fixed, 13> kFixedKeys = {{
    {keyOf("enter"), Command::Confirm},
    {keyOf("escape"), Command::Back},
    {keyOf("up"), Command::Up},
    {keyOf("down"), Command::Down},
    {keyOf("left"), Command::Left},
    {keyOf("right"), Command::Right},
    {keyOf("tab"), Command::Down},
    {keyOf("N"), Command::Next},
    {keyOf("space"), Command::Launch, false},
    {keyOf("W"), Command::Up, false},
    {keyOf("S"), Command::Down, false},
    {keyOf("A"), Command::Left, false},
    {keyOf("D"), Command::Right, false},
}};
static_assert(std::all_of(kFixedKeys.begin(), kFixedKeys.end(),
                          [](const Fixed& fixed) { return fixed.key != kNoKey; }));

constexpr std::array<Command, 8> kFixedButtons = {Command::Launch,  Command::Back, Command::Next,
                                                  Command::Mute,    Command::Up,   Command::Down,
                                                  Command::Restart, Command::Pause};
constexpr std::array<Command, kActs> kCommands = {Command::Left,    Command::Right,  Command::Down,
                                                  Command::Up,      Command::Launch, Command::Pause,
                                                  Command::Restart, Command::Mute};

std::optional<Command> fixedCommand(int key, bool inGame) {
    const auto found = std::find_if(kFixedKeys.begin(), kFixedKeys.end(),
                                    [&](const Fixed& fixed) { return fixed.key == key; });
    const bool holds = found != kFixedKeys.end() && (found->inGames || !inGame);
    return holds ? std::optional(found->command) : std::nullopt;
}

constexpr float kDeadZone = 0.2f; // share of the way of a stick

/// -1..1, from the end of the dead zone on.
Real beyondDeadZone(float share) {
    const float way = std::max(std::abs(share) - kDeadZone, 0.0f) / (1 - kDeadZone);
    return static_cast<Real>(share < 0 ? -way : way);
}

int signOf(Real x) {
    return x == 0 ? 0 : x < 0 ? -1 : 1;
}

} // namespace

void HeldKeys::give(Press press, std::optional<Command> fixed, Signals& signals) const {
    signals.anyKey = true;
    signals.presses.push_back(press);
    const std::optional<Act> act = bindings_.actOf(press);
    const std::optional<Command> bound =
        act ? std::optional(kCommands[static_cast<std::size_t>(*act)]) : std::nullopt;
    if (const auto command = inGame_ ? (bound ? bound : fixed) : (fixed ? fixed : bound)) {
        signals.commands.push_back(*command);
    }
}

void HeldKeys::press(int key, Signals& signals) {
    if (key >= 0 && static_cast<std::size_t>(key) < held_.size()) {
        held_[static_cast<std::size_t>(key)] = true;
    }
    give({false, key}, fixedCommand(key, inGame_), signals);
}

void HeldKeys::release(int key) {
    if (key >= 0 && static_cast<std::size_t>(key) < held_.size()) {
        held_[static_cast<std::size_t>(key)] = false;
    }
}

void HeldKeys::pressButton(unsigned button, Signals& signals) const {
    const std::optional<Command> fixed =
        button < kFixedButtons.size() ? std::optional(kFixedButtons[button]) : std::nullopt;
    give({true, static_cast<int>(button)}, fixed, signals);
}

void HeldKeys::take(const Pad& pad, Signals& signals) {
    const Real x = beyondDeadZone(pad.padX);
    signals.stick = x != 0 ? x : beyondDeadZone(pad.stick);
    const auto held = [&](Act act) {
        const int button = bindings_.at(act, Bindings::kPadColumn);
        return button >= 0 && ((pad.held >> button) & 1u) != 0;
    };
    signals.pullHeld = signals.pullHeld || held(Act::Pull);
    signals.pushHeld = signals.pushHeld || held(Act::Push);
    signals.serveHeld = signals.serveHeld || held(Act::Serve);
    const std::array<int, 2> tilt = {signOf(x), signOf(beyondDeadZone(pad.padY))};
    if (tilt != padTilt_) { // a menu moves once per press
        padTilt_ = tilt;
        if (tilt[1] != 0) {
            signals.commands.push_back(tilt[1] < 0 ? Command::Up : Command::Down);
        } else if (tilt[0] != 0) {
            signals.commands.push_back(tilt[0] < 0 ? Command::Left : Command::Right);
        }
    }
}

bool HeldKeys::holds(Act act) const {
    for (std::size_t column = 0; column < Bindings::kPadColumn; ++column) {
        const int key = bindings_.at(act, column);
        if (key >= 0 && held_[static_cast<std::size_t>(key)]) {
            return true;
        }
    }
    return false;
}

} // namespace apart
