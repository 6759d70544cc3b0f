// SPDX-License-Identifier: MIT
#include "continuous/continuous_collision.hpp"

#include <kodo/geometry.hpp>

#include "base/prefetch.hpp"
#include "base/vector_reuse.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <optional>

#include "continuous/allowed_approach.hpp"
#include "continuous/relative_motion.hpp"
#include "continuous/stop_motion.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kPairsPerPiece = 256;
constexpr std::size_t kCandidatesPerPiece = 64;
/// Fraction of the slop at which a separated pair is stopped before it touches. In a glancing
/// impact the normal of a round body is off by this distance relative to its size. Positions
/// resolve this distance up to 64 m from the origin in float, and up to 3e8 m in double. Farther
/// out, a stopped pair may overlap by a rounding error.
constexpr Real kStopShort = sizeof(Real) == 4 ? Real(1) / 1024 : Real(1) / 65536;

/// True if a separated pair would overlap at the end of the step along an axis on which its extents
/// overlap before: on a ledge that is narrower than the overlap is deep. Its contact points would
/// push it off the ledge. On such an axis rotations count as no approach.
bool entersAside(const Bodies& bodies, const Contact& contact, Real slop) {
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const auto [axis, distance] = separation(bodies.convex(bodyA, partA), bodies.endPose(bodyA),
                                             bodies.convex(bodyB, partB), bodies.endPose(bodyB));
    const Vec2 way = bodies.motion[bodyB].deltaPosition - bodies.motion[bodyA].deltaPosition;
    return std::max(distance, distance - dot(axis, way)) < -slop;
}

/// Separation (m) at which to stop a pair that has the separation `gap` and approaches by `motion`
/// (m). No value if the pair needs no continuous collision: it cannot come that close within the
/// step, or the overlap would do no harm.
///
/// A separated pair is stopped just before it touches. A touching pair that moves too far for its
/// contact points is stopped before it tunnels.
std::optional<Real> stoppingGap(const StepInput& input, const Contact& contact, Real gap,
                                Real motion) {
    const Bodies& bodies = input.bodies;
    const Real slop = input.tolerances.slop;
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    if (motion < gap || contact.passing || !areChecked(bodies, bodyA, bodyB)) {
        return std::nullopt;
    }
    const ConvexShape& shapeA = bodies.convex(bodyA, partA);
    const ConvexShape& shapeB = bodies.convex(bodyB, partB);
    const Real near = kStopShort * slop;
    if (contact.sensor) { // nothing holds it apart, however near it begins
        return gap > 0 ? std::optional(std::min(near, gap / 2)) : std::nullopt;
    }
    const bool locked = bodies.locked(bodyA) || bodies.locked(bodyB);
    if (gap > slop) {
        const bool bounces =
            contact.bounces && !contact.hidden && input.settings.has(Feature::Restitution);
        const bool far = motion > allowedApproach(shapeA.coreRadius, shapeB.coreRadius, locked);
        return bounces || far || (locked && entersAside(bodies, contact, slop))
                   ? std::optional(near)
                   : std::nullopt;
    }
    const Real thickness = shapeA.coreRadius + shapeB.coreRadius;
    const Real deepest = std::min(4 * slop, thickness);
    const Real held = heldApproach(input.settings, shapeA.coreRadius, shapeB.coreRadius, locked);
    const bool holds = motion <= held || shapeA.oneSided || shapeB.oneSided;
    if (deepest < near) { // once as near as that, the pair may slide, or part
        return holds || gap <= 2 * near ? std::nullopt : std::optional(near);
    }
    const Real entered = gap < -deepest / 4 ? gap : Real(0);
    const bool left = entered < 0 && (entered - deepest < -thickness || looksAgain(input.settings));
    return holds || left ? std::nullopt : std::optional(entered - deepest);
}

/// True if a pair without a locked body may approach by more than `far` (m). The test needs no
/// square root, and rejects most pairs that move together.
bool mayGoFarther(const Bodies& bodies, const ContactSummary& summary, Real far) {
    const BodyVelocity& a = bodies.motion[summary.bodyA];
    const BodyVelocity& b = bodies.motion[summary.bodyB];
    const Real rotationReach = bodies.extent[summary.bodyA].reachOfTurn(a.deltaAngle) +
                               bodies.extent[summary.bodyB].reachOfTurn(b.deltaAngle);
    const Real room = far - rotationReach;
    return room < 0 || lengthSquared(b.deltaPosition - a.deltaPosition) > room * room;
}

