// SPDX-License-Identifier: MIT
// Fracture patterns of a convex polygon: one function for each Pattern.
#include <apart/core/fracture.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace apart {

using kodo::Polygon;
using kodo::Real;
using kodo::Vec2;

namespace {

/// True if the piece is within the limits and valid for the engine. A crack almost along an edge
/// may leave corners that rounding makes collinear.
bool fits(const Polygon& piece, const PieceLimits& limits) {
    return piece.corners.size() >= 3 && areaOf(piece) >= limits.area &&
           widthOf(piece) >= limits.width && !check(kodo::Shape(piece));
}

/// Cuts each piece along the line unless a side would be too small.
std::vector<Polygon> cut(const std::vector<Polygon>& pieces, const Line& line,
                         const PieceLimits& limits) {
    std::vector<Polygon> result;
    for (const Polygon& piece : pieces) {
        Polygon left = clipped(piece, line);
        Polygon right = clipped(piece, line.flipped());
        if (fits(left, limits) && fits(right, limits)) {
            result.push_back(std::move(left));
            result.push_back(std::move(right));
        } else {
            result.push_back(piece);
        }
    }
    return result;
}

struct Extent {
    Vec2 low;
    Vec2 high;

    Vec2 at(Real x, Real y) const {
        return {low.x + (high.x - low.x) * x, low.y + (high.y - low.y) * y};
    }
};

Extent extentOf(const Polygon& polygon) {
    Extent extent{polygon.corners[0], polygon.corners[0]};
    for (const Vec2 corner : polygon.corners) {
        extent.low = {std::min(extent.low.x, corner.x), std::min(extent.low.y, corner.y)};
        extent.high = {std::max(extent.high.x, corner.x), std::max(extent.high.y, corner.y)};
    }
    return extent;
}

/// One crack from `hit` through the middle part, and one across the larger half.
std::vector<Polygon> halves(const Polygon& whole, Vec2 hit, const PieceLimits& limits,
                            Generator& chance) {
    const Vec2 middle = extentOf(whole).at(chance.between(Real(0.4), Real(0.6)), Real(0.5));
    const Vec2 along = middle - hit;
    const Vec2 direction = length(along) > limits.width ? along : Vec2{Real(0.3), 1};
    std::vector<Polygon> pieces = cut({whole}, Line::through(middle, direction), limits);
    if (pieces.size() == 1) {
        pieces =
            cut({whole}, Line::through(extentOf(whole).at(Real(0.5), Real(0.5)), {0, 1}), limits);
    }
    const auto larger =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Polygon& a, const Polygon& b) { return areaOf(a) < areaOf(b); });
    const Polygon half = *larger;
    pieces.erase(larger);
    const Vec2 across{chance.between(Real(-0.5), Real(0.5)), 1};
    const Line second = Line::through(extentOf(half).at(Real(0.5), Real(0.5)), across);
    for (Polygon& piece : cut({half}, second, limits)) {
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Cuts along nearly parallel lines, as in wood.
std::vector<Polygon> slats(const Polygon& whole, const PieceLimits& limits, Generator& chance) {
    const Extent extent = extentOf(whole);
    const std::uint32_t count = 4 + chance.below(2);
    const Real lean = chance.between(Real(-0.35), Real(0.35));
    std::vector<Polygon> pieces{whole};
    for (std::uint32_t i = 1; i < count; ++i) {
        const Real x = (static_cast<Real>(i) + chance.between(Real(-0.2), Real(0.2))) /
                       static_cast<Real>(count);
        const Vec2 direction{lean + chance.between(Real(-0.1), Real(0.1)), 1};
        pieces = cut(pieces, Line::through(extent.at(x, Real(0.5)), direction), limits);
    }
    return pieces;
}

/// Two courses with staggered joints, as in masonry.
std::vector<Polygon> bricks(const Polygon& whole, const PieceLimits& limits, Generator& chance) {
    const Extent extent = extentOf(whole);
    const Real bed = chance.between(Real(0.42), Real(0.58));
    const std::vector<Polygon> courses =
        cut({whole}, Line::through(extent.at(Real(0.5), bed), {1, 0}), limits);
    std::vector<Polygon> pieces;
    for (std::size_t i = 0; i < courses.size(); ++i) {
        std::vector<Polygon> course{courses[i]};
        const Real start = i % 2 == 0 ? Real(1) / 3 : Real(1) / 4;
        for (Real x = start; x < Real(0.95); x += i % 2 == 0 ? Real(1) / 3 : Real(1) / 4) {
            const Real joint = x + chance.between(Real(-0.04), Real(0.04));
            const Vec2 direction{chance.between(Real(-0.08), Real(0.08)), 1};
            course = cut(course, Line::through(extent.at(joint, Real(0.5)), direction), limits);
        }
        pieces.insert(pieces.end(), course.begin(), course.end());
    }
    return pieces;
}

Polygon cellOf(const Polygon& whole, const std::vector<Vec2>& seeds, std::size_t which) {
    Polygon cell = whole;
    for (std::size_t i = 0; i < seeds.size() && !cell.corners.empty(); ++i) {
        if (i != which) {
            const Vec2 normal = normalize(seeds[i] - seeds[which]);
            cell = clipped(cell, {normal, dot(normal, (seeds[i] + seeds[which]) * Real(0.5))});
        }
    }
    return cell;
}

/// Voronoi cells of random seeds, denser towards `hit`. A seed whose cell is too small is removed
/// and all cells are computed again. The result is valid cells or the whole.
std::vector<Polygon> shatter(const Polygon& whole, Vec2 hit, const PieceLimits& limits,
                             Generator& chance) {
    const Extent extent = extentOf(whole);
    const Real closest = limits.width; // m; closer seeds would give slivers
    std::vector<Vec2> seeds;
    for (std::uint32_t i = 0, count = 8 + chance.below(4); i < count; ++i) {
        const Real x = chance.unit(); // separate: the evaluation order of arguments is unspecified
        Vec2 seed = extent.at(x, chance.unit());
        const Real pull = chance.unit();
        seed += (hit - seed) * (pull * pull * Real(0.8));
        const bool apart = std::none_of(seeds.begin(), seeds.end(),
                                        [&](Vec2 other) { return length(other - seed) < closest; });
        if (apart) {
            seeds.push_back(seed);
        }
    }
    while (seeds.size() > 1) {
        std::vector<Polygon> cells;
        std::size_t bad = seeds.size();
        for (std::size_t i = 0; i < seeds.size() && bad == seeds.size(); ++i) {
            cells.push_back(cellOf(whole, seeds, i));
            bad = fits(cells.back(), limits) ? bad : i;
        }
        if (bad == seeds.size()) {
            return cells;
        }
        seeds.erase(seeds.begin() + static_cast<std::ptrdiff_t>(bad));
    }
    return {whole};
}

/// Cracks from a hub: directions in counter-clockwise order, less than 180 degrees apart.
struct Star {
    Vec2 hub;
    std::vector<Vec2> rays; // unit

    bool isOpen() const { // true if a wedge may reach 180 degrees
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (cross(rays[i], rays[(i + 1) % rays.size()]) < Real(0.05)) {
                return true;
            }
        }
        return rays.size() < 3;
    }
    /// The line through this ray and the next at `radius` (m). clipped() keeps the hub.
    Line chord(std::size_t ray, Real radius) const {
        const Vec2 from = hub + radius * rays[ray];
        const Vec2 to = hub + radius * rays[(ray + 1) % rays.size()];
        return Line::through(from, to - from);
    }
    Polygon wedge(const Polygon& whole, std::size_t ray) const {
        const Polygon left = clipped(whole, Line::through(hub, rays[ray]));
        return clipped(left, Line::through(hub, -rays[(ray + 1) % rays.size()]));
    }
};

