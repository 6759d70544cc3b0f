// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// The face of one polygon that comes nearest to separating it from another.
struct FaceAxis {
    std::size_t face = 0;
    Real separation = 0; // m; > 0: a gap along that normal, <= 0: minus the overlap
};

/// Where climbing ended, and how many vertices it compared on the way.
struct Climb {
    std::size_t vertex = 0;
    int steps = 0;
};

/// The vertex farthest along a direction (in the polygon's frame). Climbs from `start` along the
/// outline while it rises [Thesis06, 3.2.3]; a convex outline has no other summit. Ties keep the
/// vertex reached first.
Climb climbToSupport(const Convex& convex, Vec2 direction, std::size_t start);

inline std::size_t supportVertex(const Convex& convex, Vec2 direction, std::size_t start) {
    return climbToSupport(convex, direction, start).vertex;
}

/// Faces of `a` against the vertices of `b`; `ab` is b as seen from a.
///
///   s_i = min_j dot(n_i, b_j - a_i),   result = max_i s_i          [Ericson05, 5.2.1]
///
/// s_i > margin for any i proves the polygons farther apart than that. Faces are looked at some at
/// a time, and none after those among which such an i is. Ties keep the lower index: a box at rest
/// must not swap its face from one step to the next.
FaceAxis leastPenetratingFace(const Convex& a, const Convex& b, const Transform& ab, Real margin);

} // namespace kodo::inline KODO_PRECISION
