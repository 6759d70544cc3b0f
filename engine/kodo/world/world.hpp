// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/force_field.hpp>
#include <kodo/contacts/collision_record.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/solve/impact.hpp>
#include <kodo/solve/propagation.hpp>
#include <kodo/solve/rest.hpp>
#include <kodo/solve/settings.hpp>
#include <kodo/solve/soft_step.hpp>
#include <kodo/solve/sweep.hpp>
#include <kodo/world/body_ref.hpp>
#include <kodo/world/step_aids.hpp>

#include <optional>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// What a World starts with.
struct WorldDef {
    Vec2 gravity{};      // m/s^2; becomes the first force field unless it is zero
    Real lengthUnit = 1; // m; the size of a typical body. Every tolerance is a share of it
    StepSettings settings{};
};

/// What the World of it would be refused for, or nothing.
std::optional<Problem> check(const WorldDef& def);

/// Bodies, and the laws that move them [Thesis06, 4.2]. A value: a copy is a snapshot, and both
/// go on alike. Worlds share nothing that changes, so each may run on a thread of its own.
class World {
public:
    /// Throws BadDefinition with what check(def) says.
    explicit World(const WorldDef& def = {});

    /// Throws BadDefinition with what check(def) says.
    BodyId add(const BodyDef& def);
    /// Throws BadBodyId for an id that is not alive, as everything here does. What leans on the
    /// body wakes, and its joints go. Takes a time that grows with the contacts and joints of the
    /// World and the piles that rest in it.
    void remove(BodyId id);
    /// A body like this one in all but its id and its place (m, world: of the shape's frame).
    BodyId clone(BodyId id, Vec2 position);
    bool contains(BodyId id) const { return bodies_.ids.alive(id.index, id.generation); }
    std::size_t bodyCount() const { return count_; }
    std::vector<BodyId> bodies() const; // in the order of their ids

    BodyRef operator[](BodyId id) { return {*this, id}; }
    BodyView operator[](BodyId id) const { return {*this, id}; }

    /// Makes `part` a part of `into`, where it is now: its parts follow those of `into`, and its id
    /// dies. Mass, centre, inertia, momentum and angular momentum of the pair are kept; a locked
    /// `into` stays locked. Returns the index of the first part added. Throws BadDefinition for one
    /// and the same body twice, for a plane in what is not locked, and if the two have too many
    /// parts or too much mass together.
    std::size_t weld(BodyId into, BodyId part);
    /// The same with a shape in the frame of `into`'s shape, at the speed of `into`. Throws
    /// BadDefinition as well for what add would refuse: the shape, the material, the density.
    std::size_t weld(BodyId into, const Primitive& shape, const Material& material, Real density);
    /// Takes part `part` off again, as a body of its own with these flags; the parts behind it move
    /// up by one. Momentum and angular momentum are kept. Throws BadDefinition for a part that the
    /// body does not have, for its only one, and for flags that add would refuse.
    BodyId unweld(BodyId body, std::size_t part, Flags flags = 0);

    /// Throws BadDefinition with what check(def) says, BadBodyId if a body of it is not alive.
    JointId add(const JointDef& def);
    void remove(JointId id); // throws BadDefinition for an id that is not alive, as all of these do
    bool contains(JointId id) const { return joints_.contains(id); }
    const JointDef& joint(JointId id) const;
    /// Changes the numbers of a joint; what it has learned is kept. Throws BadDefinition with what
    /// check(def) says, or if it is of another kind or between other bodies.
    void setJoint(JointId id, const JointDef& def);
    /// N, on the second body: the mean of the last step in which the joint did not rest.
    Vec2 jointForce(JointId id) const;
    Real jointTorque(JointId id) const; // N m
    std::vector<JointId> joints() const { return joints_.ids(); }
    /// Joints that broke in the last step, in order. Valid until the next step.
    std::span<const BrokenJoint> brokenJoints() const { return broken_; }

    /// Fields act in the order of the list. A change wakes everything. Throws BadDefinition if a
    /// pointer to a field is null.
    void addField(FieldEntry entry);
    void setFields(std::vector<FieldEntry> fields);
    const std::vector<FieldEntry>& fields() const { return fields_; }
    /// Until the next step; on the bodies that `which` accepts. N at the centre of mass, and N m.
    /// Throws BadDefinition for what is not finite.
    void applyForceToAll(Vec2 force, CollisionFilter which = {});
    void applyTorqueToAll(Real torque, CollisionFilter which = {});

    /// Moves everything on by dt seconds, kShortestStep to kLongestStep. Throws BadDefinition for
    /// any other dt. Best is one dt for all steps: contacts and joints start from the impulses of
    /// the step before, which those of another length would not want. What helps or watches
    /// changes nothing of the outcome.
    void step(Real dt, const StepAids& aids = {});
    /// What touched in the last step, ordered by bodies and parts. Valid until the next step,
    /// whatever is added, removed or welded meanwhile. Pairs that rest, or wait outside the region,
    /// have no records until they go on; they have not ended. The first call after a step writes
    /// the list, so that one must not come from two threads at once.
    std::span<const CollisionRecord> collisions() const;

