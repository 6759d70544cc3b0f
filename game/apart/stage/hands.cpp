// SPDX-License-Identifier: MIT
#include <apart/stage/hands.hpp>

#include <algorithm>

namespace apart {

namespace {

// A tap of a key moves the paddle by a finger's width, a held key soon at full speed.
constexpr int kFirstSpeed = 45; // of 127
constexpr int kGain = 7;        // each tick: full speed after a tenth of a second

} // namespace

void Hands::take(const Signals& signals) {
    const int held = (signals.rightHeld ? 1 : 0) - (signals.leftHeld ? 1 : 0);
    if (held != held_) {
        held_ = held;
        speed_ = kFirstSpeed;
    }
    if (signals.leftHeld || signals.rightHeld) {
        target_.reset();
    } else if (signals.pointer) {
        const float milli = std::clamp(1000 * signals.pointer->x, -32000.0f, 32000.0f);
        target_ = static_cast<std::int16_t>(milli);
    }
}

Input Hands::next() {
    Input input;
    input.paddle = static_cast<std::int8_t>(held_ * speed_);
    input.target = target_;
    input.launch = launch_;
    launch_ = false;
    speed_ = std::min(speed_ + kGain, 127);
    return input;
}

} // namespace apart
