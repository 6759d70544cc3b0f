// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <span>

namespace apart {

/// What keeps a ball in play. All are functions of what is seen, so the rule is tested without a
/// game.

/// Velocity of a ball in free flight after one tick of the speed servo: moved towards `target`
/// along where it flies, so its path stays a straight line. Inside the band nothing is changed. A
/// ball that stands still sets off along `heading`, a unit vector.
kodo::Vec2 held(kodo::Vec2 velocity, kodo::Vec2 heading, kodo::Real target);

/// Velocity of a ball that flew along `heading` and has just met rubble with these normals (unit,
/// towards the ball). Rubble that lies on something is as hard as that but swallows the bounce; a
/// ball that lost most of its speed to it leaves as off a wall, at the speed `target`.
kodo::Vec2 throwOff(kodo::Vec2 velocity, kodo::Vec2 heading, std::span<const kodo::Vec2> normals,
                    kodo::Real target);

/// Velocity of a ball that has just bounced off surfaces with these normals (unit, towards the
/// ball): out of the cone around the horizontal by the smallest turn, at the same speed. A turn
/// into a surface is not made.
kodo::Vec2 turnedFromFlat(kodo::Vec2 velocity, std::span<const kodo::Vec2> normals);

} // namespace apart
