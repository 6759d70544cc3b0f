// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/collide/outlook.hpp>
#include <kodo/collide/round.hpp>
#include <kodo/collide/sat.hpp>
#include <kodo/collide/time_of_impact.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

// Polygons that fly straight need two rounds, and those that turn some five; with what is round, a
// round halves the gap at least where nothing turns. Who turns far within a step may need more. A
// pair that still creeps towards touching after this many is stopped where it is, which is safe: it
// has not touched yet.
constexpr int kMostRounds = 40;
constexpr Real kNever = Course::kNever;

/// One of the two that move.
struct Mover {
    const Convex& shape;
    const Sweep& sweep;
};

/// How fast turning alone can bring any point of the outline nearer (m per step). Only that part of
/// a plane counts which the other outline can reach.
Real turningBound(Mover mover, Mover other) {
    if (mover.sweep.turn == 0) {
        return 0; // like most of the ground
    }
    Real swing = mover.shape.swing();
    if (mover.shape.isPlane()) {
        swing = length(other.sweep.start.position - mover.sweep.start.position) +
                length(other.sweep.move) + length(mover.sweep.move) + length(other.sweep.push) +
                other.shape.reach;
    }
    return swing * std::abs(mover.sweep.turn);
}

/// How the two go on at t, until one of them is stopped.
Course courseFrom(Mover a, Mover b, Real t, Real target) {
    const bool goesA = t < a.sweep.stopAt;
    const bool goesB = t < b.sweep.stopAt;
    const Real stopA = goesA ? a.sweep.stopAt : 1;
    const Real stopB = goesB ? b.sweep.stopAt : 1;
    return {.towards =
                (goesA ? a.sweep.move : a.sweep.push) - (goesB ? b.sweep.move : b.sweep.push),
            .turnA = goesA ? a.sweep.turn : 0,
            .turnB = goesB ? b.sweep.turn : 0,
            .turning = (goesA ? turningBound(a, b) : 0) + (goesB ? turningBound(b, a) : 0),
            .length = std::min({stopA, stopB, Real(1)}) - t,
            .target = target};
}

/// Do discs around both, which hold them however they turn, come as near as that on their ways?
bool discsMeet(Mover a, Mover b, Real target) {
    if (a.shape.isPlane() || b.shape.isPlane()) {
        return true; // no disc holds one
    }
    // A little more, for roundings.
    const Real near = Real(1.001) * (a.shape.reach + b.shape.reach + std::max(target, Real(0)));
    Vec2 apart = b.sweep.start.position - a.sweep.start.position;
    for (Real t = 0; t < 1;) {
        const Course course = courseFrom(a, b, t, target);
        const Vec2 way = -course.length * course.towards;
        const Real square = lengthSquared(way);
        const Real along = std::clamp(-dot(apart, way), Real(0), square);
        const Vec2 nearest = along > 0 ? apart + (along / square) * way : apart;
        if (lengthSquared(nearest) <= near * near) {
            return true;
        }
        apart += way;
        t += course.length;
    }
    return false;
}

/// Conservative advancement with any way to look ahead.
template <typename Look>
Real advance(Mover a, Mover b, Real target, Look lookAhead) {
    Real t = 0;
    Real most = 1;
    for (int round = 0; round < kMostRounds; ++round) {
        Course course = courseFrom(a, b, t, target);
        const Real left = course.length;
        course.length = std::min(left, most);
        const Outlook outlook = lookAhead(a.sweep.at(t), b.sweep.at(t), course);
        if (outlook.passes(course)) {
            t += course.length;
            if (most >= left && t >= 1) {
                return kNever;
            }
            most *= 4;
        } else if (outlook.distance - target <= std::abs(target) / 2) {
            return t;
        } else {
            t += outlook.last;
            most = 2 * outlook.last; // an impact is near, and a short way is foreseen better
        }
    }
    return t;
}

