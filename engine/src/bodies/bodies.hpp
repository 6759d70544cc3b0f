// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "base/id_pool.hpp"
#include "base/vector_reuse.hpp"
#include "bodies/body_geometry.hpp"
#include "bodies/body_velocity.hpp"
#include "bodies/extent.hpp"
#include "bodies/sleep_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Other data of a body: read once or twice a step.
struct BodyRecord {
    std::shared_ptr<const BodyGeometry> geometry;
    std::uint64_t userData = 0;
    MotionRules rules;
    Vec2 force;      // N; accumulated since the last step, see addForce()
    Real torque = 0; // N m
    /// Number of steps, with the next one, in which LoadRelease looks at the body.
    std::uint8_t lostLoad = 0;
    /// Number among bodies that overlap deeply, so that the middle of a part lies in the other
    /// part: above that of each of them with a lower index, from the beginning of the overlap.
    std::uint32_t crowdRank = 0;
};

/// Bodies that changed since a stage last looked at them, as lists without order that may contain
/// duplicates. So a stage costs what has changed, not what there is.
struct BodyChanges {
    std::vector<std::uint32_t> activity;   // Bodies::active may have changed: see refreshAwake
    std::vector<std::uint32_t> arrived;    // see Bodies::hasArrived
    std::vector<std::uint32_t> teleported; // see Bodies::hasTeleported
    std::vector<std::uint32_t> moved;      // inactive, with an outdated Bodies::start
    std::vector<std::uint32_t> toggled;    // that the last refreshAwake listed or removed, in order
    bool allActivity = true;               // the same as if `activity` listed all bodies
    bool allMoved = true;                  // the same as if `moved` listed all bodies
    std::vector<std::uint32_t> lostLoads;  // with BodyRecord::lostLoad > 0; also repeated or gone
    std::vector<std::uint32_t> entered;    // active without an acceleration; also repeated or gone
    bool loadsStale = true;                // Bodies::loads
    bool anyDamped = false;                // some body has, or had, a damping
    bool partFilters = false;              // some part has, or had, a filter of its own
    bool continuousModes = false;          // some body has, or had, another one than All
};

/// All bodies of a World as parallel arrays, indexed by BodyId::index. A free slot has zero
/// velocity and infinite mass.
struct Bodies {
    IdPool ids;
    std::uint32_t stamp = 0; // of the World, in all its ids; 0: matches all Worlds
    std::vector<BodyVelocity> motion = std::vector<BodyVelocity>(1); // one spare at the end
    std::vector<Transform> pose;                                     // of the centre of mass
    std::vector<Acceleration> acceleration;
    std::vector<Extent> extent = std::vector<Extent>(1); // one spare at the end
    std::vector<std::uint32_t> teleportCount;            // number of teleports and geometry changes
    /// By body: teleported since the last step began, or a contact was put back since.
    std::vector<std::uint8_t> hasTeleported;
    /// By body: added or changed since the last step, so it may begin contacts with sleeping ones.
    std::vector<std::uint8_t> hasArrived;
    std::vector<Vec2> start;             // m, centre of mass when the last step began
    std::vector<CollisionFilter> filter; // not in `record`: pair search reads it at random
    std::vector<BodyRecord> record;
    std::vector<const Part*> parts; // of each body geometry; saves an indirection
    std::vector<SleepState> sleep;
    std::vector<std::uint32_t> forced; // bodies with a force; may contain duplicates
    /// The active bodies, in order: excludes sleeping, out-of-region and motionless locked bodies.
    /// Other bodies cost no time in a step.
    std::vector<std::uint32_t> awake;
    std::vector<std::uint32_t> nextAwake; // scratch of refreshAwake
    std::size_t thin = 0; // number of bodies without a core radius: with a point or a line
    LoadRange loads;      // see noteLoads()
    BodyChanges changes;
    bool anyStopped = false;        // a kinematic body in the list has become motionless
    bool anySleeping = true;        // during the solve
    Features leftOut;               // StepSettings::leaveOut
    bool accelerationsStale = true; // of all bodies; of a few: see BodyChanges::entered

