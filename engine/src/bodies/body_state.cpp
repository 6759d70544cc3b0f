// SPDX-License-Identifier: MIT
// What a snapshot holds of bodies.
#include "bodies/bodies.hpp"
#include "bodies/integrate.hpp"

#include <cmath>
#include <map>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kBeyondEverything = kPlaneExtent * Real(1e9); // m, or m/s

// False for NaN.
bool isBounded(Real value) {
    return std::abs(value) <= kBeyondEverything;
}
bool isBounded(Vec2 v) {
    return isBounded(v.x) && isBounded(v.y);
}

/// Each geometry is written once, however many bodies share it; bodies have its number.
class Geometries {
public:
    void note(const std::shared_ptr<const BodyGeometry>& geometry) {
        const auto number = static_cast<std::uint32_t>(all_.size() + 1); // 0: none
        const bool isLast = number > 1 && all_.back() == geometry;       // equal bodies in sequence
        if (geometry && !isLast && numbers_.emplace(geometry.get(), number).second) {
            all_.push_back(geometry);
        }
    }
    void visitState(StateStream& stream) {
        stream.list(all_, [&](std::shared_ptr<const BodyGeometry>& geometry) {
            if (!stream.reads()) {
                return stream.write<PartList>(*geometry);
            }
            PartList list;
            stream(list);
            geometry = makeGeometry(std::move(list));
            require(geometry->mass.mass >= 0 && geometry->mass.inertia >= 0 &&
                        isBounded(geometry->mass.center) && isBounded(geometry->boundingRadius) &&
                        hasFirmRim(*geometry),
                    "the geometry of a body is out of range");
        });
    }
    void visitNumber(StateStream& stream, std::shared_ptr<const BodyGeometry>& geometry) const {
        std::uint32_t number = geometry && !stream.reads() ? numbers_.at(geometry.get()) : 0;
        stream(number);
        if (stream.reads()) {
            require(number <= all_.size(), "a body refers to unknown geometry");
            geometry = number > 0 ? all_[number - 1] : nullptr;
        }
    }

private:
    std::vector<std::shared_ptr<const BodyGeometry>> all_;
    std::map<const BodyGeometry*, std::uint32_t> numbers_; // for look-up, never iterated
};

void checkList(const PartList& list) {
    require(!list.parts.empty(), "a body has no parts");
    for (const Part& part : list.parts) {
        require(checkMoved(part.primitive));
        require(checkRules(part));
    }
    std::size_t next = 0;
    for (const SetMass& set : list.setMasses) {
        require(set.firstPart >= next && set.partCount > 0 &&
                    set.firstPart + std::uint64_t{set.partCount} <= list.parts.size() &&
                    isBounded(set.mass.center),
                "a mass that was set has wrong parts or a wrong centre");
        require(checkMass(set.mass));
        next = set.firstPart + std::size_t{set.partCount};
    }
    require(list.former.empty() || list.former.size() == list.parts.size(),
            "what parts were before does not fit the parts");
    for (const FormerBody& former : list.former) {
        require(checkFlags("flags", former.filter.flags & ~kTypeBits));
        require(checkRequired("required", former.filter.required));
        require(check(former.rules));
    }
}

/// Sets the data that follow from geometry and flags.
void completeBody(Bodies& bodies, std::uint32_t body) {
    const BodyRecord& record = bodies.record[body];
    require(record.geometry != nullptr, "a body has no geometry");
    require(checkFlags("flags", bodies.filter[body].flags & ~kTypeBits));
    require(checkRequired("required", bodies.filter[body].required));
    for (const Part& part : record.geometry->parts) {
        require(checkPlaneType(part.primitive, bodies.filter[body].flags));
    }
    require(check(record.rules));
    setRules(bodies, body, MotionRules(record.rules));
    const Transform& pose = bodies.pose[body];
    const BodyVelocity& motion = bodies.motion[body];
    require(isBounded(pose.position) && isBounded(motion.velocity) &&
                isBounded(motion.angularVelocity) && isBounded(motion.deltaPosition) &&
                isBounded(motion.deltaAngle),
            "the pose or velocity of a body is out of range");
    require(checkRotation("rotation", pose.rotation));
    if (record.force != Vec2{} || record.torque != 0) {
        bodies.forced.push_back(body);
    }
    if (record.lostLoad != 0) {
        bodies.changes.lostLoads.push_back(body);
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

void visitState(StateStream& stream, Part& part) {
    auto& [primitive, material, density, filter, userData, convex] = part; // `convex` follows
    stream(primitive, material, density, filter, userData);
}

void PartList::visitState(StateStream& stream) {
    static_assert(countMembers<PartList>() == 3, "list a new member, or leave it out");
    stream.list(parts, [&](Part& part) { kodo::visitState(stream, part); });
    stream(setMasses, former);
    if (stream.reads()) {
        checkList(*this);
    }
}

void visitState(StateStream& stream, Bodies& bodies,
                std::shared_ptr<const BodyGeometry>& lastGeometry) {
    auto& [ids, stamp, motion, pose, acceleration, extent, teleportCount, hasTeleported, hasArrived,
           start, filter, records, parts, sleep, forced, awake, nextAwake, thin, loads, changes,
           anyStopped, anySleeping, leftOut, accelerationsStale] = bodies;
    Geometries geometries;
    for (const BodyRecord& record : records) {
        geometries.note(record.geometry);
    }
    geometries.note(lastGeometry);
    geometries.visitState(stream);
    geometries.visitNumber(stream, lastGeometry);
    stream(ids);
    if (stream.reads()) {
        stamp = 0; // bytes do not store the World of an id
        thin = 0;
        makeRoom(bodies, ids.capacity());
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        stream(teleportCount[i], hasArrived[i]); // kept for the next body in the slot
        if (stream.reads() && hasArrived[i] != 0) {
            changes.arrived.push_back(i);
        }
        if (ids.aliveAt(i)) {
            auto& [geometry, userData, rules, force, torque, lostLoad, crowdRank] = records[i];
            geometries.visitNumber(stream, geometry);
            stream(filter[i], userData, rules, force, torque, lostLoad, pose[i], motion[i],
                   acceleration[i], sleep[i], crowdRank);
            if (stream.reads()) {
                completeBody(bodies, i);
                thin += extent[i].thin();
            }
        }
    }
    bool allActivity = changes.allActivity || !changes.activity.empty();
    stream(awake, allActivity);
    if (stream.reads()) {
        changes.allActivity = allActivity;
        checkAwake(bodies);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
