// SPDX-License-Identifier: MIT
#include <kodo/base/prefetch.hpp>
#include <kodo/base/refill.hpp>
#include <kodo/collide/collide.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/solve/relative_motion.hpp>
#include <kodo/solve/sweep.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::uint32_t kNoContact = ~std::uint32_t{};
constexpr std::size_t kCrossingsAPiece = 256;
constexpr std::size_t kWaysAPiece = 256;
constexpr std::size_t kCandidatesAPiece = 64;
constexpr Real kTaken = -1; // instead of its time: the impact has happened
/// Of the slop: how far before touching what is apart is stopped. The normal is off by as much,
/// beside the size of a round body, if they hit aslant. Places are known as finely up to 64 m from
/// the origin in float, and up to 3e8 m in double; beyond, what is stopped may overlap by a
/// rounding.
constexpr Real kStopShort = sizeof(Real) == 4 ? Real(1) / 1024 : Real(1) / 65536;

Real gapOf(const Contact& contact, const Tolerances& tolerances) {
    return contact.manifold.count > 0 ? contact.manifold.points[0].separation : tolerances.margin;
}

/// The same of a pair without a sensor, told by its head.
Real gapOf(const ContactHead& head, const Tolerances& tolerances) {
    return head.meets ? head.separation[0] : tolerances.margin;
}

/// m: a pair whose parts are so thin may go so far towards each other without a sweep. Then the
/// middle of the thinner one is still outside of the other, and contact points will part the two
/// the right way; what is locked does not give way, and only half as much is let into it.
Real farFor(Real insideA, Real insideB, bool againstLocked) {
    return std::min(insideA, insideB) * (againstLocked ? Real(0.5) : Real(1));
}

/// The gap at which a pair is to be stopped that is `gap` apart and goes so far towards each other,
/// or nothing if it needs no sweep: it cannot come so close within the step, or it would not
/// matter.
///
/// A pair that is apart is stopped just before it touches. One that touches already, and moves so
/// far that its contact points cannot hold all of it, is stopped before it is through.
std::optional<Real> stoppingGap(const Bodies& bodies, const Contact& contact, Real gap, Real motion,
                                const StepSettings& settings, const Tolerances& tolerances) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    if (contact.hidden || contact.passing) {
        return std::nullopt;
    }
    const Convex& shapeA = bodies.outline(bodyA, partA);
    const Convex& shapeB = bodies.outline(bodyB, partB);
    if (motion < gap) {
        return std::nullopt;
    }
    const bool againstLocked = bodies.locked(bodyA) || bodies.locked(bodyB);
    const bool far = motion > farFor(shapeA.inside, shapeB.inside, againstLocked);
    if (gap > tolerances.slop) {
        const bool bounces = contact.bounces && settings.has(Feature::Restitution);
        return bounces || contact.sensor || far ? std::optional(kStopShort * tolerances.slop)
                                                : std::nullopt;
    }
    // Beyond the middles of both they would leave each other on the wrong side.
    const Real thickness = shapeA.inside + shapeB.inside;
    const Real deepest = std::min(4 * tolerances.slop, thickness);
    const bool holds =
        !far || motion < thickness / 2 || shapeA.oneSided || shapeB.oneSided || contact.sensor;
    return holds || gap < -deepest / 4 ? std::nullopt : std::optional(-deepest);
}

/// Could a pair of which neither is locked go farther than that against each other? Told without a
/// root, as for most of what moves along with each other.
bool mayGoFarther(const Bodies& bodies, const ContactHead& head, Real far) {
    const Motion& a = bodies.motion[head.bodyA];
    const Motion& b = bodies.motion[head.bodyB];
    const Real swing = std::abs(a.turn) * bodies.extent[head.bodyA].swing +
                       std::abs(b.turn) * bodies.extent[head.bodyB].swing;
    const Real room = far - swing;
    return room < 0 || lengthSquared(b.move - a.move) > room * room;
}

