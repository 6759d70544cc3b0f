// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>
#include <kodo/shape.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// Why the bounds in a tree stay where they are, or do not.
enum class Rest : std::uint8_t { Static, Asleep, Moving };
inline constexpr std::size_t kRests = 3;

/// Half the perimeter (m): proportional to the share of random searches that reach the box.
inline Real halfPerimeter(const Aabb& box) {
    const Vec2 extent = box.extent();
    return extent.x + extent.y;
}

template <typename Visit>
void forEachBit(std::uint32_t bits, Visit visit) {
    for (; bits != 0; bits &= bits - 1) {
        visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
}

/// A node of BoundsTrees: up to eight boxes, compared at once, and their children. Empty places
/// overlap nothing.
struct BoundsNode {
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    static constexpr std::uint32_t kWidth = 8; // boxes in a node
    static constexpr std::uint32_t kAll = (1u << kWidth) - 1;

    BoundsNode() {
        lowerX.fill(kFar);
        lowerY.fill(kFar);
        upperX.fill(-kFar);
        upperY.fill(-kFar);
    }

    Aabb boxOf(std::uint32_t i) const { return {{lowerX[i], lowerY[i]}, {upperX[i], upperY[i]}}; }
    void setBox(std::uint32_t i, const Aabb& box) {
        lowerX[i] = box.lower.x;
        lowerY[i] = box.lower.y;
        upperX[i] = box.upper.x;
        upperY[i] = box.upper.y;
    }
    void clearBox(std::uint32_t i) { setBox(i, {{kFar, kFar}, {-kFar, -kFar}}); }

    /// One bit for each child whose box overlaps this one, edges included.
    std::uint32_t reached(const Aabb& box) const {
        const auto hits = [&](std::uint32_t first) {
            return (load(lowerX, first) <= box.upper.x) & (load(lowerY, first) <= box.upper.y) &
                   (load(upperX, first) >= box.lower.x) & (load(upperY, first) >= box.lower.y);
        };
        const Bits bits = (hits(0) & Bits{1, 2, 4, 8}) | (hits(4) & Bits{16, 32, 64, 128});
        return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
    }
    /// Union of the boxes.
    Aabb box() const {
        const auto least = [](const std::array<Real, kWidth>& of) {
            const Half a = load(of, 0);
            const Half b = load(of, 4);
            const Half all = a < b ? a : b;
            return std::min(std::min(all[0], all[1]), std::min(all[2], all[3]));
        };
        const auto most = [](const std::array<Real, kWidth>& of) {
            const Half a = load(of, 0);
            const Half b = load(of, 4);
            const Half all = a > b ? a : b;
            return std::max(std::max(all[0], all[1]), std::max(all[2], all[3]));
        };
        return {{least(lowerX), least(lowerY)}, {most(upperX), most(upperY)}};
    }

    std::array<Real, kWidth> lowerX; // m
    std::array<Real, kWidth> lowerY;
    std::array<Real, kWidth> upperX;
    std::array<Real, kWidth> upperY;
    std::array<std::uint32_t, kWidth> child{}; // node; on level 0: leaf
    std::uint32_t parent = kNone;              // kWidth times the node above, plus the place in it
    std::uint8_t count = 0;
    std::uint8_t level = 0;
    std::uint8_t marks = 0; // one bit for each child: marked, or above a marked leaf
    Rest rest = Rest::Static;

private:
    using Half = Real __attribute__((vector_size(kWidth / 2 * sizeof(Real))));
    using Bits = decltype(Half{} < Half{});
    static constexpr Real kFar = std::numeric_limits<Real>::infinity();

    static Half load(const std::array<Real, kWidth>& from, std::uint32_t first) {
        Half half;
        std::memcpy(&half, &from[first], sizeof half);
        return half;
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
