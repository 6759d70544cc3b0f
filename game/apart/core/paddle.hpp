// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

namespace apart {

/// Shape of the bare paddle: a dome on a foot that narrows downwards, so that a ball at its side is
/// pushed down and out. The origin is the middle of its widest line.
kodo::Polygon paddleShape();

/// Height (m) of the dome above that line at x (m) from its middle; 0 beyond the rim.
kodo::Real domeHeight(kodo::Real x);

/// Speed of the paddle (m/s) after one tick. The force of the motor limits the acceleration, its
/// energy limits the speed; both limits fall with the mass (kg).
kodo::Real drivenSpeed(const Input& input, kodo::Real x, kodo::Real speed, kodo::Real mass);

/// Displacement of a paddle on springs from its place on the carriage.
struct Sway {
    kodo::Real tilt = 0;      // rad, counter-clockwise
    kodo::Real tiltSpeed = 0; // rad/s
    kodo::Real lift = 0;      // m, upwards; mostly negative: impacts push it down
    kodo::Real liftSpeed = 0; // m/s
};

constexpr bool tilts(PaddleKind kind) {
    return kind == PaddleKind::Tilting || kind == PaddleKind::Loose;
}
constexpr bool recoils(PaddleKind kind) {
    return kind == PaddleKind::Recoiling || kind == PaddleKind::Loose;
}

/// State after one tick. Displacements that the kind does not have are 0.
Sway swayed(Sway sway, PaddleKind kind);
/// State after an impulse (N s) at `arm` (m) from the centre of mass of the paddle.
Sway pushed(Sway sway, PaddleKind kind, const kodo::Mass& paddle, kodo::Vec2 arm,
            kodo::Vec2 impulse);

} // namespace apart