/// Do the bounds of two outlines meet on their way, if nobody is stopped?
bool mayMeet(const Bodies& bodies, const Mover& a, const Octagon& boundsA, const Mover& b,
             const Octagon& boundsB, const Tolerances& tolerances) {
    const Motion& motionA = bodies.motion[a.body];
    const Motion& motionB = bodies.motion[b.body];
    const Real swing = std::abs(motionA.turn) * a.swing + std::abs(motionB.turn) * b.swing;
    const Octagon way = unite(boundsB, boundsB.moved(motionB.move - motionA.move));
    return overlap(boundsA.grown(swing + tolerances.slop), way);
}

/// Could a pair meet in this step, if nobody is stopped? Told by its bodies as wholes, since a part
/// is no thinner than the thinnest of its body; stoppingGap tells it exactly.
bool closes(const Bodies& bodies, const PartBounds& bounds, const ContactHead& head,
            const Tolerances& tolerances) {
    const Extent& extentA = bodies.extent[head.bodyA];
    const Extent& extentB = bodies.extent[head.bodyB];
    const bool againstLocked = bodies.locked(head.bodyA) || bodies.locked(head.bodyB);
    const Real far = farFor(extentA.inside, extentB.inside, againstLocked);
    // Where one is locked, relativeMotion() goes by how the other moves as seen from it.
    if (!head.bounces && !againstLocked && !mayGoFarther(bodies, head, far)) {
        return false; // as in most of a pile
    }
    const Mover a{head.bodyA, extentA.swing};
    const Mover b{head.bodyB, extentB.swing};
    const Real motion = relativeMotion(bodies, a, b);
    const Real gap = gapOf(head, tolerances);
    if (motion < gap || (motion <= far && !head.bounces)) {
        return false;
    }
    const bool mayBeThrough =
        motion > far && motion >= (extentA.inside + extentB.inside) / 2 && gap >= -tolerances.slop;
    return (gap > tolerances.slop || mayBeThrough) &&
           mayMeet(bodies, a, bounds.tight(head.proxies.first), b,
                   bounds.tight(head.proxies.second), tolerances);
}

/// The heap's order: the earliest on top, of equal ones the first in the list.
template <typename Event>
bool later(const Event& e, const Event& f) {
    return e.time > f.time || (e.time == f.time && e.contact > f.contact);
}

/// Cuts a body's motion off, but for where it is pushed. The velocity loses what the forces gave it
/// after that moment.
void stop(Bodies& bodies, std::uint32_t body, Real share, Vec2 push, Real dt) {
    Motion& motion = bodies.motion[body];
    motion.move = share * motion.move + (1 - share) * push;
    motion.turn *= share;
    const Real lost = (1 - share) * dt;
    motion.velocity -= lost * bodies.acceleration[body].linear;
    motion.angularVelocity -= lost * bodies.acceleration[body].angular;
}

} // namespace

/// Marks who is swift. Two that are not need no sweep: they do not close a gap that is wider than
/// the slop, and a narrower one they close by less than half of their inner radii; or nothing
/// bounces, and each goes at most half as far as the thinnest may go into what is locked. False if
/// nobody is.
bool SweepStage::markSwift(const Bodies& bodies, bool mayBounce, const Tolerances& tolerances,
                           Crew& crew) {
    const Real unseen = mayBounce ? Real(0) : farFor(bodies.thinnest, bodies.thinnest, true) / 2;
    std::uint8_t anySwift = 0;
    swift_.resize(bodies.size(), 0); // of the others it is 0 from step to step
    crew.forEach(bodies.awake.size(), kWaysAPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const std::uint32_t body = bodies.awake[k];
            const Motion& motion = bodies.motion[body];
            const Extent& extent = bodies.extent[body];
            const Real way = length(motion.move) + std::abs(motion.turn) * extent.swing;
            if (way > unseen && !(way <= tolerances.slop / 2 && way < extent.inside / 4)) {
                swift_[body] = 1;
                Crew::mark(anySwift);
            }
        }
    });
    return anySwift != 0;
}

