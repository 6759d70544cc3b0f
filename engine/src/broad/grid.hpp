// SPDX-License-Identifier: MIT
#pragma once

#include "base/worker_team.hpp"
#include "broad/broad_phase.hpp"
#include "broad/packed_bounds.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// A hierarchical grid: bounds are sorted into square cells by their centres. The cells of a level
/// hold bounds up to twice the cell size; larger bounds go to a level with larger cells. A query of
/// a box visits the cells that the box covers, extended by the largest extent of bounds of that
/// level from their centres. Cells are visited row by row, contiguous in memory.
///
/// The cells cover the region of most bounds. Bounds outside belong to the cells at the edge, so an
/// escaped body costs no more than the time of that cell.
class Grid {
public:
    /// Appends each overlapping pair with at least one moved member for which `accept(first,
    /// second)` is true, once, in unspecified order. Several threads call `accept`.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out, WorkerTeam& team) {
        work_ = {};
        build(bounds, team);
        built_ = work_;
        tests_ = 0;
        std::size_t rows = 0;
        found_.gather(team, moved.list.size(), kBoundsPerPiece, out,
                      [&](std::size_t first, std::size_t last, std::vector<BoundsPair>& found) {
                          Looked looked;
                          for (std::size_t k = first; k < last; ++k) {
                              meetAll(bounds, moved, moved.list[k], accept, found, looked);
                          }
                          team.count(rows, looked.rows);
                          team.count(tests_, looked.tests);
                      });
        work_.addRows(rows);
        work_.addTested(tests_);
    }

    /// Reserves memory for that many bounds.
    void reserve(std::size_t bounds);

    /// Number of bounds compared in the last call.
    std::size_t testCount() const { return tests_; } // for tests
    /// Cost of the last call, and its part for filling the cells, which is independent of `moved`.
    PairWork work() const { return work_; }
    PairWork workToBuild() const { return built_; }

private:
    static constexpr std::size_t kBoundsPerPiece = 64;
    /// Empty: the union with a point is that point.
    static constexpr Aabb kEmpty{
        {std::numeric_limits<Real>::max(), std::numeric_limits<Real>::max()},
        {std::numeric_limits<Real>::lowest(), std::numeric_limits<Real>::lowest()}};

    /// Counts of a search: rows of cells visited, and bounds in them.
    struct Looked {
        std::size_t rows = 0;
        std::size_t tests = 0;
    };
    struct Level {
        Real cell = 0; // m
        Real perCell = 0;
        std::uint32_t count = 0; // of its bounds
        Aabb centers = kEmpty;   // contains the centres of all its bounds
        Aabb reach{};  // m; contains each of its bounds, relative to the centre of the bounds
        Vec2 origin{}; // m, lower left corner of the cells
        std::int32_t columns = 0;
        std::int32_t rows = 0;
        std::uint32_t begin = 0; // index of its first cell in starts_
    };

    std::int32_t columnOf(const Level& level, Real x) const {
        return cellOf((x - level.origin.x) * level.perCell, level.columns);
    }
    std::int32_t rowOf(const Level& level, Real y) const {
        return cellOf((y - level.origin.y) * level.perCell, level.rows);
    }
    static std::int32_t cellOf(Real cells, std::int32_t count) {
        const Real last = static_cast<Real>(count - 1);
        return static_cast<std::int32_t>(std::clamp(cells, Real(0), last));
    }

    /// Finds the pairs of moved bounds m.
    template <typename Accept>
    void meetAll(std::span<const Octagon> bounds, const Moved& moved, std::uint32_t m,
                 Accept accept, std::vector<BoundsPair>& found, Looked& looked) const {
        const Aabb box = bounds[m].box();
        const auto isMet = [&](std::uint32_t i) { return meets(m, index_[i], bounds, moved); };
        const auto meet = [&](std::uint32_t i) { addPair(m, index_[i], accept, found); };
        PackedBounds::Hits hits;
        for (const Level& level : levels_) {
            lookInto(level, box, isMet, meet, hits, looked);
        }
        hits.meetAll(isMet, meet);
    }

    /// Adds bounds that overlap the box to the hits, and processes the hits when they are full.
    template <typename IsMet, typename Meet>
    void lookInto(const Level& level, const Aabb& box, IsMet isMet, Meet meet,
                  PackedBounds::Hits& hits, Looked& looked) const {
        const Range near = cellsNear(level, box);
        looked.rows += static_cast<std::size_t>(near.top - near.bottom + 1);
        for (std::int32_t row = near.bottom; row <= near.top; ++row) {
            const std::uint32_t* const starts =
                starts_.data() + level.begin + static_cast<std::ptrdiff_t>(row) * level.columns;
            const std::uint32_t end = starts[near.right + 1];
            looked.tests += end - starts[near.left];
            for (std::uint32_t next = starts[near.left]; next < end;) {
                next = packed_.find(box, next, end, hits);
                if (hits.isFull()) {
                    hits.meetAll(isMet, meet);
                }
            }
        }
    }

    struct Range {
        std::int32_t left;
        std::int32_t right;
        std::int32_t bottom;
        std::int32_t top;
    };
    /// Cells of a level that may contain the centres of bounds that overlap the box.
    Range cellsNear(const Level& level, const Aabb& box) const {
        const auto& [lower, upper] = level.reach;
        return {columnOf(level, box.lower.x - upper.x), columnOf(level, box.upper.x - lower.x),
                rowOf(level, box.lower.y - upper.y), rowOf(level, box.upper.y - lower.y)};
    }

    void build(std::span<const Octagon> bounds, WorkerTeam& team);
    void fillCells(std::span<const Octagon> bounds, std::size_t cells, WorkerTeam& team);
    void chooseCell(std::span<const Octagon> bounds);
    void findLevels(std::span<const Octagon> bounds, std::size_t first, std::size_t last,
                    std::span<Level> levels);
    void assignLevels(std::span<const Octagon> bounds, WorkerTeam& team);
    void chooseWindow(Level& level, std::span<const Octagon> bounds);
    Real middle(const Level& level, std::span<const Octagon> bounds, Real Vec2::*axis);

    Real cell_ = 0; // m, of the lowest level
    std::uint32_t calls_ = 0;
    std::vector<Level> levels_;
    std::vector<std::uint8_t> levelOf_;
    std::vector<std::uint32_t> placeOf_; // index of its cell; later its index in packed_
    std::vector<std::uint32_t> starts_;  // by cell: index of its first entry; one more at the end
    PackedBounds packed_;                // sorted by cell
    std::vector<std::uint32_t> index_;   // by index in packed_: index of the bounds
    std::vector<Real> sizes_;            // or centres; to find the median
    std::vector<Level> levelsOfPieces_;  // while levels are assigned
    ParallelCollector<Level> levelsFound_;
    ParallelCollector<BoundsPair> found_;
    std::size_t tests_ = 0;
    PairWork work_;
    PairWork built_;
};

} // namespace KODO_PRECISION
} // namespace kodo