/// The hub first if it is large enough, then the wedges in order. `bad` is the first wedge that is
/// too small.
struct Wedges {
    std::vector<Polygon> pieces;
    std::optional<std::size_t> bad{};
};

Wedges wedgesOf(const Polygon& whole, const Star& star, Real radius, const PieceLimits& limits) {
    Polygon hub = whole;
    for (std::size_t i = 0; i < star.rays.size() && !hub.corners.empty(); ++i) {
        hub = clipped(hub, star.chord(i, radius));
    }
    const bool hasHub = fits(hub, limits);
    Wedges result;
    if (hasHub) {
        result.pieces.push_back(hub);
    }
    for (std::size_t i = 0; i < star.rays.size(); ++i) {
        Polygon wedge = star.wedge(whole, i);
        if (hasHub && !wedge.corners.empty()) {
            wedge = clipped(wedge, star.chord(i, radius).flipped());
        }
        if (!fits(wedge, limits)) {
            result.bad = i;
            return result;
        }
        result.pieces.push_back(std::move(wedge));
    }
    return result;
}

/// Pieces between the cracks and a partial ring across them. The hub is a separate piece, so that
/// wedges have no sharp tips. If a wedge is too small, its crack is removed and the pieces are
/// computed again.
std::vector<Polygon> cracked(const Polygon& whole, Star star, const PieceLimits& limits,
                             Generator& chance) {
    const Real size = std::sqrt(areaOf(whole));
    while (!star.isOpen()) {
        Wedges wedges = wedgesOf(whole, star, size * Real(0.2), limits);
        if (wedges.bad) {
            star.rays.erase(star.rays.begin() + static_cast<std::ptrdiff_t>(*wedges.bad));
            continue;
        }
        std::vector<Polygon> pieces;
        const std::size_t first = wedges.pieces.size() - star.rays.size(); // after the hub
        for (std::size_t i = 0; i < wedges.pieces.size(); ++i) {
            const bool ring = i >= first && chance.below(2) == 0;
            const std::vector<Polygon> parts =
                ring ? cut({wedges.pieces[i]}, star.chord(i - first, size * Real(0.55)), limits)
                     : std::vector<Polygon>{wedges.pieces[i]};
            pieces.insert(pieces.end(), parts.begin(), parts.end());
        }
        return pieces;
    }
    return {whole};
}

