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

template <std::floating_point T>
struct BasicCircle {
    T radius{};
    BasicVec2<T> center{};
    friend bool operator==(const BasicCircle&, const BasicCircle&) = default;
};

/// A rectangle by its full width and height; the Obb of the thesis (3.1.3).
template <std::floating_point T>
struct BasicBox {
    T width{};
    T height{};
    BasicVec2<T> center{};
    BasicRot<T> rotation{};
    friend bool operator==(const BasicBox&, const BasicBox&) = default;
};

/// Convex, corners counter-clockwise, at most kMaxCorners of them.
template <std::floating_point T>
struct BasicPolygon {
    std::vector<BasicVec2<T>> corners;
    friend bool operator==(const BasicPolygon&, const BasicPolygon&) = default;
};
inline constexpr std::size_t kMaxCorners = 1024;

using Circle = BasicCircle<Real>;
using Box = BasicBox<Real>;
using Polygon = BasicPolygon<Real>;

using Primitive = std::variant<Circle, Box, Polygon>;

/// Several primitives that move as one, to make what is not convex. Parts may overlap; where they
/// do, their masses add.
struct Compound {
    std::vector<Primitive> parts;
    friend bool operator==(const Compound&, const Compound&) = default;
};

using Shape = std::variant<Circle, Box, Polygon, Compound>;

/// What is wrong with a shape, or nothing. Fields read "radius", "corners[3]", "parts[1].width".
std::optional<Problem> check(const Primitive& primitive);
std::optional<Problem> check(const Shape& shape);

} // namespace kodo::inline KODO_PRECISION
