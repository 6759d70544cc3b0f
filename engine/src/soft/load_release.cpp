// SPDX-License-Identifier: MIT
#include "soft/load_release.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "lanes/contact_block_lanes.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Speed of a kick below which it is left to the passes, in slops per second: 0.14 m/s, which lifts
// a body by 1 mm on the earth. With 4, piles that are landing cost 2.5 times as much.
constexpr Real kSmallKick = 36;
// Speed, in slops per second and in changes by the forces of a substep, from which on a separating
// contact carries nothing.
constexpr Real kThrown = 36;
constexpr Real kThrownAgainst = 4;
// Overlap, in slops, from which on impulses push apart instead of carrying a load.
constexpr Real kDeep = 4;
// Visits of one body in a step. A tower or a pyramid needs one for each body above.
constexpr std::uint8_t kMostVisits = 16;

/// Velocity of a body, and its kinetic energy.
struct Twist {
    Vec2 velocity;
    Real angular = 0;
};

Twist twistOf(const Four& speeds) {
    return {{speeds[0], speeds[1]}, speeds[2]};
}

/// Velocity change of a body by the warm start and the forces of a substep.
Twist kickOf(const Bodies& bodies, const LoadRelease::Velocity& before, std::uint32_t body,
             Real h) {
    const Four time{h, h, h, 0};
    return twistOf(speeds(bodies.motion[body]) -
                   (before.speeds - time * rates(bodies.acceleration[body])));
}

/// Square of the speed (m/s) at which the energy would be linear.
Real squareOf(const BodyVelocity& motion, const Twist& twist) {
    const Real gyration = motion.invInertia > 0 ? motion.invMass / motion.invInertia : Real(0);
    return lengthSquared(twist.velocity) + gyration * twist.angular * twist.angular;
}

void scaleImpulses(const ContactLanes::Place& at, Real factor) {
    at.block.points[0].impulse[at.lane] *= factor;
    at.block.points[1].impulse[at.lane] *= factor;
    at.block.friction[at.lane] *= factor;
    at.block.rolling[at.lane] *= factor;
}

} // namespace

bool LoadRelease::isKicked(const StepInput& inputs, std::uint32_t body, Real h) const {
    const BodyVelocity& motion = inputs.bodies.motion[body];
    const Real force = h * inputs.bodies.acceleration[body].forcePerMass;
    const Real least = std::max(kSmallKick * inputs.tolerances.slop, force / 2);
    return motion.invMass > 0 &&
           squareOf(motion, kickOf(inputs.bodies, before_[body], body, h)) > least * least;
}

void LoadRelease::addKicked(std::uint32_t body) {
    if (queued_[body] == 0 && visits_[body] < kMostVisits) {
        queued_[body] = 1;
        ++visits_[body];
        queue_.push_back(body);
    }
}

/// Lists the contacts of a body in the passes, in the order of keys: sums depend on it.
void LoadRelease::listContacts(const StepInput& inputs, std::uint32_t body) {
    slots_.clear();
    inputs.contactSet.store().lists().forEach(body, [&](std::uint32_t slot) {
        if (inputs.contactSet.summaries()[slot].inPasses()) {
            slots_.push_back(slot);
        }
    });
    inputs.contactSet.store().sortByKey(slots_);
}

/// Finds the velocity change of a body by each of its contacts.
void LoadRelease::findGains(const StepInput& inputs, std::uint32_t body) {
    listContacts(inputs, body);
    gains_.clear();
    const Real deepest = -kDeep * inputs.tolerances.slop;
    if (std::any_of(slots_.begin(), slots_.end(), [&](std::uint32_t slot) {
            return inputs.contactSet.store().separation(slot) < deepest;
        })) {
        return;
    }
    BodyVelocity& motion = inputs.bodies.motion[body];
    const BodyVelocity kept = motion;
    for (const std::uint32_t slot : slots_) {
        const ContactSummary& summary = inputs.contactSet.summaries()[slot];
        BodyVelocity& other = inputs.bodies.motion[summary.other(body)];
        const BodyVelocity otherKept = other;
        applyImpulses(inputs.bodies, inputs.contactSet.lanes().placeOf(summary.row.index), 1);
        gains_.push_back(
            {slot, motion.velocity - kept.velocity, motion.angularVelocity - kept.angularVelocity});
        motion = kept;
        other = otherKept;
    }
}

