// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/collide/round.hpp>
#include <kodo/collide/sat.hpp>
#include <kodo/collide/time_of_impact.hpp>

#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

// Each round at least halves the gap where shapes are curved or turn; straight flight onto a face
// needs two. A pair that still creeps towards touching after this many is stopped where it is,
// which is safe: it has not touched yet.
constexpr int kMostRounds = 40;
constexpr Real kNever = 2;

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

/// Conservative advancement with any measure of separation that is never more than the distance.
template <typename Measure>
Real advance(Mover a, Mover b, Real target, Measure separationAt) {
    const Real turningA = turningBound(a, b);
    const Real turningB = turningBound(b, a);
    Real t = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        const Separation now = separationAt(a.sweep.at(t), b.sweep.at(t));
        const Real gap = now.distance - target;
        if (gap <= std::abs(target) / 2) {
            return t;
        }
        const Vec2 moveA = t < a.sweep.stopAt ? a.sweep.move : a.sweep.push;
        const Vec2 moveB = t < b.sweep.stopAt ? b.sweep.move : b.sweep.push;
        const Real turning =
            (t < a.sweep.stopAt ? turningA : 0) + (t < b.sweep.stopAt ? turningB : 0);
        const Real closing = dot(now.axis, moveA - moveB) + turning;
        // The bound holds until one of them stops; from there on the other goes on alone.
        Real until = 1;
        for (const Sweep* sweep : {&a.sweep, &b.sweep}) {
            if (t < sweep->stopAt && sweep->stopAt < until) {
                until = sweep->stopAt;
            }
        }
        const Real free = closing > 0 ? gap / closing : kNever;
        if (t + free >= until) {
            if (until >= 1) {
                return kNever;
            }
            t = until;
        } else {
            t += free;
        }
    }
    return t;
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
        const Real t = advance(line, other, target, above);
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
        const Real t = advance(line, other, target, vertex);
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
    if (shapeA.oneSided && !shapeB.isPlane()) {
        return impactOnOneSided(moverA, moverB, target);
    }
    if (shapeB.oneSided && !shapeA.isPlane()) {
        return impactOnOneSided(moverB, moverA, target);
    }
    return advance(moverA, moverB, target, [&](const Transform& at, const Transform& bt) {
        return separation(shapeA, at, shapeB, bt);
    });
}

} // namespace kodo::inline KODO_PRECISION
