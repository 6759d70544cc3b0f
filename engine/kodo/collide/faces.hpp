// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collide/manifold.hpp>
#include <kodo/collide/sat.hpp>

namespace kodo::inline KODO_PRECISION {

/// The edge at `vertex` of b that faces a normal, seen from b, most directly.
std::size_t incidentEdge(const Convex& b, std::size_t vertex, Vec2 normalInB);

/// What a face does when nothing of the other outline lies above it: the deepest corner alone tells
/// how near they are, or it leaves the contact to its neighbours.
enum class BeyondEnds : std::uint8_t { DeepestCorner, Nothing };

/// An outline and where it is.
struct Placed {
    const Convex& shape;
    const Transform& at;
};

/// Face of a against the facing edge of b; `ab` is b as seen from a. Only what lies above the face
/// counts: a corner that has come out on the far side is no second point [Thesis06, fig. 3.5].
Manifold clipAgainstFace(Placed a, Placed b, const Transform& ab, const FaceAxis& axis, Real margin,
                         BeyondEnds beyond = BeyondEnds::DeepestCorner);
/// The same with the face on b, whose features are told apart from those of a; `ba` is a as seen
/// from b.
Manifold clipAgainstFaceOfB(Placed a, Placed b, const Transform& ba, const FaceAxis& axis,
                            Real margin, BeyondEnds beyond = BeyondEnds::DeepestCorner);

/// Outlines with faces: polygons, and lines from both sides.
Manifold collideFaces(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                      const Transform& b, Real margin, Real preference);

/// Two lines on nearly the same straight line are kept apart by an end alone, which no face shows.
/// How far b lies beyond the nearer end of a; `axis` leads out of that end, in a's frame.
struct EndAxis {
    Vec2 axis;
    Real separation = 0; // m
    std::size_t end = 0; // vertex of a
};
EndAxis beyondEnd(const Convex& a, const Convex& b, const Transform& ab);

} // namespace kodo::inline KODO_PRECISION
