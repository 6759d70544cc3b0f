// SPDX-License-Identifier: MIT
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/solve/sweep.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{};

/// Apart by now, so that even a slow approach may end in a blow of its own: see stoppingGap.
bool mayBounce(const Contact& contact, const Tolerances& tolerances) {
    return contact.manifold.count == 0 || contact.manifold.points[0].separation > tolerances.slop;
}

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

/// The heap's order: the earliest on top, of equal ones the first in the list.
template <typename Event>
bool later(const Event& e, const Event& f) {
    return e.time > f.time || (e.time == f.time && e.candidate > f.candidate);
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

/// For each body, more than any point of it moves.
void SweepStage::measureWays(const Bodies& bodies) {
    ways_.assign(bodies.size(), 0);
    for (const std::uint32_t body : bodies.awake) {
        const Motion& motion = bodies.motion[body];
        ways_[body] = length(motion.move) + std::abs(motion.turn) * bodies.extent[body].reach;
    }
}

void SweepStage::run(Bodies& bodies, std::span<Contact> contacts, const StepSettings& settings,
                     const Tolerances& tolerances, Real dt) {
    measureWays(bodies);
    candidates_.clear();
    bool sensors = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const ContactKey& key = contacts[i].key;
        const Real way = ways_[key.bodyA] + ways_[key.bodyB];
        const Real thin =
            std::min(bodies.extent[key.bodyA].inside, bodies.extent[key.bodyB].inside);
        if (way == 0 || (way <= thin / 2 && !mayBounce(contacts[i], tolerances))) {
            continue; // as in most of a pile
        }
        if (const auto gap = stoppingGap(bodies, contacts[i], settings, tolerances)) {
            sensors = sensors || contacts[i].sensor;
            if (!contacts[i].sensor) {
                addCandidate(contacts[i], static_cast<std::uint32_t>(i), *gap);
            }
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

void SweepStage::addCandidate(const Contact& contact, std::uint32_t place, Real gap) {
    if (candidates_.empty()) {
        first_.assign(ways_.size(), kNone);
    }
    Candidate candidate{place, gap};
    const auto own = static_cast<std::uint32_t>(candidates_.size());
    candidate.next[0] = std::exchange(first_[contact.key.bodyA], own);
    candidate.next[1] = std::exchange(first_[contact.key.bodyB], own);
    candidates_.push_back(candidate);
}

void SweepStage::findTime(const Bodies& bodies, std::span<const Contact> contacts,
                          std::uint32_t candidate) {
    Candidate& own = candidates_[candidate];
    own.time = impactTime(bodies, contacts[own.contact], stopAt_, own.gap);
    if (own.time < 1) {
        events_.push_back({own.time, candidate});
        std::push_heap(events_.begin(), events_.end(), later<Event>);
    }
}

/// Takes the impacts in the order of their time. Each changes the way of its two bodies, so the
/// later impacts of these are found anew.
void SweepStage::stopInOrder(const Bodies& bodies, std::span<const Contact> contacts) {
    events_.clear();
    for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
        findTime(bodies, contacts, i);
    }
    while (!events_.empty()) {
        std::pop_heap(events_.begin(), events_.end(), later<Event>);
        const Event event = events_.back();
        events_.pop_back();
        Candidate& first = candidates_[event.candidate];
        if (first.done || first.time != event.time) {
            continue; // it was found anew since
        }
        first.done = true;
        const ContactKey& key = contacts[first.contact].key;
        stopAt(bodies, contacts, key.bodyA, event.time);
        stopAt(bodies, contacts, key.bodyB, event.time);
    }
}

void SweepStage::stopAt(const Bodies& bodies, std::span<const Contact> contacts, std::uint32_t body,
                        Real time) {
    if (bodies.locked(body) || stopAt_[body] <= time) {
        return;
    }
    stopAt_[body] = time;
    for (std::uint32_t i = first_[body]; i != kNone;) {
        const bool isA = contacts[candidates_[i].contact].key.bodyA == body;
        if (!candidates_[i].done && candidates_[i].time < 1) {
            findTime(bodies, contacts, i);
        }
        i = candidates_[i].next[isA ? 0 : 1];
    }
}

void SweepStage::noticeSensors(const Bodies& bodies, std::span<Contact> contacts,
                               const StepSettings& settings, const Tolerances& tolerances) {
    for (Contact& contact : contacts) {
        const auto gap =
            contact.sensor ? stoppingGap(bodies, contact, settings, tolerances) : std::nullopt;
        if (gap) {
            contact.touching = impactTime(bodies, contact, stopAt_, *gap) < 1;
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
