// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kodo {

/// Tells when it pays to put a list in order again. What comes later lies anywhere, and each step
/// that goes through the list pays a little for each such element. Once all that comes to what
/// putting it in order takes, that is done: so hardly more than twice the least is spent, whether
/// much comes in each step or hardly anything.
struct Disorder {
    static constexpr std::size_t kMany = 2048; // shorter lists lie in a near cache anyhow
    /// Putting a list in order takes as much as so many steps lose while all of it lies anywhere;
    /// 8 to 64 are as good.
    static constexpr std::uint64_t kSteps = 32;

    std::uint64_t strayed = 0; // so many got a place anywhere since the list was in order
    std::uint64_t cost = 0;    // the sum of that over the steps since

    /// Counts a step, with the length of the list. True: put it in order now, and begin anew.
    bool countStep(std::size_t size) {
        cost += std::min<std::uint64_t>(strayed, size); // some may have gone, or strayed twice
        return size >= kMany && cost >= kSteps * size;
    }
};

} // namespace kodo
