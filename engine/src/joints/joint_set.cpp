// SPDX-License-Identifier: MIT
#include "joints/joint_set.hpp"

#include "joints/anchor.hpp"
#include "joints/joint_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

bool idle(const Bodies& bodies, const JointDef& def) {
    return !bodies.active(firstBody(def).index) && !bodies.active(secondBody(def).index);
}

/// Maps anchor, axis, rack and reference angle from the frame of the welded body to that of `into`.
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
        if constexpr (requires { kind.rack; }) {
            kind.rack = isFirst && kind.rack ? place.rotation * *kind.rack : kind.rack;
        }
    } else {
        kind.body = into;
        kind.anchor = place * kind.anchor;
    }
}

/// The joint of `part` after its weld into `into`; std::nullopt for a joint between the two.
std::optional<JointDef> transferred(JointDef def, BodyId part, BodyId into,
                                    const Transform& place) {
    const bool isFirst = firstBody(def) == part;
    if ((isFirst ? secondBody(def) : firstBody(def)) == into) {
        return std::nullopt;
    }
    std::visit([&](auto& kind) { transferEnd(kind, isFirst, into, place); }, def);
    return def;
}

/// True if the joint may belong to a tree. Bodies that can only rotate are excluded: K of their
/// anchors is singular along the arm.
bool mayBeHeld(const Bodies& bodies, const JointDef& def) {
    const BodyVelocity& a = bodies.motion[firstBody(def).index];
    const BodyVelocity& b = bodies.motion[secondBody(def).index];
    const auto half = [](const BodyVelocity& m) { return (m.invMass == 0) != (m.invInertia == 0); };
    const bool revolute = std::holds_alternative<RevoluteJoint>(def);
    const auto* const fixed = std::get_if<FixedJoint>(&def);
    const bool rigid = revolute || (fixed != nullptr && fixed->hertz == 0) ||
                       std::holds_alternative<PrismaticJoint>(def);
    return rigid && (a.invMass > 0 || b.invMass > 0) && !turnsOnly(a) && !turnsOnly(b) &&
           (revolute || (!half(a) && !half(b)));
}

/// True if the joint forbids a contact between its bodies.
bool excludesContact(const JointDef& def) {
    const JointEnds* const ends = endsOf(def);
    return ends != nullptr && !ends->collide;
}

/// Erases a number from a list in order, if it is there.
void eraseFrom(std::vector<std::uint32_t>& list, std::uint32_t number) {
    const auto at = std::lower_bound(list.begin(), list.end(), number);
    if (at != list.end() && *at == number) {
        list.erase(at);
    }
}

} // namespace

JointId JointSet::add(const JointDef& def) {
    const IdPool::Slot slot = ids_.allocate();
    if (slot.index == joints_.size()) {
        joints_.emplace_back();
    }
    joints_[slot.index] = {};
    joints_[slot.index].def = def;
    list(slot.index);
    awakeStale_ = true;
    return idAt(slot.index);
}

void JointSet::remove(JointId id) {
    ids_.release(id.index);
    eraseFrom(awake_, id.index);
    unlist(id.index);
    awakeStale_ = true;
}

/// Adds a joint to the lists of its bodies.
void JointSet::list(std::uint32_t index) {
    const JointDef& def = joints_[index].def;
    lists_.add(index, firstBody(def).index, secondBody(def).index, excludesContact(def));
    notePairChange(def);
}

/// Undoes list().
void JointSet::unlist(std::uint32_t index) {
    lists_.remove(index);
    notePairChange(joints_[index].def);
}

void JointSet::notePairChange(const JointDef& def) {
    if (excludesContact(def)) {
        pairChanges_.insert(pairChanges_.end(), {firstBody(def).index, secondBody(def).index});
    }
}

void JointSet::setDef(JointId id, const JointDef& def) {
    unlist(id.index);
    Joint& joint = joints_[id.index];
    if (const auto* revolute = std::get_if<RevoluteJoint>(&def)) {
        const Real before = std::get<RevoluteJoint>(joint.def).reference;
        joint.counted = countsTurns(*revolute) ? joint.counted + before - revolute->reference : 0;
    }
    joint.def = def;
    joint.mostBias = Joint::kNoBound;
    list(id.index);
    awakeStale_ = true;
}

void JointSet::dropBody(std::uint32_t body) {
    for (const std::uint32_t index : lists_.of(body)) {
        remove(idAt(index));
    }
}

