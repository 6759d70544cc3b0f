// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/broad/broad_phase.hpp>
#include <kodo/broad/packed_bounds.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace kodo::inline KODO_PRECISION {

/// Sorts bounds into square cells by their centres. A level of cells holds bounds up to twice the
/// size of a cell; larger ones go to a level of larger cells. Whoever looks for what overlaps a box
/// looks into the cells that it reaches, grown to each side by as far as bounds of that level reach
/// from their centres, row by row, where they lie side by side in memory.
///
/// The cells cover where most of the bounds are. What lies outside counts to the cells at the edge,
/// so an escaped body costs nothing but the time of that cell.
class Grid {
public:
    /// Every pair of overlapping bounds, of which at least one has moved, that
    /// `accept(first, second)` lets through, each once, in any order. Several threads call it.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out, Crew& crew) {
        work_ = {};
        build(bounds, crew);
        built_ = work_;
        tests_ = 0;
        std::size_t rows = 0;
        found_.gather(crew, moved.list.size(), kBoundsAPiece, out,
                      [&](std::size_t first, std::size_t last, std::vector<BoundsPair>& found) {
                          Looked looked;
                          for (std::size_t k = first; k < last; ++k) {
                              meetAll(bounds, moved, moved.list[k], accept, found, looked);
                          }
                          crew.count(rows, looked.rows);
                          crew.count(tests_, looked.tests);
                      });
        work_.addRows(rows);
        work_.addTested(tests_);
    }

    /// Memory for so many bounds.
    void reserve(std::size_t bounds);

    /// Bounds that were compared in the last call: what it had to test.
    std::size_t testCount() const { return tests_; } // for tests
    /// Of the last call: all of it, and what it took to fill the cells, whoever has moved.
    PairWork work() const { return work_; }
    PairWork workToBuild() const { return built_; }

private:
    static constexpr std::size_t kBoundsAPiece = 64;
    /// Holds nothing: united with a point it is that point.
    static constexpr Aabb kEmpty{
        {std::numeric_limits<Real>::max(), std::numeric_limits<Real>::max()},
        {std::numeric_limits<Real>::lowest(), std::numeric_limits<Real>::lowest()}};

    /// What a search has looked at: rows of cells, and bounds in them.
    struct Looked {
        std::size_t rows = 0;
        std::size_t tests = 0;
    };
    struct Level {
        Real cell = 0; // m
        Real perCell = 0;
        std::uint32_t count = 0; // of its bounds
        Aabb centers = kEmpty;   // all of them are in here
        Aabb reach{};            // m; holds each of them, as seen from its own centre
        Vec2 origin{};           // m, lower left corner of the cells
        std::int32_t columns = 0;
        std::int32_t rows = 0;
        std::uint32_t begin = 0; // of its cells in starts_
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

    /// The pairs of one that has moved.
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

    /// Adds what overlaps a box to the hits, and asks for them whenever they are full.
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
    /// Of a level: in which the centres may be of what overlaps a box.
    Range cellsNear(const Level& level, const Aabb& box) const {
        const auto& [lower, upper] = level.reach;
        return {columnOf(level, box.lower.x - upper.x), columnOf(level, box.upper.x - lower.x),
                rowOf(level, box.lower.y - upper.y), rowOf(level, box.upper.y - lower.y)};
    }

    void build(std::span<const Octagon> bounds, Crew& crew);
    void fillCells(std::span<const Octagon> bounds, std::size_t cells, Crew& crew);
    void chooseCell(std::span<const Octagon> bounds);
    void findLevels(std::span<const Octagon> bounds, std::size_t first, std::size_t last,
                    std::span<Level> levels);
    void assignLevels(std::span<const Octagon> bounds, Crew& crew);
    void chooseWindow(Level& level, std::span<const Octagon> bounds);
    Real middle(const Level& level, std::span<const Octagon> bounds, Real Vec2::*axis);

    Real cell_ = 0; // m, of the lowest level
    std::uint32_t calls_ = 0;
    std::vector<Level> levels_;
    std::vector<std::uint8_t> levelOf_;
    std::vector<std::uint32_t> placeOf_; // its cell, and then where in packed_ it is
    std::vector<std::uint32_t> starts_;  // by cell: its first entry; one more at the end
    PackedBounds packed_;                // cell by cell
    std::vector<std::uint32_t> index_;   // of those
    std::vector<Real> sizes_;            // or centres, to find the middle one
    std::vector<Level> levelsOfPieces_;  // while levels are assigned
    Findings<Level> levelsFound_;
    Findings<BoundsPair> found_;
    std::size_t tests_ = 0;
    PairWork work_;
    PairWork built_;
};

} // namespace kodo::inline KODO_PRECISION
