// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/aabb.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Two bounds that overlap, by their place in the list; first < second.
struct BoundsPair {
    std::uint32_t first;
    std::uint32_t second;
    friend constexpr auto operator<=>(BoundsPair, BoundsPair) = default;
};

/// Whose pairs are wanted: those in `list`; `flags` tells by place.
struct Moved {
    std::span<const std::uint32_t> list;
    std::span<const std::uint8_t> flags;

    bool has(std::uint32_t i) const { return flags[i] != 0; }
};

/// Puts pairs in order: by the first of each into place, then by the second among the few that
/// share it.
class PairSorter {
public:
    /// `count`: all places are below it.
    void sort(std::vector<BoundsPair>& pairs, std::size_t count);

private:
    std::vector<std::uint32_t> starts_;
    std::vector<BoundsPair> spare_;
};

} // namespace kodo::inline KODO_PRECISION
