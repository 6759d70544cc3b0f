// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/state_hash.hpp>

#include "base/checks.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Numbers as little-endian bytes, the same on every machine. A stream either writes or reads, so
/// one list of fields serves both directions and cannot diverge.
class ByteStream {
public:
    /// Writes.
    ByteStream() = default;
    /// Reads.
    explicit ByteStream(std::span<const std::byte> bytes) : remaining_(bytes), reads_(true) {}

    bool reads() const { return reads_; }
    std::size_t left() const { return remaining_.size(); } // bytes not yet read
    std::vector<std::byte> takeWritten() { return std::move(written_); }

    /// Writes a number, or reads into it. Floats are stored bit by bit, including NaN and -0.
    /// Throws BadSnapshot at the end of the bytes, and for a bool that is neither 0 nor 1.
    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void number(Number& value) {
        if constexpr (std::is_same_v<Number, bool>) {
            std::uint8_t byte = value ? 1 : 0;
            integer(byte);
            if (byte > 1) {
                throw BadSnapshot("a bool is neither 0 nor 1");
            }
            value = byte == 1;
        } else if constexpr (std::is_floating_point_v<Number>) {
            std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t> bits{};
            static_assert(sizeof(bits) == sizeof(value));
            std::memcpy(&bits, &value, sizeof(bits));
            integer(bits);
            std::memcpy(&value, &bits, sizeof(bits));
        } else {
            auto bits = static_cast<std::make_unsigned_t<Number>>(value);
            integer(bits);
            value = static_cast<Number>(bits);
        }
    }

private:
    template <typename Unsigned>
    void integer(Unsigned& value) {
        if (!reads_) {
            for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
                written_.push_back(static_cast<std::byte>(std::uint64_t{value} >> 8 * i));
            }
            return;
        }
        if (remaining_.size() < sizeof(Unsigned)) {
            throw BadSnapshot("the bytes end too soon");
        }
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
            sum |= std::uint64_t{std::to_integer<std::uint8_t>(remaining_[i])} << 8 * i;
        }
        value = static_cast<Unsigned>(sum);
        remaining_ = remaining_.subspan(sizeof(Unsigned));
    }

    std::vector<std::byte> written_;
    std::span<const std::byte> remaining_;
    bool reads_ = false;
};

/// FNV-1a, 64 bits. Two sequences that differ in exactly one byte have different checksums.
inline std::uint64_t checksumOf(std::span<const std::byte> bytes) {
    StateHash hash;
    for (const std::byte byte : bytes) {
        hash.add(std::to_integer<std::uint8_t>(byte));
    }
    return hash.value();
}

} // namespace KODO_PRECISION
} // namespace kodo
