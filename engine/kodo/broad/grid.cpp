// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/broad/grid.hpp>

#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::uint32_t kCellInterval = 64; // calls between two looks at the sizes
constexpr Real kLevelStep = 4;              // each level's cells are so many times wider
constexpr std::size_t kLevels = 16;         // at most: those that nothing is in are dropped
constexpr Real kCellsPerBounds = 4;         // at most, so that clearing them costs little

Real sizeOf(const Octagon& bounds) {
    const Vec2 extent = bounds.box().extent();
    return std::max(extent.x, extent.y);
}

} // namespace

void Grid::reserve(std::size_t bounds) {
    levels_.reserve(kLevels);
    levelOf_.reserve(bounds);
    cellOf_.reserve(bounds);
    starts_.reserve(static_cast<std::size_t>(kCellsPerBounds) * bounds + kLevels + 1);
    packed_.reserve(bounds);
    index_.reserve(bounds);
    sizes_.reserve(bounds);
}

/// The lowest level takes three quarters of the bounds.
void Grid::chooseCell(std::span<const Octagon> bounds) {
    sizes_.clear();
    for (const Octagon& each : bounds) {
        sizes_.push_back(sizeOf(each));
    }
    const auto place = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() * 3 / 4);
    std::nth_element(sizes_.begin(), place, sizes_.end()); // total order: equal sizes are the same
    cell_ = std::max(*place, Real(1e-30));
}

void Grid::assignLevels(std::span<const Octagon> bounds) {
    levels_.clear();
    for (Real cell = cell_; levels_.size() < kLevels; cell *= kLevelStep) {
        levels_.push_back({cell});
    }
    levelOf_.resize(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Real size = sizeOf(bounds[i]);
        std::uint8_t at = 0;
        while (at + 1u < kLevels && size > levels_[at].cell) {
            ++at;
        }
        Level& level = levels_[at];
        level.cell = std::max(level.cell, size); // the last level takes larger ones, too
        const Vec2 center = bounds[i].box().center();
        const Aabb all = level.count == 0 ? Aabb{center, center} : level.centers;
        level.centers = unite(all, {center, center});
        ++level.count;
        levelOf_[i] = at;
    }
}

/// All of the level where there are cells enough for that, else about the middle of what is in it.
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

/// The median of the centres of a level, along one axis.
Real Grid::middle(const Level& level, std::span<const Octagon> bounds, Real Vec2::*axis) {
    sizes_.clear();
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (&levels_[levelOf_[i]] == &level) {
            sizes_.push_back(bounds[i].box().center().*axis);
        }
    }
    const auto place = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
    // total order: equal numbers are the same
    std::nth_element(sizes_.begin(), place, sizes_.end());
    return *place;
}

void Grid::build(std::span<const Octagon> bounds) {
    if (levelOf_.size() != bounds.size() || calls_ % kCellInterval == 0) {
        chooseCell(bounds);
    }
    ++calls_;
    work_.addFiled(bounds.size());
    assignLevels(bounds);
    std::size_t cells = 0;
    for (Level& level : levels_) {
        if (level.count > 0) {
            chooseWindow(level, bounds);
            level.begin = static_cast<std::uint32_t>(cells);
            cells += static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows);
        }
    }
    work_.addCells(cells);
    refill(starts_, cells + 1, 0u);
    cellOf_.resize(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Level& level = levels_[levelOf_[i]];
        const Vec2 center = bounds[i].box().center();
        const std::int32_t cell =
            rowOf(level, center.y) * level.columns + columnOf(level, center.x);
        cellOf_[i] = level.begin + static_cast<std::uint32_t>(cell);
        ++starts_[cellOf_[i]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) {
        sum += start;
        start = sum; // the end of the cell, until its entries are in
    }
    packed_.resize(bounds.size());
    index_.resize(bounds.size());
    for (std::size_t i = bounds.size(); i-- > 0;) {
        const std::uint32_t place = --starts_[cellOf_[i]];
        packed_.set(place, bounds[i].box());
        index_[place] = static_cast<std::uint32_t>(i);
    }
    std::erase_if(levels_, [](const Level& level) { return level.count == 0; });
}

} // namespace kodo::inline KODO_PRECISION
