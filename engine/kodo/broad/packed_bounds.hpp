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
    /// So many are compared before anybody looks who was hit.
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
    /// From now on they overlap nothing.
    void hide(std::size_t i) {
        constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
        set(i, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
    }

    /// Places of bounds that were found to overlap a box, until somebody asks for them.
    class Hits {
    public:
        bool isFull() const { return count_ > kFull; }
        /// Calls meet(i) for those for which isMet(i) is true, and forgets them all.
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
        static constexpr std::size_t kFull = 64; // with more than that, nothing is added

        std::size_t count_ = 0;
        std::array<std::uint32_t, kFull + kGroup> places_; // those of a group may come on top
    };

    /// Adds the places from `first` on, before `last`, whose bounds overlap the box, until all are
    /// looked at or the hits, which are not full before, are. Gives where it stopped.
    std::uint32_t find(const Aabb& box, std::uint32_t first, std::uint32_t last, Hits& hits) const;

private:
    // Each with some more behind the last, which may be read.
    std::vector<Real> lowerX_;
    std::vector<Real> lowerY_;
    std::vector<Real> upperX_;
    std::vector<Real> upperY_;
};

} // namespace kodo::inline KODO_PRECISION
