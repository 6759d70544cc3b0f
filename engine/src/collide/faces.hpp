// SPDX-License-Identifier: MIT
#pragma once

#include "collide/core_gap.hpp"
#include "collide/manifold.hpp"
#include "collide/sat.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The edge at `vertex` of b most antiparallel to a normal (in b's frame).
std::size_t incidentEdge(const ConvexShape& b, std::size_t vertex, Vec2 normalInB);

/// Result of a face when clipping leaves nothing of the other shape within the margin: its deepest
/// corner as contact point, or an empty manifold, so that a neighbour provides the contact.
enum class BeyondEnds : std::uint8_t { DeepestCorner, Nothing };

/// A shape and its pose.
struct Placed {
    const ConvexShape& shape;
    const Transform& at;
};

/// Clips the incident edge of b against a face of a; `ab`: pose of b in the frame of a. Only points
/// above the face count: a corner that has come out on the far side is not a second point
/// [Thesis06, fig. 3.5].
Manifold clipAgainstFace(Placed a, Placed b, const Transform& ab, const FaceAxis& axis, Real margin,
                         BeyondEnds beyond = BeyondEnds::DeepestCorner);
/// The same with the face on b. Its features differ from those of a. `ba`: pose of a in the frame
/// of b.
Manifold clipAgainstFaceOfB(Placed a, Placed b, const Transform& ba, const FaceAxis& axis,
                            Real margin, BeyondEnds beyond = BeyondEnds::DeepestCorner);

/// True if the contact over a gap is between two corners. Faces that are nearly parallel remain in
/// contact as faces where the gap is between their ends: its normal is then between theirs, which
/// are given in the frame of the gap.
bool isOfCorners(const CoreGap& gap, Placed a, Placed b, Vec2 faceA, Vec2 faceB);
/// Two corners, rounded by the radii of their shapes, and circles. In the directions of the world:
/// swapped shapes give the opposite bits.
Manifold collideCorners(Placed a, std::size_t vertexA, Placed b, std::size_t vertexB, Real margin);

/// Shapes with faces: polygons and two-sided lines.
Manifold collideFaces(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                      const Transform& b, Real margin, Real preference);

} // namespace KODO_PRECISION
} // namespace kodo
