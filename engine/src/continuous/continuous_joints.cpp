// SPDX-License-Identifier: MIT
// How joints pass on that continuous collision has stopped one of their bodies.
#include "joints/anchor.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "continuous/continuous_collision.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Gap (slops) that a stopped body may open at its joints. Each joint takes up that much, so that a
// stop does not spread through a long chain or a net. With 1 to 8, bodies of a crowd of ragdolls
// stop inside each other more often, and wedge joints open for good.
constexpr Real kOpened = 16;
// The same if an immovable body has stopped it.
constexpr Real kOpenedAtGround = 2;
// Least fraction of a step by which a joint stops a body earlier.
constexpr Real kLeastCut = Real(1) / 64;

/// Length (m) by which the vector between the anchors violates a joint.
Real violation(const JointDef& def, Vec2 gap, Rot rotationA) {
    if (const auto* distance = std::get_if<DistanceJoint>(&def)) {
        const Real d = length(gap);
        return distance->limits
                   ? std::abs(d - std::clamp(d, distance->limits->lower, distance->limits->upper))
                   : 0;
    }
    if (const auto* slider = std::get_if<PrismaticJoint>(&def)) {
        return std::abs(dot(perp(rotationA * slider->axis), gap));
    }
    if (const auto* wheel = std::get_if<WheelJoint>(&def)) {
        return std::abs(dot(perp(rotationA * wheel->axis), gap));
    }
    const auto* fixed = std::get_if<FixedJoint>(&def);
    const bool rigid =
        std::holds_alternative<RevoluteJoint>(def) || (fixed != nullptr && fixed->hertz == 0);
    return rigid ? length(gap) : 0;
}

} // namespace

/// Violation (m) of a joint if its bodies are at these fractions of the step.
Real ContinuousCollision::violationAt(const Bodies& bodies, const JointDef& def, Real fractionA,
                                      Real fractionB) const {
    const JointEnds* const ends = endsOf(def);
    if (ends == nullptr) {
        return 0;
    }
    const Transform a = pathOf(bodies, ends->a.index).at(fractionA);
    const Transform b = pathOf(bodies, ends->b.index).at(fractionB);
    const Vec2 gap = b.position + armOf(bodies, ends->b.index, b.rotation, ends->anchorB) -
                     a.position - armOf(bodies, ends->a.index, a.rotation, ends->anchorA);
    return violation(def, gap, a.rotation);
}

/// A body that has been stopped would lose the others at its joints, which move on: these are
/// stopped as soon as a gap opens. They stay on their paths, so they pass through nothing.
void ContinuousCollision::stopJointed(const Step& step, bool atGround) {
    const Real opened = (atGround ? kOpenedAtGround : kOpened) * step.tolerances.slop;
    const Bodies& bodies = step.bodies;
    while (!pulling_.empty()) {
        const std::uint32_t body = pulling_.back();
        pulling_.pop_back();
        const Real time = stopAt_[body];
        step.joints.listOf(body, jointsOf_);
        for (const std::uint32_t index : jointsOf_) {
            const JointDef& def = step.joints.defAt(index);
            const bool isA = firstBody(def).index == body;
            const std::uint32_t other = (isA ? secondBody(def) : firstBody(def)).index;
            if (other == body || bodies.locked(other) || !bodies.active(other) ||
                stopAt_[other] <= time + kLeastCut) {
                continue;
            }
            const auto gapAt = [&](Real fraction) {
                return isA ? violationAt(bodies, def, time, fraction)
                           : violationAt(bodies, def, fraction, time);
            };
            const Real most = std::max(opened, gapAt(time));
            const Real end = gapAt(stopAt_[other]);
            if (end > most) {
                const Real start = gapAt(time);
                const Real share = (most - start) / (end - start);
                const Real at = time + share * (stopAt_[other] - time);
                if (at < stopAt_[other] - kLeastCut) {
                    cutShort(step, other, at);
                }
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
