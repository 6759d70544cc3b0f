// SPDX-License-Identifier: MIT
#include "bodies/bodies.hpp"

#include "bodies/body_checks.hpp"
#include "bodies/integrate.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Updates the list of awake bodies for changes of some, in order and without duplicates.
void updateAwake(Bodies& bodies, std::span<const std::uint32_t> changed) {
    BodyChanges& changes = bodies.changes;
    changes.toggled.clear();
    std::vector<std::uint32_t>& awake = bodies.nextAwake;
    awake.clear();
    auto next = bodies.awake.begin();
    for (const std::uint32_t body : changed) {
        const auto at = std::lower_bound(next, bodies.awake.end(), body);
        awake.insert(awake.end(), next, at);
        const bool was = at != bodies.awake.end() && *at == body;
        next = was ? at + 1 : at;
        const bool is = bodies.ids.aliveAt(body) && bodies.active(body);
        if (is) {
            awake.push_back(body);
        } else if (was) {
            bodies.noteMove(body);
        }
        if (was != is) {
            changes.toggled.push_back(body);
        }
        if (is && !was) {
            changes.entered.push_back(body);
        }
    }
    awake.insert(awake.end(), next, bodies.awake.end());
    std::swap(awake, bodies.awake);
}

/// True if neither a lock nor a setting stops the rotation of a body. A particle has none to stop.
bool canTurn(const Bodies& bodies, std::uint32_t body) {
    return bodies.motion[body].invInertia > 0 ||
           (!bodies.leftOut.has(Feature::Rotation) && isParticle(bodies, body));
}

} // namespace

bool isParticle(const Bodies& bodies, std::uint32_t body) {
    const BodyVelocity& motion = bodies.motion[body];
    return motion.invInertia == 0 && motion.invMass > 0 &&
           bodies.geometry(body).mass.inertia == 0 &&
           (locksOf(bodies.filter[body].flags) & kLockRotate) == 0;
}

void requireAlive(const Bodies& bodies, BodyId id, const char* field) {
    if (bodies.alive(id)) {
        return;
    }
    const std::string where = field == nullptr ? std::string() : std::string(field) + ": ";
    if (id.generation == 0) {
        throw BadBodyId(where + "the null id BodyId{} names no body");
    }
    const bool foreign = id.world != 0 && bodies.stamp != 0 && id.world != bodies.stamp;
    throw BadBodyId(where + "body " + std::to_string(id.index) + " of generation " +
                    std::to_string(id.generation) +
                    (foreign ? " belongs to another World"
                             : " is not in this World: it was removed, or never added"));
}

void makeRoom(Bodies& bodies, std::size_t count) {
    bodies.motion.resize(count + 1);
    bodies.pose.resize(count);
    bodies.acceleration.resize(count);
    bodies.extent.resize(count + 1);
    bodies.teleportCount.resize(count);
    bodies.hasTeleported.resize(count);
    bodies.hasArrived.resize(count);
    bodies.filter.resize(count);
    bodies.record.resize(count);
    bodies.parts.resize(count);
    bodies.sleep.resize(count);
}

BodyId addBody(Bodies& bodies, const BodyDef& def, std::shared_ptr<const BodyGeometry> geometry) {
    const IdPool::Slot slot = bodies.ids.allocate();
    if (slot.index == bodies.size()) {
        makeRoom(bodies, slot.index + 1);
    }
    BodyVelocity motion;
    motion.velocity = def.velocity;
    motion.angularVelocity = def.angularVelocity;
    bodies.motion[slot.index] = motion;
    const Rot rotation = normalize(def.rotation);
    bodies.pose[slot.index] = {def.position + rotation * geometry->mass.center, rotation};
    bodies.acceleration[slot.index] = {};
    BodyRecord record;
    record.geometry = std::move(geometry);
    record.userData = def.userData;
    bodies.record[slot.index] = std::move(record);
    setRules(bodies, slot.index, rulesOf(def));
    bodies.changes.lostLoads.reserve(bodies.record.capacity());
    bodies.filter[slot.index] = {(def.flags & ~(kStatusFlags | kTypeBits)) | bitsOf(def.type),
                                 def.required, def.group};
    bodies.sleep[slot.index] = {};
    bodies.sleep[slot.index].since = bodies.pose[slot.index];
    bodies.noteActivity(slot.index);
    bodies.noteArrival(slot.index);
    bodies.noteMove(slot.index);
    refreshDerived(bodies, slot.index);
    bodies.thin += bodies.extent[slot.index].thin();
    return bodies.idAt(slot.index);
}

