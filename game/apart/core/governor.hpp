// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <span>

namespace apart {

// Rules that keep a ball in play, as pure functions.

/// Velocity of a ball in free flight after one tick of the speed servo. The servo changes the speed
/// towards `target` (m/s) along the velocity, so the path stays straight. Within kServoBand nothing
/// changes. A ball below kHaltSpeed starts along `heading` (unit).
kodo::Vec2 servoVelocity(kodo::Vec2 velocity, kodo::Vec2 heading, kodo::Real target);

/// Velocity of a ball after a hit on rubble with these normals (unit, towards the ball). Resting
/// rubble absorbs the bounce. A ball slower than kSwallowed of `target` (m/s) therefore leaves as
/// off a wall: along the reflection of `heading` (unit), at the speed `target`.
kodo::Vec2 throwOff(kodo::Vec2 velocity, kodo::Vec2 heading, std::span<const kodo::Vec2> normals,
                    kodo::Real target);

/// Velocity of a ball after a bounce off surfaces with these normals (unit, towards the ball). The
/// smallest rotation, at constant speed, moves it out of the cone around the horizontal. A rotation
/// into a surface is not applied.
kodo::Vec2 turnedFromFlat(kodo::Vec2 velocity, std::span<const kodo::Vec2> normals);

} // namespace apart