void SweepStage::run(Bodies& bodies, ContactSet& contactSet, const StepSettings& settings,
                     const Tolerances& tolerances, Real dt, Crew& crew) {
    candidates_.clear();
    bool sensors = false;
    if (markSwift(bodies, contactSet.mayBounce(), tolerances, crew) ||
        contactSet.mayHaveSensors()) {
        sensors = findCandidates(bodies, contactSet, tolerances, crew);
    }
    if (!candidates_.empty() || sensors) {
        stopAt_.resize(bodies.size(), 1); // of the others it is 1 from step to step
        push_.resize(bodies.size());      // likewise 0
        const bool driven = std::any_of(bodies.awake.begin(), bodies.awake.end(),
                                        [&](std::uint32_t body) { return bodies.drives(body); });
        const std::span<Contact> contacts = contactSet.contacts();
        const Step step{bodies, contacts, contactSet.heads(), settings, tolerances, driven};
        findImpacts(step, crew);
        if (!events_.empty()) {
            stopInOrder(step);
        }
        if (sensors) {
            noticeSensors(bodies, contacts, settings, tolerances);
        }
        finish(bodies, driven, dt);
    }
    for (const std::uint32_t body : bodies.awake) {
        swift_[body] = 0;
    }
}

/// Cuts the motions off of those that were stopped.
void SweepStage::finish(Bodies& bodies, bool driven, Real dt) {
    for (const std::uint32_t body : bodies.awake) {
        if (stopAt_[body] < 1) {
            stop(bodies, body, stopAt_[body], push_[body], dt);
        }
    }
    if (driven) { // also what rests, which nothing moves
        std::fill(push_.begin(), push_.end(), Vec2{});
    }
    for (const std::uint32_t body : stopped_) {
        stopAt_[body] = 1;
    }
    stopped_.clear();
}

/// Lists the pairs that could meet if nobody is stopped. True if there are sensors among all.
bool SweepStage::findCandidates(const Bodies& bodies, const ContactSet& contactSet,
                                const Tolerances& tolerances, Crew& crew) {
    const std::span<const ContactHead> heads = contactSet.heads();
    std::uint8_t sensors = 0;
    found_.gather(crew, heads.size(), kCrossingsAPiece, candidates_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      for (std::size_t i = first; i < last; ++i) {
                          const ContactHead& head = heads[i];
                          if (head.sensor) {
                              Crew::mark(sensors);
                          } else if (isSwift(head) &&
                                     closes(bodies, contactSet.bounds(), head, tolerances)) {
                              found.push_back(static_cast<std::uint32_t>(i));
                          }
                      }
                  });
    return sensors != 0;
}

/// Makes the contacts of each body known of which one is swift.
void SweepStage::linkContacts(const Step& step) {
    first_.assign(step.bodies.size(), kNoContact);
    next_.resize(step.heads.size());
    for (std::uint32_t i = 0; i < step.heads.size(); ++i) {
        const ContactHead& head = step.heads[i];
        if (!head.sensor && isSwift(head)) {
            next_[i] = {std::exchange(first_[head.bodyA], i), std::exchange(first_[head.bodyB], i)};
        }
    }
}

Sweep SweepStage::sweepOf(const Bodies& bodies, std::uint32_t body) const {
    const Motion& motion = bodies.motion[body];
    return {bodies.pose[body], motion.move, motion.turn, stopAt_[body], push_[body]};
}

Real SweepStage::motionOf(const Bodies& bodies, const Contact& contact) const {
    const auto moverOf = [&](std::uint32_t body, std::uint16_t part) {
        return Mover{body, bodies.outline(body, part).swing(), stopAt_[body]};
    };
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    return relativeMotion(bodies, moverOf(bodyA, partA), moverOf(bodyB, partB));
}

Real SweepStage::impactTime(const Bodies& bodies, const Contact& contact, Real gap) const {
    const ContactKey& key = contact.key;
    return timeOfImpact(bodies.outline(key.bodyA, key.partA), sweepOf(bodies, key.bodyA),
                        bodies.outline(key.bodyB, key.partB), sweepOf(bodies, key.bodyB), gap);
}

/// When a pair meets, as far as it is known by now which bodies are stopped.
void SweepStage::findTime(const Step& step, std::uint32_t i) {
    const Contact& contact = step.contacts[i];
    const Real motion = motionOf(step.bodies, contact);
    const auto timeFrom = [&](Real gap) {
        const auto target =
            stoppingGap(step.bodies, contact, gap, motion, step.settings, step.tolerances);
        return target ? impactTime(step.bodies, contact, *target) : Real(1);
    };
    const Real gap = gapOf(step.heads[i], step.tolerances);
    Real& time = times_[i];
    time = timeFrom(gap);
    // They as good as touch already, corner at corner, where the manifold sees a gap or nothing.
    // No contact will hold these two in the next step, so to stop them here would be to hold them
    // in the air for good, even if they part.
    if (gap > step.tolerances.slop && time * motion <= step.tolerances.slop / 32) {
        time = timeFrom(0);
    }
}

