// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Makes it `count` times that value. Unlike assign(), which takes exactly the memory it needs, it
/// grows as push_back does: a step that needs a little more than any before seldom allocates.
template <typename T>
void refill(std::vector<T>& values, std::size_t count, const T& value) {
    values.resize(count);
    std::fill(values.begin(), values.end(), value);
}

} // namespace kodo::inline KODO_PRECISION
