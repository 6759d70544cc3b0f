// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/step_stats.hpp>
#include <kodo/world.hpp>

#include "bodies/field_checks.hpp"
#include "bodies/flag_blocks.hpp"
#include "contacts/contact_set.hpp"
#include "world/change_guard.hpp"
#include "world/region.hpp"

#include <optional>
#include <span>
#include <vector>

#include "continuous/continuous_collision.hpp"
#include "propagation/propagation.hpp"
#include "sleep/sleep_system.hpp"
#include "soft/soft_solver.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void visitState(StateStream& stream, StepSettings& settings);
void visitState(StateStream& stream, Tolerances& tolerances);

/// The implementation of World. Functions of the same names are documented there.
class WorldImpl {
public:
    explicit WorldImpl(const WorldDef& def);

    BodyId add(const BodyDef& def);
    void remove(BodyId id);
    BodyId clone(BodyId id, Vec2 position);
    std::size_t bodyCount() const { return count_; }
    BodyRef operator[](BodyId id) { return {*this, id}; }
    const Bodies& bodyData() const { return bodies_; }
    ContactSet& contactData() { return contacts_; }
    const ContactSet& contactData() const { return contacts_; }

    std::size_t weld(BodyId into, BodyId part);
    std::size_t weld(BodyId into, const Primitive& shape, const Material& material, Real density);
    BodyId unweld(BodyId body, std::size_t part, std::optional<Flags> flags);

    JointId add(const JointDef& def);
    void remove(JointId id);
    const JointDef& joint(JointId id) const;
    void setJoint(JointId id, const JointDef& def);
    /// Throws BadDefinition for an id of no joint.
    void requireAlive(JointId id) const;
    const JointSet& jointData() const { return joints_; }
    std::span<const BrokenJoint> brokenJoints() const { return broken_; }

    void addField(FieldEntry entry);
    void setFields(std::vector<FieldEntry> fields);
    const std::vector<FieldEntry>& fields() const { return fields_; }
    void applyToAll(Vec2 force, Real torque, CollisionFilter which);

    void step(Real dt, const StepOptions& options);
    /// Records of the last step, to be read with recordSource().
    StepRecords& records() const { return contacts_.records(); }
    StepRecords::Source recordSource() const { return contacts_.recordSource(bodies_); }
    std::uint64_t stepCount() const { return stepCount_; }

    void setRegion(std::optional<Aabb> region);
    const std::optional<Aabb>& region() const { return region_.box(); }
    std::span<const BodyId> frozenBodies() const { return frozen_; }

    const StepSettings& settings() const { return settings_; }
    void setSettings(const StepSettings& settings);
    const Tolerances& tolerances() const { return tolerances_; }

    StepStats stats() const {
        StepStats all = work_;
        all.bodies = bodies_.awake.size();
        all.joints = joints_.awakeCount();
        all.pairs = contacts_.store().size();
        all.pairWork = contacts_.candidates().work();
        all.changeVisits =
            changeVisits_ + contacts_.candidates().bounds().moves() + region_.parked().visits();
        return all;
    }

    std::uint64_t stateHash() const;
    /// When reading, the World must be new. Before writing, the contacts must be up to date.
    void visitState(StateStream& stream, OwnFields ownFields);

    // For queries.
    const ChangeGuard& guard() const { return guard_; }

private:
    friend class BodyRef;
    friend class WorldStep;
    friend std::vector<BodyId> touching(const World& world, BodyId id);

    void jointsChanged(const JointDef& def);
    void notePairChanges();
    void wake(std::uint32_t body);
    void wakeNeighbours(std::uint32_t body);
    void bodyChanged(std::uint32_t body);
    void velocityChanged(std::uint32_t body);
    void thaw(std::uint32_t body);
    void addForce(std::uint32_t body, Vec2 force, Real torque);
    void applyImpulse(std::uint32_t body, Vec2 impulse, Real angular);
    void setRules(std::uint32_t body, const MotionRules& rules);
    void bodyAdded(std::uint32_t body);
    bool listAwake();
    void updateAwake();

    ChangeGuard guard_;
    StepSettings settings_;
    Tolerances tolerances_;
    std::uint64_t stepCount_ = 0;
    std::size_t count_ = 0;
    std::size_t roomFor_ = 0; // see WorldStep::makeRoom
    Bodies bodies_;
    FlagBlocks flagBlocks_; // of bodies_
    std::vector<FieldEntry> fields_;
    ContactSet contacts_;
    SoftSolver softSolver_;
    Propagation propagation_;
    StepStats work_;                 // of the solver, in the last step
    std::uint64_t changeVisits_ = 0; // see StepStats
    ContinuousCollision continuous_;
    SleepSystem sleep_;
    JointSet joints_;
    std::vector<BrokenJoint> broken_;
    std::vector<BodyId> frozen_;
    Region region_;
    std::shared_ptr<const BodyGeometry> lastGeometry_; // equal bodies are usually added in sequence
};

} // namespace KODO_PRECISION
} // namespace kodo
