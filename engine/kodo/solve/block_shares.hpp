// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/solve/contact_blocks.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Deals the blocks of a pass to the shares of a Crew. In each colour a share first has those that
/// are common: a body that they push is another share's, or is pushed by one of another share. Then
/// come those that are its own. So when all have done what is common of a colour, they may go on to
/// the next without waiting for each other, and since each body gets its pushes colour by colour,
/// as it does from one thread, the outcome is the same to the bit.
class BlockShares {
public:
    struct Step {
        const ContactBlocks& blocks;
        const ContactPassArguments& pass;
        std::span<const Contact> contacts;
        std::span<const std::uint32_t> newcomers; // see ContactBlocks::arrange
        std::span<const std::uint32_t> bodies;    // those that can be pushed, in order
        std::size_t bodyCount;                    // of all
    };
    /// For the passes of a step.
    void deal(const Step& step, Crew& crew);

    std::uint32_t colours() const { return static_cast<std::uint32_t>(ranges_.size() / shares_); }
    /// Of a share and a colour, in the order of the pass.
    std::span<const std::uint32_t> blocks(std::uint32_t share, std::uint32_t colour,
                                          bool own) const {
        const Range& range = ranges_[colour * shares_ + share];
        return std::span(order_).subspan(own ? range.own : range.common,
                                         own ? range.end - range.own : range.own - range.common);
    }
    /// Of those that can be pushed: so many from so many on.
    struct Part {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    Part bodies(std::uint32_t share) const { return parts_[share]; }

private:
    /// Of the blocks of a colour and a share, in order_.
    struct Range {
        std::uint32_t common = 0; // from here on
        std::uint32_t own = 0;
        std::uint32_t end = 0;
    };

    void notePushed(const Step& step, std::uint32_t block);
    bool pushesCommon(const Step& step, std::uint32_t block) const;
    void listBlocks(const Step& step);
    void listBodies(const Step& step);

    std::vector<std::uint8_t> pushedByOthers_; // by body: since all was dealt
    std::vector<std::uint8_t> common_;         // by block
    std::vector<std::uint32_t> listed_;        // the order of the pass that order_ was made from
    std::vector<std::uint32_t> order_;
    std::vector<Range> ranges_;    // by colour and share
    std::vector<Part> parts_;      // by share
    std::uint64_t lanesState_ = 0; // of ContactBlocks, when these were dealt
    std::uint32_t shares_ = 1;
    bool commonStale_ = true;
};

} // namespace kodo::inline KODO_PRECISION
