// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// Names one of the levels that nobody drew: written endless:SEED:NUMBER. The same name is the same
/// level on every machine, so a replay needs no more than it.
struct EndlessName {
    std::uint32_t seed = 1;
    std::uint32_t number = 1; // from 1; they get harder

    std::string text() const;
    friend bool operator==(const EndlessName&, const EndlessName&) = default;
};

inline constexpr std::uint32_t kMostEndless = 999999; // the highest number

/// Of endless:SEED:NUMBER; of endless:SEED and endless too, which mean the first.
std::optional<EndlessName> parseEndless(std::string_view name);

/// Every block of it can be reached, and a good player can win it.
Level endlessLevel(const EndlessName& name);

} // namespace apart
