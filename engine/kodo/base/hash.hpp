// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace kodo::inline KODO_PRECISION {

/// FNV-1a with 64 bits, fed field by field in little-endian order, so that a state has the same
/// hash on every machine.
class StateHash {
public:
    template <typename Integer>
    requires std::is_integral_v<Integer>
    void add(Integer value) {
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            const auto byte = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> 8 * i);
            value_ = (value_ ^ byte) * 1099511628211ull;
        }
    }
    // Adding +0 turns -0 into +0: both are the same place.
    void add(float value) { add(bits<std::uint32_t>(value + 0.0f)); }
    void add(double value) { add(bits<std::uint64_t>(value + 0.0)); }

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

} // namespace kodo::inline KODO_PRECISION
