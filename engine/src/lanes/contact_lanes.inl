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

/// Copies of a shared body by lane; see Shared.
struct Copies {
    ContactBlock::Each x, y, z; // velocity (m/s), angular velocity (rad/s)
};

/// Gives the shared bodies of kLanes contacts the masses of copies.
template <bool isShared>
KODO_LANES_INLINE void splitMass(Pair& pair, Shared shared) {
    constexpr Real kCopies = ContactBlock::kContacts;
    if constexpr (!isShared) {
        return;
    }
    if (shared == Shared::BodyA) {
        pair.a.w *= all(kCopies);
        pair.inertiaA *= all(kCopies);
    } else {
        pair.b.w *= all(kCopies);
        pair.inertiaB *= all(kCopies);
    }
}

/// Writes the velocities of all bodies; those of a shared body to its copies.
template <bool isShared>
KODO_LANES_INLINE void putBackPair(const Pair& pair, const ContactBlock& block, int at,
                                   BodyVelocity* motion, const BlockUse& use, Copies& copies) {
    if constexpr (!isShared) {
        putBack(motion, block.a + at, pair.a, use.movesA, at);
        putBack(motion, block.b + at, pair.b, use.movesB, at);
        return;
    }
    const bool isA = use.shared == Shared::BodyA;
    const Quad& own = isA ? pair.a : pair.b;
    store(copies.x + at, own.x);
    store(copies.y + at, own.y);
    store(copies.z + at, own.z);
    if (isA) {
        putBack(motion, block.b + at, pair.b, use.movesB, at);
    } else {
        putBack(motion, block.a + at, pair.a, use.movesA, at);
    }
}

/// Exact if all values are equal, whatever their number of digits.
KODO_LANES_INLINE Real meanOf(const Real* copies) {
    return (((copies[0] + copies[1]) + (copies[2] + copies[3])) +
            ((copies[4] + copies[5]) + (copies[6] + copies[7]))) /
           ContactBlock::kContacts;
}

KODO_LANES_INLINE void averageCopies(const ContactBlock& block, BodyVelocity* motion,
                                     const BlockUse& use, const Copies& copies) {
    const std::uint32_t place = use.shared == Shared::BodyA ? block.a[0] : block.b[0];
    Real* const speed = firstHalf(motion) + place;
    speed[0] = meanOf(copies.x);
    speed[1] = meanOf(copies.y);
    speed[2] = meanOf(copies.z);
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
