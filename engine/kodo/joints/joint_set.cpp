// SPDX-License-Identifier: MIT
#include <kodo/joints/joint_kinds.hpp>
#include <kodo/joints/joint_set.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {
namespace {

Vec2 armOf(const Bodies& bodies, std::uint32_t body, Rot rotation, Vec2 anchor) {
    return rotation * (anchor - bodies.form(body).mass.center);
}

Rot rotationNow(const Bodies& bodies, std::uint32_t body) {
    const Real turn = bodies.motion[body].turn;
    return turn == 0 ? bodies.pose[body].rotation : turned(bodies.pose[body].rotation, turn);
}

JointFrame frameOf(Bodies& bodies, const JointEnds& ends) {
    const std::uint32_t a = ends.a.index;
    const std::uint32_t b = ends.b.index;
    JointFrame frame{bodies.motion[a],       bodies.motion[b],      {}, {}, {},
                     rotationNow(bodies, a), rotationNow(bodies, b)};
    frame.armA = armOf(bodies, a, frame.rotationA, ends.anchorA);
    frame.armB = armOf(bodies, b, frame.rotationB, ends.anchorB);
    frame.gap = (bodies.pose[b].position - bodies.pose[a].position) +
                (frame.b.move - frame.a.move) + (frame.armB - frame.armA);
    return frame;
}

/// A hand counts as a body that nothing moves.
JointFrame frameOf(Bodies& bodies, const Mouse& mouse, Motion& hand) {
    const std::uint32_t b = mouse.body.index;
    JointFrame frame{hand, bodies.motion[b], {}, {}, {}, {}, rotationNow(bodies, b)};
    frame.armB = armOf(bodies, b, frame.rotationB, mouse.anchor);
    frame.gap = bodies.pose[b].position + frame.b.move + frame.armB - mouse.target;
    return frame;
}

/// Calls visit(frame, constraint, impulse, relax) for all constraints of a joint.
template <typename Visit>
void forConstraints(JointSet::Joint& joint, Bodies& bodies, const JointPass& pass, Visit visit) {
    const auto list = [&](const JointFrame& frame, const auto& kind) {
        const auto one = [&](const auto& constraint, auto& impulse, Relax relax) {
            visit(frame, constraint, impulse, relax);
        };
        JointKinds(joint, frame, pass, one)(kind);
    };
    std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.ends; }) {
                list(frameOf(bodies, kind.ends), kind);
            } else {
                Motion hand;
                list(frameOf(bodies, kind, hand), kind);
            }
        },
        joint.def);
}

bool idle(const Bodies& bodies, const JointDef& def) {
    return !bodies.active(firstBody(def).index) && !bodies.active(secondBody(def).index);
}

/// Reference angles and axes are relative to the body that the joint held before.
template <typename Kind>
void transferEnd(Kind& kind, bool isFirst, BodyId into, const Transform& place) {
    if constexpr (requires { kind.ends; }) {
        Vec2& anchor = isFirst ? kind.ends.anchorA : kind.ends.anchorB;
        anchor = place * anchor;
        (isFirst ? kind.ends.a : kind.ends.b) = into;
        if constexpr (requires { kind.reference; }) {
            kind.reference += isFirst ? place.rotation.angle() : -place.rotation.angle();
        }
        if constexpr (requires { kind.axis; }) {
            kind.axis = isFirst ? place.rotation * kind.axis : kind.axis;
        }
    } else {
        kind.body = into;
        kind.anchor = place * kind.anchor;
    }
}

struct Overload {
    Real force;
    Real torque;
};

Overload limitsOf(const JointDef& def) {
    return std::visit(
        [](const auto& kind) -> Overload {
            if constexpr (requires { kind.ends; }) {
                return {kind.ends.breakForce, kind.ends.breakTorque};
            } else {
                return {kUnbreakable, kUnbreakable};
            }
        },
        def);
}

} // namespace

