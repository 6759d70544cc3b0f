// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <vector>

namespace support {

/// True if two lists are equal byte by byte; -0 and 0 differ.
template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

} // namespace support
