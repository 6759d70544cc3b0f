// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/integrate.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/joints/joint_set.hpp>
#include <kodo/solve/prediction.hpp>
#include <kodo/solve/propagation_row.hpp>
#include <kodo/solve/settings.hpp>
#include <kodo/solve/shock_levels.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The thesis's own solver, in its order of processing [Thesis06, 4.2.2.1; Guendelman03]:
///
///   1. collisions are found where the bodies would be after the step, at their predicted poses;
///   2. they are resolved with the velocities from before it, with restitution: what rests has no
///      velocity then, and does not bounce on what it rests on;
///   3. velocities move on by the forces, and contacts are resolved with a restitution that rises
///      from -1 (nothing changes) to 0 (nothing approaches);
///   4. shock propagation, if wanted: the same level by level, from the ground up, with everything
///      below frozen;
///   5. overlapping bodies are separated, and poses move on by the new velocities.
///
/// With more than one substep, each part of the step is processed like that. Every pass visits each
/// contact once, in a stride order of its own.
///
/// The groups that a CollisionRecord speaks of are the impacts and the contacts of each part.
///
/// Where it departs from the thesis: friction is bounded by the normal impulses of all passes;
/// separation works like impulses, so heavy bodies move less and locked ones not at all; a contact
/// may close its gap before it stops its bodies; levels come from the graph of contacts and frozen
/// bodies keep their velocity, so that what stands on a moving platform goes along.
///
/// What frozen bodies cannot show: a pile under shock propagation does not tip over when every
/// single body of it lies well, though the whole leans too far.
class Propagation {
public:
    struct Step {
        const StepSettings& settings;
        const Tolerances& tolerances;
        Real dt;             // s
        std::uint64_t count; // steps of the World so far; numbers the passes
    };

    /// Wants fresh manifolds at the poses of the start. Leaves them with the separations from
    /// before the last part of the step, impulses and moves filled in.
    void solve(Bodies& bodies, std::span<Contact> contacts, JointSet& joints, const Step& step);

    /// How often a pass looked at a contact in the last step: what it cost.
    std::size_t visits() const { return visits_; }

private:
    void predict(const Bodies& bodies, std::span<Contact> contacts, const Prediction& prediction);
    void resolveCollisions(Bodies& bodies, std::span<Contact> contacts, const Step& step, Real h);
    void makeRows(const Bodies& bodies, std::span<Contact> contacts, const Step& step);
    void resolveContacts(Bodies& bodies, JointSet& joints, const JointPass& pass,
                         const StepSettings& settings);
    void findLevels(const Bodies& bodies);
    void sortByLevel(std::uint32_t highest);
    void propagateShock(Bodies& bodies, const StepSettings& settings, Real invH);
    void separate(Bodies& bodies, const Step& step, Real h);
    void markHeld(const Bodies& bodies, const JointSet& joints, Real h, Real slop);
    void store(std::span<Contact> contacts);

    template <typename Visit>
    void forEachRow(Visit visit);
    template <typename Visit>
    void forEachLevel(int passes, Visit visit);

    std::vector<PropagationRow> rows_;
    std::vector<std::array<Real, 2>> gaps_; // by contact: at the start of the part
    std::vector<std::uint32_t> struck_;     // contacts that collisions are looked for in
    std::vector<Parting> parting_;          // by body
    std::vector<Hold> holds_;               // by body
    std::vector<std::uint32_t> node_;       // by body: its place in the graph of contacts
    std::vector<std::uint32_t> immovable_;  // nodes
    std::vector<SupportEdge> supports_;     // between nodes
    std::vector<std::uint32_t> levelOf_;    // by body, as far as rows name it
    std::vector<std::uint32_t> levelStart_; // by level: where its rows begin in byLevel_
    std::vector<std::uint32_t> byLevel_;    // rows, from level 1 up
    ShockLevels levels_;
    std::uint64_t pass_ = 0; // number of the current pass; follows from Step::count
    std::size_t visits_ = 0;
};

} // namespace kodo::inline KODO_PRECISION
