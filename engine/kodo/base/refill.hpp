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

/// Makes room for `most` values, and twice that if there was too little, so that a step with a few
/// more than ever before does not allocate.
template <typename Value>
void makeRoom(std::vector<Value>& values, std::size_t most) {
    if (values.capacity() < most) {
        values.reserve(2 * most);
    }
}

} // namespace kodo::inline KODO_PRECISION
