// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/transform.hpp>

#include <cstdint>

namespace support {

/// A counter-based generator: number i of a seed is a function of seed and i alone, the same on
/// every machine. (splitmix64, Steele, Lea, Flood 2014.)
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
    /// low .. high; 24 bits, so that float and double get the same numbers.
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
