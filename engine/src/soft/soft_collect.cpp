// SPDX-License-Identifier: MIT
// The collection of the contacts of a step: new rows, leaving ones, and crowds.
#include "base/prefetch.hpp"

#include <algorithm>

#include "impacts/departure.hpp"
#include "soft/soft_solver.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kNewcomersPerPiece = 128;
constexpr std::size_t kMany = 8; // with a larger part of bodies awake, whole arrays are cleared

/// 0 for two bodies of rank 0.
std::uint32_t hashOf(std::uint32_t rankA, std::uint32_t rankB) {
    std::uint32_t hash = rankA * 0x9e3779b1u ^ rankB * 0x85ebca77u;
    hash = (hash ^ hash >> 16) * 0x7feb352du;
    hash = (hash ^ hash >> 15) * 0x846ca68bu;
    return hash ^ hash >> 16;
}

/// True if nothing contradicts that the contact is kept.
[[maybe_unused]] bool mayBeKept(const Contact& contact, const ContactSummary& summary) {
    return contact.filled && contact.responds() && summary.inPasses() &&
           summary.row.colour != ContactRow::kNoColour;
}

} // namespace

/// Clears the marks of all bodies, then marks those with joints.
void SoftSolver::clearMarks(const Bodies& bodies, const JointSet& joints) {
    anyCrowded_ = 0;
    if (kMany * bodies.awake.size() > bodies.size()) {
        std::fill(overlapCount_.begin(), overlapCount_.end(), std::uint16_t{0});
        std::fill(near_.begin(), near_.end(), std::uint8_t{0});
        std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
    } else {
        for (const std::uint32_t body : bodies.awake) {
            near_[body] = 0;
            touched_[body] = 0;
            overlapCount_[body] = 0;
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        touched_[firstBody(joint.def).index] = 1;
        touched_[secondBody(joint.def).index] = 1;
    });
}

/// Takes a contact for which keep() does not suffice. Contacts that need another lane are added to
/// `newcomers`.
void SoftSolver::takeNewcomer(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place,
                              bool friction, std::vector<std::uint32_t>& newcomers) {
    if (!friction) {
        contactSet.store().lane(place).friction() = 0; // from a step with friction
    }
    if (!contactSet.lanes().take(bodies, contactSet.store().entry(place))) {
        newcomers.push_back(place);
    }
}

/// Prepares the collection of contacts in a step.
void SoftSolver::beginCollecting(const StepInput& step) {
    ContactStore& store = step.contactSet.store();
    const std::uint32_t partitions = step.team.partitions();
    ContactBlocks& blocks = store.lanes();
    bool shared = false;
    for (std::uint32_t level = 0; partitions > 1 && level < ContactBlocks::kLevels; ++level) {
        shared = shared || blocks.worthPartitioning(level);
    }
    if (blocks.countReorder() || (shared && blocks.partitions().count() != partitions)) {
        blocks.rebuildGraph(step.bodies, store.all(), store.slotsInOrder(),
                            shared ? partitions : 1);
    }
    blocks.begin(store.all(), step.settings.has(Feature::Friction),
                 step.settings.has(Feature::RollingResistance));
    clearMarks(step.bodies, step.joints);
    newcomers_.clear();
}

/// Finds how the bodies of contacts with restitution part. Before any contact moves to another
/// lane, since each of these looks at the contacts of its bodies.
void SoftSolver::findDepartures(const StepInput& step) {
    if (!step.contactSet.mayBounce() || !step.settings.has(Feature::Restitution)) {
        return;
    }
    ContactStore& store = step.contactSet.store();
    const std::span<const std::uint32_t> live = step.contactSet.live();
    const Real slop = step.tolerances.slop;
    departures_.resize(store.contacts().size());
    step.team.forEach(live.size(), kNewcomersPerPiece, [&](std::size_t from, std::size_t to) {
        for (const std::uint32_t place : live.subspan(from, to - from)) {
            if (step.contactSet.summaries()[place].bounces &&
                needsRow(step.bodies, store, place, true, slop)) {
                const bool held =
                    isJointed(step.bodies, step.joints.lists(), store.contacts()[place].key);
                const bool deep = store.separation(place) <= -slop / 2; // it would sink on
                departures_[place] =
                    departureOf(step.bodies, store, place, !held && !deep, slop, step.dt);
            }
        }
    });
}

/// Collects the contacts for the blocks, and marks bodies that are touched or crowded. A body
/// inside a heap is separated from many others, and those behind it add to this. Together they must
/// not exceed the push speed of one contact, or the heap would burst.
void SoftSolver::collect(const StepInput& step) {
    const std::span<const std::uint32_t> live = step.contactSet.live();
    beginCollecting(step);
    findDepartures(step);
    found_.gather(step.team, live.size(), kNewcomersPerPiece, newcomers_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& newcomers) {
                      forPieces(first, last, kNewcomersPerPiece, [&](auto from, auto to) {
                          collectPiece(step, live.subspan(from, to - from), newcomers);
                      });
                  });
}

