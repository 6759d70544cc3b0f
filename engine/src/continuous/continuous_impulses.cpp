// SPDX-License-Identifier: MIT
// How kinematic bodies push along bodies that are stopped in front of them.
#include <kodo/geometry.hpp>

#include <algorithm>
#include <utility>

#include "continuous/continuous_collision.hpp"
#include "continuous/relative_motion.hpp"
#include "continuous/stop_motion.hpp"
#include "impacts/departure.hpp"
#include "impacts/impact_solver.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Raises the component of `push` along `normal` to that of `way` (m), the displacement of a
/// surface, so that the body stays ahead of it. A body that is pushed against the surface is left
/// as it is.
void pushAlong(Vec2& push, Vec2 normal, Vec2 way) {
    const Real there = dot(normal, push);
    const Real wanted = dot(normal, way);
    if (there >= 0 && wanted > there) {
        push += (wanted - there) * normal;
    }
}

/// Way (m, per whole step) of a point at `arm` (m) that goes along with a kinematic body for the
/// rest of the step, straight to its place at the end.
Vec2 carriedBy(const BodyVelocity& motion, Vec2 arm, Real time) {
    const Rot turn = turned(Rot{}, (1 - time) * motion.deltaAngle);
    return motion.deltaPosition + (turn * arm - arm) / (1 - time);
}

} // namespace

/// The push of a body, to be changed.
Vec2& ContinuousCollision::pushOf(std::uint32_t body) {
    if (push_[body] == Vec2{}) {
        pushed_.push_back(body);
    }
    return push_[body];
}

Separation ContinuousCollision::separationAt(const Step& step, const Contact& contact,
                                             Real time) const {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    return separation(step.bodies.convex(bodyA, partA), pathOf(step.bodies, bodyA).at(time),
                      step.bodies.convex(bodyB, partB), pathOf(step.bodies, bodyB).at(time));
}

/// Takes from the push of a body what would press it into a static one, which dominates: into any
/// that it touches, or nearly, at `time`.
void ContinuousCollision::holdBackAtGround(const Step& step, std::uint32_t body, Real time) {
    step.contactSet.store().lists().forEach(body, [&](std::uint32_t i) {
        const Contact& contact = step.contacts[i];
        if (step.bodies.isStill(contact.key.other(body)) && contact.mayRespond()) {
            const auto [axis, distance] = separationAt(step, contact, time);
            if (distance <= step.tolerances.margin) {
                const Vec2 out = body == contact.key.bodyB ? axis : -axis;
                push_[body] -= std::min(dot(out, push_[body]), Real(0)) * out;
            }
        }
    });
}

/// Finds the pushes by kinematic bodies that touch or nearly touch at the start of the step. A body
/// with restitution has become faster than the kinematic body by its impact and needs no push.
void ContinuousCollision::findPushes(const Step& step) {
    step.contactSet.store().forEachInOrder([&](std::uint32_t i) {
        const ContactSummary& summary = step.summaries[i];
        const Contact& contact = step.contacts[i];
        const auto [bodyA, partA, bodyB, partB] = contact.key;
        const bool isA = step.bodies.locked(bodyA);
        const auto [floor, body] = isA ? std::pair(bodyA, bodyB) : std::pair(bodyB, bodyA);
        if (!summary.mayTouch || summary.bounces || isA == step.bodies.locked(bodyB) ||
            !contact.responds() || !step.bodies.isMovingKinematic(floor) ||
            !areChecked(step.bodies, bodyA, bodyB)) {
            return;
        }
        const ManifoldPoint& point = contact.manifold.points[0];
        const Vec2 way = carriedBy(step.bodies.motion[floor], isA ? point.armA : point.armB, 0);
        pushAlong(pushOf(body), isA ? contact.manifold.normal : -contact.manifold.normal, way);
        holdBackAtGround(step, body, 0);
    });
}

/// Applies the impact of a body with restitution that meets a kinematic one at `time`, along the
/// normal there: by the next step a body that turns has another one. Where a joint holds the body,
/// or another of its contacts touches as well, the next step has all impacts. Not counted is still
/// ground on which it rests.
void ContinuousCollision::bounceOff(const Step& step, std::uint32_t slot, Real time) {
    Bodies& bodies = step.bodies;
    ContactSet& contactSet = step.contactSet;
    Contact& contact = step.contacts[slot];
    const Real slop = step.tolerances.slop;
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const bool drivenA = bodies.isMovingKinematic(bodyA);
    if (!contact.bounces || !step.settings.has(Feature::Restitution) ||
        drivenA == bodies.isMovingKinematic(bodyB) ||
        isJointed(bodies, step.joints.lists(), contact.key)) {
        return;
    }
    const std::uint32_t body = drivenA ? bodyB : bodyA;
    bool alone = true;
    contactSet.store().lists().forEach(body, [&](std::uint32_t other) {
        const Contact& beside = step.contacts[other];
        const bool rests = bodies.isStill(beside.key.other(body)) &&
                           gapOf(bodies, contactSet, other, step.tolerances) <= slop;
        alone = alone && (other == slot || rests || !beside.mayRespond() ||
                          separationAt(step, beside, time).distance > slop);
    });
    if (!alone) {
        return;
    }
    BodyVelocity& motion = bodies.motion[body];
    const Acceleration& forces = bodies.acceleration[body];
    const Real left = timeFrom(motion, forces.linear, time, step.dt);
    contactSet.store().leavePasses(slot, bodies);
    const ContactLane lane = contactSet.store().lane(slot);
    motion.velocity -= left * forces.linear; // at the time of impact
    motion.angularVelocity -= left * forces.angular;
    if (meet(bodies, contact, lane, time, step.tolerances)) {
        solveImpact(bodies, contact, lane, step.settings, step.tolerances, 0);
        contactSet.manifoldChanged(slot);
    }
    motion.velocity += left * forces.linear; // which stop() takes
    motion.angularVelocity += left * forces.angular;
    lane.expire();
}

/// A body that meets a kinematic body within the step is carried along with it for the rest of the
/// step, as it keeps its place against a static body: the next step then has the same contact in
/// both cases. A body that meets a pushed one is pushed along, but not into a static body.
void ContinuousCollision::takePushedDisplacement(const Step& step, const Contact& contact,
                                                 Real time) {
    const ContactKey& key = contact.key;
    if (push_[key.bodyA] == Vec2{} && push_[key.bodyB] == Vec2{} &&
        !step.bodies.isMovingKinematic(key.bodyA) && !step.bodies.isMovingKinematic(key.bodyB)) {
        return;
    }
    const Vec2 normal = separationAt(step, contact, time).axis;
    const auto wayOf = [&](std::uint32_t body, Vec2 arm) {
        return step.bodies.locked(body) ? carriedBy(step.bodies.motion[body], arm, time)
                                        : push_[body];
    };
    const auto take = [&](std::uint32_t body, std::uint32_t other, Vec2 away, Vec2 way) {
        if (step.bodies.locked(body)) {
            return;
        }
        Vec2& push = pushOf(body);
        if (step.bodies.isMovingKinematic(other)) {
            push = way;
        } else if (!step.bodies.locked(other)) {
            pushAlong(push, away, way);
        }
        holdBackAtGround(step, body, time);
    };
    const Vec2 arm = pathOf(step.bodies, key.bodyB).positionAt(time) -
                     pathOf(step.bodies, key.bodyA).positionAt(time);
    take(key.bodyA, key.bodyB, -normal, wayOf(key.bodyB, -arm));
    take(key.bodyB, key.bodyA, normal, wayOf(key.bodyA, arm));
}

} // namespace KODO_PRECISION
} // namespace kodo
