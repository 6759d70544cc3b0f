// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/query.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// A blast that pushes the sides of bodies that it sees.
struct Explosion {
    Vec2 center{};           // m, world
    Real radius = 1;         // m, > 0: up to here at full strength
    Real falloff = 0;        // m, >= 0: from there on the strength falls to 0 over this distance
    Real impulse = 1;        // N s for each metre of a side, seen from the centre; < 0 pulls
    CollisionFilter which{}; // bodies that it pushes; all others but sensors are a cover too
};

/// A body that was pushed.
struct ExplosionHit {
    BodyId body{};
    Vec2 point{};   // m, world; the closest point that was reached
    Vec2 impulse{}; // N s
    Real width = 0; // m, across the rays: of what was reached
};

/// Pushes all dynamic bodies in reach, and lists them in the order of ids.
///
/// Each body is met by rays in the angle that it fills, seen from the centre. A ray that reaches it
/// first at distance d has the width d times the angle between two rays. It gives
///
///   strength(d) * impulse * width     (N s, along the ray, at the point that it reaches)
///
/// A body that contains the centre is neither pushed nor a cover. Throws BadDefinition for a number
/// out of range and for a bad filter; nothing has changed then.
KODO_API std::vector<ExplosionHit> explode(World& world, const Explosion& explosion);

} // namespace KODO_PRECISION
} // namespace kodo
