// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/id_pool.hpp>
#include <kodo/bodies/form.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// What a solver reads and writes in every pass: 32 bytes (float) a body and nothing else.
struct Motion {
    Vec2 velocity;            // m/s, of the centre of mass
    Real angularVelocity = 0; // rad/s
    Real invMass = 0;         // 1/kg; 0 for what nothing can push
    Vec2 move;                // m, since the start of the step
    Real turn = 0;            // rad, since the start of the step
    Real invInertia = 0;      // 1/(kg m^2); 0 for what nothing can turn

    /// Forgets where it went in this step, but not its speed.
    void halt() {
        move = {};
        turn = 0;
    }
    bool halted() const { return move == Vec2{} && turn == 0; }
    /// Forgets both.
    void stand() {
        velocity = {};
        angularVelocity = 0;
        halt();
    }
    /// Nothing can move or turn it.
    bool locked() const { return invMass == 0 && invInertia == 0; }
};

/// Constant over a step, from forces and fields.
struct Acceleration {
    Vec2 linear;      // m/s^2
    Real angular = 0; // rad/s^2
    /// m/s^2, the sum of the sizes of all forces, also of those that cancel out. Finite, so that
    /// 0 times it is 0.
    Real effort = 0;
};

/// How much the masses of those awake differ that can be moved, and what forces do to them.
struct Loads {
    Real lightest = 0; // 1/kg, as the next
    Real heaviest = std::numeric_limits<Real>::max();
    Real strongest = 0; // (m/s^2)^2, as the next, which is also of those that can only turn
    Real weakest = std::numeric_limits<Real>::max();
    bool driven = false; // some are locked, and move
};

/// Four numbers that lie side by side, to be counted with at once. Each comes out with the bits
/// that it would have alone.
using Four = Real __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));

/// Velocity x, y, angular velocity, 1/mass.
inline Four& speeds(Motion& motion) {
    static_assert(offsetof(Motion, velocity) == 0 && offsetof(Motion, move) == sizeof(Four));
    return reinterpret_cast<Four&>(motion);
}
inline const Four& speeds(const Motion& motion) {
    return reinterpret_cast<const Four&>(motion);
}
/// Move x, y, turn, 1/inertia.
inline Four& moves(Motion& motion) {
    static_assert(sizeof(Motion) == 2 * sizeof(Four));
    return reinterpret_cast<Four&>(motion.move);
}
inline const Four& moves(const Motion& motion) {
    return reinterpret_cast<const Four&>(motion.move);
}
/// Acceleration x, y, angular acceleration, effort.
inline const Four& rates(const Acceleration& acceleration) {
    static_assert(sizeof(Acceleration) == sizeof(Four));
    return reinterpret_cast<const Four&>(acceleration);
}

/// The rest of a body: read once or twice a step.
struct BodyRecord {
    std::shared_ptr<const Form> form;
    std::uint64_t userData = 0;
    Vec2 force;      // N, since the last step; see addForce
    Real torque = 0; // N m
};

/// How long a body has been calm, and the island that it rests in.
struct RestState {
    static constexpr std::uint32_t kNoIsland = ~std::uint32_t{};

    std::uint32_t calmSteps = 0;
    std::uint32_t island = kNoIsland;
    Transform since; // where it was when it became calm
    /// J, its least kinetic energy since then.
    Real leastEnergy = std::numeric_limits<Real>::max();
};

/// Of the form of a body, at hand for loops over many.
struct Extent {
    Real swing = 0;  // m; a turn by 1 rad takes no outline farther: see Convex
    Real inside = 0; // m; the inner radius of the thinnest part
};

/// All bodies of a World as parallel arrays, indexed by BodyId::index. A dead slot keeps its place
/// with zero velocity and infinite mass.
struct Bodies {
    IdPool ids;
    std::vector<Motion> motion = std::vector<Motion>(1); // and a spare one at the end
    std::vector<Transform> pose;                         // of the centre of mass
    std::vector<Acceleration> acceleration;
    std::vector<Extent> extent = std::vector<Extent>(1); // likewise with a spare one
    std::vector<std::uint32_t> jumps; // how often each was put elsewhere or built anew: jumped()
    /// Since the last step began; or a contact came back that was away while it did.
    std::vector<std::uint8_t> hasJumped;
    std::vector<Vec2> start; // m, of the centre of mass: where each was when the last step began
    std::vector<CollisionFilter> filter; // apart, since who looks for pairs asks all over the World
    std::vector<BodyRecord> record;
    std::vector<const Part*> parts; // of the form of each, which is farther away
    std::vector<RestState> rest;
    std::vector<std::uint32_t> forced; // bodies with a force, some perhaps twice
    /// What a step works on, in order: all that can be pushed and does not rest, and of the locked
    /// bodies those that move. Everything else costs nothing.
    std::vector<std::uint32_t> awake;
    /// m, at most the least Extent::inside of all bodies. It decides who is looked at by the sweep,
    /// so it is part of a snapshot. One line or point makes it 0: then all that moves is looked at.
    Real thinnest = 0;
    Loads loads;             // see noteLoads
    bool awakeStale = true;  // whoever makes a body active or idle says so here
    bool anyRests = true;    // at the time of the solver; false: nobody needs to be asked
    bool turns = true;       // false: nothing can be turned; see Feature::Rotation
    bool startStale = true;  // also of bodies that are not awake
    bool pushesStale = true; // what accelerates whom, a mass, or who is awake has changed
    bool anyJumped = false;  // since the last step began

