// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Sets `count` elements to `value`. Unlike assign(), which allocates exactly what it needs, growth
/// is geometric, so a slowly growing need seldom allocates.
template <typename T>
void assignReusing(std::vector<T>& values, std::size_t count, const T& value) {
    values.resize(count);
    std::fill(values.begin(), values.end(), value);
}

/// Reserves `most` elements, or twice that if the capacity is too small. A step that needs slightly
/// more than before then does not allocate.
template <typename Value>
void reserveReusing(std::vector<Value>& values, std::size_t most) {
    if (values.capacity() < most) {
        values.reserve(2 * most);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
