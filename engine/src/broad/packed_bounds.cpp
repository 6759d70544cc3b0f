// SPDX-License-Identifier: MIT
#include "broad/packed_bounds.hpp"

#include "base/assert.hpp"
#include "math/lanes.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

using Word = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;

} // namespace

void PackedBounds::reserve(std::size_t count) {
    for (std::vector<Real>* column : {&lowerX_, &lowerY_, &upperX_, &upperY_}) {
        column->reserve(count + kGroup);
    }
}

void PackedBounds::resize(std::size_t count) {
    for (std::vector<Real>* column : {&lowerX_, &lowerY_, &upperX_, &upperY_}) {
        column->resize(count + kGroup);
    }
}

std::uint32_t PackedBounds::find(const Aabb& box, std::uint32_t first, std::uint32_t last,
                                 Hits& hits) const {
    const Lanes left = all(box.lower.x);
    const Lanes bottom = all(box.lower.y);
    const Lanes right = all(box.upper.x);
    const Lanes top = all(box.upper.y);
    KODO_ASSERT(!hits.isFull()); // otherwise there is no progress
    std::size_t count = hits.count_;
    for (; first < last && count <= Hits::kFull; first += kGroup) {
        std::array<Word, kGroup> overlaps; // -1: overlaps
        std::uint64_t any = 0;
        for (std::uint32_t i = 0; i < kGroup; i += kLanes) {
            const std::size_t k = first + i;
            const auto yes = (load(&lowerX_[k]) <= right) & (load(&lowerY_[k]) <= top) &
                             (left <= load(&upperX_[k])) & (bottom <= load(&upperY_[k]));
            std::memcpy(&overlaps[i], &yes, sizeof yes);
            std::array<std::uint64_t, sizeof yes / sizeof any> words;
            std::memcpy(words.data(), &yes, sizeof yes);
            for (const std::uint64_t word : words) {
                any |= word;
            }
        }
        if (any == 0) {
            continue;
        }
        const std::uint32_t end = std::min(kGroup, last - first);
        for (std::uint32_t i = 0; i < end; ++i) {
            hits.places_[count] = first + i;
            count -= static_cast<std::size_t>(overlaps[i]);
        }
    }
    hits.count_ = count;
    return std::min(first, last);
}

} // namespace KODO_PRECISION
} // namespace kodo