/// True if the bounds of two shapes meet on their paths while no body is stopped.
bool mayMeet(const Bodies& bodies, const PartBounds& bounds, const ContactSummary& summary,
             const Tolerances& tolerances) {
    const Octagon& boundsA = bounds.tight(summary.proxies.first);
    const Octagon& boundsB = bounds.tight(summary.proxies.second);
    const BodyVelocity& motionA = bodies.motion[summary.bodyA];
    const BodyVelocity& motionB = bodies.motion[summary.bodyB];
    const Real rotationReach = bodies.extent[summary.bodyA].reachOfTurn(motionA.deltaAngle) +
                               bodies.extent[summary.bodyB].reachOfTurn(motionB.deltaAngle);
    const Octagon way =
        unite(boundsB, boundsB.moved(motionB.deltaPosition - motionA.deltaPosition));
    return overlap(boundsA.grown(rotationReach + tolerances.slop), way);
}

/// True if a pair may meet in this step while no body is stopped. It uses the core radius of whole
/// bodies, which is that of their thinnest part. stoppingGap() decides exactly.
bool closes(const StepInput& input, std::uint32_t slot) {
    const Bodies& bodies = input.bodies;
    const ContactSet& contactSet = input.contactSet;
    const Tolerances& tolerances = input.tolerances;
    const ContactSummary& summary = contactSet.summaries()[slot];
    const PartBounds& bounds = contactSet.candidates().bounds();
    const Extent& extentA = bodies.extent[summary.bodyA];
    const Extent& extentB = bodies.extent[summary.bodyB];
    const bool locked = bodies.locked(summary.bodyA) || bodies.locked(summary.bodyB);
    const Real far = allowedApproach(extentA.coreRadius, extentB.coreRadius, locked);
    // relativeMotion() measures the motion against a locked body relative to that body.
    if (!summary.bounces && !locked && !mayGoFarther(bodies, summary, far)) {
        return false; // most pairs of a pile
    }
    const MovingBody a{summary.bodyA, extentA.rotationReach};
    const MovingBody b{summary.bodyB, extentB.rotationReach};
    const Real motion = relativeMotion(bodies, a, b);
    const Real gap = gapOf(bodies, contactSet, slot, tolerances);
    const bool apart = gap > tolerances.slop;
    if (motion < gap || (motion <= far && !summary.bounces && !(locked && apart))) {
        return false;
    }
    const Real held = heldApproach(input.settings, extentA.coreRadius, extentB.coreRadius, locked);
    return (apart || motion > held || isUnheld(bodies, contactSet, slot, tolerances.slop)) &&
           mayMeet(bodies, bounds, summary, tolerances);
}

/// Order of the heap: the earliest event on top, equal times in the order of the keys of contacts.
template <typename Event>
bool later(const Event& e, const Event& f) {
    return e.time > f.time || (e.time == f.time && f.key < e.key);
}

} // namespace

void ContinuousCollision::makeRoom(const Bodies& bodies) {
    resizeByBody(swift_, bodies);           // all 0 between steps
    resizeByBody(stopAt_, bodies, Real(1)); // all 1 between steps
    resizeByBody(push_, bodies);            // all 0 between steps
    pushed_.reserve(bodies.record.capacity());
    candidates_.reserve(bodies.record.capacity());
}

/// Marks the swift bodies. A pair without a swift body needs no continuous collision: it cannot
/// close a gap wider than the slop, and closes a narrower one by less than half of the core radii.
/// False if no body is swift.
bool ContinuousCollision::markSwift(const Bodies& bodies, const Tolerances& tolerances,
                                    WorkerTeam& team) {
    std::uint8_t anySwift = 0;
    team.forEach(bodies.awake.size(), kPairsPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const std::uint32_t body = bodies.awake[k];
            const Extent& extent = bodies.extent[body];
            const Real way = bodies.motion[body].way(extent.rotationReach);
            if (way > 0 && !(way <= tolerances.slop / 2 && way < extent.coreRadius / 4) &&
                modeOf(bodies, body, body) != ContinuousMode::Never) {
                swift_[body] = 1;
                WorkerTeam::mark(anySwift);
            }
        }
    });
    return anySwift != 0;
}

