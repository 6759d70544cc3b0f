// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/material.hpp>
#include <kodo/math.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

// Shapes of bodies: plain values in the frame of the body (m). World::add() checks them; check()
// gives the same answer before.
//
// A `radius` rounds a box, polygon or segment: the shape is then all points within the radius of
// it. It adds to the outside: a box with a radius is `width` + 2 `radius` wide.

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

/// A solid disc that is drawn along a line: all points within `radius` of it. One of length 0 is a
/// disc.
template <std::floating_point T>
struct BasicCapsule {
    BasicVec2<T> from{}; // m, centre of one end
    BasicVec2<T> to{};   // m, centre of the other
    T radius{};          // m, > 0
    friend bool operator==(const BasicCapsule&, const BasicCapsule&) = default;
};

/// A solid rectangle with its full width and height. The Obb of the thesis (3.1.3).
template <std::floating_point T>
struct BasicBox {
    T width{};              // m, > 0; without the radius
    T height{};             // m, > 0; without the radius
    BasicVec2<T> center{};  // m
    BasicRot<T> rotation{}; // of the width axis, against x
    T radius{};             // m, >= 0, around the rectangle
    friend bool operator==(const BasicBox&, const BasicBox&) = default;
};

/// A solid, strictly convex polygon. convexHull() makes one of any points.
template <std::floating_point T>
struct BasicPolygon {
    std::vector<BasicVec2<T>> corners{}; // m, counter-clockwise, 3 to kMaxCorners
    T radius{};                          // m, >= 0, around the outline of the corners
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

/// A line segment. The Line of the thesis (3.1.4). The number given as density is its mass per
/// length (kg/m).
///
/// A radius makes it a thick line with round ends, as solid as a Capsule: it then has an area, and
/// its density is in kg/m^2, as for all shapes with an area. Only a two-sided segment has one.
///
/// A one-sided segment collides only with bodies that come from its front: the left side as seen
/// from `from` towards `to`. Bodies from behind and from beyond an end pass.
///
/// Segments of one body that share an end point, to the bit, are linked: bodies move from one to
/// the next as over one surface. Of one-sided segments, one ends where the next begins; where
/// several begin, the one that bends most to the front is next. Two-sided segments are linked where
/// two of them meet, but not where three or more do.
template <std::floating_point T>
struct BasicSegment {
    BasicVec2<T> from{}; // m
    BasicVec2<T> to{};   // m
    bool oneSided = false;
    T radius{}; // m, >= 0; two-sided only
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
/// up. Each segment is a part of the body. World::add() takes it for static and kinematic bodies
/// alone. The segments have mass like any others, so setType() and weld() may make them dynamic.
template <std::floating_point T>
struct BasicHeightmap {
    BasicVec2<T> origin{};    // m; x of the first point, and zero of the heights
    T spacing{};              // m, > 0, between two points
    std::vector<T> heights{}; // m, 2 to kMaxHeights
    friend bool operator==(const BasicHeightmap&, const BasicHeightmap&) = default;
};
/// Largest number of heights of a heightmap.
inline constexpr std::size_t kMaxHeights = 65536;

/// Ground: linked segments from each point to the next. Each segment is a part of the body. The
/// number given as density is the mass per length (kg/m).
template <std::floating_point T>
struct BasicChain {
    std::vector<BasicVec2<T>> points{}; // m, 2 to kMaxParts + 1; closed: 3 to kMaxParts
    bool closed = false;                // the last point is joined to the first one
    /// Of an open chain, the front is the left side as seen along the points. Of a closed one it is
    /// the outside, in whichever direction the points go; edges that cross or touch are refused.
    bool oneSided = false;
    /// Of each segment; empty: that of the body. Segment i begins at point i.
    std::vector<Material> materials{};
    friend bool operator==(const BasicChain&, const BasicChain&) = default;
};

using Circle = BasicCircle<Real>;
using Capsule = BasicCapsule<Real>;
using Box = BasicBox<Real>;
using Polygon = BasicPolygon<Real>;
using Point = BasicPoint<Real>;
using Segment = BasicSegment<Real>;
using Plane = BasicPlane<Real>;
using Heightmap = BasicHeightmap<Real>;
using Chain = BasicChain<Real>;

/// A convex shape: what one part of a body is.
using Primitive = std::variant<Circle, Box, Polygon, Point, Segment, Plane, Capsule>;

/// Several primitives as one rigid body, for shapes that are not convex. Where parts overlap, their
/// masses add.
struct Compound {
    std::vector<Primitive> parts{}; // 1 to kMaxParts
    friend bool operator==(const Compound&, const Compound&) = default;
};
/// Largest number of parts of a body, also after World::weld().
inline constexpr std::size_t kMaxParts = 65535;

/// The shape of a body.
using Shape =
    std::variant<Circle, Box, Polygon, Compound, Point, Segment, Plane, Heightmap, Chain, Capsule>;

/// The reason why World::add() would refuse a shape. Fields read "radius", "corners[3]",
/// "parts[1].width".
KODO_API std::optional<Problem> check(const Primitive& primitive);
KODO_API std::optional<Problem> check(const Shape& shape);
/// The same for the result of moved(), whose corners may be rounded onto a line.
KODO_API std::optional<Problem> checkMoved(const Primitive& primitive);

/// The primitives of a valid shape: the shape itself, the parts of a compound, the segments of a
/// heightmap from left to right, or those of a chain in the order of its points. A Compound may
/// contain these segments, which are linked there too.
KODO_API std::vector<Primitive> primitivesOf(const Shape& shape);

/// A primitive as the shape of a body.
KODO_API Shape shapeOf(const Primitive& primitive);

/// True if World::add() takes the shape for static and kinematic bodies alone: a plane, which has
/// no mass, also in a compound, and a heightmap.
KODO_API bool needsLock(const Primitive& primitive);
KODO_API bool needsLock(const Shape& shape);

/// The primitive in another frame. `transform` takes points of the present frame to the new one.
KODO_API Primitive moved(const Primitive& primitive, const Transform& transform);

} // namespace KODO_PRECISION
} // namespace kodo
