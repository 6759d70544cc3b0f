// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/math.hpp>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

// Shapes of bodies: plain values in the frame of the body (m). World::add() checks them; check()
// gives the same answer before.

/// Largest length and coordinate of a shape (m), for any length unit, so that no product overflows.
/// A World also refuses lengths above kMaxCoordinate times its length unit.
inline constexpr Real kMaxLength = sizeof(Real) == 4 ? Real(1e11) : Real(1e19);

/// A solid disc.
template <std::floating_point T>
struct BasicCircle {
    T radius{};            // m, > 0
    BasicVec2<T> center{}; // m
    friend bool operator==(const BasicCircle&, const BasicCircle&) = default;
};

/// A solid rectangle with its full width and height. The Obb of the thesis (3.1.3).
template <std::floating_point T>
struct BasicBox {
    T width{};              // m, > 0
    T height{};             // m, > 0
    BasicVec2<T> center{};  // m
    BasicRot<T> rotation{}; // of the width axis, against x
    friend bool operator==(const BasicBox&, const BasicBox&) = default;
};

/// A solid, strictly convex polygon. convexHull() makes one of any points.
template <std::floating_point T>
struct BasicPolygon {
    std::vector<BasicVec2<T>> corners{}; // m, counter-clockwise, 3 to kMaxCorners
    friend bool operator==(const BasicPolygon&, const BasicPolygon&) = default;
};
/// Largest number of corners of a polygon.
inline constexpr std::size_t kMaxCorners = 1024;
/// A corner must lie farther from the line of each edge than this share of its distance. Below, its
/// place in the order around the polygon would depend on rounding.
inline constexpr Real kFlatness = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-10);

/// A particle: no size, no moment of inertia. Its mass (kg) is the number given as density.
template <std::floating_point T>
struct BasicPoint {
    BasicVec2<T> position{}; // m
    friend bool operator==(const BasicPoint&, const BasicPoint&) = default;
};

/// A line segment without thickness. The Line of the thesis (3.1.4). The number given as density is
/// its mass per length (kg/m).
///
/// A one-sided segment collides only with bodies that come from its front: the left side as seen
/// from `from` towards `to`. Bodies from behind and from beyond an end pass. `before` and `after`
/// name the outer ends of the adjacent segments, which prevents ghost collisions at the joins.
template <std::floating_point T>
struct BasicSegment {
    BasicVec2<T> from{}; // m
    BasicVec2<T> to{};   // m
    bool oneSided = false;
    std::optional<BasicVec2<T>> before{}; // m; start of the segment before; one-sided only
    std::optional<BasicVec2<T>> after{};  // m; end of the segment after; one-sided only
    friend bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

/// A half-plane: all points p with dot(normal, p) <= offset. Only for static and kinematic bodies.
template <std::floating_point T>
struct BasicPlane {
    BasicVec2<T> normal{0, 1}; // unit, out of the solid side
    T offset{};                // m, from the origin to the surface, along the normal
    friend bool operator==(const BasicPlane&, const BasicPlane&) = default;
};

/// Terrain: segments between the points origin + (i spacing, heights[i]), one-sided with the front
/// up. Each segment is a part of the body. Only for static and kinematic bodies.
template <std::floating_point T>
struct BasicHeightmap {
    BasicVec2<T> origin{};    // m; x of the first point, and zero of the heights
    T spacing{};              // m, > 0, between two points
    std::vector<T> heights{}; // m, 2 to kMaxHeights
    friend bool operator==(const BasicHeightmap&, const BasicHeightmap&) = default;
};
/// Largest number of heights of a heightmap.
inline constexpr std::size_t kMaxHeights = 65536;

using Circle = BasicCircle<Real>;
using Box = BasicBox<Real>;
using Polygon = BasicPolygon<Real>;
using Point = BasicPoint<Real>;
using Segment = BasicSegment<Real>;
using Plane = BasicPlane<Real>;
using Heightmap = BasicHeightmap<Real>;

/// A convex shape: what one part of a body is.
using Primitive = std::variant<Circle, Box, Polygon, Point, Segment, Plane>;

/// Several primitives as one rigid body, for shapes that are not convex. Where parts overlap, their
/// masses add.
struct Compound {
    std::vector<Primitive> parts{}; // 1 to kMaxParts
    friend bool operator==(const Compound&, const Compound&) = default;
};
/// Largest number of parts of a body, also after World::weld().
inline constexpr std::size_t kMaxParts = 65535;

/// The shape of a body.
using Shape = std::variant<Circle, Box, Polygon, Compound, Point, Segment, Plane, Heightmap>;

/// The reason why World::add() would refuse a shape. Fields read "radius", "corners[3]",
/// "parts[1].width".
KODO_API std::optional<Problem> check(const Primitive& primitive);
KODO_API std::optional<Problem> check(const Shape& shape);
/// The same for the result of moved(), whose corners may be rounded onto a line.
KODO_API std::optional<Problem> checkMoved(const Primitive& primitive);

/// The primitives of a valid shape: the shape itself, the parts of a compound, or the segments of a
/// heightmap from left to right.
KODO_API std::vector<Primitive> primitivesOf(const Shape& shape);

/// A primitive as the shape of a body.
KODO_API Shape shapeOf(const Primitive& primitive);

/// True if the shape has no mass (plane, heightmap), so that its body must be static or kinematic.
KODO_API bool needsLock(const Primitive& primitive);
KODO_API bool needsLock(const Shape& shape);

/// The primitive in another frame. `transform` takes points of the present frame to the new one.
KODO_API Primitive moved(const Primitive& primitive, const Transform& transform);

} // namespace KODO_PRECISION
} // namespace kodo
