// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/input_mapper.hpp>

#include <algorithm>

namespace apart {

namespace {

// A tap moves the paddle slightly; a held key soon reaches full speed.
constexpr int kFirstSpeed = 45; // of 127
constexpr int kGain = 7;        // per tick: full speed after 0.1 s

/// m. The target is clamped here, so that reversing the mouse moves the paddle at once.
constexpr kodo::Real kReach = kFieldWidth / 2 - kPaddleHalfWidth;

} // namespace

void InputMapper::take(const Signals& signals, kodo::Real paddleX, kodo::Real speed) {
    const int held = (signals.rightHeld ? 1 : 0) - (signals.leftHeld ? 1 : 0);
    if (held != held_) {
        held_ = held;
        speed_ = kFirstSpeed;
    }
    stick_ = signals.stick;
    if (signals.leftHeld || signals.rightHeld || stick_ != 0) {
        target_.reset();
    } else if (signals.moved != 0) {
        const kodo::Real from = target_.value_or(paddleX);
        target_ = std::clamp(from + speed * signals.moved, -kReach, kReach);
    }
    pullSpent_ = pullSpent_ && signals.pullHeld;
    const bool pull = signals.pullHeld && !pullSpent_;
    force_ = pull == signals.pushHeld ? Force::None : pull ? Force::Pull : Force::Push;
}

Input InputMapper::next() {
    Input input;
    const int keys = held_ * speed_;
    input.paddle = static_cast<std::int8_t>(keys != 0 ? keys : static_cast<int>(127 * stick_));
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
