// SPDX-License-Identifier: MIT
// What joints tell of themselves: ids, turns, place and motion.
#include "joints/anchor.hpp"
#include "joints/joint_frame.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A point of a body between two steps, in world axes.
struct Point {
    Vec2 position; // m
    Vec2 velocity; // m/s
    Rot rotation;
    Real angularVelocity;

    Point(const Bodies& bodies, BodyId body, Vec2 anchor)
        : rotation(bodies.pose[body.index].rotation),
          angularVelocity(bodies.motion[body.index].angularVelocity) {
        const Vec2 arm = armOf(bodies, body.index, rotation, anchor);
        position = bodies.pose[body.index].position + arm;
        velocity = velocityAt(bodies.motion[body.index], arm);
    }
};

/// Adds `share` of the distance of a point from another one.
void addLength(JointState& state, Vec2 gap, Vec2 velocity, Real share) {
    const Real distance = length(gap);
    state.length += share * distance;
    state.lengthSpeed += distance > 0 ? share * dot(gap, velocity) / distance : Real(0);
}

JointState stateOfKind(const MouseJoint& mouse, const Bodies& bodies, Real) {
    const Point grip(bodies, mouse.body, mouse.anchor);
    JointState state{.anchorA = mouse.target, .anchorB = grip.position};
    addLength(state, grip.position - mouse.target, grip.velocity, 1);
    return state;
}

template <typename Joint>
JointState stateOfKind(const Joint& joint, const Bodies& bodies, Real counted) {
    const Point a(bodies, joint.ends.a, joint.ends.anchorA);
    const Point b(bodies, joint.ends.b, joint.ends.anchorB);
    const Vec2 gap = b.position - a.position;
    const Vec2 velocity = b.velocity - a.velocity;
    JointState state{.anchorA = a.position, .anchorB = b.position};
    Rot turn = b.rotation * a.rotation.inverse();
    if constexpr (requires { joint.reference; }) {
        turn = turn * Rot::fromAngle(-joint.reference);
    }
    state.angle = turn.angle();
    if constexpr (std::is_same_v<Joint, RevoluteJoint>) {
        state.angle = countsTurns(joint) ? withTurns(state.angle, counted) : state.angle;
    }
    state.angularSpeed = b.angularVelocity - a.angularVelocity;
    if constexpr (requires { joint.axis; }) {
        const Vec2 axis = a.rotation * joint.axis;
        state.translation = dot(axis, gap);
        state.speed = dot(axis, velocity) + a.angularVelocity * dot(perp(axis), gap);
    }
    if constexpr (requires { joint.groundA; }) {
        addLength(state, a.position - joint.groundA, a.velocity, 1);
        addLength(state, b.position - joint.groundB, b.velocity, joint.ratio);
    } else {
        addLength(state, gap, velocity, 1);
    }
    return state;
}

/// A limit of a ratchet follows the angle (rad) to the last tooth; not if that is NaN.
void catchTooth(RevoluteJoint& joint, Real angle) {
    const Real tooth = joint.ratchet * std::floor(angle / joint.ratchet);
    if (joint.ratchet > 0) {
        joint.limits->lower = std::max(joint.limits->lower, std::min(tooth, joint.limits->upper));
    } else if (joint.ratchet < 0) {
        joint.limits->upper = std::min(joint.limits->upper, std::max(tooth, joint.limits->lower));
    }
}

} // namespace

std::vector<JointId> JointSet::ids() const {
    std::vector<JointId> all;
    ids_.forEach([&](std::uint32_t index) { all.push_back(idAt(index)); });
    return all;
}

std::vector<JointId> JointSet::ids(std::uint32_t body) const {
    std::vector<JointId> all;
    for (const std::uint32_t index : lists_.of(body)) {
        all.push_back(idAt(index));
    }
    return all;
}

void JointSet::count(Bodies& bodies) {
    for (const std::uint32_t index : awake_) {
        Joint& joint = joints_[index];
        if (auto* const revolute = std::get_if<RevoluteJoint>(&joint.def);
            revolute != nullptr && countsTurns(*revolute)) {
            joint.counted = frameOf(bodies, turned_, revolute->ends)
                                .countedAngle(revolute->reference, joint.counted);
            catchTooth(*revolute, joint.counted);
        } else if (const auto* gear = std::get_if<GearJoint>(&joint.def)) {
            joint.counted = slipOf(*gear, frameOf(bodies, turned_, gear->ends), joint.counted);
        }
    }
}

JointState stateOf(const JointSet::Joint& joint, const Bodies& bodies) {
    return std::visit([&](const auto& kind) { return stateOfKind(kind, bodies, joint.counted); },
                      joint.def);
}

} // namespace KODO_PRECISION
} // namespace kodo
