// SPDX-License-Identifier: MIT
#include <apart/core/fracture.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <limits>

namespace apart {

using kodo::Polygon;
using kodo::Real;
using kodo::Vec2;

namespace {

// Corners closer than this (m) become one: so near, rounding decides which way an edge points.
constexpr Real kSameCorner = Real(2e-5);

bool fits(const Polygon& piece, const PieceLimits& limits) {
    return piece.corners.size() >= 3 && areaOf(piece) >= limits.area &&
           widthOf(piece) >= limits.width;
}

Polygon withoutTwins(const Polygon& polygon) {
    Polygon result;
    for (const Vec2 corner : polygon.corners) {
        if (result.corners.empty() || length(corner - result.corners.back()) > kSameCorner) {
            result.corners.push_back(corner);
        }
    }
    while (result.corners.size() > 1 &&
           length(result.corners.front() - result.corners.back()) <= kSameCorner) {
        result.corners.pop_back();
    }
    return result;
}

Line flipped(const Line& line) {
    return {-line.normal, -line.offset};
}

/// Cuts every piece along the line, but for those where a side would be too small.
std::vector<Polygon> cut(const std::vector<Polygon>& pieces, const Line& line,
                         const PieceLimits& limits) {
    std::vector<Polygon> result;
    for (const Polygon& piece : pieces) {
        Polygon left = clipped(piece, line);
        Polygon right = clipped(piece, flipped(line));
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

/// One crack from the blow through the middle part, and one across the larger half.
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

/// Splits along nearly parallel lines, as wood does.
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

/// Two courses with their joints apart, as a wall is laid.
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

/// Cells of the points nearest to each seed, denser towards the blow. A seed whose cell is too
/// small is dropped and all is done anew, so that it ends with good cells or with the whole.
std::vector<Polygon> shatter(const Polygon& whole, Vec2 hit, const PieceLimits& limits,
                             Generator& chance) {
    const Extent extent = extentOf(whole);
    const Real closest = limits.width; // seeds closer than this can only make slivers
    std::vector<Vec2> seeds;
    for (std::uint32_t i = 0, count = 8 + chance.below(4); i < count; ++i) {
        const Real x = chance.unit(); // a line each: the order of arguments is the compiler's
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

} // namespace

Line Line::through(Vec2 point, Vec2 direction) {
    const Vec2 normal = normalize(-perp(direction));
    return {normal, dot(normal, point)};
}

Real areaOf(const Polygon& polygon) {
    return polygon.corners.size() < 3 ? 0 : massOf(polygon, Real(1)).mass;
}

Real widthOf(const Polygon& polygon) {
    Real width = std::numeric_limits<Real>::max();
    const std::vector<Vec2>& corners = polygon.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
        const Vec2 inward = normalize(perp(edge));
        Real farthest = 0;
        for (const Vec2 corner : corners) {
            farthest = std::max(farthest, dot(inward, corner - corners[i]));
        }
        width = std::min(width, farthest);
    }
    return width;
}

Polygon rectangle(Real width, Real height) {
    const Real x = width / 2;
    const Real y = height / 2;
    return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

Polygon clipped(const Polygon& polygon, const Line& line) {
    Polygon result;
    const std::vector<Vec2>& corners = polygon.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i];
        const Vec2 b = corners[(i + 1) % corners.size()];
        const Real sideA = dot(line.normal, a) - line.offset;
        const Real sideB = dot(line.normal, b) - line.offset;
        if (sideA <= 0) {
            result.corners.push_back(a);
        }
        if ((sideA < 0 && sideB > 0) || (sideA > 0 && sideB < 0)) {
            result.corners.push_back(a + (sideA / (sideA - sideB)) * (b - a));
        }
    }
    result = withoutTwins(result);
    return result.corners.size() < 3 ? Polygon{} : result;
}

std::vector<Polygon> fracture(const Polygon& whole, Vec2 hit, Pattern pattern,
                              const PieceLimits& limits, std::uint64_t key) {
    Generator chance(key);
    switch (pattern) {
    case Pattern::Slats:
        return slats(whole, limits, chance);
    case Pattern::Bricks:
        return bricks(whole, limits, chance);
    case Pattern::Shatter: {
        std::vector<Polygon> cells = shatter(whole, hit, limits, chance);
        return cells.size() > 1 ? cells : halves(whole, hit, limits, chance);
    }
    case Pattern::Halves:
        break;
    }
    return halves(whole, hit, limits, chance);
}

std::vector<Polygon> cutOutMiddle(Real width, Real height, Real lean) {
    const Polygon whole = rectangle(width, height);
    const Line left = Line::through({-width / 4, 0}, {-lean, 1});
    const Line right = Line::through({width / 4, 0}, {lean, 1});
    return {clipped(clipped(whole, flipped(left)), right), clipped(whole, left),
            clipped(whole, flipped(right))};
}

Vec2 impulseOnPieces(Vec2 blow, Real strength, Real mass) {
    const Real size = length(blow);
    const Real passed = std::min(size - strength, mass * kShardSpeed);
    return passed > 0 ? (passed / size) * blow : Vec2{};
}

std::vector<PieceMotion> motionOfPieces(std::span<const kodo::Mass> pieces, Vec2 hit, Vec2 impulse,
                                        Real burst) {
    kodo::Mass whole = pieces[0];
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        whole = combine(whole, pieces[i]);
    }
    std::vector<PieceMotion> motions(pieces.size());
    Vec2 netMomentum;
    Real netTurn = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        motions[i].velocity = burst * normalize(pieces[i].center - hit);
        netMomentum += pieces[i].mass * motions[i].velocity;
        netTurn += pieces[i].mass * cross(pieces[i].center - whole.center, motions[i].velocity);
    }
    const Vec2 drift = (impulse - netMomentum) / whole.mass;
    const Real spin = (cross(hit - whole.center, impulse) - netTurn) / whole.inertia;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        motions[i].velocity += drift + cross(spin, pieces[i].center - whole.center);
        motions[i].spin = spin;
    }
    return motions;
}

} // namespace apart
