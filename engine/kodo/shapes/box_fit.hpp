// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/shape.hpp>

#include <span>
#include <variant>

namespace kodo::inline KODO_PRECISION {

/// The box of the smallest area around points in any order, or why they have no hull.
///
/// One edge of the hull lies on a side of that box [Freeman75], so each edge is tried in turn: the
/// true optimum, in a time that grows with the square of the corners. Ties go to the first edge.
std::variant<Box, Problem> fitBox(std::span<const Vec2> points);

/// A polygon made ready for many tests [Thesis06, 3.2.3]: turned so that its bounds are as small as
/// they can be while it is not turned any further, with its sharpest corner first, which is most
/// often the extreme one and where climbing starts.
struct Arranged {
    Polygon polygon;
    Rot back; // turns its corners back to where they were
};

/// Of a valid polygon.
Arranged arrange(const Polygon& polygon);

} // namespace kodo::inline KODO_PRECISION
