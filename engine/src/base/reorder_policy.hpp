// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kodo {

/// Decides when sorting a list again pays. Each step loses a little time for every element appended
/// out of order. Once these losses add up to the cost of sorting, the list is sorted. The total is
/// hardly more than twice the minimum, whether many or few elements arrive per step.
struct ReorderPolicy {
    static constexpr std::size_t kMany = 2048; // shorter lists fit in a near cache
    /// Sorting costs as much as this many steps lose with all elements out of order. Measured: 8 to
    /// 64 perform the same.
    static constexpr std::uint64_t kSteps = 32;

    std::uint64_t strayed = 0; // elements out of order since the last sort
    std::uint64_t cost = 0;    // sum of that over the steps since

    /// Counts a step for a list of that length. True: sort it now and reset this policy.
    bool countStep(std::size_t size) {
        cost += std::min<std::uint64_t>(strayed, size); // some were removed, or strayed twice
        return size >= kMany && cost >= kSteps * size;
    }
};

} // namespace kodo
