// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/step_stats.hpp>
#include <kodo/world.hpp>

#include "contacts/contact_set.hpp"
#include "solve/continuous_collision.hpp"
#include "solve/impact_solver.hpp"
#include "solve/propagation.hpp"
#include "solve/sleep_system.hpp"
#include "solve/soft_solver.hpp"
#include "world/change_guard.hpp"
#include "world/query_tree.hpp"

#include <optional>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The implementation of World. Functions of the same names are documented there.
class WorldImpl {
public:
    explicit WorldImpl(const WorldDef& def);

    BodyId add(const BodyDef& def);
    void remove(BodyId id);
    BodyId clone(BodyId id, Vec2 position);
    bool contains(BodyId id) const { return bodies_.alive(id); }
    std::size_t bodyCount() const { return count_; }
    std::vector<BodyId> bodies() const;
    BodyRef operator[](BodyId id) { return {*this, id}; }
    BodyView operator[](BodyId id) const { return {bodies_, id}; }

    std::size_t weld(BodyId into, BodyId part);
    std::size_t weld(BodyId into, const Primitive& shape, const Material& material, Real density);
    BodyId unweld(BodyId body, std::size_t part, Flags flags);

    JointId add(const JointDef& def);
    void remove(JointId id);
    bool contains(JointId id) const { return joints_.contains(id); }
    const JointDef& joint(JointId id) const;
    void setJoint(JointId id, const JointDef& def);
    Vec2 jointForce(JointId id) const;
    Real jointTorque(JointId id) const;
    std::vector<JointId> joints() const { return joints_.ids(); }
    std::span<const BrokenJoint> brokenJoints() const { return broken_; }

    void addField(FieldEntry entry);
    void setFields(std::vector<FieldEntry> fields);
    const std::vector<FieldEntry>& fields() const { return fields_; }
    void applyForceToAll(Vec2 force, CollisionFilter which);
    void applyTorqueToAll(Real torque, CollisionFilter which);

    void step(Real dt, const StepOptions& options);
    std::span<const CollisionRecord> collisions() const {
        return contacts_.records().all(contacts_.recordSource(writeBack()));
    }
    std::vector<CollisionRecord> collisions(BodyId id) const;
    std::span<const CollisionRecord> begunCollisions() const {
        return contacts_.records().begun(contacts_.recordSource(writeBack()));
    }
    std::span<const CollisionRecord> endedCollisions() const {
        return contacts_.records().ended(contacts_.recordSource(writeBack()));
    }
    std::vector<CollisionRecord> hits(Real minSpeed) const;
    std::uint64_t stepCount() const { return stepCount_; }

    void setRegion(std::optional<Aabb> region);
    const std::optional<Aabb>& region() const { return region_; }
    std::span<const BodyId> frozenBodies() const { return frozen_; }

    const StepSettings& settings() const { return settings_; }
    void setSettings(const StepSettings& settings);
    const Tolerances& tolerances() const { return tolerances_; }

    StepStats stats() const {
        return {bodies_.awake.size(), contactVisits_, joints_.busyCount(),
                contacts_.candidates().finder().work()};
    }
    void setPairSearch(std::optional<PairSearch> only) {
        contacts_.candidates().finder().use(only);
    }

    std::uint64_t stateHash() const;

    // For queries.
    const Bodies& bodyData() const { return bodies_; }
    const ChangeGuard& guard() const { return guard_; }
    QueryTree::View queryView() const { return queries_.view(bodies_, tolerances_); }

private:
    friend class BodyRef;
    friend class SnapshotFields;

    void requireAlive(JointId id) const;
    void requireValid(const FieldEntry& entry) const;
    void jointsChanged(const JointDef& def);
    WriteBack writeBack() const {
        return [this](Contact& contact) { softSolver_.blocks().writeBack(contact, bodies_); };
    }
    void writeBackContacts() { softSolver_.blocks().writeBackAll(contacts_.contacts(), bodies_); }
    void wake(std::uint32_t body);
    void wakeAll();
    void wakeNeighbours(std::uint32_t body);
    void bodyChanged(std::uint32_t body);
    void velocityChanged(std::uint32_t body);
    void thaw(std::uint32_t body);
    void applyForce(std::uint32_t body, Vec2 arm, Vec2 force);
    void applyImpulse(std::uint32_t body, Vec2 arm, Vec2 impulse);
    bool updateRegion(std::uint32_t body);
    void placeInRegion(std::uint32_t body);
    void parkContacts();
    template <typename Which>
    void unpark(Which which);
    void unparkContactsOf(std::uint32_t body);
    void makeOutsideStatic();
    void restoreOutside();
    std::shared_ptr<const BodyGeometry> geometryFor(const BodyDef& def);

    void forAwake(WorkerTeam& team, void (*work)(Bodies&, std::span<const std::uint32_t>));
    void updateManifolds(WorkerTeam& team);
    void evictTeleported();
    void wakeIslands(bool arrivals);
    void gatherForces(Real dt, WorkerTeam& team);
    void solve(Real dt, WorkerTeam& team);
    void runContinuous(Real dt, WorkerTeam& team);
    void finishMoves(WorkerTeam& team);
    void recordCollisions(WorkerTeam& team);
    void breakJoints(Real dt);
    void updateAwake();
    void freezeUnsoundForces();
    /// True if any body is awake while an island sleeps.
    bool canWake() const { return sleep_.anyAsleep() && !bodies_.awake.empty(); }
    bool allSound(WorkerTeam& team) const;
    void freezeUnsoundMotion();

    ChangeGuard guard_;
    StepSettings settings_;
    Tolerances tolerances_;
    std::uint64_t stepCount_ = 0;
    std::size_t count_ = 0;
    Bodies bodies_;
    std::vector<FieldEntry> fields_;
    ContactSet contacts_;
    ImpactSolver impacts_;
    SoftSolver softSolver_;
    Propagation propagation_;
    std::size_t contactVisits_ = 0;
    ContinuousCollision continuous_;
    SleepSystem sleep_;
    JointSet joints_;
    std::vector<BrokenJoint> broken_;
    std::vector<BodyId> frozen_;
    std::optional<Aabb> region_;
    // Of bodies outside the region, during the solve.
    std::vector<std::pair<std::uint32_t, BodyVelocity>> outsideVelocities_;
    std::vector<Contact> parked_;   // of bodies outside the region; see parkContacts()
    std::vector<Contact> unparked_; // scratch: a step allocates nothing
    mutable QueryTree queries_;     // a cache: updated by queries
    std::shared_ptr<const BodyGeometry> lastGeometry_; // equal bodies are usually added in sequence
};

} // namespace KODO_PRECISION
} // namespace kodo
