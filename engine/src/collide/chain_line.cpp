// SPDX-License-Identifier: MIT
#include "collide/chain_line.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Unit; direction of the neighbour at a vertex: towards vertex 0, or from vertex 1; zero: none.
Vec2 wayAt(const ConvexShape& line, std::size_t end) {
    return end == 0 ? line.before : line.after;
}

Real lengthAt(const ConvexShape& line, std::size_t end) {
    return end == 0 ? line.valleyBefore : line.valleyAfter;
}

} // namespace

Real heightOverJoints(const ConvexShape& line, Vec2 p, Real sink) {
    const Vec2 along = alongOf(line);
    Real height = dot(line.normals[1], p - line.vertices[0]);
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 arm = p - line.vertices[end];
        const Real beyond = end == 0 ? -dot(along, arm) : dot(along, arm);
        const Vec2 way = wayAt(line, end);
        if (way == Vec2{}) {
            continue;
        }
        const Real onNext = end == 0 ? -dot(way, arm) : dot(way, arm);
        const bool hilltop = (end == 0 ? cross(way, along) : cross(along, way)) < 0;
        const Real next = dot(perp(way), arm);
        if (beyond > 0 || (onNext > 0 && onNext < lengthAt(line, end))) {
            height = hilltop ? std::max(height, next) : std::min(height, next);
        } else if (beyond > -sink) { // a little on the other side of the neighbour, perhaps
            height = hilltop ? std::max(height, std::min(next, Real(0)))
                             : std::min(height, std::max(next, Real(0)));
        }
    }
    return height;
}

Real directionBetween(const ConvexShape& line, const ConvexShape& next) {
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        for (const std::size_t other : {std::size_t(0), std::size_t(1)}) {
            const Real direction = end == other ? Real(-1) : Real(1);
            if (line.vertices[end] == next.vertices[other] &&
                wayAt(line, end) == direction * alongOf(next)) {
                return direction;
            }
        }
    }
    return 0;
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
        const Vec2 way = wayAt(line, end);
        if (way != Vec2{}) {
            first = std::min(first, entryBeside(end == 0 ? -way : way, lengthAt(line, end)));
            share = std::max(share, first);
        }
    }
    return from + share * (to - from);
}

} // namespace KODO_PRECISION
} // namespace kodo
