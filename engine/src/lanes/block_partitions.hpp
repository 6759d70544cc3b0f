// SPDX-License-Identifier: MIT
#pragma once

#include "base/worker_team.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Assigns the blocks of a pass to the partitions of a WorkerTeam. In each colour a partition first
/// has its border blocks (common). They move a body of another partition, or a body that another
/// partition moves. Its inner blocks (own) follow.
///
/// A worker goes on to the next colour once the border blocks of all partitions are done. It does
/// not wait for their inner blocks. Each body gets its impulses colour by colour, as on one thread,
/// so the result is bit-identical.
class BlockPartitions {
public:
    struct Step {
        const ContactBlocks& blocks;
        std::uint32_t level;
        const ContactPassArguments& pass;      // over the blocks of that level
        std::span<const std::uint32_t> bodies; // that can be moved, in order
        std::size_t bodyCount;                 // all bodies
    };
    /// Assigns the blocks for the passes of a step.
    void buildGraph(const Step& step, WorkerTeam& team);

    std::uint32_t colours() const {
        return static_cast<std::uint32_t>(ranges_.size() / partitions_);
    }
    /// Blocks of a partition and a colour in the order of the pass: inner blocks if `own`, else
    /// border blocks.
    std::span<const std::uint32_t> blocks(std::uint32_t partition, std::uint32_t colour,
                                          bool own) const {
        const Range& range = ranges_[colour * partitions_ + partition];
        return std::span(order_).subspan(own ? range.own : range.common,
                                         own ? range.end - range.own : range.own - range.common);
    }
    /// Range in Step::bodies.
    struct Part {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    Part bodies(std::uint32_t partition) const { return parts_[partition]; }

private:
    /// Range of a colour and a partition in order_.
    struct Range {
        std::uint32_t common = 0; // first border block
        std::uint32_t own = 0;
        std::uint32_t end = 0;
    };

    void notePushed(const Step& step, std::uint32_t block);
    bool pushesCommon(const Step& step, std::uint32_t block) const;
    void listBlocks(const Step& step);
    void listBodies(const Step& step);

    std::vector<std::uint8_t> pushedByOthers_; // by body: another partition moves it
    std::vector<std::uint8_t> common_;         // by block: is a border block
    std::vector<std::uint32_t> order_;
    std::vector<Range> ranges_; // by colour and partition
    std::vector<Part> parts_;   // by partition
    std::uint32_t partitions_ = 1;
};

} // namespace KODO_PRECISION
} // namespace kodo
