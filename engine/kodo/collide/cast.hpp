// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/convex.hpp>
#include <kodo/shapes/ray.hpp>

#include <optional>

namespace kodo::inline KODO_PRECISION {

/// Where a ray (in the world) first meets an outline placed at t. It may start inside: fraction 0
/// and no normal. One-sided lines are met from their front alone.
std::optional<RayHit> rayCast(const Convex& shape, const Transform& t, const Ray& ray);

/// Where an outline that moves straight on, without turning, first meets another.
struct CastHit {
    Real fraction = 0; // 0..1 of the move
    Vec2 normal;       // unit, world, from what was met to what moved; zero if they overlap already
    Vec2 point;        // m, world, where they meet
};

/// A closed form for every pair: the ray of a centre against an outline with a skin, or the largest
/// fraction at which a side of either stops to separate the two. Touching counts. A one-sided line
/// is met from its front alone, by what does not overlap it from the start.
std::optional<CastHit> shapeCast(const Convex& moving, const Transform& from, Vec2 move,
                                 const Convex& target, const Transform& t);

} // namespace kodo::inline KODO_PRECISION
