// SPDX-License-Identifier: MIT
#include "broad/pair_finder.hpp"

#include <algorithm>
#include <bit>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// ps; brute force that costs no more is chosen without comparison of the algorithms.
constexpr std::uint64_t kLittle = 2000000;
// A trial of an unused algorithm may cost 1 / kTrialShare of the work since its last trial.
constexpr std::uint64_t kTrialShare = 32;
// Calls after which the order of sweep and prune counts as outdated. A step searches for pairs at
// most twice, and the second search is usually small.
constexpr std::uint64_t kOrderCalls = 4;

} // namespace

std::uint64_t PairFinder::expectGrid(std::size_t bounds, std::size_t moved) const {
    const std::uint64_t perMoved =
        gridMoved_ == 0 ? 5 * gridPerBounds_ : gridSearch_ / gridMoved_; // initial estimate
    return gridPerBounds_ * bounds + perMoved * moved;
}

std::uint64_t PairFinder::expectSweep(std::size_t bounds) const {
    if (sweepPerBounds_ > 0) {
        return sweepPerBounds_ * bounds;
    }
    // In a square heap, the interval of each bounds overlaps those of one column.
    PairWork guess;
    guess.addRefreshed(bounds);
    guess.addSwept(bounds << (std::bit_width(bounds) / 2));
    return guess.picoseconds();
}

/// Reserves memory for all algorithms, so that a later trial allocates nothing.
void PairFinder::reserve(std::size_t bounds) {
    if (bounds > reserved_) {
        reserved_ = 2 * bounds;
        bruteForce_.reserve(reserved_);
        grid_.reserve(reserved_);
        sweepAndPrune_.reserve(reserved_);
    }
}

PairSearch PairFinder::choose(std::size_t bounds, std::size_t moved) const {
    const std::uint64_t brute = BruteForce::work(bounds, moved).picoseconds();
    if (brute <= kLittle) {
        return PairSearch::BruteForce;
    }
    const std::uint64_t grid = expectGrid(bounds, moved);
    const std::uint64_t sweep = expectSweep(bounds);
    if (sweepAgain_ || work_ - sweepSince_ > kTrialShare * 2 * sweep) { // a trial takes two calls
        return PairSearch::SweepAndPrune;
    }
    if (work_ - gridSince_ > kTrialShare * grid) {
        return PairSearch::Grid;
    }
    const std::uint64_t least = std::min({brute, grid, sweep});
    return least == grid    ? PairSearch::Grid
           : least == sweep ? PairSearch::SweepAndPrune
                            : PairSearch::BruteForce;
}

/// Averages the search cost over the last trials with weights that halve each time. A trial with a
/// single moved bounds says little about one in which all have moved.
void PairFinder::noteGrid(std::size_t bounds, std::size_t moved) {
    const std::uint64_t all = grid_.work().picoseconds();
    const std::uint64_t built = grid_.workToBuild().picoseconds();
    work_ += all;
    gridPerBounds_ = built / std::max<std::size_t>(bounds, 1);
    gridSearch_ = gridSearch_ / 2 + (all - built);
    gridMoved_ = gridMoved_ / 2 + moved;
    gridSince_ = work_;
}

void PairFinder::noteSweep(std::size_t bounds) {
    const std::uint64_t all = sweepAndPrune_.work().picoseconds();
    work_ += all;
    sweepAgain_ = calls_ - sweepCall_ > kOrderCalls && !sweepAgain_;
    sweepCall_ = calls_;
    if (!sweepAgain_) {
        sweepPerBounds_ = all / std::max<std::size_t>(bounds, 1) + 1;
    }
    sweepSince_ = work_;
}

} // namespace KODO_PRECISION
} // namespace kodo
