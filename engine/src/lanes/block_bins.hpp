// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanes/contact_block.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Numbers of bins. A bin has the blocks of one level of Refinement, one group and one number of
/// points; passes go through the bins in their order. A group is a colour. Contacts between movable
/// bodies have their colours, and so have contacts with a body of infinite mass. Behind either, a
/// further group has the blocks of contacts without a colour.
struct BlockBins {
    static constexpr std::uint32_t kLevels = 4; // see Refinement: 1, 2, 4 or 8 parts
    static constexpr std::uint32_t kFreeColours = 48;
    // Colours from kFreeColours on are for contacts with a body of infinite mass.
    static constexpr std::uint32_t kColours = 64;
    static constexpr std::uint32_t kGroups = kColours + 2;
    static constexpr std::uint32_t kLevelBins = 2 * kGroups; // by group: one point, two points
    static constexpr std::uint32_t kBins = kLevels * kLevelBins;

    static constexpr std::uint32_t of(std::uint32_t level, std::uint32_t group, int points) {
        return level * kLevelBins + 2 * group + (points == 2 ? 1 : 0);
    }
    static constexpr std::uint32_t groupOfColour(std::uint32_t colour) {
        return colour < kFreeColours ? colour : colour + 1;
    }
    static constexpr std::uint32_t groupOf(std::uint32_t bin) { return bin % kLevelBins / 2; }
    static constexpr int pointsOf(std::uint32_t bin) { return bin % 2 == 0 ? 1 : 2; }
    static constexpr std::uint32_t levelOf(std::uint32_t bin) { return bin / kLevelBins; }
    /// Parts into which a substep of these blocks is divided.
    static constexpr Real partsOf(std::uint32_t bin) {
        return static_cast<Real>(1u << levelOf(bin));
    }
    /// Bins of contacts without a colour.
    static constexpr bool isSingle(std::uint32_t bin) {
        return groupOf(bin) == kFreeColours || groupOf(bin) == kGroups - 1;
    }
};

/// A row numbers the lanes of all blocks.
constexpr std::size_t blockOf(std::uint32_t row) {
    return row / ContactBlock::kContacts;
}
constexpr std::size_t laneOf(std::uint32_t row) {
    return row % ContactBlock::kContacts;
}
constexpr std::uint8_t laneMask(std::uint32_t row) {
    return static_cast<std::uint8_t>(1u << laneOf(row));
}

/// Place of a block in the graph, and its lanes.
struct BlockState {
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    std::uint32_t bin = 0;
    std::uint32_t nextOpen = kNone; // next block of the bin with a free lane
    std::uint8_t used = 0;          // lane mask
    std::uint8_t fixedA = 0;        // lane mask: a was locked when the lane was assigned
    std::uint8_t fixedB = 0;
    std::uint8_t partition = 0; // that of body a; 0 without a colour
};

} // namespace KODO_PRECISION
} // namespace kodo
