// SPDX-License-Identifier: MIT
#include "broad/bounds_pair.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

/// Stable counting sort by one member.
void PairSorter::copyBy(std::uint32_t BoundsPair::*member, std::span<const BoundsPair> from,
                        std::span<BoundsPair> to, std::size_t count) {
    assignReusing(starts_, count + 1, 0u);
    for (const BoundsPair& pair : from) {
        ++starts_[pair.*member + 1];
    }
    for (std::size_t i = 0; i < count; ++i) {
        starts_[i + 1] += starts_[i];
    }
    for (const BoundsPair& pair : from) {
        to[starts_[pair.*member]++] = pair; // afterwards each start is the start of the next
    }
}

void PairSorter::sort(std::vector<BoundsPair>& pairs, std::size_t count) {
    constexpr std::size_t kFew = 16;           // fewer pairs are sorted faster by comparison,
    constexpr std::size_t kBoundsPerPair = 16; // as are fewer than bounds / kBoundsPerPair
    if (pairs.size() < std::max(kFew, count / kBoundsPerPair)) {
        std::sort(pairs.begin(), pairs.end()); // total order: pairs are distinct
        return;
    }
    spare_.resize(pairs.size());
    copyBy(&BoundsPair::second, pairs, spare_, count);
    copyBy(&BoundsPair::first, spare_, pairs, count);
}

} // namespace KODO_PRECISION
} // namespace kodo
