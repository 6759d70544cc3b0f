// SPDX-License-Identifier: MIT
#include "propagation/propagation.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>
#include <utility>

#include "impacts/departure.hpp"
#include "impacts/impact_solver.hpp"
#include "lanes/leverage.hpp"
#include "propagation/stride_order.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// A row that separates its bodies by less than this share of the slop within h does not count as
// touching. Its impulse may be a remnant of an underflowed speed, which other length units would
// round to zero.
constexpr Real kLeastHold = Real(1e-9);
// Passes over the contacts of joints and arrivals, after the displacements.
constexpr int kRelaxPasses = 4;
// Passes over the displacements that close joints. With two, a chain of 21 over a peg opens by 0.24
// instead of 0.06 m at 30 Hz.
constexpr int kCorrectionPasses = 4;

bool bounces(const Contact& contact, const StepSettings& settings) {
    return contact.material.restitution > 0 && settings.has(Feature::Restitution);
}

/// True for contacts without impulses: sensors, hidden contacts and those of inactive bodies. A
/// touch would have woken an inactive body.
bool leftAlone(const Bodies& bodies, const Contact& contact) {
    const auto idle = [&](std::uint32_t body) {
        return !bodies.active(body) && !bodies.locked(body);
    };
    return contact.sensor || contact.hidden || idle(contact.key.bodyA) || idle(contact.key.bodyB);
}

} // namespace

/// Visits a list island by island, each in an order of its own. `ends` has the end of each island.
template <typename Visit>
void Propagation::forEachIn(std::span<const std::uint32_t> ends, PassNumber number, Visit visit) {
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends) {
        StrideOrder order(end - first, numberOf(number));
        for (std::uint32_t k = first; k < end; ++k) {
            visit(first + order.next());
        }
        first = end;
    }
    visits_ += first;
}

/// Visits all rows in each of `passes` passes.
template <typename Visit>
void Propagation::forEachRow(Stage stage, int pass, Visit visit) {
    forEachIn(rowEnds_, {stage, static_cast<std::uint32_t>(pass)},
              [&](std::size_t k) { visit(rows_[k]); });
}

/// Of each island, visits the rows of level 1 `passes` times, then those of level 2, and so on.
template <typename Visit>
void Propagation::forEachLevel(Stage stage, int passes, Visit visit) {
    for (const LevelRows& range : levelRows_) {
        for (int pass = 0; pass < passes; ++pass) {
            const auto number =
                range.level * static_cast<std::uint32_t>(passes) + static_cast<std::uint32_t>(pass);
            StrideOrder order(range.end - range.first, numberOf({stage, number}));
            for (std::uint32_t k = range.first; k < range.end; ++k) {
                visit(rows_[byLevel_[range.first + order.next()]]);
            }
        }
        visits_ += (range.end - range.first) * static_cast<std::size_t>(passes);
    }
}

/// Predicts the contacts at the end of the substep; gaps_ gets the separations at its start.
void Propagation::predict(const Bodies& bodies, ContactStore& store, const Prediction& prediction) {
    const std::span<Contact> contacts = store.contacts();
    gaps_.resize(contacts.size());
    for (std::uint32_t k = 0; k < contacts.size(); ++k) {
        // Ghost collisions, which have a normal, are those at the predicted poses.
        contacts[k].hidden = contacts[k].hidden && contacts[k].manifold.normal == Vec2{};
        if (!leftAlone(bodies, contacts[k])) {
            gaps_[k] = predictContact(contacts[k], store.lane(k), bodies, prediction);
        }
    }
}

