// SPDX-License-Identifier: MIT
#include "collide/time_of_impact.hpp"

#include <kodo/geometry.hpp>

#include "collide/chain_line.hpp"
#include "collide/one_sided.hpp"
#include "collide/separation_bound.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Polygons need two rounds without rotation and about five with it. With a round shape and no
// rotation, each round at least halves the gap. Large rotations within a step may need more. A pair
// that is still approaching after this many rounds is stopped there, which is safe: it does not
// touch yet.
constexpr int kMostRounds = 40;
constexpr Real kNever = RelativePath::kNever;
// Targets along a valley from which a shape that stops short of a line counts as over it. A point
// that slides on one line, below it by what its contact yields, meets the next line just before the
// vertex. Continuous collision stops at 1/1024 of the slop in float, 1/65536 in double: this is
// 1/2 of the slop.
constexpr Real kAhead = sizeof(Real) == 4 ? 512 : 32768;

/// One of the two moving shapes.
struct MovingShape {
    const ConvexShape& shape;
    const MotionPath& sweep;
};

/// Upper bound (m per step) of the approach of any point by rotation alone. For a plane, only the
/// part within reach of the other shape counts.
Real turningBound(MovingShape moving, MovingShape other) {
    if (moving.sweep.deltaAngle == 0) {
        return 0; // as most static bodies
    }
    Real rotationReach = moving.shape.rotationReach();
    if (moving.shape.isPlane()) {
        rotationReach = length(other.sweep.start.position - moving.sweep.start.position) +
                        length(other.sweep.deltaPosition) + length(moving.sweep.deltaPosition) +
                        length(other.sweep.push) + other.shape.boundingRadius;
    }
    return rotationReach * std::abs(moving.sweep.deltaAngle);
}

/// Relative path from t on, until one of the two stops.
RelativePath relativePathFrom(MovingShape a, MovingShape b, Real t, Real target) {
    const bool goesA = t < a.sweep.stopAt;
    const bool goesB = t < b.sweep.stopAt;
    const Real stopA = goesA ? a.sweep.stopAt : 1;
    const Real stopB = goesB ? b.sweep.stopAt : 1;
    return {.towards = (goesA ? a.sweep.deltaPosition : a.sweep.push) -
                       (goesB ? b.sweep.deltaPosition : b.sweep.push),
            .deltaAngleA = goesA ? a.sweep.deltaAngle : 0,
            .deltaAngleB = goesB ? b.sweep.deltaAngle : 0,
            .turning = (goesA ? turningBound(a, b) : 0) + (goesB ? turningBound(b, a) : 0),
            .length = std::min({stopA, stopB, Real(1)}) - t,
            .target = target};
}

/// True if the bounding discs of both shapes come within `target` of each other on their paths,
/// from the fraction `from` of the step on.
bool discsMeet(MovingShape a, MovingShape b, Real target, Real from) {
    if (a.shape.isPlane() || b.shape.isPlane()) {
        return true; // a plane has no bounding disc
    }
    // A little larger, for rounding.
    const Real near =
        Real(1.001) * (a.shape.boundingRadius + b.shape.boundingRadius + std::max(target, Real(0)));
    Vec2 apart = b.sweep.positionAt(from) - a.sweep.positionAt(from);
    for (Real t = from; t < 1;) {
        const RelativePath path = relativePathFrom(a, b, t, target);
        const Vec2 way = -path.length * path.towards;
        const Real square = lengthSquared(way);
        const Real along = std::clamp(-dot(apart, way), Real(0), square);
        const Vec2 nearest = along > 0 ? apart + (along / square) * way : apart;
        if (lengthSquared(nearest) <= near * near) {
            return true;
        }
        apart += way;
        t += path.length;
    }
    return false;
}

