// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/hands.hpp>

#include <algorithm>

namespace apart {

namespace {

// A tap of a key moves the paddle by a finger's width, a held key soon at full speed.
constexpr int kFirstSpeed = 45; // of 127
constexpr int kGain = 7;        // each tick: full speed after a tenth of a second

/// m; the target of a mouse that has gone far beyond a wall must come back at once.
constexpr kodo::Real kReach = kFieldWidth / 2 - kPaddleHalfWidth;

} // namespace

void Hands::take(const Signals& signals, kodo::Real paddleX, kodo::Real speed) {
    const int held = (signals.rightHeld ? 1 : 0) - (signals.leftHeld ? 1 : 0);
    if (held != held_) {
        held_ = held;
        speed_ = kFirstSpeed;
    }
    if (signals.leftHeld || signals.rightHeld) {
        target_.reset();
    } else if (signals.moved != 0) {
        const kodo::Real from = target_.value_or(paddleX);
        target_ = std::clamp(from + speed * signals.moved, -kReach, kReach);
    }
    pullSpent_ = pullSpent_ && signals.pullHeld;
    const bool pull = signals.pullHeld && !pullSpent_;
    force_ = pull == signals.pushHeld ? Force::None : pull ? Force::Pull : Force::Push;
}

Input Hands::next() {
    Input input;
    input.paddle = static_cast<std::int8_t>(held_ * speed_);
    if (target_) {
        input.target = static_cast<std::int16_t>(1000 * *target_);
    }
    input.launch = launch_;
    input.force = force_;
    launch_ = false;
    speed_ = std::min(speed_ + kGain, 127);
    return input;
}

} // namespace apart
