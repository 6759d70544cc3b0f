// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace kodo {

/// Of words of eight bytes in four lanes, each as FNV-1a with a shift. Two sequences of one length
/// that differ within one word have different checksums, since each operation can be undone.
inline std::uint64_t checksumOf(std::span<const std::byte> bytes) {
    const auto mixed = [](std::uint64_t hash, std::uint64_t word) {
        hash = (hash ^ word) * 0x100000001b3u;
        return hash ^ hash >> 32;
    };
    std::array<std::uint64_t, 4> lanes{1, 2, 3, 4};
    std::size_t next = 0;
    for (; bytes.size() - next >= 8 * lanes.size(); next += 8 * lanes.size()) {
        for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
            std::array<std::byte, 8> low; // the low byte first
            std::memcpy(&low, &bytes[next + 8 * lane], sizeof low);
            if constexpr (std::endian::native == std::endian::big) {
                std::reverse(low.begin(), low.end());
            }
            std::uint64_t word = 0;
            std::memcpy(&word, &low, sizeof word);
            lanes[lane] = mixed(lanes[lane], word);
        }
    }
    std::uint64_t hash = bytes.size();
    for (const std::uint64_t lane : lanes) {
        hash = mixed(hash, lane);
    }
    for (const std::byte byte : bytes.subspan(next)) {
        hash = mixed(hash, std::to_integer<std::uint64_t>(byte));
    }
    return hash;
}

} // namespace kodo
