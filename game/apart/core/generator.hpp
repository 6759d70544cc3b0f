// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstdint>

namespace apart {

/// Pseudo-random numbers that depend on a key alone (SplitMix64: Steele, Lea, Flood 2014). Each use
/// has a generator with its own key, so its numbers do not depend on other draws.
class Generator {
public:
    explicit constexpr Generator(std::uint64_t key) : state_(key) {}

    constexpr std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    /// 0..n-1; n > 0. The bias of the remainder is below n / 2^64, which is negligible.
    constexpr std::uint32_t below(std::uint32_t n) {
        return static_cast<std::uint32_t>(next() % n);
    }

    /// 0 <= x < 1 in steps of 2^-24, exact in every Real.
    constexpr kodo::Real unit() {
        return static_cast<kodo::Real>(next() >> 40) / kodo::Real(1 << 24);
    }
    constexpr kodo::Real between(kodo::Real low, kodo::Real high) {
        return low + (high - low) * unit();
    }

private:
    std::uint64_t state_;
};

/// Combines keys into one.
constexpr std::uint64_t mixKeys(std::uint64_t a, std::uint64_t b, std::uint64_t c = 0) {
    const std::uint64_t first = Generator(a).next();
    const std::uint64_t second = Generator(first ^ b).next();
    return Generator(second ^ c).next();
}

} // namespace apart
