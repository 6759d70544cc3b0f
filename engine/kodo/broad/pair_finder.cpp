// SPDX-License-Identifier: MIT
#include <kodo/broad/pair_finder.hpp>

#include <algorithm>
#include <bit>

namespace kodo::inline KODO_PRECISION {
namespace {

// ps; if brute force takes no more, it is taken without asking what the others would take.
constexpr std::uint64_t kLittle = 2000000;
// A turn of the idle one may take this share of what has been spent since its last one.
constexpr std::uint64_t kTurnShare = 32;
// Sort and sweep still knows the order well enough if its last turn was so many calls ago: a step
// looks for pairs twice at most, and seldom for those of many the second time.
constexpr std::uint64_t kStillSorted = 4;

} // namespace

std::uint64_t PairFinder::expectGrid(std::size_t bounds, std::size_t moved) const {
    const std::uint64_t perMoved =
        gridMoved_ == 0 ? 5 * gridPerBounds_ : gridSearch_ / gridMoved_; // at first a guess
    return gridPerBounds_ * bounds + perMoved * moved;
}

std::uint64_t PairFinder::expectSweep(std::size_t bounds) const {
    if (sweepPerBounds_ > 0) {
        return sweepPerBounds_ * bounds;
    }
    // In a square heap each reaches over as many as stand in a column of it.
    PairWork guess;
    guess.addRefreshed(bounds);
    guess.addSwept(bounds << (std::bit_width(bounds) / 2));
    return guess.picoseconds();
}

/// A way has its first turn at some time, and then a step must not allocate.
void PairFinder::reserve(std::size_t bounds) {
    if (bounds > reserved_) {
        reserved_ = 2 * bounds;
        bruteForce_.reserve(reserved_);
        grid_.reserve(reserved_);
        sweep_.reserve(reserved_);
    }
}

PairSearch PairFinder::choose(std::size_t bounds, std::size_t moved) const {
    const std::uint64_t brute = BruteForce::work(bounds, moved).picoseconds();
    if (brute <= kLittle) {
        return PairSearch::BruteForce;
    }
    const std::uint64_t grid = expectGrid(bounds, moved);
    const std::uint64_t sweep = expectSweep(bounds);
    if (sweepAgain_ || work_ - sweepSince_ > kTurnShare * 2 * sweep) { // two calls make a turn
        return PairSearch::SortAndSweep;
    }
    if (work_ - gridSince_ > kTurnShare * grid) {
        return PairSearch::Grid;
    }
    const std::uint64_t least = std::min({brute, grid, sweep});
    return least == grid    ? PairSearch::Grid
           : least == sweep ? PairSearch::SortAndSweep
                            : PairSearch::BruteForce;
}

/// The search of the last turns counts, each half as much as the one after it: a turn in which one
/// large body has moved tells little about one in which all have.
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
    const std::uint64_t all = sweep_.work().picoseconds();
    work_ += all;
    sweepAgain_ = calls_ - sweepCall_ > kStillSorted && !sweepAgain_;
    sweepCall_ = calls_;
    if (!sweepAgain_) {
        sweepPerBounds_ = all / std::max<std::size_t>(bounds, 1) + 1;
    }
    sweepSince_ = work_;
}

} // namespace kodo::inline KODO_PRECISION
