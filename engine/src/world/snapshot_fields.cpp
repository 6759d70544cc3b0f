// SPDX-License-Identifier: MIT
#include "world/snapshot_fields.hpp"

#include "bodies/field_checks.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kBeyondEverything = kPlaneExtent * Real(1e9); // m, or m/s

// False for NaN.
bool bounded(Real value) {
    return std::abs(value) <= kBeyondEverything;
}
bool bounded(Vec2 v) {
    return bounded(v.x) && bounded(v.y);
}
bool bounded(const Octagon& bounds) {
    bool good = true;
    for (int i = 0; i < 4; ++i) {
        good = good && bounded(bounds.lower[i]) && bounded(bounds.upper[i]) &&
               bounds.lower[i] <= bounds.upper[i];
    }
    return good;
}

std::size_t partCount(const Bodies& bodies) {
    std::size_t parts = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        parts += bodies.ids.aliveAt(i) ? bodies.geometry(i).parts.size() : 0;
    }
    return parts;
}

void checkList(const PartList& list) {
    require(!list.parts.empty(), "a body has no parts");
    for (const Part& part : list.parts) {
        require(checkMoved(part.primitive));
        require(check(part.material));
        require(checkDensity(part.density));
    }
    std::size_t next = 0;
    for (const SetMass& set : list.setMasses) {
        require(set.firstPart >= next && set.partCount > 0 &&
                    set.firstPart + std::uint64_t{set.partCount} <= list.parts.size() &&
                    bounded(set.mass.center),
                "a mass that was set has wrong parts or a wrong centre");
        require(checkMass(set.mass));
        next = set.firstPart + std::size_t{set.partCount};
    }
    require(list.former.empty() || list.former.size() == list.parts.size(),
            "what parts were before does not fit the parts");
    for (const FormerBody& former : list.former) {
        require(checkFlags("flags", former.filter.flags & ~kTypeBits));
    }
}

/// Sets the data that follow from geometry and flags.
void completeBody(Bodies& bodies, std::uint32_t body) {
    const BodyRecord& record = bodies.record[body];
    require(record.geometry != nullptr, "a body has no geometry");
    require(checkFlags("flags", bodies.filter[body].flags & ~kTypeBits));
    for (const Part& part : record.geometry->parts) {
        require(checkPlaneType(part.primitive, bodies.filter[body].flags));
    }
    const Transform& pose = bodies.pose[body];
    const BodyVelocity& motion = bodies.motion[body];
    require(bounded(pose.position) && bounded(motion.velocity) && bounded(motion.angularVelocity) &&
                bounded(motion.deltaPosition) && bounded(motion.deltaAngle),
            "the pose or velocity of a body is out of range");
    require(checkRotation("rotation", pose.rotation));
    if (record.force != Vec2{} || record.torque != 0) {
        bodies.forced.push_back(body);
    }
    refreshDerived(bodies, body);
}

void checkAwake(const Bodies& bodies) {
    const char* const sentence = "the list of awake bodies is wrong";
    require(areInOrder(bodies.awake, bodies.size()), sentence);
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < bodies.size() && !bodies.changes.allActivity; ++i) {
        const bool listed = next < bodies.awake.size() && bodies.awake[next] == i;
        next += listed ? 1 : 0;
        const bool alive = bodies.ids.aliveAt(i);
        require(listed ? alive : !alive || !bodies.active(i), sentence);
    }
}

} // namespace

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

/// Each body geometry is written once, however many bodies share it.
void SnapshotFields::geometries(WorldImpl& world) {
    const auto note = [&](const std::shared_ptr<const BodyGeometry>& geometry) {
        const auto number = static_cast<std::uint32_t>(geometries_.size() + 1); // 0: none
        if (geometry && geometryNumbers_.emplace(geometry.get(), number).second) {
            geometries_.push_back(geometry);
        }
    };
    for (const BodyRecord& record : world.bodies_.record) {
        note(record.geometry);
    }
    note(world.lastGeometry_);
    geometries_.resize(lengthOf(geometries_.size()));
    for (std::shared_ptr<const BodyGeometry>& geometry : geometries_) {
        PartList list = geometry ? PartList(*geometry) : PartList{};
        auto& [parts, setMasses, former] = list;
        all(parts, setMasses, former);
        if (!reads()) {
            continue;
        }
        checkList(list);
        geometry = makeGeometry(std::move(list));
        require(geometry->mass.mass >= 0 && geometry->mass.inertia >= 0 &&
                    bounded(geometry->mass.center) && bounded(geometry->boundingRadius) &&
                    hasFirmRim(*geometry),
                "the geometry of a body is out of range");
    }
}

void SnapshotFields::one(std::shared_ptr<const BodyGeometry>& geometry) {
    std::uint32_t number = geometry && !reads() ? geometryNumbers_.at(geometry.get()) : 0;
    one(number);
    if (reads()) {
        require(number <= geometries_.size(), "a body refers to unknown geometry");
        geometry = number > 0 ? geometries_[number - 1] : nullptr;
    }
}

