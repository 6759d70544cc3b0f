// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/force_field.hpp>
#include <kodo/joint.hpp>
#include <kodo/settings.hpp>

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

class Executor;
class StageListener;

/// What a World starts with.
struct WorldDef {
    Vec2 gravity{};      // m/s^2; becomes the first force field, unless it is zero
    Real lengthUnit = 1; // m; size of a typical body; all tolerances scale with it
    StepSettings settings{};
};

/// The reason why World's constructor would refuse a definition.
KODO_API std::optional<Problem> check(const WorldDef& def);

/// Threads and listeners of one step. None of them changes the result.
struct StepOptions {
    Executor* executor = nullptr;      // threads for steps with hundreds of awake bodies
    StageListener* listener = nullptr; // see step_stats.hpp
};

/// Bodies, joints, force fields and their simulation [Thesis06, 4.2].
///
/// A World is a value: a copy is a snapshot, and both continue with the same bits. Worlds share no
/// mutable data, so each may run on a thread of its own. A World that was moved from may only be
/// destroyed or assigned to; other calls throw std::logic_error. The same holds if memory runs out
/// (std::bad_alloc) in a call that changes a World, but other calls then do not notice it.
class KODO_API World {
public:
    /// Throws BadDefinition with what check(def) says.
    explicit World(const WorldDef& def = {});
    World(const World& other);
    World(World&& other) noexcept;
    World& operator=(const World& other);
    World& operator=(World&& other) noexcept;
    ~World();

    // Bodies. Functions that take an id throw BadBodyId for one that names no body of this World.

    /// Throws BadDefinition with what check(def) says.
    BodyId add(const BodyDef& def);
    /// Removes a body and its joints, and wakes what touches it. Costs its own contacts and joints,
    /// whatever else the World holds. In a large World the first removal after a step takes longer,
    /// since its data are not in the cache.
    void remove(BodyId id);
    /// Adds a copy of a body at another position (m, world: of the shape's frame).
    BodyId clone(BodyId id, Vec2 position);
    bool contains(BodyId id) const;
    std::size_t bodyCount() const;
    std::vector<BodyId> bodies() const; // in the order of their ids
    /// The bodies that moved or fell asleep in the last step, in the order of their ids: others
    /// have the pose of before, unless a call changed it. Costs the awake bodies, and nothing if it
    /// is not called.
    std::vector<BodyId> movedBodies() const;

    BodyRef operator[](BodyId id);
    BodyView operator[](BodyId id) const;

    /// Makes the parts of `part` parts of `into`, at their places, and removes `part`. Keeps mass,
    /// centre of mass, momentum and angular momentum of the pair; a static or kinematic `into`
    /// stays what it is. Type, flags, `required`, user data and set mass of `part` are stored for
    /// unweld(). Returns the index of the first part added. Throws BadDefinition for equal
    /// ids, for a plane in a dynamic body, for too many parts or too much mass, and for a part or
    /// an anchor of its joints that would be beyond kMaxCoordinate.
    std::size_t weld(BodyId into, BodyId part);
    /// Adds a part, in the frame of the shape of `into`, with its velocity. Throws BadDefinition
    /// for what add() would refuse.
    std::size_t weld(BodyId into, const Primitive& shape, const Material& material, Real density);
    /// Makes a part a body of its own. A part that was one before gets back its type, flags,
    /// `required` and user data; another is a dynamic body without flags. With `flags`, it is a
    /// dynamic body with these flags, `required` 0 and its user data. The indices of later parts
    /// decrease by one.
    /// Keeps momentum and angular momentum, unless the part is static, kinematic or locked then: it
    /// stands still. A mass that was set before weld() is taken off; of one that was set for
    /// several parts, the share of the part by density. Both bodies then have centres of mass as
    /// far from those of their shapes as the whole had; setMassFromDensity() moves them back.
    /// Throws BadDefinition for a part that does not exist, for the only part, for flags that add()
    /// would refuse, and for a mass out of range.
    BodyId unweld(BodyId body, std::size_t part, std::optional<Flags> flags = std::nullopt);

    // Joints. Functions that take an id throw BadDefinition for one that names no joint.

