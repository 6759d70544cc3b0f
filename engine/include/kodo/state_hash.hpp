// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace kodo {
inline namespace KODO_PRECISION {

/// 64-bit FNV-1a hash of numbers, byte by byte from the lowest: the same on every machine.
class StateHash {
public:
    /// Adds all bytes of an integer. Use types of fixed width.
    template <typename Integer>
    requires std::is_integral_v<Integer>
    void add(Integer value) {
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            const auto byte = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> 8 * i);
            value_ = (value_ ^ byte) * 1099511628211ull;
        }
    }
    /// Adds the bits of a number. -0 and +0 have the same hash, since the sum with +0 is +0.
    void add(float value) { add(bits<std::uint32_t>(value + 0.0f)); }
    void add(double value) { add(bits<std::uint64_t>(value + 0.0)); }

    /// The hash of all numbers so far.
    std::uint64_t value() const { return value_; }

private:
    template <typename Integer, typename Float>
    static Integer bits(Float value) {
        static_assert(sizeof(Integer) == sizeof(Float));
        Integer result{};
        std::memcpy(&result, &value, sizeof(result));
        return result;
    }

    std::uint64_t value_ = 14695981039346656037ull;
};

} // namespace KODO_PRECISION
} // namespace kodo