std::optional<Problem> JointSet::checkTransfer(BodyId part, BodyId into, const Transform& place,
                                               Real lengthUnit) const {
    for (const std::uint32_t index : lists_.of(part.index)) {
        const auto after = transferred(joints_[index].def, part, into, place);
        if (auto problem = after ? check(*after, lengthUnit) : std::nullopt) {
            return problem;
        }
    }
    return std::nullopt;
}

void JointSet::transfer(BodyId part, BodyId into, const Transform& place) {
    for (const std::uint32_t index : lists_.of(part.index)) {
        if (const auto after = transferred(joints_[index].def, part, into, place)) {
            unlist(index);
            joints_[index].def = *after;
            list(index);
        } else {
            remove(idAt(index));
        }
    }
    awakeStale_ = true;
}

void JointSet::refreshLists() {
    lists_.clear();
    ids_.forEach([&](std::uint32_t index) {
        const JointDef& def = joints_[index].def;
        lists_.add(index, firstBody(def).index, secondBody(def).index, excludesContact(def));
    });
    std::erase_if(awake_, [&](std::uint32_t index) { return !ids_.aliveAt(index); });
    awakeStale_ = true;
}

void JointSet::findBusy(const Bodies& bodies, bool changed) {
    if (!changed && !awakeStale_) {
        return;
    }
    awakeStale_ = false;
    // Visits either all joints or those of the awake bodies, whichever are fewer.
    constexpr std::size_t kFew = 4; // times as many awake bodies as joints: walks all joints
    awake_.clear();
    if (joints_.size() < kFew * bodies.awake.size()) {
        for (std::uint32_t index = 0; index < joints_.size(); ++index) {
            if (ids_.aliveAt(index) && !idle(bodies, joints_[index].def)) {
                awake_.push_back(index);
            }
        }
        return;
    }
    for (const std::uint32_t body : bodies.awake) {
        lists_.forEach(body, [&](std::uint32_t index) { awake_.push_back(index); });
    }
    sortUnique(awake_);
}

void JointSet::beginStep() {
    for (const std::uint32_t index : awake_) {
        joints_[index].linearImpulseSum = {};
        joints_[index].angularImpulseSum = 0;
    }
}

namespace {

/// True for a revolute joint that may be solved as a spring. With an anchor far outside of a body,
/// the mass at the anchor is a small part of the body's, and a spring would open wide.
bool isSoft(const Bodies& bodies, const JointDef& def) {
    constexpr Real kLongArm = 16; // lever^2 m / I; a rod has 3 at its ends
    const auto* const revolute = std::get_if<RevoluteJoint>(&def);
    const auto isLong = [&](BodyId body, Vec2 anchor) {
        const BodyVelocity& motion = bodies.motion[body.index];
        const Vec2 arm = armOf(bodies, body.index, {}, anchor);
        return motion.invMass > 0 &&
               motion.invInertia * lengthSquared(arm) > kLongArm * motion.invMass;
    };
    return revolute != nullptr && !isLong(revolute->ends.a, revolute->ends.anchorA) &&
           !isLong(revolute->ends.b, revolute->ends.anchorB);
}

} // namespace

void JointSet::beginGroup(Bodies& bodies, Real jointGap, std::span<const std::uint8_t> levels,
                          std::uint32_t level) {
    own_.clear();
    takenRevolutes_.clear();
    treeCandidates_.clear();
    springs_.clear();
    for (const std::uint32_t index : awake_) {
        const JointDef& def = joints_[index].def;
        const std::uint32_t a = firstBody(def).index;
        const std::uint32_t b = secondBody(def).index;
        const std::uint32_t own = levels.empty() ? 0u : std::max(levels[a], levels[b]);
        if (own != level || idle(bodies, def)) {
            continue;
        }
        own_.push_back(index);
        for (const std::uint32_t body : {a, b}) {
            if (bodies.motion[body].invInertia == 0 && isParticle(bodies, body)) {
                bodies.motion[body].angularVelocity = 0; // it would act as a motor
            }
        }
        springs_.add(bodies, index, def);
        if (mayBeHeld(bodies, def)) {
            treeCandidates_.push_back({index, a, b, !isSoft(bodies, def)});
        }
    }
    trees_.find(bodies, treeCandidates_, jointGap);
    listHinges(bodies);
    springs_.find(bodies);
    for (const SpringRates::Spring& spring : springs_.all()) {
        joints_[spring.joint].springBound = spring.bound;
        joints_[spring.joint].stiffness = spring.stiffness;
    }
}