    BodyId idAt(std::size_t index) const {
        return {static_cast<std::uint32_t>(index), ids.generationAt(index), stamp};
    }
    bool alive(BodyId id) const {
        return ids.alive(id.index, id.generation) &&
               (id.world == stamp || id.world == 0 || stamp == 0);
    }
    std::size_t size() const { return record.size(); }
    /// Index of a BodyVelocity of no body, which never changes: unused lanes refer to it.
    std::uint32_t spare() const { return static_cast<std::uint32_t>(record.size()); }

    const BodyGeometry& geometry(std::size_t index) const { return *record[index].geometry; }
    const ConvexShape& convex(std::size_t index, std::size_t part) const {
        return parts[index][part].convex;
    }
    bool locked(std::size_t index) const { return motion[index].locked(); }
    /// True for a locked body that has moved in this step: nothing stops it.
    bool isMovingKinematic(std::size_t index) const {
        return locked(index) && !motion[index].unmoved();
    }
    bool asleep(std::size_t index) const { return (filter[index].flags & kAsleep) != 0; }
    /// True for a locked body without velocity, and without displacement in the last step.
    bool isStill(std::size_t index) const {
        const BodyVelocity& m = motion[index];
        return locked(index) && m.velocity == Vec2{} && m.angularVelocity == 0 &&
               m.deltaPosition == Vec2{} && m.deltaAngle == 0;
    }
    /// Invalidates the manifolds and impulses of the body's contacts.
    void teleported(std::size_t index) {
        ++teleportCount[index];
        noteTeleport(index);
    }
    void noteArrival(std::size_t index) { note(index, hasArrived, changes.arrived); }
    void noteTeleport(std::size_t index) { note(index, hasTeleported, changes.teleported); }
    /// A contact, joint or force that may have pressed the body changed or is gone.
    void noteLostLoad(std::size_t index, std::uint8_t steps = 1) {
        if (record[index].lostLoad == 0) {
            appendIndex(changes.lostLoads, static_cast<std::uint32_t>(index), record.size());
        }
        record[index].lostLoad = std::max(record[index].lostLoad, steps);
    }
    /// The body may have become active or inactive.
    void noteActivity(std::size_t index) { note(index, changes.activity, changes.allActivity); }
    /// Bodies::start of the body is outdated, and the body is not active.
    void noteMove(std::size_t index) { note(index, changes.moved, changes.allMoved); }

    /// True if the body takes part in a step.
    bool active(std::size_t index) const {
        return (filter[index].flags & (kAsleep | kOutside)) == 0 && !isStill(index);
    }
    /// World position of the shape's frame. Its origin may differ from the centre of mass.
    Vec2 originOf(std::size_t index) const {
        return pose[index].position - pose[index].rotation * geometry(index).mass.center;
    }
    /// Pose at the end of the displacement of this step.
    Transform endPose(std::size_t index) const {
        return {pose[index].position + motion[index].deltaPosition,
                turned(pose[index].rotation, motion[index].deltaAngle)};
    }

private:
    /// A list as long as that of the bodies saves nothing: `all` replaces it.
    void note(std::size_t index, std::vector<std::uint32_t>& list, bool& all) const {
        if (list.size() < record.size()) {
            list.push_back(static_cast<std::uint32_t>(index));
        } else {
            all = true;
        }
    }
    static void note(std::size_t index, std::vector<std::uint8_t>& marks,
                     std::vector<std::uint32_t>& list) {
        if (std::exchange(marks[index], std::uint8_t{1}) == 0) {
            list.push_back(static_cast<std::uint32_t>(index));
        }
    }
};

/// Resizes an array by body. It gets as much room as the arrays of Bodies, so that a body that is
/// added moves it as seldom as those.
template <typename T>
void resizeByBody(std::vector<T>& values, const Bodies& bodies, const T& added = {}) {
    values.reserve(bodies.record.capacity());
    values.resize(bodies.size(), added);
}