JointId JointSet::add(const JointDef& def) {
    const IdPool::Slot slot = ids_.allocate();
    if (slot.index == joints_.size()) {
        joints_.emplace_back();
    }
    joints_[slot.index] = {};
    joints_[slot.index].def = def;
    refreshLists();
    return {slot.index, slot.generation};
}

void JointSet::remove(JointId id) {
    ids_.release(id.index);
    refreshLists();
}

void JointSet::dropBody(BodyId body) {
    for (const JointId id : ids()) {
        if (firstBody(def(id)) == body || secondBody(def(id)) == body) {
            remove(id);
        }
    }
}

void JointSet::transfer(BodyId part, BodyId into, const Transform& place) {
    for (const JointId id : ids()) {
        JointDef& def = joints_[id.index].def;
        const bool isFirst = firstBody(def) == part;
        if (!isFirst && secondBody(def) != part) {
            continue;
        }
        if ((isFirst ? secondBody(def) : firstBody(def)) == into) {
            remove(id);
        } else {
            std::visit([&](auto& kind) { transferEnd(kind, isFirst, into, place); }, def);
        }
    }
    refreshLists();
}

std::vector<JointId> JointSet::ids() const {
    std::vector<JointId> all;
    for (const std::uint32_t index : live_) {
        all.push_back({index, ids_.generationAt(index)});
    }
    return all;
}

void JointSet::refreshLists() {
    live_.clear();
    apart_.clear();
    for (std::uint32_t index = 0; index < joints_.size(); ++index) {
        if (!ids_.aliveAt(index)) {
            continue;
        }
        live_.push_back(index);
        const JointDef& def = joints_[index].def;
        std::visit(
            [&](const auto& kind) {
                if constexpr (requires { kind.ends; }) {
                    if (!kind.ends.collide) {
                        apart_.push_back(std::minmax({kind.ends.a.index, kind.ends.b.index}));
                    }
                }
            },
            def);
    }
    std::sort(apart_.begin(), apart_.end()); // total order: equal pairs are the same
}

void JointSet::beginStep() {
    for (const std::uint32_t index : live_) {
        Joint& joint = joints_[index];
        joint.pushSum = {};
        joint.turnSum = 0;
        joint.solved = false;
    }
}

void JointSet::warmStart(Bodies& bodies, const JointPass& pass) {
    for (const std::uint32_t index : live_) {
        if (idle(bodies, joints_[index].def)) {
            continue;
        }
        forConstraints(joints_[index], bodies, pass,
                       [](const JointFrame& frame, const auto& constraint, auto& impulse, Relax) {
                           constraint.push(frame.a, frame.b, impulse);
                       });
    }
}

void JointSet::solve(Bodies& bodies, const JointPass& pass) {
    for (const std::uint32_t index : live_) {
        Joint& joint = joints_[index];
        if (idle(bodies, joint.def)) {
            continue;
        }
        joint.solved = true;
        forConstraints(
            joint, bodies, pass,
            [&](const JointFrame& frame, const auto& constraint, auto& impulse, Relax relax) {
                constraint.solve(frame.a, frame.b, impulse, pass.biased || relax == Relax::Same);
                if (!pass.biased) { // the last pass of the substep
                    constraint.sumUp(impulse, joint.pushSum, joint.turnSum);
                }
            });
    }
}

std::span<const BrokenJoint> JointSet::endStep(Real dt) {
    broken_.clear();
    for (const std::uint32_t index : live_) {
        Joint& joint = joints_[index];
        if (!joint.solved) {
            continue; // it goes on holding what it held
        }
        joint.force = joint.pushSum / dt;
        joint.torque = joint.turnSum / dt;
        const Overload most = limitsOf(joint.def);
        if (length(joint.force) > most.force || std::abs(joint.torque) > most.torque) {
            broken_.push_back({{index, ids_.generationAt(index)},
                               firstBody(joint.def),
                               secondBody(joint.def),
                               length(joint.force),
                               std::abs(joint.torque)});
        }
    }
    for (const BrokenJoint& broken : broken_) {
        remove(broken.id);
    }
    return broken_;
}

} // namespace kodo::inline KODO_PRECISION