/// Lists the impact of a pair, if it has one.
void SweepStage::expect(std::uint32_t contact) {
    if (const Real time = times_[contact]; time < 1) {
        events_.push_back({time, contact});
        std::push_heap(events_.begin(), events_.end(), later<Event>);
    }
}

/// Lists the impacts that there are while nobody is stopped.
void SweepStage::findImpacts(const Step& step, Crew& crew) {
    events_.clear();
    refill(times_, step.contacts.size(), Real(1));
    crew.forEach(candidates_.size(), kCandidatesAPiece, [&](std::size_t first, std::size_t last) {
        visitAhead<2>(std::span<const std::uint32_t>(candidates_).subspan(first, last - first),
                      step.contacts, [&](std::uint32_t contact) { findTime(step, contact); });
    });
    for (const std::uint32_t contact : candidates_) {
        expect(contact);
    }
}

/// Takes the impacts in the order of their time. Each changes the ways of its two bodies, so the
/// later impacts of these are found anew.
void SweepStage::stopInOrder(const Step& step) {
    linkContacts(step);
    if (step.driven) {
        findPushes(step);
    }
    while (!events_.empty()) {
        std::pop_heap(events_.begin(), events_.end(), later<Event>);
        const Event event = events_.back();
        events_.pop_back();
        if (times_[event.contact] != event.time) {
            continue; // it has happened, or was found anew since
        }
        times_[event.contact] = kTaken;
        const ContactHead& head = step.heads[event.contact];
        if (step.driven) {
            takePush(step, step.contacts[event.contact], event.time);
        }
        cutShort(step, head.bodyA, event.time);
        cutShort(step, head.bodyB, event.time);
    }
}

/// Ends the way of a body, and looks anew at whom it meets: what moved along with it may now run
/// into it.
void SweepStage::cutShort(const Step& step, std::uint32_t body, Real time) {
    if (step.bodies.locked(body) || stopAt_[body] <= time) {
        return;
    }
    if (stopAt_[body] == 1) {
        stopped_.push_back(body);
    }
    stopAt_[body] = time;
    for (std::uint32_t i = first_[body]; i != kNoContact;) {
        if (times_[i] != kTaken) {
            findTime(step, i);
            expect(i);
        }
        i = next_[i][step.heads[i].bodyA == body ? 0 : 1];
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
        const Real motion = motionOf(bodies, contact);
        const auto gap =
            stoppingGap(bodies, contact, gapOf(contact, tolerances), motion, settings, tolerances);
        const Real share = gap ? impactTime(bodies, contact, *gap) : 1;
        if (share < 1) {
            noticeOnTheWay(bodies, contact, share, tolerances);
        }
    }
}

/// Puts where and how fast a sensor was met into its contact, for the record.
void SweepStage::noticeOnTheWay(const Bodies& bodies, Contact& contact, Real share,
                                const Tolerances& tolerances) const {
    const ContactKey& key = contact.key;
    const Transform a = sweepOf(bodies, key.bodyA).at(share);
    const Transform b = sweepOf(bodies, key.bodyB).at(share);
    const Manifold met = collide(bodies.outline(key.bodyA, key.partA), a,
                                 bodies.outline(key.bodyB, key.partB), b, tolerances.margin, 0);
    if (met.count == 0) {
        return;
    }
    contact.touching = true;
    contact.manifold = met;
    contact.carried = false;
    contact.centerA = a.position;
    const ManifoldPoint& point = met.points[0];
    const Vec2 relative = velocityAt(bodies.motion[key.bodyB], point.armB) -
                          velocityAt(bodies.motion[key.bodyA], point.armA);
    contact.approachSpeed = std::max(-dot(met.normal, relative), Real(0));
}

} // namespace kodo::inline KODO_PRECISION