/// Throws BadBodyId for an id of no body of this World. The sentence begins with `field`, which is
/// for calls that take several ids.
void requireAlive(const Bodies& bodies, BodyId id, const char* field = nullptr);

/// Resizes the arrays by body to `count` slots.
void makeRoom(Bodies& bodies, std::size_t count);

/// Adds a body. Precondition: the definition is valid.
BodyId addBody(Bodies& bodies, const BodyDef& def, std::shared_ptr<const BodyGeometry> geometry);
void removeBody(Bodies& bodies, std::uint32_t index);

/// Replaces the geometry. The world position of the shape's frame stays.
void setGeometry(Bodies& bodies, std::uint32_t index, std::shared_ptr<const BodyGeometry> geometry);
/// The same; all points keep their velocities, though the centre of mass moves to another one.
void setGeometryInMotion(Bodies& bodies, std::uint32_t index,
                         std::shared_ptr<const BodyGeometry> geometry);

/// Adds the parts of body `part` to `into` at their world poses. Conserves momentum and angular
/// momentum of the pair unless `into` is locked. `part` is unchanged; the caller removes it.
void weldBodies(Bodies& bodies, std::uint32_t into, std::uint32_t part);

/// Makes the part that was taken a body of its own at the same pose, with flags and user data of
/// `made`. Both bodies keep the velocities of their points, which conserves momentum and angular
/// momentum, unless the new body is locked: then it stands still.
BodyId unweldPart(Bodies& bodies, std::uint32_t body, const DividedGeometry& geometry,
                  const FormerBody& made);

/// The body as what its parts were, for World::unweld().
FormerBody formerBodyOf(const Bodies& bodies, std::uint32_t body);

/// Adds a force (N, at the centre of mass) and a torque (N m) to the next step. They act in that
/// step only, even if the body is inactive then.
void addForce(Bodies& bodies, std::uint32_t body, Vec2 force, Real torque);

/// Stops a body and sets kFrozen. Used when its motion is unsound: see isSound().
void freeze(Bodies& bodies, std::uint32_t body);
inline bool isSound(const BodyVelocity& motion, Real lengthUnit) {
    const Real most = kMaxSpeed * lengthUnit;
    return lengthSquared(motion.velocity) <= most * most && // false for NaN
           std::abs(motion.angularVelocity) <= kMaxSpeed &&
           lengthSquared(motion.deltaPosition) <= most * most && // a step lasts at most 1 s
           std::abs(motion.deltaAngle) <= kMaxSpeed;
}
inline bool isSound(const Acceleration& acceleration) {
    return isFinite(acceleration.linear) && std::isfinite(acceleration.angular);
}

void visitState(StateStream& stream, Bodies& bodies,
                std::shared_ptr<const BodyGeometry>& lastGeometry);

/// Brings Bodies::awake up to date. True if any body may have become active or inactive;
/// BodyChanges::toggled lists those that did.
bool refreshAwake(Bodies& bodies);

/// Clears the list of arrivals.
void clearArrivals(Bodies& bodies);

/// After the solver: counts BodyRecord::lostLoad down.
void countLostLoads(Bodies& bodies);

/// Stores the positions at the start of a step, and clears the teleport flags.
void noteStart(Bodies& bodies);

/// Updates the data that follow from geometry and lock flags.
void refreshDerived(Bodies& bodies, std::uint32_t index);

/// True for a movable body without inertia, whose rotation nothing locks.
bool isParticle(const Bodies& bodies, std::uint32_t body);

/// Feature::Rotation was left out or is back. Without it, all bodies act as with kLockRotate, and
/// bodies that could rotate lose their angular velocity.
void rotationChanged(Bodies& bodies);

/// World bounds of all parts.
Aabb boundsOfBody(const Bodies& bodies, std::size_t body);

} // namespace KODO_PRECISION
} // namespace kodo
