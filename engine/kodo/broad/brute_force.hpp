// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/broad_phase.hpp>

namespace kodo::inline KODO_PRECISION {

/// Every pair of overlapping bounds that `accept(first, second)` lets through, in order. Tests
/// n (n - 1) / 2 pairs, and is the fastest way while that is a small number.
template <typename Accept>
void bruteForce(std::span<const Aabb> bounds, Accept accept, std::vector<BoundsPair>& out) {
    const auto n = static_cast<std::uint32_t>(bounds.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
            if (overlap(bounds[i], bounds[j]) && accept(i, j)) {
                out.push_back({i, j});
            }
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
