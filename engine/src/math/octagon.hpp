// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>
#include <kodo/real.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Bounds along four directions instead of two: an octagon with fixed normals, the 8-DOP of
/// [Klosowski98]. A slanted shape or path fills half of its box but nearly all of its octagon. In a
/// heap of boxes, octagons reject half of the pairs whose boxes overlap.
///
/// Diagonal coordinates are sqrt(2) times a length in metres, which saves divisions.
struct alignas(4 * sizeof(Real)) Octagon {
    using Each = Real __attribute__((vector_size(4 * sizeof(Real))));

    Each lower; // m; least and largest x, y, x + y and y - x, edges included
    Each upper;

    Aabb box() const { return {{lower[0], lower[1]}, {upper[0], upper[1]}}; }

    /// Grown by a margin (m) on every side.
    Octagon grown(Real margin) const {
        const Real slant = Real(1.4142137) * margin; // rounded up from sqrt(2)
        const Each by{margin, margin, slant, slant};
        return {lower - by, upper + by};
    }
    Octagon moved(Vec2 by) const {
        const Each along{by.x, by.y, by.x + by.y, by.y - by.x};
        return {lower + along, upper + along};
    }
    bool contains(const Octagon& other) const {
        return areAll((lower <= other.lower) & (other.upper <= upper));
    }
    /// Touching counts as overlap.
    friend bool overlap(const Octagon& a, const Octagon& b) {
        return areAll((a.lower <= b.upper) & (b.lower <= a.upper));
    }
    /// The smallest octagon that contains both.
    friend Octagon unite(const Octagon& a, const Octagon& b) {
        return {a.lower < b.lower ? a.lower : b.lower, a.upper > b.upper ? a.upper : b.upper};
    }

    /// Octagon of a disc.
    static Octagon of(Vec2 center, Real radius) {
        const Real slack = roundingAt(center);
        const Each middle{center.x, center.y, center.x + center.y, center.y - center.x};
        const Each rounding{0, 0, slack, slack};
        return Octagon{middle - rounding, middle + rounding}.grown(radius);
    }
    /// Octagon of at least one point.
    static Octagon of(std::span<const Vec2> points, const Transform& t) {
        const auto [c, s] = t.rotation;
        const Vec2 p = t.position;
        const Each alongX{c, s, c + s, s - c};
        const Each alongY{-s, c, c - s, c + s};
        const Each origin{p.x, p.y, p.x + p.y, p.y - p.x};
        const Real slack = roundingAt(p);
        const Each rounding{0, 0, slack, slack};
        Each lower = alongX * points[0].x + alongY * points[0].y + origin;
        Each upper = lower;
        for (const Vec2 point : points.subspan(1)) {
            const Each at = alongX * point.x + alongY * point.y + origin;
            lower = at < lower ? at : lower;
            upper = at > upper ? at : upper;
        }
        return {lower - rounding, upper + rounding};
    }
    /// The smallest octagon around a box, no tighter than the box.
    static Octagon of(const Aabb& box) {
        const auto [left, bottom] = box.lower;
        const auto [right, top] = box.upper;
        const Each lower{left, bottom, left + bottom, bottom - right};
        const Each upper{right, top, right + top, top - left};
        return {lower, upper};
    }

private:
    /// m; rounding error of a sum of coordinates. As with boxes, rounding of the shape itself is
    /// covered by the caller's margin.
    static Real roundingAt(Vec2 p) {
        return 2 * std::numeric_limits<Real>::epsilon() * (std::abs(p.x) + std::abs(p.y));
    }
    template <typename Mask>
    static bool areAll(const Mask& mask) {
        std::uint64_t words[sizeof mask / sizeof(std::uint64_t)];
        std::memcpy(words, &mask, sizeof mask);
        std::uint64_t all = words[0];
        for (const std::uint64_t word : words) {
            all &= word;
        }
        return all == ~std::uint64_t{};
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
