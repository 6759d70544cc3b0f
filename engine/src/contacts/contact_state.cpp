// SPDX-License-Identifier: MIT
// What a snapshot holds of contacts.
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// False for NaN.
bool isBounded(const Octagon& bounds) {
    constexpr Real kBeyondEverything = kPlaneExtent * Real(1e9); // m
    bool good = true;
    for (int i = 0; i < 4; ++i) {
        good = good && bounds.lower[i] >= -kBeyondEverything &&
               bounds.lower[i] <= bounds.upper[i] && bounds.upper[i] <= kBeyondEverything;
    }
    return good;
}

void checkRecord(const CollisionRecord& record) {
    require(record.phase <= TouchPhase::End, "the phase of a collision record is unknown");
    require(record.pointCount <= 2, "a collision record has more than two points");
    Real sum = record.point.x + record.point.y + record.normal.x + record.normal.y +
               record.separation + record.approachSpeed + record.maxImpulse + record.totalImpulse +
               record.tangentImpulse;
    for (const auto& [position, separation, maxImpulse] : record.points) {
        sum += position.x + position.y + separation + maxImpulse;
    }
    require(std::isfinite(sum), "a number of a collision record is not finite");
}

} // namespace

bool isSound(const Contact& contact, const ContactNumbers& numbers) {
    constexpr Real kMost = Real(1e15); // m or m/s
    const auto small = [](Real number, Real most) { return std::abs(number) <= most; };
    const auto near = [&](Vec2 v, Real most) { return small(v.x, most) && small(v.y, most); };
    const Manifold& manifold = contact.manifold;
    bool good = near(contact.centerA, kMost) && near(manifold.normal, 2) &&
                small(numbers.approachSpeed, kMost) && numbers.relativeDisplacement >= 0;
    for (const ManifoldPoint& p : manifold.points) {
        good = good && near(p.armA, kMost) && near(p.armB, kMost) && small(p.separation, kMost);
    }
    for (const Real separation : numbers.separation) {
        good = good && small(separation, kMost);
    }
    for (const Real impulse :
         {numbers.impulse[0].normal, numbers.impulse[1].normal, numbers.friction, numbers.rolling,
          numbers.total[0], numbers.total[1]}) {
        good = good && small(impulse, kMaxMass * kMost);
    }
    return good;
}

/// The row in the solver does not affect results.
void ContactRow::visitState(StateStream& stream) {
    auto& [row, ownColour, ownFixedA, ownFixedB] = *this;
    stream(ownColour, ownFixedA, ownFixedB);
    require(ownColour < 64 || ownColour == kNoColour, "the colour of a contact is unknown");
}

void StoredContact::visitState(StateStream& stream) {
    static_assert(countMembers<Contact>() == 17, "list a new member, or leave it out");
    // Left out: the phase is part of the records, separations are in the manifold, the others
    // follow from the bodies.
    auto& [separation, approachSpeed, relativeDisplacement, impulse, friction, rolling, total,
           sliding] = numbers;
    stream(key, centerA, manifold, teleportCounts, relativeDisplacement, impulse, row, friction,
           rolling, approachSpeed, total);
    stream(near, filled, sliding, passing, side, hidden, touching, wasTouching);
    if (stream.reads()) {
        require(side >= -1 && side <= 1, "the side of a contact is unknown");
        require(manifold.count >= 0 && manifold.count <= 2, "a contact has more than two points");
        require(isSound(*this, numbers), "a number of a contact is too large, or not a number");
        separation = separationsOf(manifold);
    }
}

void completeContact(Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const auto there = [&](std::uint32_t body, std::uint16_t part) {
        return body < bodies.size() && bodies.ids.aliveAt(body) &&
               part < bodies.geometry(body).parts.size();
    };
    require(bodyA < bodyB && there(bodyA, partA) && there(bodyB, partB),
            "a contact refers to bodies or parts that do not exist");
    describeContact(contact, bodies);
}