void ContinuousCollision::run(const StepInput& input) {
    Bodies& bodies = input.bodies;
    ContactSet& contactSet = input.contactSet;
    candidates_.clear();
    stoppedAtLines_.clear();
    bool sensors = false;
    if (markSwift(bodies, input.tolerances, input.team) || contactSet.mayHaveSensors()) {
        sensors = findCandidates(input);
    }
    if (!candidates_.empty() || sensors) {
        const bool driven =
            std::any_of(bodies.awake.begin(), bodies.awake.end(),
                        [&](std::uint32_t body) { return bodies.isMovingKinematic(body); });
        const Step step{input, contactSet.contacts(), contactSet.summaries(), driven};
        findImpacts(step, input.team);
        if (!events_.empty()) {
            stopInOrder(step);
        }
        if (sensors) {
            noticeSensors(input);
        }
        input.work.continuousPairs = candidates_.size();
        input.work.continuousStops = stopped_.size();
        finish(bodies, input.dt);
    }
    for (const std::uint32_t body : bodies.awake) {
        swift_[body] = 0;
    }
}

/// Shortens the displacements of the stopped bodies.
void ContinuousCollision::finish(Bodies& bodies, Real dt) {
    for (const std::uint32_t body : bodies.awake) {
        if (stopAt_[body] < 1) {
            stop(bodies, body, stopAt_[body], push_[body], dt);
        }
    }
    for (const std::uint32_t body : pushed_) {
        push_[body] = {};
    }
    pushed_.clear();
    for (const std::uint32_t body : stopped_) {
        stopAt_[body] = 1;
    }
    stopped_.clear();
}

/// Lists the pairs that may meet while no body is stopped. True if any contact is a sensor's.
bool ContinuousCollision::findCandidates(const StepInput& input) {
    const Bodies& bodies = input.bodies;
    const std::span<const ContactSummary> summaries = input.contactSet.summaries();
    std::uint8_t sensors = 0;
    found_.gather(input.team, summaries.size(), kPairsPerPiece, candidates_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      for (std::size_t i = first; i < last; ++i) {
                          const auto slot = static_cast<std::uint32_t>(i);
                          if (summaries[i].sensor) {
                              WorkerTeam::mark(sensors);
                          } else if (isSwift(bodies, summaries[i]) && closes(input, slot)) {
                              found.push_back(slot);
                          }
                      }
                  });
    return sensors != 0;
}

MotionPath ContinuousCollision::pathOf(const Bodies& bodies, std::uint32_t body) const {
    const BodyVelocity& motion = bodies.motion[body];
    return {bodies.pose[body], motion.deltaPosition, motion.deltaAngle, stopAt_[body], push_[body]};
}

Real ContinuousCollision::motionOf(const Bodies& bodies, const Contact& contact) const {
    const auto movingOf = [&](std::uint32_t body, std::uint16_t part) {
        return MovingBody{body, bodies.convex(body, part).rotationReach(), stopAt_[body]};
    };
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const MovingBody a = movingOf(bodyA, partA);
    const MovingBody b = movingOf(bodyB, partB);
    return contact.hidden ? motionAgainst(bodies, contact.manifold.normal, a, b)
                          : relativeMotion(bodies, a, b);
}

Real ContinuousCollision::impactTime(const Bodies& bodies, const Contact& contact, Real gap,
                                     Real from) const {
    const ContactKey& key = contact.key;
    return timeOfImpact(bodies.convex(key.bodyA, key.partA), pathOf(bodies, key.bodyA),
                        bodies.convex(key.bodyB, key.partB), pathOf(bodies, key.bodyB), gap, from);
}

/// Finds the time of impact of a pair from the fraction `from` of the step on, given the bodies
/// that are stopped so far.
void ContinuousCollision::findTime(const Step& step, std::uint32_t i, Real from) {
    const Contact& contact = step.contacts[i];
    const Real motion = motionOf(step.bodies, contact);
    const Real gap = gapOf(step.bodies, step.contactSet, i, step.tolerances);
    const Real slop = step.tolerances.slop;
    const bool unheld =
        gap <= slop && gap > -slop / 2 && isUnheld(step.bodies, step.contactSet, i, slop);
    const auto timeFrom = [&](Real apart, std::optional<Real> departure) {
        const auto target = unheld && !departure
                                ? std::optional(-slop)
                                : stoppingGap(step, contact, departure ? 2 * slop : apart, motion);
        const Real first = departure.value_or(0);
        return target ? std::min(impactTime(step.bodies, contact, *target, std::max(from, first)),
                                 timeToJointedLine(step, contact, *target, first))
                      : Real(1);
    };
    Real& time = times_[i];
    time = timeFrom(gap,
                    unheld ? departureTime(step.bodies, step.contactSet, i, kStopShort * slop, slop)
                           : std::nullopt);
    if (time >= 1) {
        time = timeThroughLine(step, contact, motion);
    }
    // The pair practically touches where the manifold has a gap or no point. The next step would
    // have no impact for it. Stopping it here would leave it hanging in the air, even if it
    // separates.
    const auto hangs = [&] { return time * motion <= slop / 32; };
    if ((gap > slop || unheld) && hangs()) {
        time = timeFrom(0, std::nullopt);
        time = unheld && hangs() ? Real(1) : time;
    }
    if (contact.hidden && time < 1 && !meetsSurface(step, contact, time)) {
        time = 1;
    }
}

