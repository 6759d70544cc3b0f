// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/step_stats.hpp>

#include "math/octagon.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Two overlapping bounds, by their indices in the list; first < second.
struct BoundsPair {
    std::uint32_t first;
    std::uint32_t second;
    friend constexpr auto operator<=>(BoundsPair, BoundsPair) = default;
};

/// Cost of a search, computed from weighted operation counts instead of a clock, so that it is the
/// same on every machine. Costs common to all algorithms are excluded: filtering, storing and
/// sorting pairs.
class PairWork {
public:
    void addCompared(std::size_t bounds) { picoseconds_ += kCompare * bounds; }
    void addSwept(std::size_t pairs) { picoseconds_ += kSweep * pairs; }
    void addRefreshed(std::size_t ends) { picoseconds_ += kRefresh * ends; }
    void addShifted(std::size_t ends) { picoseconds_ += kShift * ends; }
    void addSorted(std::size_t comparisons) { picoseconds_ += kSort * comparisons; }
    void addFiled(std::size_t bounds) { picoseconds_ += kFile * bounds; }
    void addCells(std::size_t cells) { picoseconds_ += kCell * cells; }
    void addRows(std::size_t rows) { picoseconds_ += kRow * rows; }
    void addTested(std::size_t entries) { picoseconds_ += kTest * entries; }

    std::uint64_t picoseconds() const { return picoseconds_; }

private:
    // ps. Weights of the grid and of brute force are fitted to CPU times of 160 random scenes of
    // 300 to 12,000 bounds: dense and sparse, of equal and of mixed sizes. The other weights are
    // fitted to the extra time of tumbler, circles and debris with `kodo-bench --pairs brute|sweep
    // --stages` over the grid. Compiler: g++ 12 -O3, x86-64, float. Sums are accurate to 25 %. The
    // ratios depend little on the machine.
    static constexpr std::uint64_t kCompare = 430;   // two bounds, by brute force
    static constexpr std::uint64_t kSweep = 6000;    // two bounds, during a sweep
    static constexpr std::uint64_t kRefresh = 10000; // update of an interval of the sweep
    static constexpr std::uint64_t kShift = 600;     // one position in insertion sort
    static constexpr std::uint64_t kSort = 6500;     // one comparison in a full sort
    static constexpr std::uint64_t kFile = 12000;    // insertion of bounds into a cell
    static constexpr std::uint64_t kCell = 750;      // clearing and prefix sum of a cell
    static constexpr std::uint64_t kRow = 25000;     // visit of a row of cells
    static constexpr std::uint64_t kTest = 1900;     // test of an entry of a cell

    std::uint64_t picoseconds_ = 0;
};

/// The bounds whose pairs are searched: their indices in `list`, and a flag for each index. All
/// bounds that changed since the last call must be included.
struct Moved {
    std::span<const std::uint32_t> list;
    std::span<const std::uint8_t> flags;

    bool has(std::uint32_t i) const { return flags[i] != 0; }
};

/// True if the pair of moved bounds m and of `other` is to be reported; precondition: their boxes
/// overlap. If both have moved, only the one with the lower index reports the pair. Branchless: a
/// branch here mispredicts.
inline bool meets(std::uint32_t m, std::uint32_t other, std::span<const Octagon> bounds,
                  const Moved& moved) {
    const bool metAlready = moved.has(other) & (other <= m);
    return !metAlready & overlap(bounds[m], bounds[other]);
}

/// Appends the pair of moved bounds m and of `other` if `accept(first, second)` is true.
template <typename Accept>
void addPair(std::uint32_t m, std::uint32_t other, Accept accept, std::vector<BoundsPair>& out) {
    const BoundsPair pair = other < m ? BoundsPair{other, m} : BoundsPair{m, other};
    if (accept(pair.first, pair.second)) {
        out.push_back(pair);
    }
}

/// Radix sort of pairs: by `second`, then stably by `first`.
class PairSorter {
public:
    /// `count`: upper bound of all indices, exclusive.
    void sort(std::vector<BoundsPair>& pairs, std::size_t count);

private:
    void copyBy(std::uint32_t BoundsPair::*member, std::span<const BoundsPair> from,
                std::span<BoundsPair> to, std::size_t count);

    std::vector<std::uint32_t> starts_;
    std::vector<BoundsPair> spare_;
};

} // namespace KODO_PRECISION
} // namespace kodo
