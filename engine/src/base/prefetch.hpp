// SPDX-License-Identifier: MIT
#pragma once

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kodo {

/// Prefetches the first `lines` cache lines of a list's element, if it exists. Affects time only.
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

/// Prefetches the cache line in which an element begins.
template <typename T>
void prefetch(const T& element) {
    __builtin_prefetch(&element);
}

/// Calls visit(place) for the given elements of a list. Prefetches the first `lines` cache lines of
/// each some elements ahead.
template <std::size_t lines, typename T, typename Visit>
void visitPrefetched(std::span<const std::uint32_t> places, std::span<T> list, const Visit& visit) {
    constexpr std::size_t kAhead = 6;
    for (std::size_t k = 0; k < std::min(places.size(), kAhead); ++k) {
        prefetch<lines>(list, places[k]);
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k + kAhead < places.size()) {
            prefetch<lines>(list, places[k + kAhead]);
        }
        visit(places[k]);
    }
}

/// Indices that one loop collects so that the next loop can prefetch them.
template <std::size_t most>
class PrefetchList {
public:
    /// At most `most` calls, including those with `wanted` false. Branchless.
    void add(std::uint32_t place, bool wanted = true) {
        KODO_ASSERT(count_ < most);
        places_[count_] = place;
        count_ += wanted ? 1 : 0;
    }
    std::span<const std::uint32_t> list() const { return {places_.data(), count_}; }

private:
    std::array<std::uint32_t, most> places_;
    std::size_t count_ = 0;
};

} // namespace kodo
