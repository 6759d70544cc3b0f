// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Two overlapping bounds, by their indices in the list; first < second.
struct BoundsPair {
    std::uint32_t first;
    std::uint32_t second;
    friend constexpr auto operator<=>(BoundsPair, BoundsPair) = default;
};

/// Radix sort of pairs: by `second`, then stably by `first`.
class PairSorter {
public:
    /// `count`: upper bound of all indices, exclusive.
    void sort(std::vector<BoundsPair>& pairs, std::size_t count);

private:
    void copyBy(std::uint32_t BoundsPair::*member, std::span<const BoundsPair> from,
                std::span<BoundsPair> to, std::size_t count);

    std::vector<std::uint32_t> starts_;
    std::vector<BoundsPair> spare_;
};

} // namespace KODO_PRECISION
} // namespace kodo
