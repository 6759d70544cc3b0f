// SPDX-License-Identifier: MIT
#include "soft/refinement.hpp"

#include <algorithm>
#include <numbers>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Compression of contacts, in slops, above which substeps are divided. The substeps themselves add
// a quarter to it.
constexpr Real kMaxCompression = Real(1.6);
// Least cosine between the acceleration of a body and the direction towards the other body with
// which it presses on that body. Between steeper faces it is wedged, and presses harder than this.
constexpr Real kLeastPress = Real(0.1);

// Speed, in slops per second, from which on a body that leaves another one does not press on it.
constexpr Real kLeaves = 36;
// Contacts of a body that carry its weight as one does alone. The weight may be uneven.
constexpr Real kCarriers = 4;
// Share of the speed that arrives in a step which counts as a load.
constexpr Real kArrival = Real(1) / 8;
// Ratio of masses up to which the passes of one step transmit a blow. With -1, a ball at 19 m/s on
// its like divides the substeps of its pile: falling discs take 5 % more passes.
constexpr Real kTransmitted = 16;
constexpr Real kLeastArrival = 64; // slops per second, of an approach that counts

/// Acceleration (m/s^2) that the spring of a contact has to carry, per mass of its lighter body, if
/// the body presses on the other one; else 0.
Real loadOf(const Bodies& bodies, const Contact& contact, std::uint32_t body, Real slop) {
    const bool isA = contact.key.bodyA == body;
    const Vec2 normal = contact.manifold.normal;
    const Vec2 between =
        bodies.motion[contact.key.bodyB].velocity - bodies.motion[contact.key.bodyA].velocity;
    if (dot(normal, between) > kLeaves * slop) {
        return 0;
    }
    const Vec2 acceleration = bodies.acceleration[body].linear;
    const Real size = length(acceleration);
    if (!(dot(acceleration, isA ? normal : -normal) > kLeastPress * size)) {
        return 0;
    }
    const Real own = bodies.motion[body].invMass;
    const Real other = bodies.motion[isA ? contact.key.bodyB : contact.key.bodyA].invMass;
    return (own + other) / own * size;
}

/// The same for a joint at a limit. A row of joints carries the load on light bodies at both ends,
/// so it counts twice.
Real loadOf(const Bodies& bodies, const JointSet::Joint& joint, std::uint32_t body) {
    const std::uint32_t a = firstBody(joint.def).index;
    const std::uint32_t other = a == body ? secondBody(joint.def).index : a;
    const Real own = bodies.motion[body].invMass;
    const Real ratio = (own + bodies.motion[other].invMass) / own;
    return joint.atLimit ? 2 * ratio * length(bodies.acceleration[body].linear) : 0;
}

} // namespace

/// Lists the contacts that approach fast, and a body of each that does too fast with its level.
void Refinement::findArrivals(const Step& step, Real most) {
    const Bodies& bodies = step.bodies;
    const ContactStore& store = step.contactSet.store();
    const Real press = kArrival / step.dt;                                         // 1/s
    const Real least = std::min(kLeastArrival, 1 / step.h) * step.tolerances.slop; // m/s
    arriving_.clear();
    if (!(step.contactSet.fastestApproach() > least)) {
        return;
    }
    for (const std::uint32_t slot : step.contactSet.live()) {
        const ContactSummary& summary = step.contactSet.summaries()[slot];
        if (!summary.mayTouch || summary.sensor || !(store.approachSpeed(slot) > least)) {
            continue;
        }
        arriving_.push_back(slot);
        const Real approach = store.approachSpeed(slot);
        if (store.separation(slot) > approach * step.dt) {
            continue;
        }
        const BodyVelocity& a = bodies.motion[summary.bodyA];
        const BodyVelocity& b = bodies.motion[summary.bodyB];
        const Real heavier = std::min(a.invMass, b.invMass);
        const Real load =
            heavier > 0
                ? press * approach * (std::max(a.invMass, b.invMass) / heavier - kTransmitted)
                : Real(0);
        addSeed(a.locked() ? summary.bodyB : summary.bodyA, load / most);
    }
}

/// Lists a body whose load is `excess` times as large as that of level 0 may be.
void Refinement::addSeed(std::uint32_t body, Real excess) {
    std::uint8_t level = 0;
    while (level + 1u < kLevels && excess > static_cast<Real>(1 << 2 * level)) {
        ++level;
    }
    if (level > 0) {
        seeds_.emplace_back(level, body);
    }
}