/// Lists the contacts that may get impulses, island by island, in the order of their keys. So the
/// order of the passes of one island does not depend on another.
void Propagation::findIslands(const Bodies& bodies, const ContactSet& contactSet,
                              const JointSet& joints) {
    const std::span<const Contact> contacts = contactSet.contacts();
    for (const std::uint32_t body : bodies.awake) {
        islands_.makeSet(body);
        numbers_[body] = kNone;
    }
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (bodies.active(a) && bodies.active(b) && !bodies.locked(a) && !bodies.locked(b)) {
            islands_.join(a, b);
        }
    };
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        join(firstBody(joint.def).index, secondBody(joint.def).index);
    });
    const auto takesPart = [&](const Contact& contact) {
        return contact.manifold.count > 0 && !leftAlone(bodies, contact) &&
               !(bodies.locked(contact.key.bodyA) && bodies.locked(contact.key.bodyB));
    };
    for (const Contact& contact : contacts) {
        if (takesPart(contact)) {
            join(contact.key.bodyA, contact.key.bodyB);
        }
    }
    const auto islandOf = [&](const Contact& contact) -> std::uint32_t& {
        const std::uint32_t body =
            bodies.locked(contact.key.bodyA) ? contact.key.bodyB : contact.key.bodyA;
        return numbers_[islands_.rootOf(body)];
    };
    ends_.clear(); // at first the numbers of contacts
    contactSet.store().forEachInOrder([&](std::uint32_t slot) {
        if (takesPart(contacts[slot])) {
            std::uint32_t& island = islandOf(contacts[slot]);
            if (island == kNone) {
                island = static_cast<std::uint32_t>(ends_.size());
                ends_.push_back(0);
            }
            ++ends_[island];
        }
    });
    std::uint32_t sum = 0;
    for (std::uint32_t& end : ends_) {
        sum += std::exchange(end, sum); // the begin of the island, until it is filled
    }
    reserveReusing(byIsland_, contacts.size());
    byIsland_.resize(sum);
    contactSet.store().forEachInOrder([&](std::uint32_t slot) {
        if (takesPart(contacts[slot])) {
            byIsland_[ends_[islandOf(contacts[slot])]++] = slot;
        }
    });
}

/// Calls visit(slot) for the contacts of findIslands. `list` grows by it; its ends of islands are
/// stored in `ends`.
template <typename List, typename Visit>
void Propagation::fillByIsland(const List& list, std::vector<std::uint32_t>& ends, Visit visit) {
    ends.clear();
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends_) {
        for (; first < end; ++first) {
            visit(byIsland_[first]);
        }
        ends.push_back(static_cast<std::uint32_t>(list.size()));
    }
}

/// A contact with restitution is solved where it will touch. A contact without is solved once it
/// touches; until then the contact passes let it close the gap.
void Propagation::resolveCollisions(Bodies& bodies, ContactStore& store, const StepInput& step,
                                    Real h) {
    const std::span<Contact> contacts = store.contacts();
    struck_.clear();
    reserveReusing(struck_, contacts.size()); // capacity for an impact of many
    if (!step.settings.has(Feature::Restitution)) {
        return;
    }
    fillByIsland(struck_, struckEnds_, [&](std::uint32_t k) {
        if (bounces(contacts[k], step.settings) || gaps_[k][0] <= step.tolerances.slop) {
            struck_.push_back(k);
        }
    });
    bool any = !struck_.empty();
    for (int pass = 0;
         pass < step.solver<PropagationSettings>().impactPasses && std::exchange(any, false);
         ++pass) {
        forEachIn(struckEnds_, {Stage::Impacts, static_cast<std::uint32_t>(pass)},
                  [&](std::size_t k) {
                      any = solveImpact(bodies, contacts[struck_[k]], store.lane(struck_[k]),
                                        step.settings, step.tolerances, h) ||
                            any;
                  });
    }
}

/// Makes rows for contacts that may touch. A contact with restitution gets none before it touches,
/// or between two impacts: braking would reduce its rebound. Where joints hold a body, the passes
/// need more than a step to find its impulses: a parked car crept by 6 mm/s. The impulse of a blow
/// would come again, so a contact starts with impulses only while its bodies rest against it.
void Propagation::makeRows(Bodies& bodies, ContactStore& store, const JointLists& joints,
                           const StepInput& step, Real h) {
    const std::span<const Contact> contacts = store.contacts();
    rows_.clear();
    reserveReusing(rows_, contacts.size());
    fillByIsland(rows_, rowEnds_, [&](std::uint32_t k) {
        const Contact& contact = contacts[k];
        const ContactLane lane = store.lane(k);
        const Real slop = step.tolerances.slop;
        const bool held = isJointed(bodies, joints, contact.key);
        const bool waits =
            bounces(contact, step.settings) &&
            (lane.separation(0) > slop ||
             departureOf(bodies, store, k, !held, slop, h) == Departure::BetweenImpacts);
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
            lane.separation(i) = gaps_[k][i];
        }
        if (!waits) {
            addRow(bodies, contact, k, step.settings);
            rows_.back().again = held;
            if (held) {
                warmStart(rows_.back(), lane, bodies, h);
            }
        }
    });
}