void removeBody(Bodies& bodies, std::uint32_t index) {
    bodies.thin -= bodies.extent[index].thin();
    bodies.ids.release(index);
    bodies.motion[index] = {};
    bodies.pose[index] = {};
    bodies.acceleration[index] = {};
    bodies.filter[index] = {};
    bodies.record[index] = {};
    bodies.parts[index] = nullptr;
    bodies.sleep[index] = {};
    bodies.noteActivity(index);
}

FormerBody formerBodyOf(const Bodies& bodies, std::uint32_t body) {
    CollisionFilter filter = bodies.filter[body];
    filter.flags &= ~kStatusFlags;
    return {true, filter, bodies.record[body].userData, bodies.record[body].rules};
}

BodyId unweldPart(Bodies& bodies, std::uint32_t body, const DividedGeometry& geometry,
                  const FormerBody& made) {
    const Transform frame{bodies.originOf(body), bodies.pose[body].rotation};
    BodyVelocity before = bodies.motion[body];
    const Vec2 center = bodies.pose[body].position;
    const Real inertia = bodies.geometry(body).mass.inertia;
    const bool setMass = !bodies.geometry(body).setMasses.empty();

    BodyDef def = definitionOf(made);
    def.position = frame.position;
    def.rotation = frame.rotation;
    def.angularVelocity = before.angularVelocity;
    const BodyId freed = addBody(bodies, def, geometry.taken);
    setGeometry(bodies, body, geometry.rest);
    if (setMass && canTurn(bodies, body) && canTurn(bodies, freed.index)) {
        // A smaller moment of inertia than that of the shapes was set.
        const Real sum = combine(geometry.rest->mass, geometry.taken->mass).inertia;
        constexpr Real kRounding = 1 + 32 * std::numeric_limits<Real>::epsilon();
        before.angularVelocity *= sum > kRounding * inertia ? inertia / sum : Real(1);
    }
    for (const std::uint32_t index : {body, freed.index}) {
        bodies.motion[index].velocity = velocityAt(before, bodies.pose[index].position - center);
        bodies.motion[index].angularVelocity = before.angularVelocity;
    }
    if (bodies.locked(freed.index)) {
        bodies.motion[freed.index].stop();
    }
    return freed;
}

Aabb boundsOfBody(const Bodies& bodies, std::size_t body) {
    const std::vector<Part>& parts = bodies.geometry(body).parts;
    Aabb box = boundsOf(parts[0].convex, bodies.pose[body]);
    for (const Part& part : parts) {
        box = unite(box, boundsOf(part.convex, bodies.pose[body]));
    }
    return box;
}

void addForce(Bodies& bodies, std::uint32_t body, Vec2 force, Real torque) {
    BodyRecord& record = bodies.record[body];
    if (record.force == Vec2{} && record.torque == 0) {
        appendIndex(bodies.forced, body, bodies.size());
        bodies.accelerationsStale = true;
    }
    record.force += force;
    record.torque += torque;
}

void freeze(Bodies& bodies, std::uint32_t body) {
    bodies.filter[body].flags |= kFrozen;
    bodies.motion[body] = {};
    bodies.acceleration[body] = {};
    bodies.teleported(body);
    bodies.noteActivity(body);
}

bool refreshAwake(Bodies& bodies) {
    std::vector<std::uint32_t>& changed = bodies.changes.activity;
    if (std::exchange(bodies.anyStopped, false)) {
        std::copy_if(bodies.awake.begin(), bodies.awake.end(), std::back_inserter(changed),
                     [&](std::uint32_t body) { return !bodies.active(body); });
    }
    if (std::exchange(bodies.changes.allActivity, false)) {
        changed.resize(bodies.size());
        std::iota(changed.begin(), changed.end(), 0u);
    }
    if (changed.empty()) {
        return false;
    }
    sortUnique(changed);
    updateAwake(bodies, changed);
    changed.clear();
    bodies.changes.loadsStale = true;
    return true;
}

void clearArrivals(Bodies& bodies) {
    for (const std::uint32_t body : bodies.changes.arrived) {
        bodies.hasArrived[body] = 0;
    }
    bodies.changes.arrived.clear();
}

void countLostLoads(Bodies& bodies) {
    std::vector<std::uint32_t>& list = bodies.changes.lostLoads;
    sortUnique(list);
    std::erase_if(list, [&](std::uint32_t body) {
        std::uint8_t& steps = bodies.record[body].lostLoad;
        steps = static_cast<std::uint8_t>(steps - (steps > 0));
        return steps == 0;
    });
}

