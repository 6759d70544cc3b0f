// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace kodo {

/// Asks for the first `lines` cache lines of one of a list's elements, if there is one at that
/// place, so that they are at hand when a loop over large elements comes to it. This changes how
/// long the loop takes, and nothing else.
template <std::size_t lines, typename T>
void prefetch(std::span<T> list, std::size_t place) {
    constexpr std::size_t kLine = 64; // bytes
    static_assert(lines * kLine <= sizeof(T));
    if (place < list.size()) {
        const char* const element = reinterpret_cast<const char*>(&list[place]);
        for (std::size_t i = 0; i < lines; ++i) {
            __builtin_prefetch(element + i * kLine);
        }
    }
}

} // namespace kodo
