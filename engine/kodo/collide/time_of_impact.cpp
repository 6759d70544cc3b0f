// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/time_of_impact.hpp>

#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

// Each round at least halves the gap where shapes are curved or turn; straight flight onto a face
// needs two. A pair that still creeps towards touching after this many is stopped where it is,
// which is safe: it has not touched yet.
constexpr int kMostRounds = 40;

/// How fast turning alone can bring any point of the outline nearer (m per step).
Real turningBound(const Convex& shape, const Sweep& sweep) {
    // A circle around the centre of mass looks the same however it is turned.
    const bool spins = !(shape.isRound() && shape.vertices[0] == Vec2{});
    return spins ? shape.reach * std::abs(sweep.turn) : 0;
}

} // namespace

Real timeOfImpact(const Convex& shapeA, const Sweep& a, const Convex& shapeB, const Sweep& b,
                  Real target) {
    Real t = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        const Separation now = separation(shapeA, a.at(t), shapeB, b.at(t));
        const Real gap = now.distance - target;
        if (gap <= target / 2) {
            return t;
        }
        const Vec2 moveA = t < a.stopAt ? a.move : Vec2{};
        const Vec2 moveB = t < b.stopAt ? b.move : Vec2{};
        const Real turning = (t < a.stopAt ? turningBound(shapeA, a) : 0) +
                             (t < b.stopAt ? turningBound(shapeB, b) : 0);
        const Real closing = dot(now.axis, moveA - moveB) + turning;
        // The bound holds until one of them stops; from there on the other goes on alone.
        Real until = 1;
        for (const Sweep* sweep : {&a, &b}) {
            if (t < sweep->stopAt && sweep->stopAt < until) {
                until = sweep->stopAt;
            }
        }
        const Real free = closing > 0 ? gap / closing : 2;
        if (t + free >= until) {
            if (until >= 1) {
                return 2;
            }
            t = until;
        } else {
            t += free;
        }
    }
    return t;
}

} // namespace kodo::inline KODO_PRECISION
