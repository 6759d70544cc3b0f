// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/broad_phase.hpp>
#include <kodo/broad/packed_bounds.hpp>

#include <utility>

namespace kodo::inline KODO_PRECISION {

/// Compares all bounds with each that has moved: the fastest way while they are few, or few have
/// moved.
class BruteForce {
public:
    /// Every pair of overlapping bounds, of which at least one has moved, that
    /// `accept(first, second)` lets through, each once, in any order.
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
            packed_.hide(m); // or each would meet itself, and most meet nobody else
            PackedBounds::Hits hits;
            for (std::uint32_t next = 0; next < count;) {
                next = packed_.find(bounds[m].box(), next, count, hits);
                hits.meetAll([&](std::uint32_t i) { return meets(m, i, bounds, moved); },
                             [&](std::uint32_t i) { addPair(m, i, accept, out); });
            }
            packed_.set(m, bounds[m].box());
        }
    }

    /// Some bounds have moved without it being asked for their pairs, or are in another order.
    void forget() { packedCount_ = 0; }
    /// Memory for so many bounds.
    void reserve(std::size_t bounds) { packed_.reserve(bounds); }

    /// What it takes for so many, of which so many have moved.
    static PairWork work(std::size_t bounds, std::size_t moved) {
        PairWork work;
        work.addCompared(bounds * moved);
        return work;
    }

private:
    PackedBounds packed_;
    std::uint32_t packedCount_ = 0;
};

} // namespace kodo::inline KODO_PRECISION
