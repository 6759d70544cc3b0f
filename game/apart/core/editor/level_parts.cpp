// SPDX-License-Identifier: MIT
#include <apart/core/editor/level_parts.hpp>
#include <apart/core/field.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace apart {

using kodo::Aabb;
using kodo::Real;
using kodo::Vec2;

namespace {

std::int32_t thousandthsOf(Real metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1000));
}

/// Calls `use` with each part of the level.
template <typename Use>
void forParts(const Level& level, Use use) {
    const auto all = [&](LevelPart::Of of, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            use(LevelPart{of, i});
        }
    };
    all(LevelPart::Of::Water, level.waters.size());
    all(LevelPart::Of::Obstruction, level.obstructions.size());
    all(LevelPart::Of::Cell, level.cells.size());
    all(LevelPart::Of::Block, level.freeBlocks.size());
    all(LevelPart::Of::Well, level.wells.size());
    all(LevelPart::Of::Link, level.links.size());
}

Vec2 metresOf(std::int32_t x, std::int32_t y) {
    return {static_cast<Real>(x) / 1000, static_cast<Real>(y) / 1000};
}

Aabb boundsOf(const ObstructionDef& def) {
    const Vec2 middle = metresOf(def.x, def.y);
    if (def.kind == ObstructionKind::Ledge) {
        return boundsOf(placedShapeOf(
            {.x = def.x, .y = def.y, .turn = def.turn, .width = def.size, .height = def.height}));
    }
    if (!def.points.empty()) {
        return kodo::aabbOf(std::span<const Vec2>(outlineOf(def)));
    }
    if (def.kind == ObstructionKind::Ground) {
        const auto last = static_cast<std::int32_t>(def.heights.size()) - 1;
        const std::int32_t top = *std::max_element(def.heights.begin(), def.heights.end());
        return {middle, metresOf(def.x + last * def.spacing, def.y + top)};
    }
    const bool disc = def.kind == ObstructionKind::Bumper || def.kind == ObstructionKind::Pin;
    const Real half = static_cast<Real>(def.size) / (disc ? 1000 : 2000);
    const bool stands = def.kind == ObstructionKind::Gate &&
                        (def.facing == Facing::Left || def.facing == Facing::Right);
    const Vec2 reach{stands ? Real(0.1) : half, disc || stands ? half : Real(0.1)};
    return {middle - reach, middle + reach};
}

/// 1/1000 m.
struct Range {
    std::int32_t low = 0;
    std::int32_t high = 0;

    bool meets(const Range& other, std::int32_t gap) const {
        return low < other.high + gap && other.low < high + gap;
    }
    Range plus(std::int32_t way) const { return {low + way, high + way}; }
};

Range across(const Aabb& box) {
    return {thousandthsOf(box.lower.x), thousandthsOf(box.upper.x)};
}
Range up(const Aabb& box) {
    return {thousandthsOf(box.lower.y), thousandthsOf(box.upper.y)};
}

/// The shortest way so far, of those within kSnapReach.
class Nearest {
public:
    void offer(std::int32_t way) {
        const std::int32_t least = way_ ? std::abs(*way_) : kSnapReach + 1;
        if (std::abs(way) < least) {
            way_ = way;
        }
    }
    void offerContact(const Range& own, const Range& other) {
        offer(other.high - own.low);
        offer(other.low - own.high);
    }
    void offerFlush(const Range& own, const Range& other) {
        offer(other.low - own.low);
        offer(other.high - own.high);
    }
    std::optional<std::int32_t> way() const { return way_; }

private:
    std::optional<std::int32_t> way_;
};

std::int32_t toGrid(std::int32_t place) {
    const Real cells = static_cast<Real>(place) / static_cast<Real>(kSnapGrid);
    return static_cast<std::int32_t>(std::lround(cells)) * kSnapGrid - place;
}

