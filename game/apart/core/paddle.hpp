// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

namespace apart {

/// The bare paddle: a dome on a foot that narrows downwards, so that a ball caught at its side is
/// pushed down and out. The origin lies in the middle of its widest line.
kodo::Polygon paddleShape();

/// Height of the dome above that line at a distance from its middle (m); 0 beyond the rim.
kodo::Real domeHeight(kodo::Real x);

/// Speed of the paddle (m/s) after one tick at the wheel. The motor's force limits how fast it may
/// change and the motor's energy how large it may be, so mass makes it slow.
kodo::Real drivenSpeed(const Input& input, kodo::Real x, kodo::Real speed, kodo::Real mass);

/// How far an unruly paddle is off its place on the carriage.
struct Sway {
    kodo::Real tilt = 0;      // rad, counter-clockwise
    kodo::Real tiltSpeed = 0; // rad/s
    kodo::Real lift = 0;      // m, upwards; mostly negative: blows push it down
    kodo::Real liftSpeed = 0; // m/s
};

constexpr bool tilts(PaddleKind kind) {
    return kind == PaddleKind::Tilting || kind == PaddleKind::Loose;
}
constexpr bool recoils(PaddleKind kind) {
    return kind == PaddleKind::Recoiling || kind == PaddleKind::Loose;
}

/// One tick later. What the kind does not allow is gone at once.
Sway swayed(Sway sway, PaddleKind kind);
/// After an impulse (N s) at `arm` from the centre of mass of a paddle.
Sway pushed(Sway sway, PaddleKind kind, const kodo::Mass& paddle, kodo::Vec2 arm,
            kodo::Vec2 impulse);

} // namespace apart
