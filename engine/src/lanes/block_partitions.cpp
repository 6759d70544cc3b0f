// SPDX-License-Identifier: MIT
#include "lanes/block_partitions.hpp"

#include <algorithm>
#include <array>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kBlocksPerPiece = 64;

/// Calls work(body) for each body that a contact of the block can move.
template <typename Work>
void forEachPushed(const ContactPassArguments& pass, std::uint32_t block, const Work& work) {
    const ContactBlock& lanes = pass.blocks[block];
    const BlockUse& use = pass.use[block];
    for (unsigned lane = 0; lane < ContactBlock::kContacts; ++lane) {
        if ((use.movesA >> lane & 1) != 0) {
            work(bodyOfPlace(lanes.a[lane]));
        }
        if ((use.movesB >> lane & 1) != 0) {
            work(bodyOfPlace(lanes.b[lane]));
        }
    }
}

} // namespace

/// Marks the bodies that a block of another partition can move. The first partition solves all
/// blocks of single contacts, so the bodies of these count as shared, even its own.
void BlockPartitions::notePushed(const Step& step, std::uint32_t block) {
    const bool single = BlockBins::isSingle(step.blocks.stateOf(block).bin);
    const std::uint8_t partition = step.blocks.stateOf(block).partition;
    forEachPushed(step.pass, block, [&](std::uint32_t body) {
        if (single || step.blocks.partitions().of(body) != partition) {
            pushedByOthers_[body] = 1;
        }
    });
}

bool BlockPartitions::pushesCommon(const Step& step, std::uint32_t block) const {
    bool common = false;
    forEachPushed(step.pass, block,
                  [&](std::uint32_t body) { common = common || pushedByOthers_[body] != 0; });
    return common;
}

void BlockPartitions::buildGraph(const Step& step, WorkerTeam& team) {
    partitions_ = step.blocks.partitions().count();
    common_.resize(step.blocks.blockCount());
    const std::span<const std::uint32_t> order(step.pass.order, step.pass.count);
    pushedByOthers_.assign(step.bodyCount, 0);
    for (const std::uint32_t block : order) {
        notePushed(step, block);
    }
    team.forEach(order.size(), kBlocksPerPiece, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t block : order.subspan(first, last - first)) {
            common_[block] = pushesCommon(step, block) ? 1 : 0;
        }
    });
    listBlocks(step);
    listBodies(step);
}

/// Orders the blocks of each colour by partition, and in each partition border blocks first. All
/// blocks of single contacts belong to the first partition.
void BlockPartitions::listBlocks(const Step& step) {
    const std::uint32_t* const order = step.pass.order;
    ranges_.clear();
    order_.resize(step.pass.count);
    std::uint32_t first = 0;
    for (const PassOrder::Colour& colour : step.blocks.passOrder().colours(step.level)) {
        const std::uint32_t end = first + static_cast<std::uint32_t>(colour.count);
        std::array<std::uint32_t, 2 * WorkerTeam::kMaxPartitions + 1> next{};
        const auto groupOf = [&](std::uint32_t block) {
            return colour.oneByOne
                       ? 0u
                       : 2u * step.blocks.stateOf(block).partition + 1u - common_[block];
        };
        for (std::uint32_t k = first; k < end; ++k) {
            ++next[groupOf(order[k]) + 1];
        }
        next[0] = first;
        for (std::uint32_t partition = 0; partition < partitions_; ++partition) {
            next[2 * partition + 1] += next[2 * partition];
            next[2 * partition + 2] += next[2 * partition + 1];
            ranges_.push_back(
                {next[2 * partition], next[2 * partition + 1], next[2 * partition + 2]});
        }
        for (std::uint32_t k = first; k < end; ++k) {
            order_[next[groupOf(order[k])]++] = order[k];
        }
        first = end;
    }
}

void BlockPartitions::listBodies(const Step& step) {
    parts_.clear();
    auto from = step.bodies.begin();
    for (std::uint32_t partition = 0; partition < partitions_; ++partition) {
        const auto to = std::partition_point(from, step.bodies.end(), [&](std::uint32_t body) {
            return step.blocks.partitions().of(body) <= partition;
        });
        parts_.push_back({static_cast<std::size_t>(from - step.bodies.begin()),
                          static_cast<std::size_t>(to - from)});
        from = to;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
