// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/aabb.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Bounds in four columns, so that a box is compared with several of them at once and without a
/// branch: whether two bounds overlap is hardly ever foreseen by the processor.
class PackedBounds {
public:
    void reserve(std::size_t count);
    void resize(std::size_t count);
    void set(std::size_t i, const Aabb& box) {
        lowerX_[i] = box.lower.x;
        lowerY_[i] = box.lower.y;
        upperX_[i] = box.upper.x;
        upperY_[i] = box.upper.y;
    }
    /// From now on they overlap nothing.
    void hide(std::size_t i) {
        constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
        set(i, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
    }

    /// Calls meet(i) for all places from `first` on, before `last`, whose bounds overlap the box
    /// and for which isMet(i) is true.
    template <typename IsMet, typename Meet>
    void forEachOverlap(const Aabb& box, std::uint32_t first, std::uint32_t last, IsMet isMet,
                        Meet meet) const {
        for (; first < last; first += kMostHits) {
            Hits hits;
            const std::size_t found = find(box, first, std::min(last, first + kMostHits), hits);
            std::size_t count = 0;
            for (std::size_t k = 0; k < found; ++k) {
                hits[count] = hits[k];
                count += isMet(hits[k]) ? 1 : 0;
            }
            for (std::size_t k = 0; k < count; ++k) {
                meet(hits[k]);
            }
        }
    }

private:
    static constexpr std::uint32_t kMostHits = 64;
    using Hits = std::array<std::uint32_t, kMostHits>;

    /// Writes the places of those that overlap the box, and tells how many.
    std::size_t find(const Aabb& box, std::uint32_t first, std::uint32_t last, Hits& hits) const;

    // Each with some more behind the last, which may be read.
    std::vector<Real> lowerX_;
    std::vector<Real> lowerY_;
    std::vector<Real> upperX_;
    std::vector<Real> upperY_;
};

} // namespace kodo::inline KODO_PRECISION
