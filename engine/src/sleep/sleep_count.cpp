// SPDX-License-Identifier: MIT
// SleepSystem: the calm steps of bodies and islands, and which of them still move by their law.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "sleep/sleep_system.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Speed that contacts and rounding cause on a body at rest, as a fraction of the speed that its
// forces would cause in a step.
constexpr Real kNoise = Real(1) / 2048;
// The same for a body that cannot tip, roll or swing by itself: contacts of a high stack settle as
// springs, and a stack of twenty boxes sways by this speed.
constexpr Real kNoiseOnBase = Real(1) / 128;

// A contact supports a body if its normal has a larger share than this against the acceleration.
constexpr Real kSteepBase = Real(0.25);

/// Calm steps between two samples of a velocity: a quarter of those until sleep.
std::uint32_t sampleInterval(std::uint32_t enough) {
    constexpr std::uint32_t kSamples = 4;
    return std::max(enough / kSamples, std::uint32_t{1});
}

Real kineticEnergy(const BodyVelocity& motion, const Mass& mass) {
    const Real w = motion.angularVelocity;
    return (mass.mass * lengthSquared(motion.velocity) + mass.inertia * w * w) / 2;
}

/// Kinetic energy (J) that the forces give a body within dt from rest.
Real energyOfForces(const Acceleration& acceleration, const Mass& mass, Real dt) {
    const Real v = dt * acceleration.forcePerMass;
    const Real w = dt * acceleration.angular;
    return (mass.mass * v * v + mass.inertia * w * w) / 2;
}

/// True if any point of the body has moved by more than `distance` (m) from `since`.
bool hasCrept(const Transform& pose, const Transform& since, Real reach, Real distance) {
    const Rot turn = pose.rotation * since.rotation.inverse();
    const Real moved = lengthSquared(pose.position - since.position);
    const Real turned = reach * reach * turn.s * turn.s;
    return moved + turned > distance * distance || turn.c < 0;
}

/// True if a motor with a target speed moves its joint: at half of that speed at least. One that is
/// stalled, by a limit or a load, lets its island sleep.
bool drives(const JointSet::Joint& joint, const Bodies& bodies) {
    const auto reaches = [&](Real most, Real target, Real JointState::*speed) {
        return most > 0 && target != 0 && stateOf(joint, bodies).*speed / target > Real(0.5);
    };
    if (const auto* slider = std::get_if<PrismaticJoint>(&joint.def)) {
        return reaches(slider->motorForce, slider->motorSpeed, &JointState::speed);
    }
    if (const auto* rod = std::get_if<DistanceJoint>(&joint.def)) {
        return reaches(rod->motorForce, rod->motorSpeed, &JointState::lengthSpeed);
    }
    if (const auto* hinge = std::get_if<RevoluteJoint>(&joint.def)) {
        return reaches(hinge->motorTorque, hinge->motorSpeed, &JointState::angularSpeed);
    }
    const auto* wheel = std::get_if<WheelJoint>(&joint.def);
    return wheel != nullptr &&
           reaches(wheel->motorTorque, wheel->motorSpeed, &JointState::angularSpeed);
}

} // namespace

/// Restarts the calm count of a body; it stays in its island.
void restartCount(SleepState& rest, const Transform& pose) {
    const std::uint32_t island = rest.island;
    rest = {};
    rest.island = island;
    rest.since = pose;
}

/// Counts the calm steps of each body. Lists the bodies that have been calm for long enough.
void SleepSystem::countCalm(Bodies& bodies, const StepSettings& settings,
                            const Tolerances& tolerances, Real dt) {
    calm_.clear();
    calm_.reserve(bodies.record.capacity());
    const auto enough = static_cast<std::uint32_t>(settings.sleepSteps);
    for (const std::uint32_t body : bodies.awake) {
        SleepState& rest = bodies.sleep[body];
        const BodyGeometry& geometry = bodies.geometry(body);
        const BodyVelocity& motion = bodies.motion[body];
        const Real energy = kineticEnergy(motion, geometry.mass);
        const bool calm =
            (bodies.filter[body].flags & kNeverSleep) == 0 &&
            energy <= energyOfForces(bodies.acceleration[body], geometry.mass, dt) &&
            !hasCrept(bodies.pose[body], rest.since, geometry.boundingRadius, tolerances.slop / 4);
        if (calm) {
            ++rest.calmSteps;
            rest.leastEnergy = std::min(rest.leastEnergy, energy);
        } else {
            restartCount(rest, bodies.pose[body]);
        }
        if (rest.calmSteps % sampleInterval(enough) == 0) {
            rest.samples[1] =
                std::exchange(rest.samples[0], {motion.velocity, motion.angularVelocity});
        }
        if (rest.calmSteps >= enough && !bodies.locked(body)) {
            calm_.push_back(body);
        }
    }
}

void SleepSystem::makeRoom(const Bodies& bodies) {
    resizeByBody(leastCalm_, bodies);
    resizeByBody(reachedBy_, bodies); // all 0 between steps
    resizeByBody(neighboursOf_, bodies);
}

/// Finds the base of each body of calm islands: the range of the points that support it, across its
/// acceleration.
void SleepSystem::findBases(const Bodies& bodies, const ContactSet& contacts) {
    bases_.clear();
    reserveReusing(bases_, sleepers_.size());
    for (const auto& [root, body] : sleepers_) {
        bases_.push_back(baseOf(body, bodies, contacts));
    }
}