void Propagation::addRow(const Bodies& bodies, const Contact& contact, std::uint32_t slot,
                         const StepSettings& settings) {
    rows_.push_back(makeRow(contact, slot));
    PropagationRow& row = rows_.back();
    for (std::size_t i = 0; i < row.count; ++i) {
        row.points[i].gap = gaps_[slot][i];
        if (isBlocked(bodies, contact, i)) {
            row.points[i].leverA = row.points[i].leverB = 0;
        }
    }
    if (settings.has(Feature::Friction)) {
        row.staticFriction = contact.material.staticFriction;
        row.kineticFriction = contact.material.kineticFriction;
        row.surfaceSpeed = contact.material.surfaceSpeed;
    }
    if (settings.has(Feature::RollingResistance)) {
        row.rollingLever = rollingLever(contact, bodies.motion[row.a], bodies.motion[row.b]);
    }
}

void Propagation::resolveContacts(Bodies& bodies, JointSet& joints, const JointPass& pass,
                                  const PropagationSettings& settings) {
    for (int k = 1; k <= settings.contactPasses; ++k) {
        const Real fraction = static_cast<Real>(k) / static_cast<Real>(settings.contactPasses);
        joints.solve(bodies, pass);
        forEachRow(Stage::Contacts, k, [&](PropagationRow& row) {
            solveRow(row, bodies, massesOf(bodies, row), fraction, 1 / pass.h);
        });
    }
}

void Propagation::propagateShock(Bodies& bodies, const PropagationSettings& settings, Real invH) {
    forEachLevel(Stage::Shock, settings.shockPasses, [&](PropagationRow& row) {
        solveRow(row, bodies, frozenMasses(bodies, row), 1, invH);
    });
}

void Propagation::separate(Bodies& bodies, const StepInput& step, Real h) {
    const PropagationSettings& settings = step.solver<PropagationSettings>();
    const Real unit = step.tolerances.slop * Tolerances::kSlopsPerUnit;
    const SeparationLimits limits{step.tolerances.slop / 4, settings.pushSpeed * unit * h};
    const bool any = std::any_of(rows_.begin(), rows_.end(), [&](const PropagationRow& row) {
        return std::min(row.points[0].gap, row.points[row.count - 1].gap) < -limits.allowed;
    });
    if (!any) {
        return;
    }
    for (const PropagationRow& row : rows_) {
        parting_[row.a] = parting_[row.b] = {};
    }
    for (int pass = 0; pass < settings.contactPasses; ++pass) {
        forEachRow(Stage::Separation, pass, [&](PropagationRow& row) {
            separateRow(row, parting_, massesOf(bodies, row), limits);
        });
    }
    if (settings.shockPasses > 0) {
        forEachLevel(Stage::SeparationShock, settings.shockPasses, [&](PropagationRow& row) {
            separateRow(row, parting_, frozenMasses(bodies, row), limits);
        });
    }
    for (const PropagationRow& row : rows_) {
        for (const std::uint32_t body : {row.a, row.b}) { // applied once, then cleared
            const Real way = length(parting_[body].deltaPosition);
            if (way > limits.most) { // in a crowd
                parting_[body].deltaPosition *= limits.most / way;
                parting_[body].deltaAngle *= limits.most / way;
            }
            bodies.motion[body].deltaPosition += parting_[body].deltaPosition;
            bodies.motion[body].deltaAngle += parting_[body].deltaAngle;
            parting_[body] = {};
        }
    }
}

