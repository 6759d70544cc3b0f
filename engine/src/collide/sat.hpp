// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// The face of a polygon with the largest separation from another polygon.
struct FaceAxis {
    std::size_t face = 0;
    Real separation = 0; // m; > 0: a gap along that normal, <= 0: minus the overlap
};

/// Result of hill climbing, and the number of vertices compared.
struct Climb {
    std::size_t vertex = 0;
    int steps = 0;
};

/// The support vertex: farthest along a direction (in the polygon's frame). Hill climbing from
/// `start` [Thesis06, 3.2.3]; on a convex shape a local maximum is global. Ties keep the vertex
/// reached first.
Climb climbToSupport(const ConvexShape& convex, Vec2 direction, std::size_t start);

inline std::size_t supportVertex(const ConvexShape& convex, Vec2 direction, std::size_t start) {
    return climbToSupport(convex, direction, start).vertex;
}

/// Separating axis test of the faces of `a` against the vertices of `b`; `ab`: pose of b in the
/// frame of a.
///
///   s_i = min_j dot(n_i, b_j - a_i),   result = max_i s_i          [Ericson05, 5.2.1]
///
/// s_i > margin for any i proves a larger distance than that. Faces are tested in groups; the
/// search ends after a group with such an i. Ties keep the lower index, so that the face of a box
/// at rest does not alternate between steps.
FaceAxis leastPenetratingFace(const ConvexShape& a, const ConvexShape& b, const Transform& ab,
                              Real margin);

} // namespace KODO_PRECISION
} // namespace kodo
