// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/broad_phase.hpp>

namespace kodo::inline KODO_PRECISION {

/// Every pair of overlapping bounds, of which at least one has moved, that `accept(first, second)`
/// lets through, each once, in any order. Tests them all, and is the fastest way while they are
/// few, or few have moved.
template <typename Accept>
void bruteForce(std::span<const Aabb> bounds, const Moved& moved, Accept accept,
                std::vector<BoundsPair>& out) {
    for (const std::uint32_t m : moved.list) {
        for (std::uint32_t i = 0; i < bounds.size(); ++i) {
            if (!overlap(bounds[i], bounds[m]) || i == m || (moved.has(i) && i < m)) {
                continue; // apart, itself, or met already
            }
            const BoundsPair pair = i < m ? BoundsPair{i, m} : BoundsPair{m, i};
            if (accept(pair.first, pair.second)) {
                out.push_back(pair);
            }
        }
    }
}

/// What it takes for so many, of which so many have moved.
inline PairWork bruteForceWork(std::size_t bounds, std::size_t moved) {
    PairWork work;
    work.addCompared(bounds * moved);
    return work;
}

} // namespace kodo::inline KODO_PRECISION