/// Cracks from a hub beside `hit`, as in glass. Close to an edge there may be no room for wedges
/// behind the hub; then it is moved towards the middle.
std::vector<Polygon> radial(const Polygon& whole, Vec2 hit, const PieceLimits& limits,
                            Generator& chance) {
    const Vec2 middle = massOf(whole, Real(1)).center;
    Star star{hit + chance.between(Real(0.45), Real(0.75)) * (middle - hit), {}};
    const std::uint32_t count = 6 + chance.below(3);
    const Real turn = chance.unit();
    for (std::uint32_t i = 0; i < count; ++i) {
        const Real place = turn + static_cast<Real>(i) + chance.between(Real(-0.25), Real(0.25));
        const Real angle = place / static_cast<Real>(count) * 2 * std::numbers::pi_v<Real>;
        star.rays.push_back(kodo::Rot::fromAngle(angle).xAxis());
    }
    std::vector<Polygon> pieces = cracked(whole, star, limits, chance);
    for (int moved = 0; pieces.size() == 1 && moved < 2; ++moved) {
        star.hub += (middle - star.hub) / (moved == 0 ? Real(2) : Real(1)); // half way, then fully
        pieces = cracked(whole, star, limits, chance);
    }
    return pieces;
}

std::vector<Polygon> broken(const Polygon& whole, Vec2 hit, Pattern pattern,
                            const PieceLimits& limits, Generator& chance) {
    switch (pattern) {
    case Pattern::Slats:
        return slats(whole, limits, chance);
    case Pattern::Bricks:
        return bricks(whole, limits, chance);
    case Pattern::Radial:
        return radial(whole, hit, limits, chance);
    case Pattern::Shatter:
        return shatter(whole, hit, limits, chance);
    case Pattern::Halves:
        break;
    }
    return halves(whole, hit, limits, chance);
}

} // namespace

std::vector<Polygon> fracture(const Polygon& whole, Vec2 hit, Pattern pattern,
                              const PieceLimits& limits, std::uint64_t key) {
    Generator chance(key);
    std::vector<Polygon> pieces = broken(whole, hit, pattern, limits, chance);
    // A polygon too small for its pattern may still break in halves.
    return pieces.size() > 1 ? pieces : halves(whole, hit, limits, chance);
}

} // namespace apart