void SnapshotFields::one(IdPool& pool) {
    auto& [generations, free] = pool;
    all(generations, free);
    std::vector<bool> seen(generations.size());
    for (const std::uint32_t index : free) {
        require(index < generations.size() && generations[index] % 2 == 0 &&
                    generations[index] != 0 && !seen[index],
                "the list of free ids is wrong");
        seen[index] = true;
    }
}

void SnapshotFields::one(Bodies& bodies) {
    auto& [ids, stamp, motion, pose, acceleration, extent, teleportCount, hasTeleported, hasArrived,
           start, filter, record, parts, rest, forced, awake, nextAwake, thinnest, loads, changes,
           thinnestAge, anyStopped, anySleeping, turns, accelerationsStale] = bodies;
    one(ids);
    if (reads()) {
        stamp = 0; // bytes do not store the World of an id
        const std::size_t count = ids.capacity();
        motion.resize(count + 1);
        pose.resize(count);
        acceleration.resize(count);
        extent.resize(count + 1);
        teleportCount.resize(count);
        hasTeleported.resize(count);
        hasArrived.resize(count);
        filter.resize(count);
        record.resize(count);
        parts.resize(count);
        rest.resize(count);
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        one(teleportCount[i]); // kept for the next body in the slot
        one(hasArrived[i]);
        if (reads() && hasArrived[i] != 0) {
            changes.arrived.push_back(i);
        }
        if (ids.aliveAt(i)) {
            auto& [geometry, userData, force, torque, lostLoad, crowdRank] = record[i];
            all(geometry, filter[i], userData, force, torque, lostLoad, pose[i], motion[i],
                acceleration[i], rest[i], crowdRank);
            if (reads() && lostLoad != 0) {
                changes.lostLoads.push_back(i);
            }
            if (reads()) {
                completeBody(bodies, i);
            }
        }
    }
    changes.allActivity = changes.allActivity || !changes.activity.empty();
    all(awake, changes.allActivity);
    if (reads()) {
        findThinnest(bodies);
        checkAwake(bodies);
    }
}

/// A field as the arguments of its constructor, returned by the given functions.
template <typename Field, typename... Values>
void SnapshotFields::field(std::shared_ptr<const ForceField>& field,
                           Values (Field::*... get)() const) {
    std::tuple<Values...> values;
    if (!reads()) {
        const auto& own = static_cast<const Field&>(*field);
        values = {(own.*get)()...};
    }
    std::apply([this](auto&... value) { this->all(value...); }, values);
    if (reads()) {
        field = std::apply(
            [](const auto&... value) { return std::make_shared<const Field>(value...); }, values);
    }
}

void SnapshotFields::one(FieldEntry& entry) {
    auto& [shared, which] = entry;
    FieldKind kind = shared ? shared->kind() : FieldKind::Own;
    as<std::uint8_t>(kind);
    switch (kind) {
    case FieldKind::Own:
        if (reads()) {
            require(!ownFields_.empty(),
                    "fewer user-defined force fields were given than the snapshot needs: give them "
                    "to fromBytes(), in the order of World::fields()");
            require(ownFields_.front() != nullptr, "a given force field is null");
            shared = ownFields_.front();
            ownFields_ = ownFields_.subspan(1);
        }
        break;
    case FieldKind::Gravity:
        field(shared, &Gravity::acceleration);
        break;
    case FieldKind::Drag:
        field(shared, &Drag::law, &Drag::air);
        break;
    case FieldKind::Wind:
        field(shared, &Wind::law, &Wind::velocity, &Wind::region);
        break;
    case FieldKind::Attractor:
        field(shared, &Attractor::law, &Attractor::center, &Attractor::strength,
              &Attractor::softening);
        break;
    case FieldKind::Buoyancy:
        field(shared, &Buoyancy::fluid, &Buoyancy::surface, &Buoyancy::gravity);
        break;
    default:
        require(false, "the kind of a force field is unknown");
    }
    one(which);
}