    /// Adds a RevoluteJoint, or another alternative of JointDef. Throws BadDefinition with what
    /// check(def) says, BadBodyId for an unknown body; its sentence begins with the end. While no
    /// body of a joint is dynamic, it has no effect.
    template <typename Joint>
    requires std::constructible_from<JointDef, const Joint&> JointId add(const Joint& joint) {
        return addJoint(JointDef(joint));
    }
    void remove(JointId id);
    bool contains(JointId id) const;
    const JointDef& joint(JointId id) const;
    /// Changes the numbers of a joint; its accumulated impulses stay. Throws BadDefinition with
    /// what check(def) says, and for another kind or other bodies.
    void setJoint(JointId id, const JointDef& def);
    /// Changes some numbers of a joint: `change(joint)` sets them in the RevoluteJoint, or in
    /// another kind. Throws as setJoint(), and BadDefinition if the joint is of another kind.
    template <typename Joint, typename Change>
    void changeJoint(JointId id, Change change) {
        const Joint* const found = std::get_if<Joint>(&this->joint(id));
        if (found == nullptr) {
            throw BadDefinition({"joint", "is of another kind than the one to be changed"});
        }
        Joint changed = *found;
        change(changed);
        setJoint(id, changed);
    }
    /// Angle, length and translation of a joint, their speeds, and its anchors in the world.
    JointState jointState(JointId id) const;
    /// N, on body b: mean over the last step in which the joint was awake.
    Vec2 jointForce(JointId id) const;
    Real jointTorque(JointId id) const; // N m, likewise
    /// All joints, or those of one body.
    std::vector<JointId> joints(std::optional<BodyId> id = std::nullopt) const;
    /// Joints that broke in the last step, in the order of ids. Valid until the next step.
    std::span<const BrokenJoint> brokenJoints() const;

    // Forces.

    /// Fields act in the order of the list. A change wakes all bodies. Throws BadDefinition for a
    /// null pointer, a bad number of one of the engine's own fields, and a bad filter: two match
    /// modes, or `required` without a mode.
    void addField(FieldEntry entry);
    void setFields(std::vector<FieldEntry> fields);
    const std::vector<FieldEntry>& fields() const;
    /// During the next step, on the bodies that `which` accepts: N at the centre of mass, and N m.
    /// Throws BadDefinition for values that are not finite and for a bad filter, as addField().
    void applyForceToAll(Vec2 force, CollisionFilter which = {});
    void applyTorqueToAll(Real torque, CollisionFilter which = {});

    // Steps.

    /// Advances by dt seconds, from kMinTimeStep to kMaxTimeStep. Throws BadDefinition for another
    /// dt. A fixed dt is best: warm starting takes the impulses of the step before.
    ///
    /// Code of the user that runs within the step (listener, fields, executor) may read the World.
    /// Calls that change or copy it throw std::logic_error, and it must not be moved or destroyed.
    /// An exception of a listener passes through and leaves the step half done: the World can be
    /// used, but its state is unspecified. Go back to a copy or snapshot from before.
    void step(Real dt, const StepOptions& options = {});

    // Collisions of the last step, in the order of bodies and parts. The first call of each
    // function after a step writes the records, so these functions must not run on two threads at
    // once. Lists are valid until the next step, whatever is added or removed meanwhile.

    /// Contacts that began, persisted or ended. Costs all touching pairs. Sleeping pairs and pairs
    /// outside the region have no records until they continue; they have not ended.
    std::span<const CollisionRecord> collisions() const;
    /// Of these, the ones that began. This list and the next cost what began and ended. A pair can
    /// end and begin in one step: read what ended first.
    std::span<const CollisionRecord> begunCollisions() const;
    std::span<const CollisionRecord> endedCollisions() const;
    /// Of these, the impacts: the ones with an impulse whose approachSpeed is at least minSpeed
    /// (m/s, >= 0). Costs the hits and, if any contact is that fast, one number of each contact.
    std::vector<CollisionRecord> hits(Real minSpeed) const;
    /// Of these, the ones with this body. Costs its contacts and those that were removed; the first
    /// call also lists the contacts of all awake bodies.
    std::vector<CollisionRecord> collisions(BodyId id) const;
    std::uint64_t stepCount() const;

    /// Only bodies whose bounds meet the region (m, world) are simulated. std::nullopt: all are.
    /// Throws BadDefinition unless lower <= upper on both axes.
    void setRegion(std::optional<Aabb> region);
    const std::optional<Aabb>& region() const;

    /// Bodies that the last step stopped, since forces made them faster than kMaxSpeed or not
    /// finite. They keep their last valid pose, as static bodies, until a velocity is set.
    std::span<const BodyId> frozenBodies() const;

    const StepSettings& settings() const;
    void setSettings(const StepSettings& settings); // throws BadDefinition with what check() says
    const Tolerances& tolerances() const;

    /// Equal for Worlds that continue alike. The same on every machine.
    std::uint64_t stateHash() const;

    /// For the functions of query.hpp, snapshot.hpp and step_stats.hpp.
    WorldImpl& impl();
    const WorldImpl& impl() const;

private:
    WorldImpl& change(const char* call);
    JointId addJoint(const JointDef& def);

    std::unique_ptr<WorldImpl> impl_;
};

/// The numbers for a spring of that stiffness (N/m, > 0) and damping (N s/m, >= 0) in a joint,
/// with the present masses of its bodies; of a RevoluteJoint N m/rad and N m s/rad. Throws
/// BadDefinition for a joint without a spring and for bodies that nothing moves.
///
///   hertz = sqrt(stiffness / m) / (2 pi),  damping ratio = damping / (2 sqrt(stiffness m))
KODO_API Spring springOf(const World& world, const JointDef& def, Real stiffness, Real damping = 0);

} // namespace KODO_PRECISION
} // namespace kodo