/// Conservative advancement from the fraction t of the step on.
Real advance(MovingShape a, MovingShape b, Real target, Real t) {
    Real most = 1;
    for (int round = 0; round < kMostRounds; ++round) {
        RelativePath path = relativePathFrom(a, b, t, target);
        const Real left = path.length;
        path.length = std::min(left, most);
        const SeparationBound separationBound =
            separationBoundOf(a.shape, a.sweep.at(t), b.shape, b.sweep.at(t), path);
        if (separationBound.passes(path)) {
            t += path.length;
            if (most >= left && t >= 1) {
                return kNever;
            }
            most *= 4;
        } else if (separationBound.distance - target <= std::abs(target) / 2) {
            return t;
        } else {
            t += separationBound.last;
            most = 2 * separationBound.last; // an impact is near; shorter paths have tighter bounds
        }
    }
    return t;
}

/// The half-plane behind a line, on the other side of a normal of it.
ConvexShape behind(const ConvexShape& line, Vec2 normal) {
    ConvexShape plane;
    plane.kind = ConvexKind::HalfPlane;
    plane.vertices.push_back(line.vertices[0]);
    plane.normals.push_back(normal);
    return plane;
}

/// A disc about a corner of a shape.
ConvexShape discOf(Vec2 corner, Real radius) {
    ConvexShape disc;
    disc.vertices.push_back(corner);
    disc.radius = radius;
    disc.boundingRadius = length(corner) + radius;
    return disc;
}

/// True if a corner is over the line, between its ends.
bool isOver(MovingShape line, MovingShape other, Vec2 corner, Real t) {
    const Vec2 along = line.shape.vertices[1] - line.shape.vertices[0];
    const Vec2 place = between(line.sweep.at(t), other.sweep.at(t)) * corner;
    const Real at = dot(along, place - line.shape.vertices[0]);
    return at >= 0 && at <= lengthSquared(along);
}

/// A shape in front first touches the line with a corner, along the line's normal, or at a vertex
/// along a direction that the line owns there. All other impacts belong to neighbours, or the shape
/// passes through. The lowest corner may touch a neighbour and leave while another one comes down;
/// one that comes by less than a slop slides on.
Real impactOnOneSided(MovingShape line, MovingShape other, Real target, Real from) {
    const ConvexShape below = behind(line.shape, line.shape.normals[1]);
    const auto heightOf = [&](const ConvexShape& shape) {
        return separation(below, line.sweep.at(from), shape, other.sweep.at(from)).distance;
    };
    const auto comesTo = [&](const ConvexShape& corner, Real height) {
        return advance({below, line.sweep}, {corner, other.sweep}, height, from);
    };
    const Real lowest = heightOf(other.shape);
    bool comes = lowest <= target * Real(1.5);
    Real first = kNever;
    for (const Vec2 vertex : other.shape.vertices) {
        const ConvexShape corner = discOf(vertex, other.shape.radius);
        const Real height = heightOf(corner);
        const Real deep = height > lowest ? comesTo(corner, -2 * kAhead * target) : from;
        const bool slides = height > lowest && (deep > 1 || !isOver(line, other, vertex, deep));
        if (slides || height <= target * Real(1.5)) {
            continue;
        }
        const Real t = comesTo(corner, target);
        comes = comes || t <= 1;
        if (t < first && collideOneSided(line.shape, line.sweep.at(t), other.shape,
                                         other.sweep.at(t), {8 * target, 0, kAhead * target})
                                 .count > 0) {
            first = t;
        }
    }
    if (!comes) {
        return kNever;
    }
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        if (!ownsVertex(line.shape, end)) {
            continue;
        }
        const ConvexShape vertex = discOf(line.shape.vertices[end], 0);
        const Real t = advance({vertex, line.sweep}, other, target, from);
        if (t < first) {
            const Transform a = line.sweep.at(t);
            const Vec2 axis = separation(vertex, a, other.shape, other.sweep.at(t)).axis;
            first = ownsDirection(line.shape, end, unrotate(a.rotation, axis)) ? t : first;
        }
    }
    return first;
}

