// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/broad/grid.hpp>

#include <cmath>
#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::uint32_t kCellInterval = 64; // calls between two looks at the sizes
constexpr Real kLevelStep = 4;              // each level's cells are so many times wider
constexpr Real kWidest = 2;                 // what is wider than so many cells is not in the level
constexpr std::size_t kLevels = 16;         // at most: those that nothing is in are dropped
constexpr std::size_t kFiledAPiece = 512;
// Reaches are lengthened by it, or a rounding could hide what just touches.
constexpr Real kRounded = 1 + 4 * std::numeric_limits<Real>::epsilon();
constexpr Real kCellsPerBounds = 4; // at most, so that clearing them costs little

Real sizeOf(const Octagon& bounds) {
    const Vec2 extent = bounds.box().extent();
    return std::max(extent.x, extent.y);
}

} // namespace

void Grid::reserve(std::size_t bounds) {
    levels_.reserve(kLevels);
    levelsOfPieces_.reserve(kLevels * (bounds / kFiledAPiece + 1));
    levelOf_.reserve(bounds);
    placeOf_.reserve(bounds);
    starts_.reserve(static_cast<std::size_t>(kCellsPerBounds) * bounds + kLevels + 1);
    packed_.reserve(bounds);
    index_.reserve(bounds);
    sizes_.reserve(bounds);
}

/// Three quarters of the bounds are no larger than a cell of the lowest level.
void Grid::chooseCell(std::span<const Octagon> bounds) {
    sizes_.clear();
    for (const Octagon& each : bounds) {
        sizes_.push_back(sizeOf(each));
    }
    const auto place = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() * 3 / 4);
    std::nth_element(sizes_.begin(), place, sizes_.end()); // total order: equal sizes are the same
    cell_ = std::max(*place, Real(1e-30));
}

/// Finds the levels of a piece of the bounds, and what these make of the levels.
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

void Grid::assignLevels(std::span<const Octagon> bounds, Crew& crew) {
    levels_.clear();
    for (Real cell = cell_; levels_.size() < kLevels; cell *= kLevelStep) {
        levels_.push_back({.cell = cell});
    }
    levelOf_.resize(bounds.size());
    levelsOfPieces_.clear();
    levelsFound_.gather(crew, bounds.size(), kFiledAPiece, levelsOfPieces_,
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

void Grid::build(std::span<const Octagon> bounds, Crew& crew) {
    if (levelOf_.size() != bounds.size() || calls_ % kCellInterval == 0) {
        chooseCell(bounds);
    }
    ++calls_;
    work_.addFiled(bounds.size());
    assignLevels(bounds, crew);
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
    fillCells(bounds, cells, crew);
    std::erase_if(levels_, [](const Level& level) { return level.count == 0; });
}

/// Puts the bounds into the cells, of which there are so many.
void Grid::fillCells(std::span<const Octagon> bounds, std::size_t cells, Crew& crew) {
    placeOf_.resize(bounds.size());
    crew.forEach(bounds.size(), kFiledAPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Level& level = levels_[levelOf_[i]];
            const Vec2 center = bounds[i].box().center();
            const std::int32_t cell =
                rowOf(level, center.y) * level.columns + columnOf(level, center.x);
            placeOf_[i] = level.begin + static_cast<std::uint32_t>(cell);
        }
    });
    refill(starts_, cells + 1, 0u);
    for (const std::uint32_t cell : placeOf_) {
        ++starts_[cell];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) {
        sum += start;
        start = sum; // the end of the cell, until its entries are in
    }
    for (std::size_t i = bounds.size(); i-- > 0;) {
        placeOf_[i] = --starts_[placeOf_[i]];
    }
    packed_.resize(bounds.size());
    index_.resize(bounds.size());
    crew.forEach(bounds.size(), kFiledAPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            packed_.set(placeOf_[i], bounds[i].box());
            index_[placeOf_[i]] = static_cast<std::uint32_t>(i);
        }
    });
}

} // namespace kodo::inline KODO_PRECISION
