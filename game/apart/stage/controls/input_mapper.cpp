// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/controls/input_mapper.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

// A tap moves the paddle slightly; a held key soon reaches full speed.
constexpr int kFirstSpeed = 45; // of 127
constexpr int kGain = 7;        // per tick: full speed after 0.1 s

constexpr kodo::Real kMostAngle = kodo::Real(1.0471); // rad, of kMostAim
constexpr kodo::Real kAngleByMouse = kodo::Real(0.1); // rad for 1 m of the mouse
constexpr kodo::Real kAngleByKeys = kodo::Real(0.01); // rad a tick at full speed

/// m. The target is clamped here, so that reversing the mouse moves the paddle at once.
constexpr kodo::Real kReach = kFieldWidth / 2 - kPaddleHalfWidth;

} // namespace

void InputMapper::take(const PaddleSignals& signals, kodo::Real paddleX, kodo::Real speed) {
    const int held = (signals.rightHeld ? 1 : 0) - (signals.leftHeld ? 1 : 0);
    if (held != held_) {
        held_ = held;
        speed_ = kFirstSpeed;
    }
    stick_ = signals.stick;
    if (angle_ && !launch_) {
        angle_ = *angle_ + kAngleByMouse * speed * signals.moved;
        launch_ = !signals.serveHeld;
    } else if (signals.leftHeld || signals.rightHeld || stick_ != 0) {
        target_.reset();
    } else if (signals.moved != 0) {
        const kodo::Real from = target_.value_or(paddleX);
        target_ = std::clamp(from + speed * signals.moved, -kReach, kReach);
    }
    pullSpent_ = pullSpent_ && signals.pullHeld;
    const bool pull = signals.pullHeld && !pullSpent_;
    force_ = pull == signals.pushHeld ? Force::None : pull ? Force::Pull : Force::Push;
}

void InputMapper::launch(const PaddleSignals& signals, std::optional<kodo::Vec2> serve) {
    pullSpent_ = true;
    if (serve && signals.serveHeld) {
        angle_ = std::atan2(serve->x, serve->y);
    } else {
        launch_ = true;
    }
}

Input InputMapper::next() {
    Input input;
    const int keys = held_ * speed_;
    const int way = keys != 0 ? keys : static_cast<int>(127 * stick_);
    if (angle_) {
        const kodo::Real turned = *angle_ + kAngleByKeys * static_cast<kodo::Real>(way) / 127;
        angle_ = std::clamp(turned, -kMostAngle, kMostAngle);
        input.aim = static_cast<std::int16_t>(std::lround(1000 * std::tan(*angle_)));
    } else {
        input.paddle = static_cast<std::int8_t>(way);
    }
    if (target_) {
        input.target = static_cast<std::int16_t>(1000 * *target_);
    }
    input.launch = launch_;
    input.force = force_;
    if (launch_) {
        angle_.reset();
    }
    launch_ = false;
    speed_ = std::min(speed_ + kGain, 127);
    return input;
}

} // namespace apart
