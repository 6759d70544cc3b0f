// SPDX-License-Identifier: MIT
// How the stop of one body changes the impacts of its neighbours.
#include <kodo/geometry.hpp>

#include "contacts/ghost_collisions.hpp"

#include <algorithm>

#include "continuous/continuous_collision.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// True if a body that was just stopped, and keeps its place, may still be hit by `other`: if their
/// bounding discs meet on the rest of the other's path.
bool ContinuousCollision::mayMeetStopped(const Step& step, std::uint32_t body,
                                         std::uint32_t other) const {
    const Bodies& bodies = step.bodies;
    const BodyVelocity& motion = bodies.motion[other];
    const Real time = stopAt_[body];
    const Real end = stopAt_[other];
    if (end <= time || motion.unmoved()) {
        return false; // neither moves any more
    }
    const Vec2 place = bodies.pose[body].position + time * bodies.motion[body].deltaPosition;
    const Vec2 apart = bodies.pose[other].position + time * motion.deltaPosition - place;
    const Vec2 way = (end - time) * motion.deltaPosition;
    const Real square = lengthSquared(way);
    const Real along = std::clamp(-dot(apart, way), Real(0), square);
    const Vec2 nearest = along > 0 ? apart + (along / square) * way : apart;
    // A little larger, for rounding; impacts stop bodies before they touch.
    const Real near = Real(1.001) * (bodies.geometry(body).boundingRadius +
                                     bodies.geometry(other).boundingRadius + step.tolerances.slop);
    return lengthSquared(nearest) <= near * near;
}

/// Stops a body at `time` and computes its later impacts again: bodies that moved along with it may
/// now hit it. Its path until then is the same, so earlier impacts are, too.
void ContinuousCollision::cutShort(const Step& step, std::uint32_t body, Real time) {
    if (step.bodies.locked(body) || stopAt_[body] <= time) {
        return;
    }
    if (stopAt_[body] == 1) {
        stopped_.push_back(body);
    }
    stopAt_[body] = time;
    pulling_.push_back(body);
    step.contactSet.store().lists().forEach(body, [&](std::uint32_t i) {
        const ContactSummary& summary = step.summaries[i];
        if (summary.sensor || !isSwift(step.bodies, summary)) {
            return;
        }
        const std::uint32_t other = summary.other(body);
        const bool pushed = push_[body] != Vec2{} || push_[other] != Vec2{};
        if (pushed && times_[i] != kTaken) { // pushes move stopped bodies
            findTime(step, i, 0);
            queueImpact(step, i);
        } else if (times_[i] > time) {
            times_[i] = 1;
            if (mayMeetStopped(step, body, other)) {
                findTime(step, i, time);
                queueImpact(step, i);
            }
        }
    });
}

/// True if a pair with a hidden contact meets along the surface above the hidden ground: then the
/// body strikes that surface, as with the far end of a rod, and no internal edge.
bool ContinuousCollision::meetsSurface(const Step& step, const Contact& contact, Real time) const {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const Bodies& bodies = step.bodies;
    const Manifold met = collide(bodies.convex(bodyA, partA), pathOf(bodies, bodyA).at(time),
                                 bodies.convex(bodyB, partB), pathOf(bodies, bodyB).at(time),
                                 step.tolerances.margin, 0);
    return met.count > 0 && isSameWay(met.normal, contact.manifold.normal);
}

} // namespace KODO_PRECISION
} // namespace kodo
