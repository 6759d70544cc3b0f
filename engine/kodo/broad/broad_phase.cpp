// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/broad/broad_phase.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {

/// Copies pairs in the order of one of their members; those with the same stay as they were.
void PairSorter::copyBy(std::uint32_t BoundsPair::*member, std::span<const BoundsPair> from,
                        std::span<BoundsPair> to, std::size_t count) {
    refill(starts_, count + 1, 0u);
    for (const BoundsPair& pair : from) {
        ++starts_[pair.*member + 1];
    }
    for (std::size_t i = 0; i < count; ++i) {
        starts_[i + 1] += starts_[i];
    }
    for (const BoundsPair& pair : from) {
        to[starts_[pair.*member]++] = pair; // in the end each start is that of the next
    }
}

void PairSorter::sort(std::vector<BoundsPair>& pairs, std::size_t count) {
    constexpr std::size_t kFew = 16;           // are sorted faster by comparing,
    constexpr std::size_t kBoundsPerPair = 16; // and so are pairs of which there are fewer
    if (pairs.size() < std::max(kFew, count / kBoundsPerPair)) {
        std::sort(pairs.begin(), pairs.end()); // total order: no two are equal
        return;
    }
    spare_.resize(pairs.size());
    copyBy(&BoundsPair::second, pairs, spare_, count);
    copyBy(&BoundsPair::first, spare_, pairs, count);
}

} // namespace kodo::inline KODO_PRECISION