/// Of all lists the one of all records is stored; those of begins and ends follow from it.
void StepRecords::visitState(StateStream& stream, const Source& source) {
    auto& [allDue, eventsDue, toggled, turned, allRecords, begun, ended, removed, ends, nextEnds,
           slots] = *this;
    std::vector<CollisionRecord> due;
    if (allDue) { // only of a World that is written
        list(source, due);
    }
    stream(allDue ? due : allRecords, nextEnds);
    if (stream.reads()) {
        std::for_each(allRecords.begin(), allRecords.end(), checkRecord);
        std::for_each(nextEnds.begin(), nextEnds.end(), checkRecord);
        eventsDue = true;
    }
}

/// Bounds of bodies that do not move date from their last motion. They do not follow from the
/// bodies, so they are stored.
void PartBounds::visitState(StateStream& stream, const Bodies& bodies) {
    auto& [parts, firstPart, room, count, firstBefore, from, listed, usedCount, inOrder, hasMoved,
           compared, moves, tight, grown, changed, isChanged, outgrown] = *this;
    if (!stream.reads() && (hasUnused() || !inOrder)) { // the bytes do not depend on indices
        PartBounds renumbered = *this;
        renumbered.renumber();
        renumbered.visitState(stream, bodies);
        return;
    }
    stream(tight, grown, changed);
    if (!stream.reads()) {
        return;
    }
    const std::vector<Octagon> tightAsRead = std::move(tight);
    const std::vector<Octagon> grownAsRead = std::move(grown);
    const std::vector<std::uint32_t> changedAsRead = std::move(changed);
    const auto good = [](const Octagon& octagon) { return isBounded(octagon); };
    number(bodies);
    require(tightAsRead.size() == parts.size() && grownAsRead.size() == parts.size() &&
                std::all_of(tightAsRead.begin(), tightAsRead.end(), good) &&
                std::all_of(grownAsRead.begin(), grownAsRead.end(), good),
            "the bounds do not fit the bodies");
    std::copy(tightAsRead.begin(), tightAsRead.end(), tight.begin());
    std::copy(grownAsRead.begin(), grownAsRead.end(), grown.begin());
    for (const std::uint32_t i : changedAsRead) {
        require(i < parts.size() && isChanged[i] == 0, "the list of changed bounds is wrong");
        list(i, changed);
    }
}

/// The shape of the trees affects time, not results.
void CandidatePairs::visitState(StateStream& stream, const Bodies& bodies) {
    auto& [bounds, trees, planes, pairs, nodePairs, leaves, found, sorter, anyArrived, work] =
        *this;
    bounds.visitState(stream, bodies);
    if (stream.reads()) {
        buildTrees(bodies);
    }
}

void ContactStore::visitState(StateStream& stream, const Bodies& bodies, const PartBounds& bounds) {
    auto& [contacts, summaries, lanes, order, newOrder, lists, gone, changes, changesFound, holes,
           added, addedIsDeep, movedTo, slots, reorderPolicy, placesStale] = *this;
    auto size = static_cast<std::uint32_t>(contacts.size() - gone.size());
    if (!stream.reads()) { // the bytes do not depend on slots
        stream(size);
        forEachInOrder([&](std::uint32_t slot) { stream.write(copyOf(slot, bodies)); });
        return;
    }
    std::vector<StoredContact> stored;
    stream(stored);
    for (StoredContact& contact : stored) {
        completeContact(contact, bodies);
    }
    assign(stored);
    this->order(bounds);
    const auto before = [&all = contacts_](const Place& a, const Place& b) {
        return all[a.slot].key < all[b.slot].key;
    };
    require(std::adjacent_find(order_.begin(), order_.end(), std::not_fn(before)) == order_.end(),
            "a contact occurs twice");
}

void ContactSet::visitState(StateStream& stream, const Bodies& bodies) {
    auto& [candidates, store, touchCounts, records, ghostCollisions, oneWayBodies, lineSides, live,
           found, onGround, idle, changes, activityChanges, arrivals, hasChanged, fastestApproach,
           stale, pairsStale, liveStale, allArrived, contactsChanged, anySensors, anyBounces] =
        *this;
    records.visitState(stream, recordSource(bodies));
    candidates.visitState(stream, bodies);
    store.visitState(stream, bodies, candidates.bounds());
    if (stream.reads()) {
        stale = false;
        pairsStale = false;
        activityChanges.clear();
        contactsChanged_ = liveStale_ = true;
        touchCounts.recount(store.contacts(), bodies);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
