// SPDX-License-Identifier: MIT
// SleepSystem: the calm steps of bodies and islands, and which of them still move by their law.
#include "solve/sleep_system.hpp"

#include <algorithm>
#include <cmath>

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
constexpr Real kSteep = Real(0.25);

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
    const Real v = dt * acceleration.effort;
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

} // namespace

/// Restarts the calm count of a body; it stays in its island.
void restartCount(SleepState& rest, const Transform& pose) {
    const std::uint32_t island = rest.island;
    rest = {};
    rest.island = island;
    rest.since = pose;
}

/// True if any body has been calm for long enough, so that islands must be checked.
bool SleepSystem::countCalm(Bodies& bodies, const StepSettings& settings,
                            const Tolerances& tolerances, Real dt) {
    bool any = false;
    const auto enough = static_cast<std::uint32_t>(settings.sleepSteps);
    const std::uint32_t interval = sampleInterval(enough);
    for (const std::uint32_t body : bodies.awake) {
        SleepState& rest = bodies.sleep[body];
        const BodyGeometry& geometry = bodies.geometry(body);
        const Real energy = kineticEnergy(bodies.motion[body], geometry.mass);
        const bool calm =
            (bodies.filter[body].flags & kNeverSleep) == 0 &&
            energy <= energyOfForces(bodies.acceleration[body], geometry.mass, dt) &&
            !hasCrept(bodies.pose[body], rest.since, geometry.boundingRadius, tolerances.slop / 4);
        if (calm) {
            ++rest.calmSteps;
            rest.leastEnergy = std::min(rest.leastEnergy, energy);
            if (rest.calmSteps % interval == 0) {
                const BodyVelocity& motion = bodies.motion[body];
                rest.samples[1] = rest.samples[0];
                rest.samples[0] = {motion.velocity, motion.angularVelocity};
            }
        } else {
            restartCount(rest, bodies.pose[body]);
        }
        any = any || rest.calmSteps >= enough;
    }
    return any;
}

/// Finds the base of each body: the range of the points that support it, across its acceleration.
void SleepSystem::findBases(const Bodies& bodies, const ContactSet& contacts) {
    resizeByBody(bases_, bodies);
    for (const std::uint32_t body : bodies.awake) {
        bases_[body] = {};
    }
    for (const Contact& contact : contacts.contacts()) {
        if (!contact.touching || contact.sensor) {
            continue;
        }
        for (const bool isA : {true, false}) {
            const std::uint32_t body = isA ? contact.key.bodyA : contact.key.bodyB;
            const Vec2 pull = bodies.acceleration[body].linear;
            const Vec2 push = isA ? -contact.manifold.normal : contact.manifold.normal;
            if (!(dot(push, pull) < -kSteep * length(pull))) {
                continue; // a load, or a wall
            }
            const Vec2 across = perp(pull) / length(pull);
            for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
                const ManifoldPoint& point = contact.manifold.points[i];
                const Real at = dot(across, isA ? point.armA : point.armB);
                bases_[body].least = std::min(bases_[body].least, at);
                bases_[body].most = std::max(bases_[body].most, at);
            }
        }
    }
}

/// Among the bodies of calm islands: one that moves by its own law, not by noise, keeps its island
/// awake. Such a body has become faster than in its slowest calm step, so it tips or rolls off a
/// summit. Or its velocity still changes: it swings, and turns back just now.
void SleepSystem::holdMoving(Bodies& bodies, std::uint32_t enough, const Tolerances& tolerances,
                             Real dt) {
    const auto isOnBase = [&](const Base& base) {
        return base.least < -tolerances.slop && base.most > tolerances.slop;
    };
    sleepers_.clear(); // here: the calm bodies
    sleepers_.reserve(bodies.record.capacity());
    for (const std::uint32_t body : bodies.awake) {
        const std::uint32_t root = touching_.rootOf(body);
        if (leastCalm_[root] >= enough) {
            sleepers_.emplace_back(root, body);
        }
    }
    for (const auto& [root, body] : sleepers_) {
        SleepState& rest = bodies.sleep[body];
        const Mass& mass = bodies.geometry(body).mass;
        BodyVelocity change = bodies.motion[body];
        const Real now = std::sqrt(kineticEnergy(change, mass));
        change.velocity -= rest.samples[1].velocity;
        change.angularVelocity -= rest.samples[1].angularVelocity;
        const Real changed = std::sqrt(kineticEnergy(change, mass));
        const Real noise = (isOnBase(bases_[body]) ? kNoiseOnBase : kNoise) *
                           std::sqrt(energyOfForces(bodies.acceleration[body], mass, dt));
        if (now - std::sqrt(rest.leastEnergy) > noise) {
            restartCount(rest, bodies.pose[body]);
            leastCalm_[root] = 0;
        } else if (changed > noise && rest.calmSteps > 1) {
            rest.calmSteps = enough - sampleInterval(enough);
            leastCalm_[root] = 0;
        }
    }
}

void SleepSystem::joinTouching(const Bodies& bodies, const ContactSet& contacts,
                               const JointSet& joints) {
    touching_.resize(bodies.size());
    resizeByBody(leastCalm_, bodies);
    for (const std::uint32_t body : bodies.awake) {
        touching_.makeSet(body);
    }
    for (const Contact& contact : contacts.contacts()) {
        const ContactKey& key = contact.key;
        if (contact.touching && !contact.sensor && bodies.active(key.bodyA) &&
            bodies.active(key.bodyB)) {
            // A kinematic body joins the bodies that it carries, so none of them falls asleep.
            touching_.join(key.bodyA, key.bodyB);
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        const std::uint32_t b = secondBody(joint.def).index;
        if (bodies.active(a) && bodies.active(b)) {
            touching_.join(a, b);
        }
    });
    for (const std::uint32_t body : bodies.awake) {
        leastCalm_[body] = bodies.locked(body) ? 0 : bodies.sleep[body].calmSteps;
    }
    for (const std::uint32_t body : bodies.awake) {
        std::uint32_t& least = leastCalm_[touching_.rootOf(body)];
        const std::uint32_t own = bodies.locked(body) ? 0 : bodies.sleep[body].calmSteps;
        least = std::min(least, own);
    }
}

bool SleepSystem::updateSleep(Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                              const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    if (!countCalm(bodies, settings, tolerances, dt)) {
        return false;
    }
    joinTouching(bodies, contacts, joints);
    const auto enough = static_cast<std::uint32_t>(settings.sleepSteps);
    findBases(bodies, contacts);
    holdMoving(bodies, enough, tolerances, dt);
    sleepers_.clear();
    for (const std::uint32_t body : bodies.awake) {
        const std::uint32_t root = touching_.rootOf(body);
        if (leastCalm_[root] >= enough) {
            sleepers_.emplace_back(root, body);
        }
    }
    return !sleepers_.empty();
}

} // namespace KODO_PRECISION
} // namespace kodo