    /// Only bodies whose bounds meet the region (m, world) take part in steps; the others wait
    /// where they are. Nothing: all do. Throws BadDefinition unless lower <= upper along both axes.
    void setRegion(std::optional<Aabb> region);
    const std::optional<Aabb>& region() const { return region_; }

    /// Bodies that the last step had to stop, since a force made them faster than kHighestSpeed or
    /// not finite. They stand where they were, as if locked, until a velocity is set.
    std::span<const BodyId> frozenBodies() const { return frozen_; }

    const StepSettings& settings() const { return settings_; }
    /// Throws BadDefinition with what check(settings) says.
    void setSettings(const StepSettings& settings);
    /// How pairs are looked for; nothing: in the cheapest way, call by call. All find the same
    /// pairs, so nothing but the cost of a step follows from it, and a snapshot knows nothing of
    /// it.
    void setPairSearch(std::optional<PairSearch> only) { contacts_.pairFinder().use(only); }
    const Tolerances& tolerances() const { return tolerances_; }
    std::uint64_t stepCount() const { return stepCount_; }
    /// How often the solver looked at a contact in the last step: its cost, free of any clock.
    std::size_t contactVisits() const { return contactVisits_; }
    /// How many bodies the last step worked on: what rests, stands locked or waits is not among
    /// them.
    std::size_t bodyVisits() const { return bodies_.awake.size(); }
    /// How many joints the last step worked on: those of whose bodies none took part are not among
    /// them.
    std::size_t jointVisits() const { return joints_.busyCount(); }

    /// ps that the search for pairs has taken in all steps so far, by what it had to do and what
    /// that takes on one machine: its cost, free of any clock. See PairWork.
    std::uint64_t pairWork() const { return contacts_.pairFinder().work(); }

    /// Equal for worlds that will go on alike. The same on every machine.
    std::uint64_t stateHash() const;

private:
    friend class BodyView;
    friend class BodyRef;
    friend class SnapshotFields;

    void requireAlive(BodyId id) const;
    void requireAlive(JointId id) const;
    void jointsChanged(const JointDef& def);
    Contact current(const Contact& contact) const;
    void fetchContacts() { softStep_.blocks().fetchAll(contacts_.contacts(), bodies_); }
    void wake(std::uint32_t body);
    void wakeAll();
    void disturb(std::uint32_t body);
    bool askRegion(std::uint32_t body);
    void placeInRegion(std::uint32_t body);
    void putContactsAside();
    template <typename Which>
    void takeBack(Which which);
    void takeBackContactsOf(std::uint32_t body);
    void holdWhatWaits();
    void releaseWhatWaits();
    std::shared_ptr<const Form> formFor(const BodyDef& def);

    void forAwake(Crew& crew, void (*work)(Bodies&, std::span<const std::uint32_t>));
    void updateManifolds(Crew& crew);
    void reclaimJumped();
    void gatherForces(Real dt, Crew& crew);
    void solve(Real dt, Crew& crew);
    void sweep(Real dt, Crew& crew);
    void finishMoves(Crew& crew);
    void recordCollisions(Crew& crew);
    void breakJoints(Real dt);
    void findAwake();
    void freezeUnsoundForces();
    /// Is there somebody who could wake somebody?
    bool mayWake() const { return rest_.anyResting() && !bodies_.awake.empty(); }
    bool allSound(Crew& crew) const;
    void freezeUnsoundMotion();

    StepSettings settings_;
    Tolerances tolerances_;
    std::uint64_t stepCount_ = 0;
    std::size_t count_ = 0;
    Bodies bodies_;
    std::vector<FieldEntry> fields_;
    ContactSet contacts_;
    ImpactStage impacts_;
    SoftStep softStep_;
    Propagation propagation_;
    std::size_t contactVisits_ = 0;
    SweepStage sweep_;
    RestStage rest_;
    JointSet joints_;
    std::vector<BrokenJoint> broken_;
    std::vector<BodyId> frozen_;
    std::optional<Aabb> region_;
    std::vector<std::pair<std::uint32_t, Motion>> held_; // what waits, while the solver runs
    std::vector<Contact> aside_;                         // of what waits; see putContactsAside
    std::vector<Contact> returning_;                     // spare, so that a step allocates nothing
    std::vector<std::uint32_t> wereAwake_;               // likewise: before the list was made anew
    std::vector<std::uint32_t> switched_;                // likewise: who began or ceased to be
    std::shared_ptr<const Form> lastForm_;               // equal bodies are usually added in a row
};

} // namespace kodo::inline KODO_PRECISION
