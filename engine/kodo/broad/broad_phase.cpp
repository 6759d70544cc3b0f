// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/broad/broad_phase.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {

void PairSorter::sort(std::vector<BoundsPair>& pairs, std::size_t count) {
    constexpr std::size_t kFew = 16;           // are sorted faster by comparing,
    constexpr std::size_t kBoundsPerPair = 16; // and so are pairs of which there are fewer
    if (pairs.size() < std::max(kFew, count / kBoundsPerPair)) {
        std::sort(pairs.begin(), pairs.end()); // total order: no two are equal
        return;
    }
    refill(starts_, count + 1, 0u);
    for (const BoundsPair& pair : pairs) {
        ++starts_[pair.first + 1];
    }
    for (std::size_t i = 0; i < count; ++i) {
        starts_[i + 1] += starts_[i];
    }
    spare_.resize(pairs.size());
    for (const BoundsPair& pair : pairs) {
        spare_[starts_[pair.first]++] = pair; // in the end each start is that of the next
    }
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < count; begin = starts_[i++]) {
        if (starts_[i] - begin > 1) { // total order: no two are equal
            std::sort(spare_.begin() + begin, spare_.begin() + starts_[i]);
        }
    }
    std::copy(spare_.begin(), spare_.end(), pairs.begin());
}

} // namespace kodo::inline KODO_PRECISION