/// Bounds of bodies that do not move date from their last motion. They do not follow from the
/// bodies, so they are stored.
void SnapshotFields::contacts(ContactSet& set, const Bodies& bodies, const Tolerances& tolerances) {
    // The state of the pair finder affects time, not results: it starts fresh.
    auto& [candidates, store, touchCounts, records, ghostCollisions, oneWayBodies, lineSides, live,
           found, onGround, idle, changes, activityChanges, arrivals, hasChanged, fastestApproach,
           stale, pairsStale, liveStale, allArrived, contactsChanged, anySensors, anyBounces] = set;
    auto& [bounds, finder, still, movers, pairs] = candidates;
    auto& [contacts, summaries, order, newOrder, lists, gone, pairChanges, changesFound, holes,
           added, addedIsDeep, movedTo, slots, reorderPolicy, placesStale] = store;
    auto& [allDue, eventsDue, toggled, allRecords, begun, ended, removed, ends, nextEnds,
           recordSlots] = records;
    auto& [parts, firstPart, room, count, firstBefore, from, listed, usedCount, inOrder, compared,
           moves, convexes, corners, leftOver, tight, grown, changed, isChanged, outgrown] = bounds;
    set.records().all(set.recordSource([](Contact&) {})); // none is resident
    if (!reads()) {
        set.applyChanges(bodies, tolerances);
        if (candidates.compact()) {
            store.renewPlaces(bounds);
        }
        set.sortContacts(); // the bytes do not depend on slots, nor on indices of parts
    }
    all(contacts, nextEnds, allRecords, tight, grown, changed, reorderPolicy);
    if (!reads()) {
        return;
    }
    const auto good = [](const Octagon& octagon) { return bounded(octagon); };
    require(tight.size() == partCount(bodies) && grown.size() == tight.size() &&
                std::all_of(tight.begin(), tight.end(), good) &&
                std::all_of(grown.begin(), grown.end(), good),
            "the bounds do not fit the bodies");
    std::vector<Octagon> tightAsRead = std::move(tight);
    std::vector<Octagon> grownAsRead = std::move(grown);
    const std::vector<std::uint32_t> changedAsRead = std::move(changed);
    bounds.number(bodies);
    tight = std::move(tightAsRead);
    grown = std::move(grownAsRead);
    for (const std::uint32_t i : changedAsRead) {
        require(i < tight.size() && isChanged[i] == 0, "the list of changed bounds is wrong");
        bounds.list(i, changed);
    }
    stale = false;
    pairsStale = false;
    activityChanges.clear();
    eventsDue = true;
    for (Contact& contact : contacts) {
        completeContact(contact, bodies);
    }
    set.changed();
    store.order(bounds);
    touchCounts.recount(contacts, bodies);
    const auto before = [&all = contacts](const auto& a, const auto& b) {
        return all[a.slot].key < all[b.slot].key;
    };
    require(std::adjacent_find(order.begin(), order.end(), std::not_fn(before)) == order.end(),
            "a contact occurs twice");
}

void SnapshotFields::definitions(const WorldImpl& world) {
    StepSettings settings = world.settings_;
    Tolerances tolerances = world.tolerances_;
    std::optional<Aabb> region = world.region_.box();
    all(settings, tolerances, region);
    for (FieldEntry entry : world.fields_) {
        one(entry);
    }
    for (std::uint32_t i = 0; i < world.bodies_.size(); ++i) {
        if (world.bodies_.ids.aliveAt(i)) {
            std::uint64_t userData = world.bodies_.record[i].userData;
            one(userData);
            const PartList& list = world.bodies_.geometry(i);
            for (Part part : list.parts) {
                one(part);
            }
            for (SetMass set : list.setMasses) { // nothing is added if none was set
                one(set);
            }
            for (FormerBody former : list.former) { // likewise
                if (former.filter.flags != 0 || former.filter.required != 0 ||
                    former.userData != 0) {
                    one(former);
                }
            }
        }
    }
    world.joints_.forEach([&](const JointSet::Joint& joint) {
        JointDef def = joint.def;
        one(def);
    });
}

void SnapshotFields::world(WorldImpl& world) {
    auto& [guard, settings, tolerances, stepCount, count, roomFor, bodies, flagBlocks, fields,
           contacts, impacts, softSolver, propagation, contactVisits, changeVisits, continuous,
           sleep, joints, broken, frozen, region, queries, lastGeometry] = world;
    auto& [box, outsideVelocities, parkedContacts, unparked, scans] = region;
    auto& [parked, gaps, lists, slots, visits] = parkedContacts;
    parkedContacts.closeGaps();
    softSolver.blocks().writeBackAll(contacts.contacts(), bodies);
    all(settings, tolerances, stepCount);
    bodies.turns = settings.has(Feature::Rotation);
    geometries(world);
    all(bodies, lastGeometry, fields);
    require(ownFields_.empty(),
            "more user-defined force fields were given than the snapshot needs");
    for (const FieldEntry& entry : fields) {
        require(entry.field == nullptr ? std::nullopt
                                       : checkField(*entry.field, tolerances.unit()));
    }
    this->joints(joints, bodies, tolerances.unit());
    this->contacts(contacts, bodies, tolerances);
    this->rest(sleep, bodies);
    as<std::uint64_t>(contactVisits);
    all(broken, frozen, box, parked);
    if (reads()) {
        for (Contact& contact : parked) {
            completeContact(contact, bodies);
            contact.row = {};
        }
        parkedContacts.listAll();
    }
    if (box) {
        require(box->lower.x <= box->upper.x && box->lower.y <= box->upper.y,
                "the region has its corners swapped");
    }
    count = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        count += bodies.ids.aliveAt(i) ? 1 : 0;
        flagBlocks.note(i, bodies.filter[i].flags);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
