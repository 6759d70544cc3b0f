// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace apart {

/// Codes bits by the probability of each, as an adaptive binary range coder (G. N. N. Martin, Range
/// encoding, 1979). The same calls write and read: a writer returns the bit that it is given, a
/// reader the bit that it finds. A text that ends too early is read as if zeros followed.
class BitCoder {
public:
    /// Share of zeros in 1/2048; it follows the bits that are coded with it.
    struct Odds {
        std::uint16_t zero = 1024;
    };
    /// Models of numbers below 2^31 that are mostly small: their length, then their first bits.
    struct NumberOdds {
        std::array<Odds, 32> length{};
        std::array<Odds, 32 * 8> first{};
    };

    BitCoder() = default; // a writer
    explicit BitCoder(std::string_view coded);

    bool bit(bool value, Odds& odds);
    std::uint32_t number(std::uint32_t value, NumberOdds& odds);
    std::int32_t signedNumber(std::int32_t value, NumberOdds& odds);
    bool reads() const { return reads_; }
    /// What a writer has coded so far, with all that a reader needs.
    std::string finish();

private:
    void fill();

    bool reads_ = false;
    std::string_view rest_;
    std::string out_;
    std::uint32_t low_ = 0;
    std::uint32_t range_ = 0xffffffff;
    std::uint32_t code_ = 0; // of a reader: what was read, minus low
};

} // namespace apart
