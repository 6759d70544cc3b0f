// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/brute_force.hpp>
#include <kodo/broad/grid.hpp>
#include <kodo/broad/sort_and_sweep.hpp>

#include <optional>

namespace kodo::inline KODO_PRECISION {

/// Finds pairs in the way that is the cheapest here [after Thesis06, 5.1.3], call by call. What
/// brute force will take is known beforehand; what a grid, or sort and sweep, would take is what
/// they took lately, by how many bounds there are and how many have moved. The one that is not in
/// use has a turn whenever so much has been spent that the turn is next to nothing beside it. All
/// ways find the same pairs.
class PairFinder {
public:
    /// Every pair of overlapping bounds, of which at least one has moved, that
    /// `accept(first, second)` lets through, in order.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out, Crew& crew) {
        const std::size_t count = bounds.size();
        ++calls_;
        reserve(count);
        way_ = only_ ? *only_ : choose(count, moved.list.size());
        if (way_ == PairSearch::BruteForce) {
            bruteForce_.pairs(bounds, moved, accept, out);
            work_ += BruteForce::work(count, moved.list.size()).picoseconds();
        } else {
            bruteForce_.forget();
            if (way_ == PairSearch::Grid) {
                grid_.pairs(bounds, moved, accept, out, crew);
                noteGrid(count, moved.list.size());
            } else {
                sweep_.pairs(bounds, moved, accept, out);
                noteSweep(count);
            }
        }
        if (out.size() > 1) {
            sorter_.sort(out, count);
        }
    }

    /// The bounds are others than those of the last call, or in another order.
    void forget() { bruteForce_.forget(); }
    /// From now on in this way alone; nothing: in the cheapest.
    void use(std::optional<PairSearch> only) { only_ = only; }
    PairSearch way() const { return way_; } // of the last call; for tests
    /// ps, of all calls: see PairWork.
    std::uint64_t work() const { return work_; }

private:
    static constexpr std::size_t kFew = 32; // of which all are compared, as a rule

    void reserve(std::size_t bounds);
    PairSearch choose(std::size_t bounds, std::size_t moved) const;
    void noteGrid(std::size_t bounds, std::size_t moved);
    void noteSweep(std::size_t bounds);
    std::uint64_t expectGrid(std::size_t bounds, std::size_t moved) const;
    std::uint64_t expectSweep(std::size_t bounds) const;

    BruteForce bruteForce_;
    Grid grid_;
    SortAndSweep sweep_;
    PairSorter sorter_;
    std::optional<PairSearch> only_;
    PairSearch way_ = PairSearch::BruteForce;
    std::size_t reserved_ = kFew; // bounds for which all ways have their memory
    std::uint64_t calls_ = 0;
    std::uint64_t work_ = 0; // ps
    // What they took lately.
    std::uint64_t gridPerBounds_ = 20000; // ps; before the first turn a guess
    std::uint64_t gridSearch_ = 0;        // ps, of the last turns, for so many that had moved
    std::uint64_t gridMoved_ = 0;
    std::uint64_t sweepPerBounds_ = 0; // ps; 0: it had no turn yet
    std::uint64_t gridSince_ = 0;      // the work_ up to the last turn
    std::uint64_t sweepSince_ = 0;
    std::uint64_t sweepCall_ = 0; // of its last turn
    bool sweepAgain_ = false;     // in its last turn it had to sort what it did not know
};

} // namespace kodo::inline KODO_PRECISION
