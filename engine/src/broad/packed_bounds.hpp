// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Bounds as structure of arrays, for SIMD comparison of a box with several bounds. Branchless,
/// since a branch on overlap mispredicts.
class PackedBounds {
    /// Number of bounds compared before the hits are inspected.
    static constexpr std::uint32_t kGroup = 16;

public:
    void reserve(std::size_t count);
    void resize(std::size_t count);
    void set(std::size_t i, const Aabb& box) {
        lowerX_[i] = box.lower.x;
        lowerY_[i] = box.lower.y;
        upperX_[i] = box.upper.x;
        upperY_[i] = box.upper.y;
    }
    /// From now on these bounds overlap nothing.
    void hide(std::size_t i) {
        constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
        set(i, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
    }

    /// Buffer of indices of bounds that overlap a box.
    class Hits {
    public:
        bool isFull() const { return count_ > kFull; }
        /// Calls meet(i) for each hit for which isMet(i) is true, and clears the buffer.
        template <typename IsMet, typename Meet>
        void meetAll(IsMet isMet, Meet meet) {
            std::size_t met = 0;
            for (std::size_t k = 0; k < count_; ++k) {
                const std::uint32_t place = places_[k];
                places_[met] = place;
                met += isMet(place) ? 1 : 0;
            }
            count_ = 0;
            for (std::size_t k = 0; k < met; ++k) {
                meet(places_[k]);
            }
        }

    private:
        friend class PackedBounds;
        static constexpr std::size_t kFull = 64; // beyond this number nothing is added

        std::size_t count_ = 0;
        std::array<std::uint32_t, kFull + kGroup> places_; // the last group may exceed kFull
    };

    /// Appends the indices in first..last whose bounds overlap the box, until the hits are full or
    /// all are compared. Returns the index at which to resume. Precondition: the hits are not full.
    std::uint32_t find(const Aabb& box, std::uint32_t first, std::uint32_t last, Hits& hits) const;

private:
    // Each has kGroup more elements than bounds, which may be read.
    std::vector<Real> lowerX_;
    std::vector<Real> lowerY_;
    std::vector<Real> upperX_;
    std::vector<Real> upperY_;
};

} // namespace KODO_PRECISION
} // namespace kodo
