// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/broad_phase.hpp>

namespace kodo::inline KODO_PRECISION {

/// Every pair of overlapping bounds, of which at least one has moved, that `accept(first, second)`
/// lets through, each once, in any order. Tests them all, and is the fastest way while they are
/// few.
template <typename Accept>
void bruteForce(std::span<const Aabb> bounds, const Moved& moved, Accept accept,
                std::vector<BoundsPair>& out) {
    for (const std::uint32_t m : moved.list) {
        for (std::uint32_t i = 0; i < bounds.size(); ++i) {
            if (i == m || (moved.has(i) && i < m) || !overlap(bounds[i], bounds[m])) {
                continue; // itself, met already, or apart
            }
            const BoundsPair pair = i < m ? BoundsPair{i, m} : BoundsPair{m, i};
            if (accept(pair.first, pair.second)) {
                out.push_back(pair);
            }
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
