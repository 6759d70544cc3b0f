// SPDX-License-Identifier: MIT
// Loads of the joints in a step, and joints that break under them.
#include "joints/anchor.hpp"
#include "joints/joint_set.hpp"
#include "math/decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Least separation (m) of the contacts of two bodies; infinite if none is near.
Real separationOf(const ContactSet& contactSet, std::uint32_t a, std::uint32_t b) {
    Real least = std::numeric_limits<Real>::infinity();
    contactSet.store().lists().forEach(a, [&](std::uint32_t slot) {
        const Contact& contact = contactSet.contacts()[slot];
        if ((contact.key.bodyA == b || contact.key.bodyB == b) && contact.responds()) {
            least = std::min(least, contactSet.store().separation(slot));
        }
    });
    return least;
}

} // namespace

void JointSet::boundBias(const ContactSet& contactSet, Real slop, Real pushSpeed) {
    // With all of the speed while they touch, a joint and a contact gain ten times as much energy.
    // With a sixteenth, the joint opens so far that it closes with force once the bodies have
    // parted.
    const Real touching = pushSpeed / 4;
    for (const std::uint32_t index : awake_) {
        Joint& joint = joints_[index];
        joint.mostBias = Joint::kNoBound;
        const JointEnds* const ends = endsOf(joint.def);
        if (ends != nullptr && ends->collide) {
            const Real apart = separationOf(contactSet, ends->a.index, ends->b.index);
            if (apart < std::numeric_limits<Real>::infinity()) {
                joint.mostBias = apart < slop ? touching : pushSpeed;
            }
        }
    }
}

std::span<const BrokenJoint> JointSet::endStep(Real dt) {
    // Without a hold, a lift sinks with few substeps and rises with many, for ever.
    constexpr Real kHold = 8;        // times the load of a step
    const Real kept = decay(2 * dt); // a peak lasts for half a second
    broken_.clear();
    for (const std::uint32_t index : awake_) {
        Joint& joint = joints_[index];
        if (!std::exchange(joint.solved, false)) {
            continue; // not solved in this step: the load stays
        }
        const Real load = std::exchange(joint.load, Real(0));
        joint.held = std::max({load, std::min(joint.held, kHold * load), kept * joint.held});
        joint.force = joint.linearImpulseSum / dt;
        joint.torque = joint.angularImpulseSum / dt;
        const JointEnds* const ends = endsOf(joint.def);
        const Real force = length(joint.force);
        const Real torque = std::abs(joint.torque);
        if (ends != nullptr && (force > ends->breakForce || torque > ends->breakTorque)) {
            broken_.push_back({idAt(index), ends->a, ends->b, force, torque});
        }
    }
    for (const BrokenJoint& broken : broken_) {
        remove(broken.id);
    }
    return broken_;
}

} // namespace KODO_PRECISION
} // namespace kodo
