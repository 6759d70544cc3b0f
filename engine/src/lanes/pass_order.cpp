// SPDX-License-Identifier: MIT
#include "lanes/pass_order.hpp"

#include <algorithm>
#include <numeric>

namespace kodo {
inline namespace KODO_PRECISION {

void PassOrder::build(std::span<const BlockState> states) {
    constexpr std::uint32_t kBins = BlockBins::kBins;
    constexpr std::uint32_t kLevelBins = BlockBins::kLevelBins;
    std::array<std::uint32_t, kBins + 1> next{};
    std::uint32_t lowest = kBins - 1; // of the bins with a block
    std::uint32_t highest = 0;
    for (const BlockState& state : states) {
        next[state.bin + 1] += state.used != 0 ? 1 : 0;
        lowest = std::min(lowest, state.bin);
        highest = std::max(highest, state.bin);
    }
    lowest = std::min(lowest, highest);
    std::partial_sum(next.begin() + lowest, next.begin() + highest + 2, next.begin() + lowest);
    const auto firstOf = [&](std::uint32_t bin) {
        return next[std::clamp(bin, lowest, highest + 1)];
    };
    for (std::uint32_t number = 0; number < BlockBins::kLevels; ++number) {
        Level& level = levels_[number];
        const std::uint32_t end = (number + 1) * kLevelBins;
        level.first = firstOf(end - kLevelBins);
        level.count = firstOf(end) - level.first;
        level.colours.clear();
        for (std::uint32_t bin = std::max(end - kLevelBins, lowest / 2 * 2);
             bin < std::min(end, highest + 1); bin += 2) {
            if (const std::uint32_t count = firstOf(bin + 2) - firstOf(bin); count > 0) {
                level.colours.push_back({count, BlockBins::isSingle(bin)});
            }
        }
    }
    order_.resize(firstOf(kBins));
    inUse_.clear();
    for (std::uint32_t i = 0; i < states.size(); ++i) {
        if (states[i].used != 0) {
            order_[next[states[i].bin]++] = i;
            inUse_.push_back(i);
        }
    }
}

void PassOrder::reserve(std::size_t blocks) {
    order_.reserve(blocks);
    inUse_.reserve(blocks);
}

void PassOrder::clear() {
    order_.clear();
    inUse_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
