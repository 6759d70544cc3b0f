// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
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

/// Sorts indices or ids and removes duplicates.
template <typename T>
void sortUnique(std::vector<T>& list) {
    std::sort(list.begin(), list.end()); // total order: equal ones are identical
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The indices 0 to count - 1.
inline std::vector<std::uint32_t> allIndices(std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// Appends an index to a list that may contain duplicates. Removes these once the list is longer
/// than twice `count`, the number of different indices.
inline void appendIndex(std::vector<std::uint32_t>& list, std::uint32_t index, std::size_t count) {
    if (list.size() > 2 * count) {
        sortUnique(list);
    }
    list.push_back(index);
}

} // namespace KODO_PRECISION
} // namespace kodo