/// Adds the impact of a pair to the heap, if it has one.
void ContinuousCollision::queueImpact(const Step& step, std::uint32_t contact) {
    if (const Real time = times_[contact]; time < 1) {
        events_.push_back({time, contact, step.contacts[contact].key});
        std::push_heap(events_.begin(), events_.end(), later<Event>);
    }
}

/// Finds the impacts that occur while no body is stopped.
void ContinuousCollision::findImpacts(const Step& step, WorkerTeam& team) {
    events_.clear();
    assignReusing(times_, step.contacts.size(), Real(1));
    team.forEach(candidates_.size(), kCandidatesPerPiece, [&](std::size_t first, std::size_t last) {
        visitPrefetched<2>(std::span<const std::uint32_t>(candidates_).subspan(first, last - first),
                           step.contacts,
                           [&](std::uint32_t contact) { findTime(step, contact, 0); });
    });
    for (const std::uint32_t contact : candidates_) {
        queueImpact(step, contact);
    }
}

/// Processes the impacts in the order of time. Each changes the paths of its two bodies, so their
/// later impacts are computed again.
void ContinuousCollision::stopInOrder(const Step& step) {
    if (step.driven) {
        findPushes(step);
    }
    while (!events_.empty()) {
        std::pop_heap(events_.begin(), events_.end(), later<Event>);
        const Event event = events_.back();
        events_.pop_back();
        if (times_[event.contact] != event.time) {
            continue; // processed, or computed again since
        }
        times_[event.contact] = kTaken;
        const ContactSummary& summary = step.summaries[event.contact];
        noteLine(step, event.contact);
        if (step.driven) {
            bounceOff(step, event.contact, event.time);
            takePushedDisplacement(step, step.contacts[event.contact], event.time);
        }
        cutShort(step, summary.bodyA, event.time);
        cutShort(step, summary.bodyB, event.time);
        stopJointed(step, step.bodies.locked(summary.bodyA) || step.bodies.locked(summary.bodyB));
    }
}

void ContinuousCollision::noticeSensors(const StepInput& input) {
    const Bodies& bodies = input.bodies;
    ContactStore& store = input.contactSet.store();
    const Tolerances& tolerances = input.tolerances;
    for (std::uint32_t slot = 0; slot < store.size(); ++slot) {
        Contact& contact = store.contacts()[slot];
        if (!contact.sensor) {
            continue;
        }
        const ContactLane lane = store.lane(slot);
        const Real apart = contact.manifold.count > 0 ? lane.separation(0) : tolerances.margin;
        // A contact that the last step brought just short of touching has begun to touch, and
        // persists.
        contact.touching = contact.wasTouching && apart <= tolerances.slop / 32;
        const Real motion = motionOf(bodies, contact);
        const auto gap = stoppingGap(input, contact, apart, motion);
        const Real fraction = gap ? impactTime(bodies, contact, *gap, 0) : 1;
        if (fraction < 1) {
            meet(bodies, contact, lane, fraction, tolerances);
        }
    }
}

/// Stores manifold and speed of an impact in its contact. False if the shapes do not touch then.
bool ContinuousCollision::meet(const Bodies& bodies, Contact& contact, const ContactLane& lane,
                               Real fraction, const Tolerances& tolerances) const {
    const ContactKey& key = contact.key;
    const Transform a = pathOf(bodies, key.bodyA).at(fraction);
    const Transform b = pathOf(bodies, key.bodyB).at(fraction);
    const Manifold met = collide(bodies.convex(key.bodyA, key.partA), a,
                                 bodies.convex(key.bodyB, key.partB), b, tolerances.margin, 0);
    if (met.count == 0) {
        return false;
    }
    contact.touching = contact.near = true;
    contact.manifold = met;
    lane.setSeparations(met);
    contact.filled = false;
    contact.centerA = a.position;
    measureApproach(contact, lane, bodies);
    return true;
}

} // namespace KODO_PRECISION
} // namespace kodo
