// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lanes/block_bins.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The blocks in the order of a pass: by level of Refinement, and colour by colour.
class PassOrder {
public:
    /// Consecutive blocks in the order of the pass. No two of their contacts move the same body, so
    /// they may be solved in parallel, except where oneByOne is set.
    struct Colour {
        std::size_t count = 0;
        bool oneByOne = false; // contacts without a colour, to be solved in order
    };

    /// Lists the blocks in use.
    void build(std::span<const BlockState> states);
    void reserve(std::size_t blocks);
    void clear();

    /// Indices of blocks, of all levels or of one.
    std::span<const std::uint32_t> blocks() const { return order_; }
    std::span<const std::uint32_t> blocks(std::uint32_t level) const {
        return blocks().subspan(levels_[level].first, levels_[level].count);
    }
    /// The same blocks in the order of memory.
    std::span<const std::uint32_t> inMemory() const { return inUse_; }
    std::span<const Colour> colours(std::uint32_t level) const { return levels_[level].colours; }

private:
    /// Blocks of a level: a range of order_.
    struct Level {
        std::size_t first = 0;
        std::size_t count = 0;
        std::vector<Colour> colours;
    };

    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> inUse_;
    std::array<Level, BlockBins::kLevels> levels_;
};

} // namespace KODO_PRECISION
} // namespace kodo
