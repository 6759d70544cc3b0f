// SPDX-License-Identifier: MIT
#pragma once

#include "math/lanes.hpp"
#include "math/trig.hpp"

#include <cstdint>
#include <cstring>
#include <numbers>

/// Rotations in lanes. Internal linkage throughout, for the reason given in lanes.hpp.
namespace kodo {
inline namespace KODO_PRECISION {
namespace { // NOLINT: see above

/// True if a comparison holds in any lane.
template <typename Mask>
KODO_LANES_INLINE bool any(const Mask& mask) {
    std::uint64_t words[kLaneBytes / sizeof(std::uint64_t)];
    std::memcpy(words, &mask, sizeof words);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words) {
        all |= word;
    }
    return all != 0;
}

/// Bit-identical to sinCos(), except for the sign of a zero.
KODO_LANES_INLINE Couple cosSin(Lanes angle) {
    const auto far = larger(angle, -angle) > all(std::numbers::pi_v<Real> / 4);
    const SinCosOf<Lanes> both = any(far) ? sinCosFar<Real>(angle) : sinCosNear<Real>(angle);
    return {both.cos, both.sin};
}

KODO_LANES_INLINE Couple turnedBy(const Couple& rotation, const Couple& v) {
    return {rotation.x * v.x - rotation.y * v.y, rotation.y * v.x + rotation.x * v.y};
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
