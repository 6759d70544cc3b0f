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

} // namespace

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
