// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The categories of each block of 64 bodies: a search for bodies that a filter accepts skips the
/// blocks without one. A flag that no body of a block has any more stays noted. Scratch: no result
/// depends on it.
class FlagBlocks {
public:
    /// A body has these flags from now on.
    void note(std::size_t body, Flags flags) {
        blocks_.resize(std::max(blocks_.size(), body / kBodies + 1));
        blocks_[body / kBodies] |= categoriesOf(flags);
    }

    /// Calls visit(body) for all bodies of the blocks that may have one which the filter accepts.
    template <typename Visit>
    void forEachIn(CollisionFilter which, std::size_t bodies, Visit visit) const {
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (!mayAccept(which, blocks_[block])) {
                continue;
            }
            const std::size_t end = std::min(bodies, (block + 1) * kBodies);
            for (std::size_t body = block * kBodies; body < end; ++body) {
                visit(static_cast<std::uint32_t>(body));
            }
        }
    }

private:
    static constexpr std::size_t kBodies = 64;

    /// `all`: the union of the flags of several bodies.
    static constexpr bool mayAccept(CollisionFilter which, Flags all) {
        const Flags required = which.required;
        if (which.group > 0) { // it may find bodies that the mode does not
            return true;
        }
        switch (which.flags & kMatchModes) {
        case kMatchAny:
            return (all & required) != 0;
        case kMatchAll:
        case kMatchEqual:
            return (all & required) == required;
        default:
            return true;
        }
    }

    std::vector<Flags> blocks_;
};

} // namespace KODO_PRECISION
} // namespace kodo
