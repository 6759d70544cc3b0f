// SPDX-License-Identifier: MIT
#include "broad/grid.hpp"

#include "base/vector_reuse.hpp"

#include <cmath>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kCellInterval = 64; // calls between two choices of the cell size
constexpr Real kLevelStep = 4;              // ratio of the cell sizes of consecutive levels
constexpr Real kWidest = 2;                 // in cells; wider bounds go to a higher level
constexpr std::size_t kLevels = 16;         // maximum; empty levels are removed
constexpr std::size_t kFiledPerPiece = 512;
// Scales the extents, so that rounding does not hide bounds that just touch.
constexpr Real kRounded = 1 + 4 * std::numeric_limits<Real>::epsilon();
constexpr Real kCellsPerBounds = 4; // maximum, so that clearing them costs little

Real sizeOf(const Octagon& bounds) {
    const Vec2 extent = bounds.box().extent();
    return std::max(extent.x, extent.y);
}

} // namespace

void Grid::reserve(std::size_t bounds) {
    levels_.reserve(kLevels);
    levelsOfPieces_.reserve(kLevels * (bounds / kFiledPerPiece + 1));
    levelOf_.reserve(bounds);
    placeOf_.reserve(bounds);
    starts_.reserve(static_cast<std::size_t>(kCellsPerBounds) * bounds + kLevels + 1);
    packed_.reserve(bounds);
    index_.reserve(bounds);
    sizes_.reserve(bounds);
}

/// Cell size of the lowest level: 75 % of the bounds are no larger.
void Grid::chooseCell(std::span<const Octagon> bounds) {
    sizes_.clear();
    for (const Octagon& each : bounds) {
        sizes_.push_back(sizeOf(each));
    }
    const auto place = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() * 3 / 4);
    std::nth_element(sizes_.begin(), place, sizes_.end()); // total order: equal sizes are identical
    cell_ = std::max(*place, Real(1e-30));
}

/// Assigns a range of bounds to levels and accumulates the statistics of the levels.
void Grid::findLevels(std::span<const Octagon> bounds, std::size_t first, std::size_t last,
                      std::span<Level> levels) {
    for (std::size_t i = first; i < last; ++i) {
        const Real size = sizeOf(bounds[i]);
        std::uint8_t at = 0;
        while (at + 1u < kLevels && size > kWidest * levels[at].cell) {
            ++at;
        }
        Level& level = levels[at];
        const Aabb box = bounds[i].box();
        const Vec2 center = box.center();
        level.centers = unite(level.centers, {center, center});
        level.reach = unite(level.reach, {box.lower - center, box.upper - center});
        ++level.count;
        levelOf_[i] = at;
    }
}

void Grid::assignLevels(std::span<const Octagon> bounds, WorkerTeam& team) {
    levels_.clear();
    for (Real cell = cell_; levels_.size() < kLevels; cell *= kLevelStep) {
        levels_.push_back({.cell = cell});
    }
    levelOf_.resize(bounds.size());
    levelsOfPieces_.clear();
    levelsFound_.gather(team, bounds.size(), kFiledPerPiece, levelsOfPieces_,
                        [&](std::size_t first, std::size_t last, std::vector<Level>& found) {
                            found.insert(found.end(), levels_.begin(), levels_.end());
                            findLevels(bounds, first, last, std::span(found).last(kLevels));
                        });
    for (std::size_t i = 0; i < levelsOfPieces_.size(); ++i) {
        Level& level = levels_[i % kLevels];
        level.count += levelsOfPieces_[i].count;
        level.centers = unite(level.centers, levelsOfPieces_[i].centers);
        level.reach = unite(level.reach, levelsOfPieces_[i].reach);
    }
}

/// The cells cover the whole level if their number permits it. Otherwise they surround the median
/// of its centres.
void Grid::chooseWindow(Level& level, std::span<const Octagon> bounds) {
    level.perCell = 1 / level.cell;
    const Vec2 wanted = level.perCell * level.centers.extent() + Vec2{1, 1};
    const Real most = kCellsPerBounds * static_cast<Real>(level.count);
    Vec2 cells = wanted;
    if (wanted.x * wanted.y > most) {
        cells.x = std::min(wanted.x, std::sqrt(most));
        cells.y = std::min(wanted.y, most / cells.x);
        cells.x = std::min(wanted.x, most / cells.y);
    }
    level.columns = static_cast<std::int32_t>(std::max(cells.x, Real(1)));
    level.rows = static_cast<std::int32_t>(std::max(cells.y, Real(1)));
    level.origin = level.centers.lower;
    if (cells.x < wanted.x) {
        level.origin.x = middle(level, bounds, &Vec2::x) - cells.x / 2 * level.cell;
    }
    if (cells.y < wanted.y) {
        level.origin.y = middle(level, bounds, &Vec2::y) - cells.y / 2 * level.cell;
    }
}

/// Median of the centres of a level along one axis.
Real Grid::middle(const Level& level, std::span<const Octagon> bounds, Real Vec2::*axis) {
    sizes_.clear();
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (&levels_[levelOf_[i]] == &level) {
            sizes_.push_back(bounds[i].box().center().*axis);
        }
    }
    const auto place = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
    // total order: equal numbers are identical
    std::nth_element(sizes_.begin(), place, sizes_.end());
    return *place;
}

void Grid::build(std::span<const Octagon> bounds, WorkerTeam& team) {
    if (levelOf_.size() != bounds.size() || calls_ % kCellInterval == 0) {
        chooseCell(bounds);
    }
    ++calls_;
    work_.addFiled(bounds.size());
    assignLevels(bounds, team);
    std::size_t cells = 0;
    for (Level& level : levels_) {
        if (level.count > 0) {
            chooseWindow(level, bounds);
            level.reach = {kRounded * level.reach.lower, kRounded * level.reach.upper};
            level.begin = static_cast<std::uint32_t>(cells);
            cells += static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows);
        }
    }
    work_.addCells(cells);
    fillCells(bounds, cells, team);
    std::erase_if(levels_, [](const Level& level) { return level.count == 0; });
}

/// Sorts the bounds into `cells` cells.
void Grid::fillCells(std::span<const Octagon> bounds, std::size_t cells, WorkerTeam& team) {
    placeOf_.resize(bounds.size());
    team.forEach(bounds.size(), kFiledPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Level& level = levels_[levelOf_[i]];
            const Vec2 center = bounds[i].box().center();
            const std::int32_t cell =
                rowOf(level, center.y) * level.columns + columnOf(level, center.x);
            placeOf_[i] = level.begin + static_cast<std::uint32_t>(cell);
        }
    });
    assignReusing(starts_, cells + 1, 0u);
    for (const std::uint32_t cell : placeOf_) {
        ++starts_[cell];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) {
        sum += start;
        start = sum; // end of the cell until its entries are inserted
    }
    for (std::size_t i = bounds.size(); i-- > 0;) {
        placeOf_[i] = --starts_[placeOf_[i]];
    }
    packed_.resize(bounds.size());
    index_.resize(bounds.size());
    team.forEach(bounds.size(), kFiledPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            packed_.set(placeOf_[i], bounds[i].box());
            index_[placeOf_[i]] = static_cast<std::uint32_t>(i);
        }
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
