// SPDX-License-Identifier: MIT
#include <apart/core/bit_coder.hpp>

#include <bit>

namespace apart {

namespace {

constexpr int kOddsBits = 11; // of Odds::zero
constexpr int kFollow = 4;    // 1/16 of the error is corrected with each bit
constexpr std::uint32_t kLeastRange = 1u << 24;

} // namespace

BitCoder::BitCoder(std::string_view coded) : reads_(true), rest_(coded) {
    for (int i = 0; i < 4; ++i) {
        fill();
    }
    range_ = 0xffffffff;
}

/// Moves one byte out, or in.
void BitCoder::fill() {
    range_ <<= 8;
    if (reads_) {
        const auto next = rest_.empty() ? 0u : static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(rest_.empty() ? 0 : 1);
        code_ = (code_ << 8) | next;
        return;
    }
    out_ += static_cast<char>(low_ >> 24);
    low_ <<= 8;
}

bool BitCoder::bit(bool value, Odds& odds) {
    const std::uint32_t zeros = (range_ >> kOddsBits) * odds.zero;
    const bool one = reads_ ? code_ >= zeros : value;
    if (!one) {
        range_ = zeros;
        odds.zero = static_cast<std::uint16_t>(odds.zero + ((2048 - odds.zero) >> kFollow));
    } else {
        range_ -= zeros;
        odds.zero = static_cast<std::uint16_t>(odds.zero - (odds.zero >> kFollow));
        if (reads_) {
            code_ -= zeros;
        } else {
            low_ += zeros;
            for (std::size_t i = out_.size(); low_ < zeros && i-- > 0;) { // carry
                out_[i] = static_cast<char>(out_[i] + 1);
                if (out_[i] != 0) {
                    break;
                }
            }
        }
    }
    while (range_ < kLeastRange) {
        fill();
    }
    return one;
}

std::uint32_t BitCoder::number(std::uint32_t value, NumberOdds& odds) {
    const auto length = static_cast<std::uint32_t>(std::bit_width(value));
    std::uint32_t node = 1;
    for (int i = 4; i >= 0; --i) {
        node = 2 * node + (bit((length >> i & 1) != 0, odds.length[node]) ? 1 : 0);
    }
    const std::uint32_t bits = node - 32;
    std::uint32_t found = bits > 0 ? 1 : 0;
    std::uint32_t prefix = 1; // of the bits that have odds of their own
    for (std::uint32_t left = bits; left > 1; --left) {
        Odds even;
        Odds& own = prefix < 8 ? odds.first[8 * bits + prefix] : even;
        const bool one = bit((value >> (left - 2) & 1) != 0, own);
        prefix = 2 * prefix + (one ? 1 : 0);
        found = 2 * found + (one ? 1 : 0);
    }
    return found;
}

std::int32_t BitCoder::signedNumber(std::int32_t value, NumberOdds& odds) {
    const auto sign = static_cast<std::uint32_t>(value < 0 ? 1 : 0);
    const auto size = static_cast<std::uint32_t>(value < 0 ? -(value + 1) : value);
    const std::uint32_t found = number(2 * size + sign, odds);
    const auto half = static_cast<std::int32_t>(found / 2);
    return found % 2 == 0 ? half : -half - 1;
}

std::string BitCoder::finish() {
    for (int i = 0; i < 4; ++i) {
        out_ += static_cast<char>(low_ >> 24);
        low_ <<= 8;
    }
    while (!out_.empty() && out_.back() == 0) { // a reader finds zeros there
        out_.pop_back();
    }
    return std::move(out_);
}

} // namespace apart
