// SPDX-License-Identifier: MIT
#include "collide/jointed_line.hpp"

#include "collide/line_frame.hpp"

#include <algorithm>
#include <array>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Neighbours of a two-sided line on one of its sides.
struct Neighbours {
    std::array<Vec2, 2> way; // unit; at vertex 0 towards it, at vertex 1 from it; zero: none
    std::array<Real, 2> length;
};

Neighbours frontOf(const ConvexShape& line) {
    return {{line.before, line.after}, {line.valleyBefore, line.valleyAfter}};
}

Neighbours backOf(const ConvexShape& line) {
    return {{line.backBefore, line.backAfter}, {line.backValleyBefore, line.backValleyAfter}};
}

/// heightOverJoints() with the neighbours of one side.
Real heightOver(const ConvexShape& line, const Neighbours& neighbours, Vec2 p, Real sink) {
    const Vec2 along = alongOf(line);
    Real height = dot(line.normals[1], p - line.vertices[0]);
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 arm = p - line.vertices[end];
        const Real beyond = end == 0 ? -dot(along, arm) : dot(along, arm);
        const Vec2 way = neighbours.way[end];
        if (way == Vec2{}) {
            continue;
        }
        const Real onNext = end == 0 ? -dot(way, arm) : dot(way, arm);
        const bool hilltop = (end == 0 ? cross(way, along) : cross(along, way)) < 0;
        const Real next = dot(perp(way), arm);
        if (beyond > 0 || (onNext > 0 && onNext < neighbours.length[end])) {
            height = hilltop ? std::max(height, next) : std::min(height, next);
        } else if (beyond > -sink) { // a little on the other side of the neighbour, perhaps
            height = hilltop ? std::max(height, std::min(next, Real(0)))
                             : std::min(height, std::max(next, Real(0)));
        }
    }
    return height;
}

} // namespace

JointHeights heightOverJoints(const ConvexShape& line, Vec2 p, Real sink) {
    const Real front = heightOver(line, frontOf(line), p, sink);
    const bool same = line.before == line.backBefore && line.after == line.backAfter;
    return {front, same ? front : heightOver(line, backOf(line), p, sink)};
}

bool areNeighbours(const ConvexShape& line, Real side, const ConvexShape& next) {
    const Neighbours neighbours = side > 0 ? frontOf(line) : backOf(line);
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        for (const std::size_t other : {std::size_t(0), std::size_t(1)}) {
            if (line.vertices[end] == next.vertices[other]) {
                const Vec2 away = next.vertices[1 - other] - next.vertices[other];
                return normalize(end == 0 ? -away : away) == neighbours.way[end];
            }
        }
    }
    return false;
}

Vec2 withinJoints(const ConvexShape& line, Vec2 from, Vec2 to) {
    const Vec2 along = alongOf(line);
    // Share of the way to the first point at which a distance that falls from `a` to `b` is zero.
    const auto entry = [](Real a, Real b) {
        if (a <= 0) {
            return Real(0);
        }
        return b < 0 ? a / (a - b) : Real(1);
    };
    Real share = 0;
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 corner = line.vertices[end];
        const auto entryBeside = [&](Vec2 outward, Real reach) {
            return entry(dot(outward, from - corner) - reach, dot(outward, to - corner) - reach);
        };
        Real first = entryBeside(end == 0 ? -along : along, 0);
        bool isFree = true;
        for (const Neighbours& neighbours : {frontOf(line), backOf(line)}) {
            const Vec2 way = neighbours.way[end];
            if (way != Vec2{}) {
                isFree = false;
                first = std::min(first, entryBeside(end == 0 ? -way : way, neighbours.length[end]));
            }
        }
        share = isFree ? share : std::max(share, first);
    }
    return from + share * (to - from);
}

} // namespace KODO_PRECISION
} // namespace kodo
