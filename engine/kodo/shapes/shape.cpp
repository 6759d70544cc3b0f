// SPDX-License-Identifier: MIT
#include <kodo/math/aabb.hpp>
#include <kodo/shapes/shape.hpp>

#include <cmath>
#include <string>

namespace kodo::inline KODO_PRECISION {
namespace {

// A corner closer to the line through its neighbours than this share of their distance is taken for
// a rounding error: its two edges would have no dependable order around the polygon.
constexpr Real kFlatness = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-10);

std::string corner(std::size_t i) {
    return "corners[" + std::to_string(i) + "]";
}

std::optional<Problem> checkLength(const char* field, Real value) {
    if (!std::isfinite(value) || value <= 0) {
        return Problem{field,
                       "must be a finite length greater than 0 m, but is " + std::to_string(value)};
    }
    return std::nullopt;
}

std::optional<Problem> checkPoint(const std::string& field, Vec2 point) {
    if (!isFinite(point)) {
        return Problem{field, "must be finite"};
    }
    return std::nullopt;
}

std::optional<Problem> check(const Circle& circle) {
    if (auto problem = checkPoint("center", circle.center)) {
        return problem;
    }
    return checkLength("radius", circle.radius);
}

std::optional<Problem> check(const Box& box) {
    if (auto problem = checkLength("width", box.width)) {
        return problem;
    }
    if (auto problem = checkLength("height", box.height)) {
        return problem;
    }
    const Real norm = box.rotation.c * box.rotation.c + box.rotation.s * box.rotation.s;
    if (!(std::abs(norm - 1) < Real(1e-3))) {
        return Problem{"rotation", "must be a unit vector (cos, sin)"};
    }
    return checkPoint("center", box.center);
}

/// The first corner that makes the outline not strictly convex and counter-clockwise.
std::optional<Problem> checkConvex(const std::vector<Vec2>& corners) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const Vec2 edge = corners[j] - corners[i];
        const Real size = length(edge);
        if (!(size > 0)) {
            return Problem{corner(j), "is the same point as corner " + std::to_string(i)};
        }
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i || k == j) {
                continue;
            }
            const Vec2 arm = corners[k] - corners[i];
            const Real height = cross(edge, arm) / size;
            if (!(height > kFlatness * std::max(size, length(arm)))) {
                return Problem{corner(k), "lies on or outside the line from corner " +
                                              std::to_string(i) + " to corner " +
                                              std::to_string(j) +
                                              "; corners must go counter-clockwise around a "
                                              "strictly convex outline"};
            }
        }
    }
    return std::nullopt;
}

std::optional<Problem> check(const Polygon& polygon) {
    const std::size_t n = polygon.corners.size();
    if (n < 3 || n > kMaxCorners) {
        return Problem{"corners", "must be 3 to " + std::to_string(kMaxCorners) + ", but are " +
                                      std::to_string(n)};
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (auto problem = checkPoint(corner(i), polygon.corners[i])) {
            return problem;
        }
    }
    return checkConvex(polygon.corners);
}

std::optional<Problem> check(const Compound& compound) {
    if (compound.parts.empty()) {
        return Problem{"parts", "must be at least one"};
    }
    for (std::size_t i = 0; i < compound.parts.size(); ++i) {
        if (auto problem = check(compound.parts[i])) {
            problem->field = "parts[" + std::to_string(i) + "]." + problem->field;
            return problem;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Problem> check(const Primitive& primitive) {
    return std::visit([](const auto& shape) { return check(shape); }, primitive);
}

std::optional<Problem> check(const Shape& shape) {
    return std::visit([](const auto& kind) { return check(kind); }, shape);
}

} // namespace kodo::inline KODO_PRECISION
