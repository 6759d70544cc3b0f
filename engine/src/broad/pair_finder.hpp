// SPDX-License-Identifier: MIT
#pragma once

#include "broad/brute_force.hpp"
#include "broad/grid.hpp"
#include "broad/sweep_and_prune.hpp"

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Finds pairs by the algorithm with the lowest expected cost, chosen for each call [after
/// Thesis06, 5.1.3]. The cost of brute force is known in advance. The costs of grid and of sweep
/// and prune are estimated from their recent calls, by number of bounds and of moved bounds.
/// Algorithms not in use run again as a trial whenever the accumulated work makes its cost
/// negligible. All algorithms find the same pairs.
class PairFinder {
public:
    /// Appends each overlapping pair with at least one moved member for which `accept(first,
    /// second)` is true, in order.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out, WorkerTeam& team) {
        const std::size_t count = bounds.size();
        ++calls_;
        reserve(count);
        algorithm_ = only_ ? *only_ : choose(count, moved.list.size());
        if (algorithm_ == PairSearch::BruteForce) {
            bruteForce_.pairs(bounds, moved, accept, out);
            work_ += BruteForce::work(count, moved.list.size()).picoseconds();
        } else {
            bruteForce_.forget();
            if (algorithm_ == PairSearch::Grid) {
                grid_.pairs(bounds, moved, accept, out, team);
                noteGrid(count, moved.list.size());
            } else {
                sweepAndPrune_.pairs(bounds, moved, accept, out);
                noteSweep(count);
            }
        }
        if (out.size() > 1) {
            sorter_.sort(out, count);
        }
    }

    /// Call if the bounds differ from those of the last call, or are in another order.
    void forget() { bruteForce_.forget(); }
    /// Fixes the algorithm; std::nullopt: the cheapest one for each call.
    void use(std::optional<PairSearch> only) { only_ = only; }
    PairSearch algorithm() const { return algorithm_; } // of the last call; for tests
    /// ps, total of all calls; see PairWork.
    std::uint64_t work() const { return work_; }

private:
    static constexpr std::size_t kFew = 32; // bounds; brute force usually suffices

    void reserve(std::size_t bounds);
    PairSearch choose(std::size_t bounds, std::size_t moved) const;
    void noteGrid(std::size_t bounds, std::size_t moved);
    void noteSweep(std::size_t bounds);
    std::uint64_t expectGrid(std::size_t bounds, std::size_t moved) const;
    std::uint64_t expectSweep(std::size_t bounds) const;

    BruteForce bruteForce_;
    Grid grid_;
    SweepAndPrune sweepAndPrune_;
    PairSorter sorter_;
    std::optional<PairSearch> only_;
    PairSearch algorithm_ = PairSearch::BruteForce;
    std::size_t reserved_ = kFew; // number of bounds for which all algorithms have memory
    std::uint64_t calls_ = 0;
    std::uint64_t work_ = 0; // ps
    // Costs of recent calls.
    std::uint64_t gridPerBounds_ = 20000; // ps; an estimate before the first trial
    std::uint64_t gridSearch_ = 0;        // ps, weighted sum over recent trials
    std::uint64_t gridMoved_ = 0;
    std::uint64_t sweepPerBounds_ = 0; // ps; 0: no trial yet
    std::uint64_t gridSince_ = 0;      // work_ at the last trial
    std::uint64_t sweepSince_ = 0;
    std::uint64_t sweepCall_ = 0; // call of its last trial
    bool sweepAgain_ = false;     // the last trial had to sort an outdated order
};

} // namespace KODO_PRECISION
} // namespace kodo