SleepSystem::Base SleepSystem::baseOf(std::uint32_t body, const Bodies& bodies,
                                      const ContactSet& contacts) const {
    Base base;
    const Vec2 pull = bodies.acceleration[body].linear;
    const Vec2 across = perp(pull) / length(pull);
    contacts.store().lists().forEach(body, [&](std::uint32_t slot) {
        const Contact& contact = contacts.contacts()[slot];
        if (!contact.touching || contact.sensor) {
            return;
        }
        const bool isA = contact.key.bodyA == body;
        const Vec2 push = isA ? -contact.manifold.normal : contact.manifold.normal;
        if (!(dot(push, pull) < -kSteepBase * length(pull))) {
            return; // a load, or a wall
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
            const ManifoldPoint& point = contact.manifold.points[i];
            const Real at = dot(across, isA ? point.armA : point.armB);
            base.least = std::min(base.least, at);
            base.most = std::max(base.most, at);
        }
    });
    return base;
}

/// Among the bodies of calm islands: one that moves by its own law, not by noise, keeps its island
/// awake. Such a body has become faster than in its slowest calm step, so it tips or rolls off a
/// summit. Or its velocity still changes: it swings, and turns back just now.
void SleepSystem::holdMoving(Bodies& bodies, std::uint32_t enough, const Tolerances& tolerances,
                             Real dt) {
    const auto isOnBase = [&](const Base& base) {
        return base.least < -tolerances.slop && base.most > tolerances.slop;
    };
    for (std::size_t k = 0; k < sleepers_.size(); ++k) {
        const auto [root, body] = sleepers_[k];
        SleepState& rest = bodies.sleep[body];
        const Mass& mass = bodies.geometry(body).mass;
        BodyVelocity change = bodies.motion[body];
        const Real now = std::sqrt(kineticEnergy(change, mass));
        change.velocity -= rest.samples[1].velocity;
        change.angularVelocity -= rest.samples[1].angularVelocity;
        const Real changed = std::sqrt(kineticEnergy(change, mass));
        const Real noise = (isOnBase(bases_[k]) ? kNoiseOnBase : kNoise) *
                           std::sqrt(energyOfForces(bodies.acceleration[body], mass, dt));
        if (now - std::sqrt(rest.leastEnergy) > noise) {
            restartCount(rest, bodies.pose[body]);
            leastCalm_[root] = 0;
        } else if (changed > noise) {
            rest.calmSteps = enough - sampleInterval(enough);
            leastCalm_[root] = 0;
        }
    }
    std::erase_if(sleepers_, [&](const auto& sleeper) { return leastCalm_[sleeper.first] == 0; });
}

/// Lists the bodies of calm islands, searched from one calm body after the other.
void SleepSystem::findCalmIslands(const Bodies& bodies, const ContactSet& contacts,
                                  const JointSet& joints, std::uint32_t enough) {
    reached_.clear();
    reached_.reserve(bodies.awake.capacity());
    std::uint32_t search = 0;
    for (const std::uint32_t body : calm_) {
        if (reachedBy_[body] != 0) {
            continue;
        }
        const std::size_t first = reached_.size();
        if (followIsland(body, ++search, bodies, contacts, joints, enough)) {
            const auto island = std::span(reached_).subspan(first);
            const std::uint32_t root = *std::min_element(island.begin(), island.end());
            leastCalm_[root] = enough;
            for (const std::uint32_t member : island) {
                sleepers_.emplace_back(root, member);
            }
        }
    }
    for (const std::uint32_t body : reached_) {
        reachedBy_[body] = 0;
    }
}

/// Appends the island of a calm body to reached_, up to a body that keeps it awake. False if there
/// is one, or if an earlier search has found one in this island.
bool SleepSystem::followIsland(std::uint32_t start, std::uint32_t search, const Bodies& bodies,
                               const ContactSet& contacts, const JointSet& joints,
                               std::uint32_t enough) {
    bool calm = true;
    const auto reach = [&](std::uint32_t body) {
        if (!bodies.active(body)) {
            return;
        }
        // A kinematic body keeps the bodies awake that it carries.
        const bool isCalm = !bodies.locked(body) && bodies.sleep[body].calmSteps >= enough;
        const std::uint32_t before = std::exchange(reachedBy_[body], search);
        calm = calm && isCalm && (before == 0 || before == search);
        if (before == 0) {
            reached_.push_back(body);
        }
    };
    const std::span<const ContactSummary> summaries = contacts.summaries();
    std::size_t next = reached_.size();
    reach(start);
    for (; calm && next < reached_.size(); ++next) {
        const std::uint32_t body = reached_[next];
        contacts.store().lists().forEach(body, [&](std::uint32_t slot) {
            const ContactSummary& summary = summaries[slot];
            const Contact& contact = contacts.contacts()[slot];
            if (!summary.sensor && contact.touching) {
                calm = calm && contact.material.surfaceSpeed == 0; // a belt conveys what it carries
                reach(summary.other(body));
            }
        });
        joints.visitOf(body, [&](const JointSet::Joint& joint) {
            calm = calm && !drives(joint, bodies);
            const std::uint32_t a = firstBody(joint.def).index;
            reach(a == body ? secondBody(joint.def).index : a);
        });
    }
    return calm;
}

bool SleepSystem::updateSleep(Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                              const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    countCalm(bodies, settings, tolerances, dt);
    if (calm_.empty()) {
        return false;
    }
    const auto enough = static_cast<std::uint32_t>(settings.sleepSteps);
    sleepers_.clear();
    sleepers_.reserve(bodies.awake.capacity());
    findCalmIslands(bodies, contacts, joints, enough);
    if (!sleepers_.empty()) {
        findBases(bodies, contacts);
        holdMoving(bodies, enough, tolerances, dt);
    }
    return !sleepers_.empty();
}

} // namespace KODO_PRECISION
} // namespace kodo