/// The same along one axis at a time.
template <typename Measure>
Real advanceAlong(Mover a, Mover b, Real target, Measure separationAt) {
    return advance(a, b, target,
                   [&](const Transform& at, const Transform& bt, const Course& course) {
                       const Separation now = separationAt(at, bt);
                       Outlook outlook;
                       outlook.see(now.axis, now.distance, course);
                       return outlook;
                   });
}

/// Of the whole straight line through a one-sided line, along its normal.
Separation aboveLine(const Convex& line, const Transform& a, const Convex& other,
                     const Transform& b) {
    const Transform ab = between(a, b);
    const Vec2 normal = line.normals[1];
    const std::size_t lowest = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    return {a.rotation * normal,
            dot(normal, ab * other.vertices[lowest] - line.vertices[0]) - other.radius};
}

/// Of one vertex of the line.
Separation fromVertex(const Convex& line, std::size_t end, const Transform& a, const Convex& other,
                      const Transform& b) {
    if (other.isRound()) {
        const Vec2 arm = between(a, b) * other.vertices[0] - line.vertices[end];
        return {a.rotation * normalize(arm), length(arm) - other.radius};
    }
    const RoundAxis axis = nearestToCenter(other, between(b, a) * line.vertices[end]);
    return {-(b.rotation * axis.normal), axis.distance};
}

/// What comes from the front first touches the line along its own normal, or one of its vertices
/// along a direction that the line owns there. Everything else belongs to its neighbours, or is let
/// pass.
Real impactOnOneSided(Mover line, Mover other, Real target) {
    const auto above = [&](const Transform& a, const Transform& b) {
        return aboveLine(line.shape, a, other.shape, b);
    };
    if (above(line.sweep.start, other.sweep.start).distance > target * Real(1.5)) {
        const Real t = advanceAlong(line, other, target, above);
        if (t > 1 || collideOneSided(line.shape, line.sweep.at(t), other.shape, other.sweep.at(t),
                                     2 * target, 0)
                             .count > 0) {
            return t;
        }
    }
    Real first = kNever;
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        if (!ownsVertex(line.shape, end)) {
            continue;
        }
        const auto vertex = [&](const Transform& a, const Transform& b) {
            return fromVertex(line.shape, end, a, other.shape, b);
        };
        const Real t = advanceAlong(line, other, target, vertex);
        if (t < first) {
            const Transform a = line.sweep.at(t);
            const Vec2 direction = unrotate(a.rotation, vertex(a, other.sweep.at(t)).axis);
            first = ownsDirection(line.shape, end, direction) ? t : first;
        }
    }
    return first;
}

/// Has a one-sided line turned its back on a plane?
bool turnsAway(Mover line, Mover plane) {
    const Vec2 front = line.sweep.start.rotation * line.shape.normals[1];
    return dot(front, plane.sweep.start.rotation * plane.shape.normals[0]) > 0;
}

} // namespace

Real timeOfImpact(const Convex& shapeA, const Sweep& a, const Convex& shapeB, const Sweep& b,
                  Real target) {
    const Mover moverA{shapeA, a};
    const Mover moverB{shapeB, b};
    if ((shapeA.oneSided && shapeB.isPlane() && turnsAway(moverA, moverB)) ||
        (shapeB.oneSided && shapeA.isPlane() && turnsAway(moverB, moverA))) {
        return kNever;
    }
    if (!discsMeet(moverA, moverB, target)) {
        return kNever;
    }
    if (shapeA.oneSided && !shapeB.isPlane()) {
        return impactOnOneSided(moverA, moverB, target);
    }
    if (shapeB.oneSided && !shapeA.isPlane()) {
        return impactOnOneSided(moverB, moverA, target);
    }
    return advance(moverA, moverB, target,
                   [&](const Transform& at, const Transform& bt, const Course& course) {
                       return outlookOf(shapeA, at, shapeB, bt, course);
                   });
}

} // namespace kodo::inline KODO_PRECISION
