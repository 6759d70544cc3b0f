// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/assert.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// Asks for the line that an element begins in.
template <typename T>
void prefetch(const T& element) {
    __builtin_prefetch(&element);
}

/// Calls visit(place) for some places of a list of large elements, and asks for the first `lines`
/// of each some places ahead.
template <std::size_t lines, typename T, typename Visit>
void visitAhead(std::span<const std::uint32_t> places, std::span<T> list, const Visit& visit) {
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

/// Places of a list that one loop finds for the next, which so knows what to ask for beforehand.
template <std::size_t most>
class Places {
public:
    /// At most `most` of them, counting those that turn out not to be wanted.
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
