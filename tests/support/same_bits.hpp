// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <vector>

namespace support {

/// Have two lists the same bytes, so that also a -0 is no 0?
template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

} // namespace support
