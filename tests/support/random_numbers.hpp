// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <cstdint>

namespace support {

/// Counter-based generator: number i depends only on the seed and i, identically on every machine
/// (splitmix64; Steele, Lea, Flood 2014).
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : counter_(seed << 32) {}

    std::uint64_t bits() {
        std::uint64_t z = ++counter_ * 0x9e3779b97f4a7c15ull;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ z >> 27) * 0x94d049bb133111ebull;
        return z ^ z >> 31;
    }
    /// 0 .. count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
    /// low .. high, with 24 random bits: float and double builds get the same numbers.
    kodo::Real between(double low, double high) {
        const double share = static_cast<double>(bits() >> 40) / 16777216.0;
        return static_cast<kodo::Real>(low + share * (high - low));
    }
    /// Both coordinates in -reach .. reach.
    kodo::Vec2 point(double reach) {
        const kodo::Real x = between(-reach, reach);
        return {x, between(-reach, reach)};
    }
    kodo::Rot rotation() { return kodo::Rot::fromAngle(between(-3.14159, 3.14159)); }
    kodo::Transform pose(double reach) {
        const kodo::Vec2 position = point(reach);
        return {position, rotation()};
    }

private:
    std::uint64_t counter_;
};

} // namespace support
