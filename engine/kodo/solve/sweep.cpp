// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/solve/sweep.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo::inline KODO_PRECISION {
namespace {

const Convex& outline(const Bodies& bodies, std::uint32_t body, std::uint16_t part) {
    return bodies.form(body).parts[part].convex;
}

/// The gap at which a pair is to be stopped, or nothing if it needs no sweep: it cannot come so
/// close within the step, or it would not matter.
///
/// A pair that is apart is stopped just before it touches. One that touches already, and moves so
/// far that its contact points cannot hold all of it, is stopped before it is through.
std::optional<Real> stoppingGap(const Bodies& bodies, const Contact& contact,
                                const StepSettings& settings, const Tolerances& tolerances) {
    if (contact.hidden || contact.passing) {
        return std::nullopt;
    }
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    const Convex& shapeA = outline(bodies, contact.key.bodyA, contact.key.partA);
    const Convex& shapeB = outline(bodies, contact.key.bodyB, contact.key.partB);
    const bool near = contact.manifold.count > 0;
    const Real gap = near ? contact.manifold.points[0].separation : tolerances.margin;
    // Not their relative motion: one of them may be stopped by something else.
    const Real motion = length(a.move) + length(b.move) + std::abs(a.turn) * shapeA.reach +
                        std::abs(b.turn) * shapeB.reach;
    if (motion < gap) {
        return std::nullopt;
    }
    const Real thinner = std::min(shapeA.inside, shapeB.inside);
    const bool far = motion > thinner / 2;
    if (gap > tolerances.slop) {
        const bool bounces = contact.material.restitution > 0 && settings.has(Feature::Restitution);
        return bounces || contact.sensor || far ? std::optional(tolerances.slop / 64)
                                                : std::nullopt;
    }
    // Beyond the middles of both they would leave each other on the wrong side.
    const Real thickness = shapeA.inside + shapeB.inside;
    const Real deepest = std::min(4 * tolerances.slop, thickness);
    const bool holds =
        !far || motion < thickness / 2 || shapeA.oneSided || shapeB.oneSided || contact.sensor;
    return holds || gap < -deepest / 4 ? std::nullopt : std::optional(-deepest);
}

Sweep sweepOf(const Bodies& bodies, std::uint32_t body, Real stopAt) {
    const Motion& motion = bodies.motion[body];
    return {bodies.pose[body], motion.move, motion.turn, stopAt};
}

Real impactTime(const Bodies& bodies, const Contact& contact, std::span<const Real> stopAt,
                Real gap) {
    const ContactKey& key = contact.key;
    return timeOfImpact(
        outline(bodies, key.bodyA, key.partA), sweepOf(bodies, key.bodyA, stopAt[key.bodyA]),
        outline(bodies, key.bodyB, key.partB), sweepOf(bodies, key.bodyB, stopAt[key.bodyB]), gap);
}

/// Cuts a body's motion off. The velocity loses what the forces gave it after that moment.
void stop(Bodies& bodies, std::uint32_t body, Real share, Real dt) {
    Motion& motion = bodies.motion[body];
    motion.move *= share;
    motion.turn *= share;
    const Real lost = (1 - share) * dt;
    motion.velocity -= lost * bodies.acceleration[body].linear;
    motion.angularVelocity -= lost * bodies.acceleration[body].angular;
}

} // namespace

void SweepStage::run(Bodies& bodies, std::span<Contact> contacts, const StepSettings& settings,
                     const Tolerances& tolerances, Real dt) {
    candidates_.clear();
    bool sensors = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        sensors = sensors || contacts[i].sensor;
        if (contacts[i].sensor) {
            continue;
        }
        if (const auto gap = stoppingGap(bodies, contacts[i], settings, tolerances)) {
            candidates_.push_back({static_cast<std::uint32_t>(i), *gap, 0, false});
        }
    }
    if (candidates_.empty() && !sensors) {
        return;
    }
    stopAt_.assign(bodies.size(), 1);
    stopInOrder(bodies, contacts);
    if (sensors) {
        noticeSensors(bodies, contacts, settings, tolerances);
    }
    for (const std::uint32_t body : bodies.awake) {
        if (stopAt_[body] < 1) {
            stop(bodies, body, stopAt_[body], dt);
        }
    }
}

/// Takes the impacts in the order of their time. Each changes the way of its two bodies, so the
/// later impacts of these are found anew.
void SweepStage::stopInOrder(const Bodies& bodies, std::span<const Contact> contacts) {
    for (Candidate& candidate : candidates_) {
        candidate.time = impactTime(bodies, contacts[candidate.contact], stopAt_, candidate.gap);
    }
    while (true) {
        Candidate* first = nullptr;
        for (Candidate& candidate : candidates_) {
            if (!candidate.done && candidate.time < 1 &&
                (first == nullptr || candidate.time < first->time)) {
                first = &candidate;
            }
        }
        if (first == nullptr) {
            return;
        }
        first->done = true;
        const ContactKey& key = contacts[first->contact].key;
        for (const std::uint32_t body : {key.bodyA, key.bodyB}) {
            if (!bodies.locked(body)) {
                stopAt_[body] = std::min(stopAt_[body], first->time);
            }
        }
        for (Candidate& other : candidates_) {
            const ContactKey& k = contacts[other.contact].key;
            const bool shares = k.bodyA == key.bodyA || k.bodyA == key.bodyB ||
                                k.bodyB == key.bodyA || k.bodyB == key.bodyB;
            if (!other.done && other.time < 1 && shares) {
                other.time = impactTime(bodies, contacts[other.contact], stopAt_, other.gap);
            }
        }
    }
}

void SweepStage::noticeSensors(const Bodies& bodies, std::span<Contact> contacts,
                               const StepSettings& settings, const Tolerances& tolerances) {
    for (Contact& contact : contacts) {
        if (!contact.sensor) {
            continue;
        }
        // What the way of a step brought just short of touching has begun to touch, and goes on.
        contact.touching = contact.wasTouching && contact.manifold.count > 0 &&
                           contact.manifold.points[0].separation <= tolerances.slop / 32;
        const auto gap = stoppingGap(bodies, contact, settings, tolerances);
        const Real share = gap ? impactTime(bodies, contact, stopAt_, *gap) : 1;
        if (share < 1) {
            noticeOnTheWay(bodies, contact, share, tolerances);
        }
    }
}

/// Puts where and how fast a sensor was met into its contact, for the record.
void SweepStage::noticeOnTheWay(const Bodies& bodies, Contact& contact, Real share,
                                const Tolerances& tolerances) const {
    const ContactKey& key = contact.key;
    const Transform a = sweepOf(bodies, key.bodyA, stopAt_[key.bodyA]).at(share);
    const Transform b = sweepOf(bodies, key.bodyB, stopAt_[key.bodyB]).at(share);
    const Manifold met = collide(outline(bodies, key.bodyA, key.partA), a,
                                 outline(bodies, key.bodyB, key.partB), b, tolerances.margin, 0);
    if (met.count == 0) {
        return;
    }
    contact.touching = true;
    contact.manifold = met;
    contact.centerA = a.position;
    const ManifoldPoint& point = met.points[0];
    const Vec2 relative = velocityAt(bodies.motion[key.bodyB], point.armB) -
                          velocityAt(bodies.motion[key.bodyA], point.armA);
    contact.approachSpeed = std::max(-dot(met.normal, relative), Real(0));
}

} // namespace kodo::inline KODO_PRECISION
