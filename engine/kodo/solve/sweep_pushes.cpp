// SPDX-License-Identifier: MIT
// How what is locked and moves pushes along what has been stopped in front of it.
#include <kodo/collide/collide.hpp>
#include <kodo/solve/sweep.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {
namespace {

/// Adds to `push` what is missing for it to keep ahead of a surface that comes so far, unless it is
/// pushed against that.
void pushAlong(Vec2& push, Vec2 normal, Vec2 way) {
    const Real there = dot(normal, push);
    const Real wanted = dot(normal, way);
    if (there >= 0 && wanted > there) {
        push += (wanted - there) * normal;
    }
}

/// Nothing is pushed into what stands for good.
void holdBack(Vec2& push, Vec2 normal) {
    push -= std::min(dot(normal, push), Real(0)) * normal;
}

} // namespace

/// By what is locked and moves, and touches at the start of the step or nearly so. What bounces off
/// it will be faster than it, and needs no push.
void SweepStage::findPushes(const Step& step) {
    againstLocked_.clear();
    for (std::uint32_t i = 0; i < step.contacts.size(); ++i) {
        const ContactHead& head = step.heads[i];
        if (head.meets && !head.bounces &&
            step.bodies.locked(head.bodyA) != step.bodies.locked(head.bodyB) &&
            step.contacts[i].responds()) {
            againstLocked_.push_back(i);
        }
    }
    for (const bool stand : {false, true}) { // what stands has the last word
        for (const std::uint32_t i : againstLocked_) {
            const Contact& contact = step.contacts[i];
            const auto [bodyA, partA, bodyB, partB] = contact.key;
            const bool isA = step.bodies.locked(bodyA);
            if (step.bodies.drives(isA ? bodyA : bodyB) == stand) {
                continue;
            }
            const Motion& floor = step.bodies.motion[isA ? bodyA : bodyB];
            const ManifoldPoint& point = contact.manifold.points[0];
            const Vec2 way = floor.move + cross(floor.turn, isA ? point.armA : point.armB);
            const Vec2 normal = isA ? contact.manifold.normal : -contact.manifold.normal;
            Vec2& push = push_[isA ? bodyB : bodyA];
            if (stand) {
                holdBack(push, normal);
            } else {
                pushAlong(push, normal, way);
            }
        }
    }
}

/// Whoever has met what is locked and moves, or what that pushes, is pushed with it, but not into
/// what is locked and stands.
void SweepStage::takePush(const Step& step, const Contact& contact, Real time) {
    const ContactKey& key = contact.key;
    if (contact.bounces || (push_[key.bodyA] == Vec2{} && push_[key.bodyB] == Vec2{} &&
                            !step.bodies.drives(key.bodyA) && !step.bodies.drives(key.bodyB))) {
        return;
    }
    const Transform a = sweepOf(step.bodies, key.bodyA).at(time);
    const Transform b = sweepOf(step.bodies, key.bodyB).at(time);
    const Vec2 normal = separation(step.bodies.outline(key.bodyA, key.partA), a,
                                   step.bodies.outline(key.bodyB, key.partB), b)
                            .axis;
    const auto wayOf = [&](std::uint32_t body, Vec2 from) {
        const Motion& motion = step.bodies.motion[body];
        const std::uint32_t other = body == key.bodyA ? key.bodyB : key.bodyA;
        return step.bodies.locked(body)
                   ? motion.move + cross(motion.turn, step.bodies.pose[other].position - from)
                   : push_[body];
    };
    const Vec2 wayA = wayOf(key.bodyA, a.position);
    const Vec2 wayB = wayOf(key.bodyB, b.position);
    const auto take = [&](std::uint32_t body, std::uint32_t other, Vec2 away, Vec2 way) {
        if (step.bodies.locked(body)) {
            return;
        }
        if (step.bodies.locked(other) && !step.bodies.drives(other)) {
            holdBack(push_[body], away);
        } else {
            pushAlong(push_[body], away, way);
        }
    };
    take(key.bodyA, key.bodyB, -normal, wayB);
    take(key.bodyB, key.bodyA, normal, wayA);
}

} // namespace kodo::inline KODO_PRECISION