/// Takes back the impulses that kick a body. Adds the bodies that this kicks to the queue.
void LoadRelease::release(const StepInput& inputs, std::uint32_t body, Real h) {
    Bodies& bodies = inputs.bodies;
    ContactBlocks& blocks = inputs.contactSet.lanes();
    const BodyVelocity& motion = bodies.motion[body];
    const Twist kick = kickOf(bodies, before_[body], body, h);
    const Real gyration = motion.invInertia > 0 ? motion.invMass / motion.invInertia : Real(0);
    const auto along = [&](const Gain& gain) {
        return dot(kick.velocity, gain.velocity) + gyration * kick.angular * gain.angular;
    };
    findGains(inputs, body);
    std::erase_if(gains_, [&](const Gain& gain) { return !(along(gain) > 0); });
    Twist gained;
    for (const Gain& gain : gains_) {
        gained.velocity += gain.velocity;
        gained.angular += gain.angular;
    }
    const Real square = squareOf(motion, gained);
    if (!(square > 0)) {
        return;
    }
    const Real share =
        std::clamp(along({0, gained.velocity, gained.angular}) / square, Real(0), Real(1));
    for (const Gain& gain : gains_) {
        const ContactSummary& summary = inputs.contactSet.summaries()[gain.slot];
        const ContactLanes::Place lane = blocks.placeOf(summary.row.index);
        applyImpulses(bodies, lane, -share);
        scaleImpulses(lane, 1 - share);
        const std::uint32_t other = summary.other(body);
        if (isKicked(inputs, other, h)) {
            addKicked(other);
        }
    }
}

/// Least speed (m/s) at which a loaded point of a contact separates, without contacts and joints.
Real LoadRelease::separatingSpeed(const Bodies& bodies, const ContactLanes::Place& at) const {
    const ContactBlock& block = at.block;
    const std::size_t lane = at.lane;
    const std::uint32_t a = bodyOfPlace(block.a[lane]);
    const std::uint32_t b = bodyOfPlace(block.b[lane]);
    // kinematic bodies have their velocity here, too
    const Twist ofA = twistOf(bodies.locked(a) ? speeds(bodies.motion[a]) : before_[a].speeds);
    const Twist ofB = twistOf(bodies.locked(b) ? speeds(bodies.motion[b]) : before_[b].speeds);
    const Real middle =
        dot({block.normalX[lane], block.normalY[lane]}, ofB.velocity - ofA.velocity);
    Real least = std::numeric_limits<Real>::max();
    for (const ContactBlock::Point& point : block.points) {
        if (point.impulse[lane] > 0) {
            least = std::min(least, middle + point.leverB[lane] * ofB.angular -
                                        point.leverA[lane] * ofA.angular);
        }
    }
    return least;
}

/// Takes back the impulses of contacts that separate too fast to carry anything.
void LoadRelease::releaseSeparating(const StepInput& inputs, std::uint32_t body, Real h) {
    listContacts(inputs, body);
    for (const std::uint32_t slot : slots_) {
        const ContactSummary& summary = inputs.contactSet.summaries()[slot];
        const ContactLanes::Place lane = inputs.contactSet.lanes().placeOf(summary.row.index);
        const Real fall = h * (inputs.bodies.acceleration[summary.bodyA].forcePerMass +
                               inputs.bodies.acceleration[summary.bodyB].forcePerMass);
        const Real sum =
            lane.block.points[0].impulse[lane.lane] + lane.block.points[1].impulse[lane.lane];
        const Real give = inputs.bodies.motion[summary.bodyA].invMass +
                          inputs.bodies.motion[summary.bodyB].invMass;
        if (give * sum > kSmallKick * inputs.tolerances.slop &&
            separatingSpeed(inputs.bodies, lane) >
                std::max(kThrown * inputs.tolerances.slop, kThrownAgainst * fall)) {
            applyImpulses(inputs.bodies, lane, -1);
            scaleImpulses(lane, 0);
            changed_.push_back(summary.other(body));
        }
    }
}

void LoadRelease::run(const StepInput& inputs, std::span<const std::uint32_t> list,
                      std::span<const Velocity> before, Real h) {
    const Bodies& bodies = inputs.bodies;
    if (bodies.changes.lostLoads.empty()) {
        return;
    }
    changed_.clear();
    std::copy_if(list.begin(), list.end(), std::back_inserter(changed_), [&](std::uint32_t body) {
        return bodies.record[body].lostLoad != 0 && bodies.motion[body].invMass > 0;
    });
    before_ = before;
    queue_.clear();
    for (std::size_t i = 0, count = changed_.size(); i < count; ++i) {
        releaseSeparating(inputs, changed_[i], h);
    }
    for (const std::uint32_t body : changed_) {
        if (isKicked(inputs, body, h)) {
            addKicked(body);
        }
    }
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        const std::uint32_t body = queue_[next];
        queued_[body] = 0;
        if (!inputs.joints.lists().hasAny(body)) {
            release(inputs, body, h);
        }
    }
    for (const std::uint32_t body : queue_) {
        visits_[body] = 0;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