/// Marks both bodies as touched or near, and counts deep overlaps. A body that leaves is only near,
/// so it follows its parabola from the impact on.
inline void SoftSolver::markExposure(const StepInput& step, std::uint32_t place, bool leaves) {
    const ContactSummary& summary = step.contactSet.summaries()[place];
    const Bodies& bodies = step.bodies;
    const WorkerTeam& team = step.team;
    const Real slop = step.tolerances.slop;
    const Real separation = step.contactSet.store().separation(place);
    std::uint8_t* const marks = separation <= slop && !leaves ? touched_.data() : near_.data();
    WorkerTeam::mark(marks[summary.bodyA]);
    WorkerTeam::mark(marks[summary.bodyB]);
    if (separation < -4 * slop) {
        countOverlap(bodies, summary, team);
    }
}

/// First the kept contacts, by their summaries alone, then the others.
void SoftSolver::collectPiece(const StepInput& step, std::span<const std::uint32_t> places,
                              std::vector<std::uint32_t>& newcomers) {
    const Bodies& bodies = step.bodies;
    ContactSet& contactSet = step.contactSet;
    const std::span<Contact> contacts = contactSet.contacts();
    // local copies, since a byte store may alias the originals
    const ContactSummary* const summaryOf = contactSet.summaries().data();
    const bool friction = step.settings.has(Feature::Friction);
    const bool restitution = step.settings.has(Feature::Restitution);
    ContactStore& store = contactSet.store();
    ContactBlocks& blocks = store.lanes();
    const bool keeps = friction && blocks.keepsLanes();
    const Real slop = step.tolerances.slop;
    PrefetchList<kNewcomersPerPiece> visited;
    for (const std::uint32_t place : places) {
        const ContactSummary& summary = summaryOf[place];
        const bool bounces = summary.bounces && restitution; // it may be between two impacts
        if (keeps && summary.kept && !bounces && needsRow(bodies, store, place, false, slop)) {
            KODO_ASSERT(mayBeKept(contacts[place], summary));
            blocks.keep(summary.row.index);
            markExposure(step, place, false);
        } else if (!keeps || summary.mayTouch || summary.inPasses()) {
            visited.add(place);
        }
    }
    visitPrefetched<3>(visited.list(), contacts, [&](std::uint32_t place) {
        if (!needsRow(bodies, store, place, restitution, slop) || !contacts[place].responds()) {
            store.leavePasses(place, bodies);
            return;
        }
        const Departure departure = restitution && contacts[place].bounces
                                        ? departures_[place]
                                        : departureOf(bodies, store, place, false, slop, step.dt);
        if (departure == Departure::BetweenImpacts) {
            store.leavePasses(place, bodies);
            store.lane(place).clearImpulses();
        } else {
            takeNewcomer(bodies, contactSet, place, friction, newcomers);
        }
        markExposure(step, place, departure != Departure::None);
    });
}

/// Counts an overlap beyond four slops for both bodies.
void SoftSolver::countOverlap(const Bodies& bodies, const ContactSummary& summary,
                              const WorkerTeam& team) {
    for (const std::uint32_t body : {summary.bodyA, summary.bodyB}) {
        if (bodies.locked(body)) {
            continue;
        }
        const auto count = static_cast<std::uint16_t>(team.count(overlapCount_[body]) + 1);
        if (count > ContactBlocks::kNeighbours) {
            WorkerTeam::mark(anyCrowded_);
        }
    }
}

/// After a step with a crowd: what becomes inactive or immovable before the next one counts
/// nothing.
void SoftSolver::clearOverlapCounts(ContactSet& contactSet) {
    for (const std::uint32_t place : contactSet.live()) {
        const ContactSummary& summary = contactSet.summaries()[place];
        overlapCount_[summary.bodyA] = overlapCount_[summary.bodyB] = 0;
    }
}

/// In a crowd, drops new contacts without a colour, so that about kMostOverlaps of a body are left:
/// always the same, by a hash of the ranks. The others follow as the crowd thins out.
void SoftSolver::limitOverlaps(Bodies& bodies, ContactSet& contactSet) {
    std::erase_if(newcomers_, [&](std::uint32_t place) {
        const ContactSummary& summary = contactSet.summaries()[place];
        const std::uint32_t bodyA = summary.bodyA;
        const std::uint32_t bodyB = summary.bodyB;
        if (summary.row.colour != ContactRow::kNoColour || bodies.locked(bodyA) ||
            bodies.locked(bodyB)) {
            return false;
        }
        constexpr std::uint32_t kMost = ContactBlocks::kMostOverlaps;
        const std::uint32_t crowd = std::max(overlapCount_[bodyA], overlapCount_[bodyB]);
        const std::uint32_t hash =
            hashOf(bodies.record[bodyA].crowdRank, bodies.record[bodyB].crowdRank);
        const bool drops = crowd > kMost && hash % crowd >= kMost;
        if (drops) {
            contactSet.store().leavePasses(place, bodies);
        }
        return drops;
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