void noteStart(Bodies& bodies) {
    resizeByBody(bodies.start, bodies);
    const auto note = [&](std::uint32_t body) { bodies.start[body] = bodies.pose[body].position; };
    if (std::exchange(bodies.changes.allMoved, false)) {
        for (std::uint32_t body = 0; body < bodies.size(); ++body) {
            note(body);
        }
    }
    BodyChanges& changes = bodies.changes;
    std::for_each(bodies.awake.begin(), bodies.awake.end(), note);
    std::for_each(changes.moved.begin(), changes.moved.end(), note);
    changes.moved.clear();
    for (const std::uint32_t body : changes.teleported) {
        note(body);
        bodies.hasTeleported[body] = 0;
    }
    changes.teleported.clear();
}

void setGeometry(Bodies& bodies, std::uint32_t index,
                 std::shared_ptr<const BodyGeometry> geometry) {
    const Vec2 origin = bodies.originOf(index);
    Transform& pose = bodies.pose[index];
    pose.position = origin + pose.rotation * geometry->mass.center;
    bodies.thin -= bodies.extent[index].thin();
    bodies.record[index].geometry = std::move(geometry);
    bodies.noteArrival(index);
    bodies.teleported(index);
    refreshDerived(bodies, index);
    bodies.thin += bodies.extent[index].thin();
}

void setGeometryInMotion(Bodies& bodies, std::uint32_t index,
                         std::shared_ptr<const BodyGeometry> geometry) {
    const Vec2 center = bodies.pose[index].position;
    setGeometry(bodies, index, std::move(geometry));
    BodyVelocity& motion = bodies.motion[index];
    motion.velocity = velocityAt(motion, bodies.pose[index].position - center);
}

void weldBodies(Bodies& bodies, std::uint32_t into, std::uint32_t part) {
    const Transform frame{bodies.originOf(into), bodies.pose[into].rotation};
    const Transform other{bodies.originOf(part), bodies.pose[part].rotation};
    Transform place = between(frame, other);
    place.rotation = normalize(place.rotation); // rounding errors of repeated welds would add up
    PartList list = bodies.geometry(into);
    append(list, bodies.geometry(part), place, formerBodyOf(bodies, part));
    const std::shared_ptr<const BodyGeometry> geometry = makeGeometry(std::move(list));

    const Vec2 center = frame * geometry->mass.center;
    Vec2 momentum;
    Real spin = 0; // angular momentum about the new centre
    for (const std::uint32_t body : {into, part}) {
        const Mass& mass = bodies.geometry(body).mass;
        const BodyVelocity& motion = bodies.motion[body];
        momentum += mass.mass * motion.velocity;
        spin += mass.inertia * motion.angularVelocity +
                mass.mass * cross(bodies.pose[body].position - center, motion.velocity);
    }
    BodyVelocity& motion = bodies.motion[into];
    if (motion.invMass > 0) {
        motion.velocity = momentum / geometry->mass.mass;
    } else { // locked: the centre moves, the motion stays
        motion.velocity = velocityAt(motion, center - bodies.pose[into].position);
    }
    setGeometry(bodies, into, geometry);
    if (motion.invInertia > 0) { // after setGeometry(): a particle may have gained inertia
        motion.angularVelocity = spin / geometry->mass.inertia;
    }
}

void refreshDerived(Bodies& bodies, std::uint32_t index) {
    const BodyGeometry& geometry = bodies.geometry(index);
    bodies.extent[index] = {geometry.rotationReach, geometry.coreRadius};
    bodies.parts[index] = geometry.parts.data();
    bodies.changes.partFilters = bodies.changes.partFilters || geometry.filters;
    const Mass& mass = geometry.mass;
    const Flags flags = bodies.filter[index].flags;
    const Flags locks = locksOf(flags);
    const bool frozen = (flags & kFrozen) != 0;
    bodies.motion[index].invMass = frozen || (locks & kLockMove) != 0 ? 0 : 1 / mass.mass;
    // A particle has neither inertia nor a lever arm.
    const bool free =
        !bodies.leftOut.has(Feature::Rotation) && !frozen && (locks & kLockRotate) == 0;
    const bool turns = free && mass.inertia > 0;
    bodies.motion[index].invInertia = turns ? 1 / mass.inertia : 0;
    bodies.accelerationsStale = true;
}

void rotationChanged(Bodies& bodies) {
    bodies.ids.forEach([&](std::uint32_t index) {
        refreshDerived(bodies, index);
        bodies.teleported(index);
        if (bodies.leftOut.has(Feature::Rotation) &&
            (locksOf(bodies.filter[index].flags) & kLockRotate) == 0) {
            bodies.motion[index].angularVelocity = 0;
        }
    });
    bodies.changes.allActivity = true;
}

} // namespace KODO_PRECISION
} // namespace kodo