void JointSet::listHinges(const Bodies& bodies) {
    hinges_.clear();
    if (trees_.empty()) {
        return;
    }
    for (const ArticulatedTrees::Edge& edge : treeCandidates_) {
        HeldRows* const rows = trees_.rowsOf(edge.joint);
        const auto* const revolute = std::get_if<RevoluteJoint>(&joints_[edge.joint].def);
        if (rows == nullptr || revolute == nullptr || revolute->motorTorque > 0 ||
            revolute->limits || revolute->hertz > 0) {
            continue;
        }
        const Vec2 armA = revolute->ends.anchorA - bodies.geometry(edge.a).mass.center;
        const Vec2 armB = revolute->ends.anchorB - bodies.geometry(edge.b).mass.center;
        rows->hinge = true;
        rows->reachA = length(armA);
        rows->reachB = length(armB);
        joints_[edge.joint].solved = true;
        hinges_.push_back({edge.joint, edge.a, edge.b, armA, armB, rows});
    }
    trees_.findTouched(bodies);
    std::erase_if(own_, [&](std::uint32_t index) {
        const HeldRows* const rows = trees_.rowsOf(index);
        return rows != nullptr && rows->hinge;
    });
}

std::span<const std::uint32_t> JointSet::takeRevolutes(const Bodies& bodies) {
    std::erase_if(own_, [&](std::uint32_t index) {
        const JointDef& def = joints_[index].def;
        const auto* const revolute = std::get_if<RevoluteJoint>(&def);
        const bool taken = revolute != nullptr && !countsTurns(*revolute) &&
                           trees_.rowsOf(index) == nullptr &&
                           joints_[index].mostBias == Joint::kNoBound &&
                           !turnsOnly(bodies.motion[firstBody(def).index]) &&
                           !turnsOnly(bodies.motion[secondBody(def).index]);
        if (taken) {
            takenRevolutes_.push_back(index);
        }
        return taken;
    });
    return takenRevolutes_;
}

void JointSet::scaleImpulses(Real by) {
    if (by == 1) {
        return;
    }
    for (const Hinge& hinge : hinges_) {
        joints_[hinge.joint].point *= by;
    }
    for (const std::span<const std::uint32_t> list :
         {std::span<const std::uint32_t>(own_), std::span<const std::uint32_t>(takenRevolutes_)}) {
        for (const std::uint32_t index : list) {
            Joint& joint = joints_[index];
            joint.point *= by;
            for (Real& impulse : joint.axes) {
                impulse *= by;
            }
        }
    }
}

void JointSet::forgetUnsound() {
    ids_.forEach([&](std::uint32_t index) {
        Joint& joint = joints_[index];
        const Real sum =
            std::accumulate(joint.axes.begin(), joint.axes.end(), joint.angularImpulseSum);
        joint.counted = std::isfinite(joint.counted) ? joint.counted : 0;
        if (!std::isfinite(sum) || !isFinite(joint.point) || !isFinite(joint.linearImpulseSum)) {
            joint.point = {};
            joint.axes = {};
            joint.linearImpulseSum = {};
            joint.angularImpulseSum = 0;
        }
    });
}

/// The sums of a step are left out: the next step resets them.
void JointSet::Joint::visitState(StateStream& stream) {
    static_assert(countMembers<Joint>() == 15, "list a new member, or leave it out");
    stream(def, point, axes, counted, force, torque, held, atLimit);
    const Real impulses = std::accumulate(axes.begin(), axes.end(), point.x + point.y);
    require(!stream.reads() ||
                std::isfinite(impulses + force.x + force.y + torque + counted + held),
            "an impulse or an angle of a joint is not finite");
}

void JointSet::visitState(StateStream& stream, const Bodies& bodies, Real lengthUnit) {
    auto& [ids, stamp, joints, lists, pairChanges, broken, trees, treeCandidates, hinges, springs,
           inertias, rotations, own, takenRevolutes, busy, busyStale, lastPass] = *this;
    stream(ids);
    if (stream.reads()) {
        stamp = 0;
        joints.resize(ids.capacity());
    }
    ids.forEach([&, &joints = joints_](std::uint32_t i) {
        stream(joints[i]);
        if (!stream.reads()) {
            return;
        }
        require(check(joints[i].def, lengthUnit));
        for (const BodyId body : {firstBody(joints[i].def), secondBody(joints[i].def)}) {
            require(bodies.ids.alive(body.index, body.generation),
                    "a joint refers to a body that does not exist");
        }
    });
    if (stream.reads()) {
        refreshLists();
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
