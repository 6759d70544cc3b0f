// SPDX-License-Identifier: MIT
#pragma once

#include "base/disjoint_sets.hpp"
#include "bodies/integrate.hpp"
#include "joints/step_input.hpp"

#include <span>
#include <vector>

#include "propagation/prediction.hpp"
#include "propagation/propagation_row.hpp"
#include "propagation/shock_levels.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The solver of the thesis, in its order of processing [Thesis06, 4.2.2.1; Guendelman03]:
///
///   1. Collisions are found at the predicted poses after the step.
///   2. They are solved with restitution and the velocities before the step. Bodies at rest have no
///      velocity then and do not bounce.
///   3. Forces change the velocities. Contacts are solved with a restitution that rises from -1 (no
///      change) to 0 (no approach).
///   4. Optional shock propagation does the same level by level, from the ground up, with all lower
///      bodies frozen.
///   5. Overlaps are separated, and poses change by the new velocities. Of an island in which a gap
///      has closed, the contacts are solved once more: a blow comes whole in its substep.
///
/// Each substep is processed like that. Every pass visits each contact of an island once, in a
/// StrideOrder of its own. The groups of a CollisionRecord are the impacts and the contacts of each
/// substep.
///
/// Differences from the thesis: The normal impulses of all passes bound the friction. Separation
/// works like impulses, so heavy bodies move less and locked bodies not at all. A contact lets
/// its gap close before it stops its bodies. Levels come from the contact graph. Frozen bodies keep
/// their velocity, so bodies on a moving platform move along.
///
/// Limit of frozen bodies: a leaning pile under shock propagation does not tip over as a whole
/// while each single body is stable.
class Propagation {
public:
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies);
    /// Needs fresh manifolds at the start poses. Leaves them with the separations before the last
    /// substep, and with impulses. Bodies get their displacements.
    void solve(const StepInput& step);

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    enum class Stage : std::uint8_t { Impacts, Contacts, Shock, Separation, SeparationShock };
    static constexpr std::uint64_t kStages = 5;
    struct PassNumber {
        Stage stage;
        std::uint32_t pass; // within the stage
    };
    /// Rows of an island and a level: a range of byLevel_.
    struct LevelRows {
        std::uint32_t first;
        std::uint32_t end;
        std::uint32_t level;
    };

    /// The largest impulse of a contact in the substeps so far, with the manifold it acted at.
    struct StrongestGroup {
        Real impulse = 0; // N s, of both points
        Manifold manifold;
        Vec2 centerA; // m, see Contact::centerA
    };

    std::uint64_t numberOf(PassNumber number) const {
        return (substep_ * kStages + static_cast<std::uint64_t>(number.stage)) << 32 | number.pass;
    }
    void findIslands(const Bodies& bodies, const ContactSet& contactSet, const JointSet& joints);
    template <typename List, typename Visit>
    void fillByIsland(const List& list, std::vector<std::uint32_t>& ends, Visit visit);
    void addRow(const Bodies& bodies, const Contact& contact, std::uint32_t slot,
                const StepSettings& settings);
    void predict(const Bodies& bodies, ContactStore& store, const Prediction& prediction);
    void resolveCollisions(Bodies& bodies, ContactStore& store, const StepInput& step, Real h);
    void makeRows(Bodies& bodies, ContactStore& store, const JointLists& joints,
                  const StepInput& step, Real h);
    void resolveContacts(Bodies& bodies, JointSet& joints, const JointPass& pass,
                         const PropagationSettings& settings);
    void findLevels(const Bodies& bodies);
    void sortByLevel();
    void propagateShock(Bodies& bodies, const PropagationSettings& settings, Real invH);
    void separate(Bodies& bodies, const StepInput& step, Real h);
    RowMasses frozenMasses(const Bodies& bodies, const PropagationRow& row) const;
    void markExposure(const Bodies& bodies, const JointLists& joints, Real h, Real slop);
    bool findArrivals(const Bodies& bodies, Real h);
    void relax(Bodies& bodies, JointSet& joints, JointPass pass,
               const PropagationSettings& settings);
    void store(ContactStore& contacts);
    void findStrongest(ContactStore& store);
    void restoreStrongest(ContactStore& store) const;

    template <typename Visit>
    void forEachIn(std::span<const std::uint32_t> ends, PassNumber number, Visit visit);
    template <typename Visit>
    void forEachRow(Stage stage, int pass, Visit visit);
    template <typename Visit>
    void forEachLevel(Stage stage, int passes, Visit visit);

    DisjointSets islands_;                  // of the awake bodies
    std::vector<std::uint32_t> numbers_;    // by root: number of the island
    std::vector<std::uint32_t> byIsland_;   // slots of contacts that may get impulses
    std::vector<std::uint32_t> ends_;       // by island: its end in byIsland_
    std::vector<PropagationRow> rows_;      // by island
    std::vector<std::uint32_t> rowEnds_;    // by island: its end in rows_
    std::vector<std::array<Real, 2>> gaps_; // by contact: m, at the start of the substep
    std::vector<StrongestGroup> strongest_; // by contact, with several substeps
    std::vector<std::uint32_t> struck_;     // contacts that are tested for impacts, by island
    std::vector<std::uint32_t> struckEnds_; // by island: its end in struck_
    std::vector<SeparationShift> parting_;  // by body
    std::vector<ContactExposure> exposure_; // by body
    std::vector<std::uint32_t> node_;       // by body: its node in the contact graph
    std::vector<std::uint32_t> immovable_;  // nodes
    std::vector<SupportEdge> supports_;     // between nodes
    std::vector<std::uint32_t> levelOf_;    // by body, for bodies with rows
    std::vector<std::uint32_t> byLevel_;    // rows that the ground supports, by island and level
    std::vector<LevelRows> levelRows_;
    ShockLevels levels_;
    std::uint64_t substep_ = 0; // number of the current one; follows from StepInput::count
    std::size_t visits_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
