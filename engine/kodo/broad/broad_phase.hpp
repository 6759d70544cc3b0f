// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/octagon.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Two bounds that overlap, by their place in the list; first < second.
struct BoundsPair {
    std::uint32_t first;
    std::uint32_t second;
    friend constexpr auto operator<=>(BoundsPair, BoundsPair) = default;
};

/// The ways to look for pairs. All find the same ones.
enum class PairSearch : std::uint8_t { BruteForce, Grid, SortAndSweep };

/// What a search took, counted and not timed, so that it is the same on every machine; each count
/// weighs what its work takes. What all ways have in common is left out: asking whether a pair is
/// wanted, writing it down, putting pairs in order.
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
    // ps. Those of the grid and of brute force are fitted to CPU times of 160 random scenes of 300
    // to 12,000 bounds, dense and sparse, of equal and of mixed sizes; the others to what tumbler,
    // circles and debris take longer by `kodo-bench --pairs brute|sweep --stages` than by grid (g++
    // 12 -O3, x86-64, float). Sums are right to a quarter, so two ways between which they choose
    // may differ by that much more on a clock. Machines differ in speed, and less in these ratios.
    static constexpr std::uint64_t kCompare = 430;   // two bounds, by brute force
    static constexpr std::uint64_t kSweep = 6000;    // the same, while sweeping
    static constexpr std::uint64_t kRefresh = 10000; // the ends of one of the bounds to be swept
    static constexpr std::uint64_t kShift = 600;     // by one place, where insertion sorts them
    static constexpr std::uint64_t kSort = 6500;     // a comparison, where they are sorted anew
    static constexpr std::uint64_t kFile = 12000;    // one of the bounds into its cell
    static constexpr std::uint64_t kCell = 750;      // to clear it and to add it up
    static constexpr std::uint64_t kRow = 25000;     // of cells, looked into
    static constexpr std::uint64_t kTest = 1900;     // an entry of a cell

    std::uint64_t picoseconds_ = 0;
};

/// Whose pairs are wanted: those in `list`; `flags` tells by place. All bounds that are not as they
/// were in the last call are among them.
struct Moved {
    std::span<const std::uint32_t> list;
    std::span<const std::uint8_t> flags;

    bool has(std::uint32_t i) const { return flags[i] != 0; }
};

/// Do the bounds of m, which has moved, overlap those of another? Their boxes do. Of two that have
/// moved only the one with the lower place finds the other. Without a branch, since nobody could
/// foresee it.
inline bool meets(std::uint32_t m, std::uint32_t other, std::span<const Octagon> bounds,
                  const Moved& moved) {
    const bool metAlready = moved.has(other) & (other <= m);
    return !metAlready & overlap(bounds[m], bounds[other]);
}

/// Adds the pair of one that has moved and another that it meets, if `accept(first, second)` lets
/// it through.
template <typename Accept>
void addPair(std::uint32_t m, std::uint32_t other, Accept accept, std::vector<BoundsPair>& out) {
    const BoundsPair pair = other < m ? BoundsPair{other, m} : BoundsPair{m, other};
    if (accept(pair.first, pair.second)) {
        out.push_back(pair);
    }
}

/// Puts pairs in order: by the second of each into place, and then by the first.
class PairSorter {
public:
    /// `count`: all places are below it.
    void sort(std::vector<BoundsPair>& pairs, std::size_t count);

private:
    void copyBy(std::uint32_t BoundsPair::*member, std::span<const BoundsPair> from,
                std::span<BoundsPair> to, std::size_t count);

    std::vector<std::uint32_t> starts_;
    std::vector<BoundsPair> spare_;
};

} // namespace kodo::inline KODO_PRECISION