/// Bodies with a joint or a noticeable impulse of a row move by their velocity, all others in free
/// flight.
void Propagation::markExposure(const Bodies& bodies, const JointLists& joints, Real h, Real slop) {
    for (const std::uint32_t body : bodies.awake) {
        const bool held = !bodies.locked(body) && joints.hasAny(body);
        exposure_[body] = held ? ContactExposure::Touched : ContactExposure::Free;
    }
    for (const PropagationRow& row : rows_) {
        const RowMasses masses = massesOf(bodies, row);
        Real parted = 0; // m/s
        for (std::size_t i = 0; i < row.count; ++i) {
            parted += row.impulse[i] * masses.response(row.points[i].leverA, row.points[i].leverB);
        }
        if (h * parted > kLeastHold * slop) {
            exposure_[row.a] = exposure_[row.b] = ContactExposure::Touched;
        }
    }
}

/// After the displacements: what has arrived stops, and the velocity that the errors of trees and
/// limits have added is removed. Where contacts of their bodies resisted it, their impulses are
/// taken back as well. Otherwise the bodies would leave at that velocity.
void Propagation::relax(Bodies& bodies, JointSet& joints, JointPass pass,
                        const PropagationSettings& settings) {
    const bool arrived = findArrivals(bodies, pass.h);
    if (joints.awakeCount() == 0 && !arrived) {
        return;
    }
    for (int k = 0; k <= kRelaxPasses; ++k) {
        if (k > 0) {
            forEachRow(Stage::Contacts, settings.contactPasses + k, [&](PropagationRow& row) {
                if (row.again) {
                    solveRow(row, bodies, massesOf(bodies, row), 1, 1 / pass.h);
                }
            });
        }
        pass.last = k == kRelaxPasses;
        joints.solve(bodies, pass);
    }
}

void Propagation::solve(const StepInput& step) {
    Bodies& bodies = step.bodies;
    ContactSet& contactSet = step.contactSet;
    JointSet& joints = step.joints;
    contactSet.leavePasses(bodies);
    ContactStore& store = contactSet.store();
    const PropagationSettings& settings = step.solver<PropagationSettings>();
    const Real h = step.dt / static_cast<Real>(settings.substeps);
    JointPass pass{.h = h,
                   .stiff = Softness::from(settings.jointHertz, settings.jointDamping, h),
                   .biased = true,
                   .errors = ErrorRemoval::ByDisplacement,
                   .mostBias = settings.pushSpeed * step.tolerances.unit()};
    const bool several = settings.substeps > 1;
    if (several) {
        assignReusing(strongest_, store.size(), StrongestGroup{});
    }
    visits_ = 0;
    joints.beginStep();
    joints.boundBias(contactSet, step.tolerances.slop, pass.mostBias);
    joints.beginGroup(bodies, 0);
    for (int part = 0; part < settings.substeps; ++part) {
        substep_ = step.count * static_cast<std::uint64_t>(settings.substeps) +
                   static_cast<std::uint64_t>(part);
        predict(bodies, store,
                {step.tolerances, h, step.settings.has(Feature::ContinuousCollision), part == 0});
        contactSet.hidePredicted(bodies, step.tolerances);
        findIslands(bodies, contactSet, joints);
        resolveCollisions(bodies, store, step, h);
        integrateVelocities(bodies, bodies.awake, h);
        pass.biased = true;
        makeRows(bodies, store, joints.lists(), step, h);
        joints.warmStart(bodies, pass);
        resolveContacts(bodies, joints, pass, settings);
        if (settings.shockPasses > 0) {
            findLevels(bodies);
            propagateShock(bodies, settings, 1 / h);
        }
        separate(bodies, step, h);
        markExposure(bodies, joints.lists(), h, step.tolerances.slop);
        integrateMoves(bodies, bodies.awake, exposure_, h);
        joints.correct(bodies, pass, kCorrectionPasses, step.tolerances.slop);
        pass.biased = false;
        relax(bodies, joints, pass, settings);
        if (several) {
            findStrongest(store);
        }
        this->store(store);
    }
    if (several) {
        restoreStrongest(store);
    }
    for (std::uint32_t slot = 0; slot < store.size(); ++slot) {
        contactSet.manifoldChanged(slot);
    }
    step.work.contacts = visits_;
}

} // namespace KODO_PRECISION
} // namespace kodo
