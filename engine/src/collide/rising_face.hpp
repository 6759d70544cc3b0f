// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>
#include <kodo/geometry.hpp>

#include "collide/manifold.hpp"
#include "collide/one_sided.hpp"

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// A face of ground that carries a shape.
struct CarryingFace {
    Vec2 normal; // unit, world, out of the ground
    Vec2 point;  // m, world: on the face
    Real slop;   // m
    Real margin; // m, as of collide()
    Real way;    // m, by which the shape may move along it in the step
};

/// For a shape that moves along a face towards a piece of ground that rises from it: where both
/// meet, the piece has a vertex at the face. Nearest to the shape is that vertex, or a side below
/// the face, and a contact there would throw the shape back or up. This is its contact with the
/// face that rises from the vertex instead, as if that face went on below the other one. So the
/// shape turns where it touches both, and loses only v sin(bend).
///
/// `found`: contact of the piece (body a) with the shape (body b). Empty unless all of its points
/// are at such a vertex; if it has none, the face must rise gently, as tiles ahead do, in reach.
/// Without a point if the shape is farther than the margin from the face.
std::optional<Manifold> contactWithRisingFace(const ConvexShape& ground, const Transform& a,
                                              const ConvexShape& other, const Transform& b,
                                              const Manifold& found, const CarryingFace& carrying);

} // namespace KODO_PRECISION
} // namespace kodo