    BodyId idAt(std::size_t index) const {
        return {static_cast<std::uint32_t>(index), ids.generationAt(index)};
    }
    std::size_t size() const { return record.size(); }
    /// Place of a Motion that belongs to no body and never changes: lanes without work use it.
    std::uint32_t spare() const { return static_cast<std::uint32_t>(record.size()); }

    const Form& form(std::size_t index) const { return *record[index].form; }
    const Convex& outline(std::size_t index, std::size_t part) const {
        return parts[index][part].convex;
    }
    bool locked(std::size_t index) const { return motion[index].locked(); }
    /// Is it locked, and does it move? Nothing stops it, then.
    bool drives(std::size_t index) const { return locked(index) && !motion[index].halted(); }
    bool resting(std::size_t index) const { return (filter[index].flags & kResting) != 0; }
    /// Locked, and neither moving nor having moved in the last step.
    bool stands(std::size_t index) const {
        const Motion& m = motion[index];
        return locked(index) && m.velocity == Vec2{} && m.angularVelocity == 0 &&
               m.move == Vec2{} && m.turn == 0;
    }
    /// What was known of where it touches others is out of date.
    void jumped(std::size_t index) {
        ++jumps[index];
        noteJump(index);
    }
    void noteJump(std::size_t index) {
        hasJumped[index] = 1;
        anyJumped = true;
    }

    /// Takes part in a step.
    bool active(std::size_t index) const {
        return (filter[index].flags & (kResting | kOutside)) == 0 && !stands(index);
    }
    /// Position of the shape's frame, whose origin need not be the centre of mass.
    Vec2 originOf(std::size_t index) const {
        return pose[index].position - pose[index].rotation * form(index).mass.center;
    }
};

/// Adds a body from a valid definition.
BodyId addBody(Bodies& bodies, const BodyDef& def, std::shared_ptr<const Form> form);
void removeBody(Bodies& bodies, std::uint32_t index);

/// Gives a body another form and keeps the world place of its shape's frame.
void setForm(Bodies& bodies, std::uint32_t index, std::shared_ptr<const Form> form);

/// Moves the parts of one body into another, where they are, and keeps momentum and angular
/// momentum of the two as far as `into` is not locked. `part` stays as it is, to be removed.
void weldBodies(Bodies& bodies, std::uint32_t into, std::uint32_t part);

/// Takes one part of a body away and makes a body of it, in its place, with flags of its own. Both
/// move on as they moved together, so momentum and angular momentum are kept. A body keeps at least
/// one part.
BodyId unweldPart(Bodies& bodies, std::uint32_t body, std::size_t part, Flags flags);

/// Adds to the force (N, at the centre of mass) and the torque (N m) of the next step. They last
/// for that one step, whether the body can be pushed in it or not.
void addForce(Bodies& bodies, std::uint32_t body, Vec2 force, Real torque);

/// Stops a body for good that has become unsound: not finite, or faster than kHighestSpeed in a
/// World of that length unit.
void freeze(Bodies& bodies, std::uint32_t body);
inline bool isSound(const Motion& motion, Real lengthUnit) {
    const Real most = kHighestSpeed * lengthUnit;
    return lengthSquared(motion.velocity) <= most * most && // false for NaN
           std::abs(motion.angularVelocity) <= kHighestSpeed &&
           lengthSquared(motion.move) <= most * most && // in a second at the most
           std::abs(motion.turn) <= kHighestSpeed;
}
inline bool isSound(const Acceleration& acceleration) {
    return isFinite(acceleration.linear) && std::isfinite(acceleration.angular);
}

/// Finds who is awake.
void listAwake(Bodies& bodies);
/// The same, if the list is out of date. True if it was.
inline bool refreshAwake(Bodies& bodies) {
    const bool stale = bodies.awakeStale;
    if (stale) {
        listAwake(bodies);
    }
    return stale;
}

/// A step begins where the bodies are.
void noteStart(Bodies& bodies);

/// After a change of form or lock flags: what is told by these, and is at hand for loops over many.
void refreshBuild(Bodies& bodies, std::uint32_t index);

/// Lets bodies turn, or makes all act as if they had kLockRotate and forget their spin.
void setTurns(Bodies& bodies, bool turns);

/// World velocity of the point that an arm (m, from the centre of mass) reaches
/// [Thesis06, eq. 4.5].
inline Vec2 velocityAt(const Motion& motion, Vec2 arm) {
    return motion.velocity + cross(motion.angularVelocity, arm);
}

/// Bounds of all parts, where they are.
Aabb boundsOfBody(const Bodies& bodies, std::size_t body);

/// Changes the velocities as an impulse (N s) at the end of an arm does.
inline void applyImpulse(Motion& motion, Vec2 arm, Vec2 impulse) {
    motion.velocity += motion.invMass * impulse;
    motion.angularVelocity += motion.invInertia * cross(arm, impulse);
}

} // namespace kodo::inline KODO_PRECISION
