// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/brute_force.hpp>
#include <kodo/broad/grid.hpp>
#include <kodo/broad/sort_and_sweep.hpp>

namespace kodo::inline KODO_PRECISION {

/// Finds pairs in the way that is the cheapest here: brute force while there are few bounds, else
/// a grid or sort and sweep. From time to time the one of these that is not in use has a turn, and
/// takes over if it needed clearly fewer tests. All of them find the same pairs.
class PairFinder {
public:
    enum class Way : std::uint8_t { BruteForce, Grid, SortAndSweep };

    // Up to here the brute force beats sorting.
    static constexpr std::size_t kBruteForceLimit = 32;

    /// Every pair of overlapping bounds, of which at least one has moved, that
    /// `accept(first, second)` lets through, in order.
    template <typename Accept>
    void pairs(std::span<const Aabb> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out, Crew& crew) {
        if (bounds.size() <= kBruteForceLimit) {
            bruteForce(bounds, moved, accept, out);
        } else {
            search(bounds, moved, accept, out, crew);
        }
        sorter_.sort(out, bounds.size());
    }

    /// Of the last call with that many bounds.
    Way way(std::size_t count) const { return count <= kBruteForceLimit ? Way::BruteForce : way_; }

private:
    static constexpr std::uint32_t kTrialInterval = 64;
    // What sorting one of the bounds in costs, in tests.
    static constexpr std::size_t kGridCost = 8;
    static constexpr std::size_t kSweepCost = 4;

    template <typename Accept>
    void search(std::span<const Aabb> bounds, const Moved& moved, Accept accept,
                std::vector<BoundsPair>& out, Crew& crew) {
        const bool trial = ++calls_ % kTrialInterval == 0;
        if ((way_ == Way::Grid) != trial) {
            grid_.pairs(bounds, moved, accept, out, crew);
            gridCost_ = kGridCost * bounds.size() + grid_.testCount();
        } else {
            sweep_.pairs(bounds, moved, accept, out);
            sweepCost_ = kSweepCost * bounds.size() + sweep_.testCount();
        }
        if (trial) {
            compareCosts();
        }
    }

    void compareCosts() {
        const bool swap =
            way_ == Way::Grid ? sweepCost_ * 5 < gridCost_ * 4 : gridCost_ * 5 < sweepCost_ * 4;
        if (swap) {
            way_ = way_ == Way::Grid ? Way::SortAndSweep : Way::Grid;
        }
    }

    Grid grid_;
    SortAndSweep sweep_;
    PairSorter sorter_;
    Way way_ = Way::Grid;
    std::uint32_t calls_ = 0;
    std::size_t gridCost_ = 0;
    std::size_t sweepCost_ = 0;
};

} // namespace kodo::inline KODO_PRECISION