/// `local`: m, in the frame of the shape.
bool isInside(const kodo::Shape& shape, Vec2 local) {
    constexpr Real kNear = Real(0.01); // m; a pin may be at an edge
    const auto inside = [&](const kodo::Polygon& polygon) {
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const Vec2 from = polygon.corners[k];
            const Vec2 edge = polygon.corners[(k + 1) % polygon.corners.size()] - from;
            if (cross(edge, local - from) < -kNear * length(edge)) {
                return false;
            }
        }
        return true;
    };
    const std::vector<kodo::Polygon> polygons = polygonsOf(shape);
    return std::any_of(polygons.begin(), polygons.end(), inside);
}

bool isHere(const Level& level, LevelPart part, Vec2 place) {
    constexpr Real kNearLine = Real(0.15); // m
    if (part.of == LevelPart::Of::Link) {
        const LinkDef& link = level.links[part.index];
        const Vec2 from = metresOf(link.fromX, link.fromY);
        const Vec2 way = metresOf(link.toX, link.toY) - from;
        const Real along = std::clamp(dot(place - from, way) / std::max(dot(way, way), Real(1e-6)),
                                      Real(0), Real(1));
        return length(place - from - along * way) < kNearLine;
    }
    if (!boundsOf(level, part).contains(place)) {
        return false;
    }
    if (part.of == LevelPart::Of::Block) {
        return blockAt(level, place) == part.index;
    }
    const bool outline =
        part.of == LevelPart::Of::Obstruction && !level.obstructions[part.index].points.empty();
    return !outline || isInside(solidOf(level.obstructions[part.index]), place);
}

/// Edges of an outline that blocks stand on or beside: the level ones that face up, and the upright
/// ones.
void addEdges(std::vector<std::pair<Range, Range>>& all, const ObstructionDef& ground) {
    for (std::size_t i = 0; i < ground.points.size(); ++i) {
        const GroundPoint a = ground.points[i];
        const GroundPoint b = ground.points[(i + 1) % ground.points.size()];
        if (a.x == b.x || (a.y == b.y && b.x < a.x)) {
            all.emplace_back(Range{std::min(a.x, b.x), std::max(a.x, b.x)},
                             Range{std::min(a.y, b.y), std::max(a.y, b.y)});
        }
    }
}

/// Where the other parts are that blocks touch, across and up.
std::vector<std::pair<Range, Range>> solidsBut(const Level& level, std::span<const LevelPart> own) {
    std::vector<std::pair<Range, Range>> others;
    forParts(level, [&](LevelPart part) {
        const bool solid = part.of == LevelPart::Of::Block || part.of == LevelPart::Of::Cell ||
                           (part.of == LevelPart::Of::Obstruction &&
                            level.obstructions[part.index].kind != ObstructionKind::Ground);
        if (std::find(own.begin(), own.end(), part) != own.end()) {
            return;
        }
        if (solid) {
            const Aabb box = boundsOf(level, part);
            others.emplace_back(across(box), up(box));
        } else if (part.of == LevelPart::Of::Obstruction) {
            addEdges(others, level.obstructions[part.index]);
        }
    });
    return others;
}

/// Takes the gap to another range, if it lies on one of the sides.
void limit(std::int32_t& low, std::int32_t& high, const Range& own, const Range& other) {
    if (other.high <= own.low) {
        low = std::min(low, own.low - other.high);
    } else if (other.low >= own.high) {
        high = std::min(high, other.low - own.high);
    }
}

} // namespace

std::vector<std::int32_t> blocksAt(const Level& level, Vec2 place) {
    std::vector<std::int32_t> found;
    for (std::size_t i = level.freeBlocks.size(); i-- > 0;) {
        const PlacedShape placed = placedShapeOf(level.freeBlocks[i]);
        if (isInside(placed.shape, toLocal(placed.frame, place))) {
            found.push_back(static_cast<std::int32_t>(i));
        }
    }
    return found;
}

