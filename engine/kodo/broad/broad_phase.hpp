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

} // namespace kodo::inline KODO_PRECISION
