// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/hash.hpp>
#include <kodo/base/problem.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Numbers as bytes, the lowest first, so that they are the same on every machine. A stream either
/// writes or reads: one list of numbers serves both directions, which then cannot drift apart.
class ByteStream {
public:
    /// Writes.
    ByteStream() = default;
    /// Reads.
    explicit ByteStream(std::span<const std::byte> bytes) : rest_(bytes), reads_(true) {}

    bool reads() const { return reads_; }
    std::size_t left() const { return rest_.size(); } // bytes that are still to be read
    std::vector<std::byte> takeWritten() { return std::move(written_); }

    /// Writes a number, or sets it. A float goes by its bits, so even a NaN or a -0 comes back as
    /// it was. Throws BadSnapshot where the bytes end, and for a bool that is neither 0 nor 1.
    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void number(Number& value) {
        if constexpr (std::is_same_v<Number, bool>) {
            std::uint8_t byte = value ? 1 : 0;
            integer(byte);
            if (byte > 1) {
                throw BadSnapshot("a byte that stands for a bool is neither 0 nor 1");
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
        if (rest_.size() < sizeof(Unsigned)) {
            throw BadSnapshot("the bytes end too soon");
        }
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
            sum |= std::uint64_t{std::to_integer<std::uint8_t>(rest_[i])} << 8 * i;
        }
        value = static_cast<Unsigned>(sum);
        rest_ = rest_.subspan(sizeof(Unsigned));
    }

    std::vector<std::byte> written_;
    std::span<const std::byte> rest_;
    bool reads_ = false;
};

/// FNV-1a with 64 bits. No two runs of bytes that differ in one byte have the same.
inline std::uint64_t checksumOf(std::span<const std::byte> bytes) {
    StateHash hash;
    for (const std::byte byte : bytes) {
        hash.add(std::to_integer<std::uint8_t>(byte));
    }
    return hash.value();
}

} // namespace kodo::inline KODO_PRECISION