/// Lists the bodies that press too hard on another one, with their levels. `most`: acceleration
/// (m/s^2) that level 0 carries.
void Refinement::findSeeds(const Step& step, Real most) {
    const Bodies& bodies = step.bodies;
    const LoadRange& loads = bodies.loads;
    // An upper bound of any load, so that the result does not depend on the lightest body of the
    // World. A joint counts twice, see loadOf().
    const Real factor = step.joints.awakeCount() > 0 ? Real(2) : Real(1);
    const auto presses = [&](Real invMass, Real accelerationSquared) {
        const Real ratio = factor * (1 + loads.maxInvMass / invMass);
        return ratio * ratio * accelerationSquared > most * most;
    };
    if (!presses(loads.minInvMass, loads.maxAccelerationSquared)) {
        return;
    }
    for (const std::uint32_t body : bodies.awake) {
        const Real invMass = bodies.motion[body].invMass;
        if (!(invMass > 0) || !presses(invMass, lengthSquared(bodies.acceleration[body].linear))) {
            continue;
        }
        Real load = 0;
        Real carriers = 0;
        step.contactSet.store().lists().forEach(body, [&](std::uint32_t slot) {
            const Contact& contact = step.contactSet.contacts()[slot];
            const Real separation = step.contactSet.store().separation(slot);
            if (contact.responds() && separation <= step.tolerances.slop) {
                const Real own = loadOf(bodies, contact, body, step.tolerances.slop);
                load = std::max(load, own);
                carriers += own > 0 ? 1 : 0;
            }
        });
        load /= std::max(Real(1), carriers / kCarriers);
        step.joints.visitOf(body, [&](const JointSet::Joint& joint) {
            load = std::max(load, loadOf(bodies, joint, body));
        });
        addSeed(body, load / most);
    }
}

/// Gives the level to all bodies of an island.
void Refinement::spread(const Step& step, std::uint32_t body, std::uint8_t level) {
    const Bodies& bodies = step.bodies;
    const bool restitution = step.settings.has(Feature::Restitution);
    const auto reach = [&](std::uint32_t other) {
        if (!bodies.locked(other) && levels_[other] == 0) {
            levels_[other] = level;
            refined_.push_back(other);
            queue_.push_back(other);
        }
    };
    queue_.clear();
    reach(body);
    while (!queue_.empty()) {
        const std::uint32_t next = queue_.back();
        queue_.pop_back();
        step.contactSet.store().lists().forEach(next, [&](std::uint32_t slot) {
            const ContactSummary& summary = step.contactSet.summaries()[slot];
            const std::uint32_t other = summary.other(next);
            if (summary.mayTouch && levels_[other] == 0 &&
                needsRow(bodies, step.contactSet.store(), slot, restitution,
                         step.tolerances.slop) &&
                step.contactSet.contacts()[slot].responds()) {
                reach(other);
            }
        });
        step.joints.visitOf(next, [&](const JointSet::Joint& joint) {
            reach(firstBody(joint.def).index);
            reach(secondBody(joint.def).index);
        });
    }
}

bool Refinement::find(const Step& step) {
    std::swap(before_, refined_);
    refined_.clear();
    levelsThen_.clear();
    for (const std::uint32_t body : before_) {
        levelsThen_.push_back(levels_[body]);
        levels_[body] = 0;
    }
    const Real omega = 2 * std::numbers::pi_v<Real> * step.hertz;
    const Real most = kMaxCompression * step.tolerances.slop * omega * omega; // m/s^2
    seeds_.clear();
    findSeeds(step, most);
    const Real jointOmega = 2 * std::numbers::pi_v<Real> * step.jointHertz;
    const Real gap = step.solver<SoftSettings>().jointGap / SoftSettings{}.jointGap;
    step.joints.forEachBusy([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        addSeed(step.bodies.locked(a) ? secondBody(joint.def).index : a,
                joint.held / (jointOmega * jointOmega) / gap);
    });
    findArrivals(step, most);
    if (!seeds_.empty()) {
        std::sort(seeds_.begin(), seeds_.end(), std::greater<>()); // total order: bodies are unique
        for (const auto& [level, body] : seeds_) {                 // the highest first
            spread(step, body, level);
        }
        std::sort(refined_.begin(), refined_.end()); // total order: bodies are unique
    }
    const auto now = [&](std::uint32_t body) { return levels_[body]; };
    return refined_ != before_ ||
           !std::equal(refined_.begin(), refined_.end(), levelsThen_.begin(), levelsThen_.end(),
                       [&](std::uint32_t body, std::uint8_t then) { return now(body) == then; });
}

} // namespace KODO_PRECISION
} // namespace kodo
