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

// Corners closer than this (m) are merged: rounding would decide the direction of their edge.
constexpr Real kSameCorner = Real(2e-5);

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

std::vector<Polygon> cutOutMiddle(Real width, Real height, Real lean) {
    const Polygon whole = rectangle(width, height);
    const Line left = Line::through({-width / 4, 0}, {-lean, 1});
    const Line right = Line::through({width / 4, 0}, {lean, 1});
    return {clipped(clipped(whole, left.flipped()), right), clipped(whole, left),
            clipped(whole, right.flipped())};
}

Vec2 impulseOnPieces(Vec2 impact, Real strength, Real mass) {
    const Real size = length(impact);
    const Real passed = std::min(size - strength, mass * kShardSpeed);
    return passed > 0 ? (passed / size) * impact : Vec2{};
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