/// A linked two-sided line as that side of its chain on which the other shape starts: what slides
/// over a vertex does not touch the end of the next line. None for other shapes, and for a line
/// with a free end, which is met from all sides.
std::optional<ConvexShape> sideTowards(MovingShape line, MovingShape other) {
    if (!line.shape.isLine() || line.shape.oneSided || isFree(line.shape, 0) ||
        isFree(line.shape, 1) || other.shape.isPlane()) {
        return std::nullopt;
    }
    const Vec2 middle = between(line.sweep.start, other.sweep.start) * other.shape.middle;
    const bool isBehind = heightOverJoints(line.shape, middle, 0) < 0;
    return facingTo(line.shape, line.shape.normals[isBehind ? 0 : 1]);
}

/// Fraction of the step after which a point or corner of another body has come down to slop / 4 (m)
/// over a line, between its ends; to -slop if it starts lower than `slop`; kNever if it does not.
Real timeOfDisc(MovingShape line, Vec2 normal, MovingShape other, const ConvexShape& disc,
                Real slop) {
    const ConvexShape below = behind(line.shape, normal);
    const Real start = separation(below, line.sweep.start, disc, other.sweep.start).distance;
    const Real height = start > slop ? slop / 4 : -slop;
    const Real t =
        start > -slop ? advance({below, line.sweep}, {disc, other.sweep}, height, 0) : kNever;
    return t <= 1 && isOver(line, other, disc.vertices[0], t) ? t : kNever;
}

/// True if a one-sided line faces away from a plane.
bool turnsAway(MovingShape line, MovingShape plane) {
    const Vec2 front = line.sweep.start.rotation * line.shape.normals[1];
    return dot(front, plane.sweep.start.rotation * plane.shape.normals[0]) > 0;
}

} // namespace

Real timeOfImpact(const ConvexShape& shapeA, const MotionPath& a, const ConvexShape& shapeB,
                  const MotionPath& b, Real target, Real from) {
    const MovingShape movingA{shapeA, a};
    const MovingShape movingB{shapeB, b};
    if ((shapeA.oneSided && shapeB.isPlane() && turnsAway(movingA, movingB)) ||
        (shapeB.oneSided && shapeA.isPlane() && turnsAway(movingB, movingA)) ||
        !discsMeet(movingA, movingB, target, from)) {
        return kNever;
    }
    if (const auto side = sideTowards(movingA, movingB)) {
        return timeOfImpact(*side, a, shapeB, b, target, from);
    }
    if (const auto side = sideTowards(movingB, movingA)) {
        return timeOfImpact(shapeA, a, *side, b, target, from);
    }
    if (shapeA.oneSided && !shapeB.isPlane()) {
        return impactOnOneSided(movingA, movingB, target, from);
    }
    if (shapeB.oneSided && !shapeA.isPlane()) {
        return impactOnOneSided(movingB, movingA, target, from);
    }
    return advance(movingA, movingB, target, from);
}

Real timeBehind(const ConvexShape& line, const MotionPath& a, const ConvexShape& other,
                const MotionPath& b, Real slop, bool corners) {
    const Vec2 normal = line.normals[1];
    if (heightOverJoints(line, between(a.start, b.start) * other.middle, slop) < -slop) {
        return kNever;
    }
    const MovingShape ground{line, a};
    const MovingShape above{other, b};
    Real first = timeOfDisc(ground, normal, above, discOf(other.middle, 0), slop);
    if (corners || other.coreRadius < slop) {
        for (const Vec2 vertex : other.vertices) {
            const ConvexShape corner = discOf(vertex, other.radius);
            first = std::min(first, timeOfDisc(ground, normal, above, corner, slop));
        }
    }
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        if (other.isLine() && ownsVertex(line, end)) {
            const ConvexShape vertex = discOf(line.vertices[end], 0);
            const Vec2 seen = between(b.start, a.start) * line.vertices[end];
            const bool isBelow = dot(other.normals[1], seen - other.vertices[0]) < 0;
            const Vec2 side = other.normals[isBelow ? 0 : 1];
            first = std::min(first, timeOfDisc(above, side, ground, vertex, slop));
        }
    }
    return first;
}

} // namespace KODO_PRECISION
} // namespace kodo
