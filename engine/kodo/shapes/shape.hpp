// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/problem.hpp>
#include <kodo/math/transform.hpp>

#include <optional>
#include <variant>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The shapes that a body can be made of, as plain descriptions in the body's own frame (m).
/// Nothing checks them until they reach a World; `check(shape)` says beforehand what it will say.

/// No length and no coordinate of a shape may be larger (m), whatever the length unit of the World:
/// the products of what follows from them must not overflow. A World takes none larger than its
/// kFarthest either.
inline constexpr Real kLargest = sizeof(Real) == 4 ? Real(1e11) : Real(1e19);

/// A disc.
template <std::floating_point T>
struct BasicCircle {
    T radius{};            // m, > 0
    BasicVec2<T> center{}; // m
    friend bool operator==(const BasicCircle&, const BasicCircle&) = default;
};

/// A rectangle by its full width and height; the Obb of the thesis (3.1.3).
template <std::floating_point T>
struct BasicBox {
    T width{};              // m, > 0
    T height{};             // m, > 0
    BasicVec2<T> center{};  // m
    BasicRot<T> rotation{}; // of its width against the x axis
    friend bool operator==(const BasicBox&, const BasicBox&) = default;
};

/// Convex, corners counter-clockwise, at most kMaxCorners of them.
template <std::floating_point T>
struct BasicPolygon {
    std::vector<BasicVec2<T>> corners; // m
    friend bool operator==(const BasicPolygon&, const BasicPolygon&) = default;
};
inline constexpr std::size_t kMaxCorners = 1024;
/// A corner closer to the line of an edge than this share of its distance is taken for a rounding
/// error: it would have no dependable place in the order around the polygon.
inline constexpr Real kFlatness = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-10);

/// A particle: no size, no moment of inertia, and a mass of `density` kg.
template <std::floating_point T>
struct BasicPoint {
    BasicVec2<T> position{}; // m
    friend bool operator==(const BasicPoint&, const BasicPoint&) = default;
};

/// A straight line between two points, without thickness; the Line of the thesis (3.1.4). Its mass
/// is `density` kg for each metre.
///
/// A one-sided one blocks only what comes from its front, the left hand on the way `from` -> `to`,
/// and lets pass what comes from behind or from beyond an end. It may name the points of the lines
/// that go on from its ends, `before` -> `from` and `to` -> `after`; then nothing catches on the
/// joints between them.
template <std::floating_point T>
struct BasicSegment {
    BasicVec2<T> from{}; // m, as all of them
    BasicVec2<T> to{};
    bool oneSided = false;
    std::optional<BasicVec2<T>> before{}; // of a one-sided one only
    std::optional<BasicVec2<T>> after{};
    friend bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

/// Half of everything: all points p with dot(normal, p) <= offset. Only for locked bodies.
template <std::floating_point T>
struct BasicPlane {
    BasicVec2<T> normal{0, 1}; // unit, out of the solid half
    T offset{};                // m, from the origin to the surface along the normal
    friend bool operator==(const BasicPlane&, const BasicPlane&) = default;
};

/// Ground: straight lines between the points origin + (i spacing, heights[i]), solid from above.
/// Each of its cells becomes a part of the body. Only for locked bodies.
template <std::floating_point T>
struct BasicHeightmap {
    BasicVec2<T> origin{};  // m; the first height is measured from here
    T spacing{};            // m, between two heights
    std::vector<T> heights; // m, at least two
    friend bool operator==(const BasicHeightmap&, const BasicHeightmap&) = default;
};
inline constexpr std::size_t kMaxHeights = 65536;

using Circle = BasicCircle<Real>;
using Box = BasicBox<Real>;
using Polygon = BasicPolygon<Real>;
using Point = BasicPoint<Real>;
using Segment = BasicSegment<Real>;
using Plane = BasicPlane<Real>;
using Heightmap = BasicHeightmap<Real>;

using Primitive = std::variant<Circle, Box, Polygon, Point, Segment, Plane>;

/// Several primitives that move as one, to make what is not convex. Parts may overlap; where they
/// do, their masses add.
struct Compound {
    std::vector<Primitive> parts; // at most kMaxParts
    friend bool operator==(const Compound&, const Compound&) = default;
};
inline constexpr std::size_t kMaxParts = 65535; // of one body, also when it is welded together

using Shape = std::variant<Circle, Box, Polygon, Compound, Point, Segment, Plane, Heightmap>;

/// What is wrong with a shape, or nothing. Fields read "radius", "corners[3]", "parts[1].width".
std::optional<Problem> check(const Primitive& primitive);
std::optional<Problem> check(const Shape& shape);
/// The same for one that was moved: its corners may have been rounded onto a line.
std::optional<Problem> checkMoved(const Primitive& primitive);

/// The primitives that a valid shape consists of: itself, the parts of a compound, or one
/// one-sided segment for each cell of a heightmap, from left to right.
std::vector<Primitive> primitivesOf(const Shape& shape);

/// Has it no end, or no mass of its own, so that only a locked body can be made of it?
bool needsLock(const Primitive& primitive);
bool needsLock(const Shape& shape);

/// The same primitive in another frame: `transform` takes the old one to the new.
Primitive moved(const Primitive& primitive, const Transform& transform);

} // namespace kodo::inline KODO_PRECISION
