// SPDX-License-Identifier: MIT
#include <apart/front/held_keys.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

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

constexpr int kSecondServe = keyOf("enter"); // of the second of two players
constexpr std::array<int, 2> kShifts = {keyOf("left shift"), keyOf("right shift")};

constexpr float kDeadZone = 0.2f;   // share of the way of a stick
constexpr float kTiltBegins = 0.6f; // likewise, in a menu
constexpr float kTiltEnds = 0.4f;
constexpr float kTriggerPulled = 0.5f;
constexpr std::size_t kShoulder = 4; // the left one; the right one follows

/// -1..1, from the end of the dead zone on.
Real beyondDeadZone(float share) {
    const float way = std::max(std::abs(share) - kDeadZone, 0.0f) / (1 - kDeadZone);
    return static_cast<Real>(share < 0 ? -way : way);
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
        latest_ = key;
    }
    signals.seats[0].serves |= bindings_.actOf({false, key}) == Act::Serve;
    signals.seats[1].serves |= key == kSecondServe;
    give({false, key}, fixedCommand(key, inGame_), signals);
}

void HeldKeys::release(int key) {
    if (key >= 0 && static_cast<std::size_t>(key) < held_.size()) {
        held_[static_cast<std::size_t>(key)] = false;
    }
}

Pad Pad::joined(const Pad& other) const {
    const auto farther = [](float a, float b) { return std::abs(b) > std::abs(a) ? b : a; };
    return {farther(stickX, other.stickX),
            farther(stickY, other.stickY),
            farther(padX, other.padX),
            farther(padY, other.padY),
            {std::max(triggers[0], other.triggers[0]), std::max(triggers[1], other.triggers[1])},
            held | other.held};
}

void HeldKeys::pressButtons(std::uint32_t held, Signals& signals) {
    const std::uint32_t begun = held & ~buttonsHeld_;
    buttonsHeld_ = held;
    for (std::size_t i = 0; i < static_cast<std::size_t>(kMostButtons); ++i) {
        if ((begun >> i & 1u) != 0) {
            std::optional<Command> fixed;
            if (i < kFixedButtons.size()) {
                fixed = kFixedButtons[i];
            }
            give({true, static_cast<int>(i)}, fixed, signals);
        }
    }
}

/// A stick must go farther to tilt than to stay tilted, so that a trembling one moves a menu once.
void HeldKeys::tilt(const Pad& pad, Signals& signals) {
    const auto tilted = [](float share, int before) {
        const float least = static_cast<float>(before) * share > 0 ? kTiltEnds : kTiltBegins;
        return std::abs(share) > least ? (share < 0 ? -1 : 1) : 0;
    };
    const bool upright = std::abs(pad.stickY) > std::abs(pad.stickX);
    const std::array<int, 2> now = {tilted(pad.padX != 0 ? pad.padX
                                           : upright     ? 0
                                                         : pad.stickX,
                                           tilt_[0]),
                                    tilted(pad.padY != 0 ? pad.padY
                                           : upright     ? pad.stickY
                                                         : 0,
                                           tilt_[1])};
    if (now == std::exchange(tilt_, now)) {
        return;
    }
    if (now[1] != 0) {
        signals.commands.push_back(now[1] < 0 ? Command::Up : Command::Down);
    } else if (now[0] != 0) {
        signals.commands.push_back(now[0] < 0 ? Command::Left : Command::Right);
    }
}

/// The buttons of a gamepad that are held, with its triggers as shoulders.
static std::uint32_t heldOf(const Pad& pad) {
    std::uint32_t held = pad.held;
    for (std::size_t side = 0; side < pad.triggers.size(); ++side) {
        held |= pad.triggers[side] > kTriggerPulled ? 1u << (kShoulder + side) : 0u;
    }
    return held;
}

void HeldKeys::addPad(const Pad& pad, PaddleSignals& signals) const {
    const Real x = beyondDeadZone(pad.padX);
    signals.stick = x != 0 ? x : beyondDeadZone(pad.stickX);
    const auto held = [&, all = heldOf(pad)](Act act) {
        const int button = bindings_.at(act, Bindings::kPadColumn);
        return button >= 0 && (all >> button & 1u) != 0;
    };
    signals.pullHeld = signals.pullHeld || held(Act::Pull);
    signals.pushHeld = signals.pushHeld || held(Act::Push);
    signals.serveHeld = signals.serveHeld || held(Act::Serve);
}

void HeldKeys::take(const std::array<Pad, kSeats>& pads, Signals& signals) {
    for (std::size_t i = 0; i < kSeats; ++i) {
        SeatSignals& seat = signals.seats[i];
        const bool byKey = std::exchange(seat.serveHeld, false);
        addPad(pads[i], seat);
        const bool before = std::exchange(serveHeld_[i], seat.serveHeld);
        seat.serves |= seat.serveHeld && !before;
        seat.serveHeld |= byKey;
    }
    const Pad pad = pads[0].joined(pads[1]);
    addPad(pad, signals);
    pressButtons(heldOf(pad), signals);
    tilt(pad, signals);
}

bool HeldKeys::holds(Act act, std::size_t column) const {
    const int key = bindings_.at(act, column);
    return key >= 0 && held_[static_cast<std::size_t>(key)];
}

void HeldKeys::addColumn(std::size_t column, PaddleSignals& signals) const {
    signals.leftHeld |= holds(Act::Left, column);
    signals.rightHeld |= holds(Act::Right, column);
    signals.pullHeld |= holds(Act::Pull, column);
    signals.pushHeld |= holds(Act::Push, column);
}

void HeldKeys::addHeld(const std::array<bool, 2>& buttons, Signals& signals) const {
    signals.shiftHeld = std::any_of(kShifts.begin(), kShifts.end(),
                                    [&](int key) { return held_[static_cast<std::size_t>(key)]; });
    signals.keyHeld =
        latest_ != kNoKey && held_[static_cast<std::size_t>(latest_)] ? latest_ : kNoKey;
    bool serve = buttons[0];
    for (std::size_t i = 0; i < kSeats; ++i) {
        addColumn(kColumnOfSeat[i], signals);
        addColumn(kColumnOfSeat[i], signals.seats[i]);
        serve |= holds(Act::Serve, kColumnOfSeat[i]);
    }
    for (PaddleSignals* mouse :
         {static_cast<PaddleSignals*>(&signals), static_cast<PaddleSignals*>(&signals.seats[0])}) {
        mouse->pullHeld |= buttons[0];
        mouse->pushHeld |= buttons[1];
        mouse->serveHeld |= serve;
    }
    signals.seats[1].serveHeld |= held_[static_cast<std::size_t>(kSecondServe)];
}

} // namespace apart
