// SPDX-License-Identifier: MIT
#include "soft/manifold_refresh.hpp"

#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lanes/contact_block_lanes.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kLargestWay = Real(0.125); // of the core radius, that needs no look
constexpr Real kLeastWay = 2;             // slops, likewise
constexpr Real kDeepest = Real(0.5);      // of the core radius: overlap of a useful manifold

/// Way (m) of a part of a body of this core radius that needs no look.
Real allowedWay(Real coreRadius, Real slop) {
    return std::max(kLargestWay * coreRadius, kLeastWay * slop);
}

/// Bound (m) of the way of two bodies against each other in a substep, also after a blow: that
/// turns the speed of the middle into one of up to twice as much at an end.
Real wayOf(const Bodies& bodies, const ContactSummary& summary, Real h) {
    const BodyVelocity& a = bodies.motion[summary.bodyA];
    const BodyVelocity& b = bodies.motion[summary.bodyB];
    return h * (2 * length(b.velocity - a.velocity) +
                std::abs(a.angularVelocity) * bodies.extent[summary.bodyA].rotationReach +
                std::abs(b.angularVelocity) * bodies.extent[summary.bodyB].rotationReach);
}

} // namespace

/// Lists the contacts of bodies that have turned too far. A further point comes along the tangent,
/// by reach times angle. Where a manifold has all its points, the arcs of these alone leave it, by
/// half of reach times angle squared.
void ManifoldRefresh::findTurned(const Step& step, std::span<const std::uint32_t> bodies) {
    if (std::exchange(anySpins_, std::uint8_t{0}) == 0) {
        return;
    }
    if (!std::exchange(listed_, true)) {
        turning_.clear();
        for (const std::uint32_t body : bodies) { // but for discs about their centres
            if (const auto& [reach, core] = step.bodies.extent[body]; reach > 0) {
                turning_.push_back({body, allowedWay(core, step.tolerances.slop) / reach, 0, 0});
            }
        }
    }
    const ContactStore& store = step.contactSet.store();
    for (Turning& turning : turning_) {
        const BodyVelocity& motion = step.bodies.motion[turning.body];
        const Real turn =
            step.first ? step.h * motion.angularVelocity : motion.deltaAngle - turning.atGaining;
        if (!(std::abs(turn) > turning.allowed && std::abs(motion.angularVelocity) > spin_)) {
            continue;
        }
        const Real whole = motion.deltaAngle - turning.atAll;
        const bool all = whole * whole > 2 * turning.allowed;
        turning.atGaining = motion.deltaAngle;
        turning.atAll = all ? motion.deltaAngle : turning.atAll;
        store.lists().forEach(turning.body, [&](std::uint32_t slot) {
            const Contact& contact = store.contacts()[slot];
            if (contact.near && !contact.sensor && !contact.hidden &&
                (all || mayGainPoint(step.bodies, contact))) {
                slots_.push_back(slot);
            }
        });
    }
}

/// Lists the contacts that approach by too much in a substep, if they may gain a point.
void ManifoldRefresh::findFast(const Step& step) {
    ContactSet& contactSet = step.contactSet;
    for (const std::uint32_t slot : step.arriving) {
        const ContactSummary& summary = contactSet.summaries()[slot];
        const Contact& contact = contactSet.contacts()[slot];
        const Real core = std::min(step.bodies.extent[summary.bodyA].coreRadius,
                                   step.bodies.extent[summary.bodyB].coreRadius);
        if (contactSet.store().approachSpeed(slot) * step.h >
                allowedWay(core, step.tolerances.slop) &&
            !contact.hidden && mayGainPoint(step.bodies, contact)) {
            slots_.push_back(slot);
        }
    }
}

void ManifoldRefresh::find(const Step& step, std::uint32_t slot) {
    Bodies& bodies = step.bodies;
    ContactSet& contactSet = step.contactSet;
    const Tolerances& tolerances = step.tolerances;
    const ContactEntry entry = contactSet.store().entry(slot);
    Contact& contact = entry.contact;
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const ContactLane lane = contactSet.store().lane(slot);
    if (std::exchange(entry.summary.kept, false)) { // not visited in this step
        contact.centerA = bodies.start[bodyA];
    }
    const Contact old = contact;
    const ContactNumbers numbers = lane.numbers();
    const BodyVelocity& a = bodies.motion[bodyA];
    const BodyVelocity& b = bodies.motion[bodyB];
    const Transform startA = bodies.pose[bodyA];
    const Transform startB = bodies.pose[bodyB];
    bodies.pose[bodyA] = bodies.endPose(bodyA);
    bodies.pose[bodyB] = bodies.endPose(bodyB);
    Tolerances wider = tolerances;
    wider.margin += wayOf(bodies, entry.summary, step.h);
    findContact(contact, lane, bodies, wider, step.dt);
    const Vec2 centerA = bodies.pose[bodyA].position;
    bodies.pose[bodyA] = startA;
    bodies.pose[bodyB] = startB;
    const Real core = std::min(bodies.extent[bodyA].coreRadius, bodies.extent[bodyB].coreRadius);
    const Real deepest = leastOf(separationsOf(contact.manifold), contact.manifold.count);
    const bool passed =
        old.manifold.count > 0 &&
        (deepest < -kDeepest * core || dot(contact.manifold.normal, old.manifold.normal) < 0);
    if (contact.manifold.count == 0 || passed) {
        contact = old; // with its record, and to the side from which the bodies came
        lane = numbers;
        return;
    }
    // What acted so far acted along the old normal.
    const Vec2 sums{lane.impacts() + (step.first ? Real(0) : lane.total(0)), lane.total(1)};
    contactSet.records().turned(contact.key, impulseOf(sums, old.manifold.normal) -
                                                 impulseOf(sums, contact.manifold.normal));
    contact.centerA = centerA;
    const Vec2 n = contact.manifold.normal;
    const Real moved = dot(n, b.deltaPosition - a.deltaPosition);
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        const ManifoldPoint& p = contact.manifold.points[i];
        lane.separation(i) -=
            moved + (leverOf(p.armB, n) * b.deltaAngle - leverOf(p.armA, n) * a.deltaAngle);
    }
    lane.expire();
    entry.summary.mayTouch = true;
    entry.summary.settled = false; // an impact may have opened a gap
}

void ManifoldRefresh::apply(const Step& step, std::uint32_t slot, Real times) {
    const ContactSummary& summary = step.contactSet.summaries()[slot];
    if (summary.inPasses()) {
        applyImpulses(step.bodies, step.contactSet.lanes().placeOf(summary.row.index), times);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