Aabb boundsOf(const Level& level, LevelPart part) {
    switch (part.of) {
    case LevelPart::Of::Block:
        return boundsOf(placedShapeOf(level.freeBlocks[part.index]));
    case LevelPart::Of::Obstruction:
        return boundsOf(level.obstructions[part.index]);
    case LevelPart::Of::Cell: {
        const Vec2 middle = centerOf(level.cells[part.index]);
        const Vec2 half{kCellWidth / 2, kCellHeight / 2};
        return {middle - half, middle + half};
    }
    case LevelPart::Of::Water: {
        const WaterDef& water = level.waters[part.index];
        return {metresOf(water.x - water.width / 2, water.y - water.depth),
                metresOf(water.x + water.width / 2, water.y)};
    }
    case LevelPart::Of::Well: {
        const Vec2 middle = metresOf(level.wells[part.index].x, level.wells[part.index].y);
        return Aabb{middle, middle}.grown(Real(0.6));
    }
    case LevelPart::Of::Link:
        break;
    }
    const LinkDef& link = level.links[part.index];
    const Vec2 from = metresOf(link.fromX, link.fromY);
    const Vec2 to = metresOf(link.toX, link.toY);
    return unite(Aabb{from, from}, Aabb{to, to}).grown(Real(0.1));
}

std::optional<std::size_t> blockAt(const Level& level, Vec2 place) {
    const std::vector<std::int32_t> found = blocksAt(level, place);
    return found.empty() ? std::nullopt : std::optional(static_cast<std::size_t>(found.front()));
}

std::optional<LevelPart> partAt(const Level& level, Vec2 place) {
    std::optional<LevelPart> found;
    forParts(level, [&](LevelPart part) {
        if (isHere(level, part, place)) {
            found = part;
        }
    });
    return found;
}

LevelParts partsIn(const Level& level, const Aabb& box) {
    LevelParts parts;
    forParts(level, [&](LevelPart part) {
        if (box.contains(boundsOf(level, part).center())) {
            parts.push_back(part);
        }
    });
    return parts;
}

LevelParts followed(LevelParts parts, const Level& before, const Level& after) {
    const auto follow = [](std::size_t& index, const auto& from, const auto& to) {
        const auto found =
            index < from.size() ? std::find(to.begin(), to.end(), from[index]) : to.end();
        index = found == to.end() ? index : static_cast<std::size_t>(found - to.begin());
    };
    for (LevelPart& part : parts) {
        if (part.of == LevelPart::Of::Obstruction) {
            follow(part.index, before.obstructions, after.obstructions);
        } else if (part.of == LevelPart::Of::Cell) {
            follow(part.index, before.cells, after.cells);
        }
    }
    return parts;
}

EditStep snapped(const Level& level, const Aabb& bounds, std::span<const LevelPart> own,
                 EditStep step) {
    constexpr std::int32_t kBeside = 300; // 1/1000 m; nearer parts are neighbours
    const Range x = across(bounds).plus(step.x);
    const Range y = up(bounds).plus(step.y);
    const std::vector<std::pair<Range, Range>> others = solidsBut(level, own);
    Nearest rise;
    for (const auto& [otherX, otherY] : others) {
        if (x.meets(otherX, 0)) {
            rise.offerContact(y, otherY);
        } else if (x.meets(otherX, kBeside)) {
            rise.offerFlush(y, otherY);
        }
    }
    const std::int32_t wayY = rise.way().value_or(toGrid(y.low));
    const Range level2 = y.plus(wayY);
    Nearest side;
    for (const auto& [otherX, otherY] : others) {
        if (level2.meets(otherY, 0)) {
            side.offerContact(x, otherX);
        } else if (level2.meets(otherY, kBeside)) {
            side.offerFlush(x, otherX);
            side.offer((otherX.low + otherX.high - x.low - x.high) / 2);
        }
    }
    side.offer(-(x.low + x.high) / 2); // the middle of the field
    const std::int32_t wayX = side.way().value_or(toGrid(x.low));
    return {step.x + wayX, step.y + wayY};
}

Gaps gapsBeside(const Level& level, LevelPart part) {
    Gaps gaps;
    const Aabb bounds = boundsOf(level, part);
    const Range x = across(bounds);
    const Range y = up(bounds);
    for (const auto& [otherX, otherY] : solidsBut(level, {&part, 1})) {
        if (y.meets(otherY, 0)) {
            limit(gaps.left, gaps.right, x, otherX);
        }
        if (x.meets(otherX, 0)) {
            limit(gaps.below, gaps.above, y, otherY);
        }
    }
    return gaps;
}

} // namespace apart
