// SPDX-License-Identifier: MIT
// Included by contact_passes.inl, whose first lines hold here too.
#pragma once

#include "lanes/contact_block.hpp"
#include "lanes/velocity_lanes.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// The bodies of kLanes contacts.
struct Pair {
    Quad a; // x, y: velocity, z: angular velocity, w: 1/mass
    Quad b;
    Lanes inertiaA; // 1/inertia
    Lanes inertiaB;
};

/// Applies the linear part of the impulse (x, y) * impulse (N s).
KODO_LANES_INLINE void push(Pair& pair, Lanes x, Lanes y, Lanes impulse) {
    pair.a.x -= (pair.a.w * x) * impulse;
    pair.a.y -= (pair.a.w * y) * impulse;
    pair.b.x += (pair.b.w * x) * impulse;
    pair.b.y += (pair.b.w * y) * impulse;
}

/// Prefetch distance in blocks, for blocks outside the near cache. 4 and 8 are as fast.
constexpr std::size_t kBlocksAhead = 6;

KODO_LANES_INLINE void prefetchLines(const void* from, const void* end) {
    for (const char* at = static_cast<const char*>(from); at < end; at += 64) { // bytes a line
        __builtin_prefetch(at);
    }
}

/// Prefetches what a pass reads of a later block: its points, and all members from `tail` on unless
/// that is null.
template <typename Arguments>
KODO_LANES_INLINE void prefetchBlock(const Arguments& pass, std::size_t k,
                                     ContactBlock::Each ContactBlock::*tail) {
    if (pass.far && k + kBlocksAhead < pass.count) {
        const std::size_t i = pass.order[k + kBlocksAhead];
        const ContactBlock& next = pass.blocks[i];
        prefetchLines(&next, next.points + (pass.use[i].twoPoints ? 2 : 1));
        if (tail != nullptr) {
            prefetchLines(&(next.*tail), &next + 1);
        }
    }
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
