// SPDX-License-Identifier: MIT
#pragma once

#include "broad/broad_phase.hpp"
#include "broad/packed_bounds.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// Compares each moved bounds with all others. The fastest algorithm if there are few bounds or few
/// have moved.
class BruteForce {
public:
    /// Appends each overlapping pair with at least one moved member for which `accept(first,
    /// second)` is true, once, in unspecified order.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out) {
        const auto count = static_cast<std::uint32_t>(bounds.size());
        if (std::exchange(packedCount_, count) != count) {
            packed_.resize(count);
            for (std::uint32_t i = 0; i < count; ++i) {
                packed_.set(i, bounds[i].box());
            }
        } else {
            for (const std::uint32_t m : moved.list) {
                packed_.set(m, bounds[m].box());
            }
        }
        for (const std::uint32_t m : moved.list) {
            packed_.hide(m); // excludes the pair of m with itself
            PackedBounds::Hits hits;
            for (std::uint32_t next = 0; next < count;) {
                next = packed_.find(bounds[m].box(), next, count, hits);
                hits.meetAll([&](std::uint32_t i) { return meets(m, i, bounds, moved); },
                             [&](std::uint32_t i) { addPair(m, i, accept, out); });
            }
            packed_.set(m, bounds[m].box());
        }
    }

    /// Call if bounds have moved without a call of pairs(), or are in another order.
    void forget() { packedCount_ = 0; }
    /// Reserves memory for that many bounds.
    void reserve(std::size_t bounds) { packed_.reserve(bounds); }

    /// Predicted cost for these numbers of bounds and of moved bounds.
    static PairWork work(std::size_t bounds, std::size_t moved) {
        PairWork work;
        work.addCompared(bounds * moved);
        return work;
    }

private:
    PackedBounds packed_;
    std::uint32_t packedCount_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
