// SPDX-License-Identifier: MIT
#include "propagation/stride_order.hpp"

#include <numeric>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Spreads consecutive numbers over all 64 bits (SplitMix64; Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t number) {
    std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

} // namespace

StrideOrder::StrideOrder(std::size_t count, std::uint64_t pass) : count_(count) {
    if (count < 2) {
        return;
    }
    const std::uint64_t bits = mixed(pass);
    at_ = static_cast<std::size_t>((bits >> 32) % count);
    stride_ = 1 + static_cast<std::size_t>((bits >> 1 & 0x7fffffff) % (count - 1));
    while (std::gcd(stride_, count) != 1) {
        stride_ = stride_ + 1 < count ? stride_ + 1 : 1; // reaches 1 at the latest
    }
    if ((bits & 1) != 0) { // reversed, with equal probability
        stride_ = count - stride_;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
