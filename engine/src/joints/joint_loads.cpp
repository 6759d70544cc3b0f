// SPDX-License-Identifier: MIT
// Loads of the joints in a step, and joints that break under them.
#include "joints/joint_set.hpp"

#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

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

/// The two ends, if the bodies of a joint may collide.
const JointEnds* collidingEnds(const JointDef& def) {
    return std::visit(
        [](const auto& kind) -> const JointEnds* {
            if constexpr (requires { kind.ends; }) {
                return kind.ends.collide ? &kind.ends : nullptr;
            } else {
                return nullptr;
            }
        },
        def);
}

/// True if some contact of two bodies overlaps by more than the slop. While a contact is resident,
/// its summary alone has the separation of this step.
bool overlaps(const ContactSet& contactSet, std::uint32_t a, std::uint32_t b, Real slop) {
    bool any = false;
    contactSet.store().lists().forEach(a, [&](std::uint32_t slot) {
        const Contact& contact = contactSet.contacts()[slot];
        const bool meets = contact.key.bodyA == b || contact.key.bodyB == b;
        any = any ||
              (meets && contact.responds() && contactSet.summaries()[slot].separation[0] < -slop);
    });
    return any;
}

} // namespace

void JointSet::boundBias(const ContactSet& contactSet, Real slop, Real pushSpeed) {
    // With all of the speed, a joint and a contact gain ten times as much energy. With a sixteenth,
    // the joint opens so far that it closes with force once the bodies have parted.
    const Real most = pushSpeed / 4;
    if (excludedPairs_.size() == live_.size()) {
        return; // no joint lets its bodies collide, nor is any left bounded: see setDef()
    }
    for (const std::uint32_t index : busy_) {
        Joint& joint = joints_[index];
        const JointEnds* const ends = collidingEnds(joint.def);
        const bool bounded =
            ends != nullptr && overlaps(contactSet, ends->a.index, ends->b.index, slop);
        joint.mostBias = bounded ? most : Joint::kNoBound;
    }
}

std::span<const BrokenJoint> JointSet::endStep(Real dt) {
    broken_.clear();
    for (const std::uint32_t index : busy_) {
        Joint& joint = joints_[index];
        if (!std::exchange(joint.solved, false)) {
            continue; // not solved in this step: the load stays
        }
        joint.force = joint.linearImpulseSum / dt;
        joint.torque = joint.angularImpulseSum / dt;
        const Overload most = limitsOf(joint.def);
        const bool mayBreak = most.force < kUnbreakable || most.torque < kUnbreakable;
        if (mayBreak &&
            (length(joint.force) > most.force || std::abs(joint.torque) > most.torque)) {
            broken_.push_back({idAt(index), firstBody(joint.def), secondBody(joint.def),
                               length(joint.force), std::abs(joint.torque)});
        }
    }
    for (const BrokenJoint& broken : broken_) {
        remove(broken.id);
    }
    return broken_;
}

} // namespace KODO_PRECISION
} // namespace kodo
