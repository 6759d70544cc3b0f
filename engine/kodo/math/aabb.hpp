// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/vec2.hpp>

#include <algorithm>
#include <span>

namespace kodo::inline KODO_PRECISION {

/// Axis-aligned box from its lower left to its upper right corner, both included.
template <std::floating_point T>
struct BasicAabb {
    BasicVec2<T> lower;
    BasicVec2<T> upper;

    constexpr BasicVec2<T> center() const { return T(0.5) * (lower + upper); }
    constexpr BasicVec2<T> extent() const { return upper - lower; }

    constexpr bool contains(BasicVec2<T> p) const {
        return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y;
    }
    constexpr bool contains(const BasicAabb& other) const {
        return lower.x <= other.lower.x && lower.y <= other.lower.y && other.upper.x <= upper.x &&
               other.upper.y <= upper.y;
    }
    /// Grown by a margin on every side.
    constexpr BasicAabb grown(T margin) const {
        return {{lower.x - margin, lower.y - margin}, {upper.x + margin, upper.y + margin}};
    }
    friend constexpr bool operator==(const BasicAabb&, const BasicAabb&) = default;
};

using Aabb = BasicAabb<Real>;

/// Touching counts.
template <std::floating_point T>
constexpr bool overlap(const BasicAabb<T>& a, const BasicAabb<T>& b) {
    // which of the four fails is hard to foresee, so none of them is left out
    return (a.lower.x <= b.upper.x) & (b.lower.x <= a.upper.x) & (a.lower.y <= b.upper.y) &
           (b.lower.y <= a.upper.y);
}

/// The smallest that holds both.
template <std::floating_point T>
constexpr BasicAabb<T> unite(const BasicAabb<T>& a, const BasicAabb<T>& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

/// The smallest that holds all of at least one point.
template <std::floating_point T>
constexpr BasicAabb<T> aabbOf(std::span<const BasicVec2<T>> points) {
    BasicAabb<T> box{points[0], points[0]};
    for (const BasicVec2<T> p : points.subspan(1)) {
        box = unite(box, {p, p});
    }
    return box;
}

} // namespace kodo::inline KODO_PRECISION
