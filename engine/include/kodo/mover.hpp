// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/query.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// A character that is moved by casts instead of forces. It walks on slopes, climbs steps, stays on
/// the ground over crests, and rides on moving bodies. A value: copy it with the World to go back
/// to both.
///
/// Each tick, call move() after World::step(): what the mover stands on has moved then. All lengths
/// fit a World whose length unit is 1 m. It keeps a gap of `skin` from everything, so it slides
/// over flush tiles. It passes one-sided segments from behind; to drop through one, change `which`.
struct KODO_API Mover {
    Primitive shape = Capsule{{0, Real(-0.4)}, {0, Real(0.4)}, Real(0.3)}; // never turns; no plane
    Vec2 position{};             // m, world: of the shape's frame; set it to teleport
    Vec2 up{0, 1};               // unit
    Real slopeLimit = Real(0.9); // rad, 0 to 1.5: steepest ground that it stands on
    Real stepHeight = Real(0.3); // m: of steps that it climbs, and descends without a fall
    Real skin = Real(0.01);      // m, > 0
    Real pushForce = 0;          // N: largest force on a dynamic body in its way
    Real weight = 0;             // N, on a dynamic body below it
    CollisionFilter which{};     // what blocks it; sensors never do
    /// A kinematic body that follows, so that others feel the mover; the null id: none. The mover
    /// itself ignores this body. It arrives with the next step, so it lags by one step.
    BodyId body{};

    // Results of the last move().

    /// m/s. On the ground: relative to the ground, and across `up`. In the air: in the world.
    Vec2 velocity{};
    /// On ground up to slopeLimit, or wedged between steeper slopes.
    bool grounded = false;
    Vec2 groundNormal{};    // unit, out of the ground; zero in the air
    BodyId groundBody{};    // the null id in the air
    Transform groundPose{}; // of groundBody then
    Vec2 wallNormal{};      // unit, out of what stopped it sideways; zero if nothing did

    /// Moves for dt (s) with a wished velocity (m/s), as `velocity` is meant. With a part along
    /// `up` the mover jumps, and takes the velocity of the ground with it. Else, on the ground, the
    /// part across `up` is the speed along the ground, on slopes too. Gravity may be added always.
    /// In the air and on steeper ground `wish` is the whole velocity: to slide or to keep flying,
    /// add what `velocity` has.
    ///
    /// Pushes and loads dynamic bodies, and moves `body`. Throws BadDefinition for a number out of
    /// range, a shape that check() refuses and a plane; nothing has changed then.
    void move(World& world, Vec2 wish, Real dt);
};

} // namespace KODO_PRECISION
} // namespace kodo
