// SPDX-License-Identifier: MIT
#include "solve/propagation.hpp"

#include "base/vector_reuse.hpp"
#include "bodies/integrate.hpp"
#include "solve/impact_solver.hpp"
#include "solve/leverage.hpp"
#include "solve/stride_order.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint64_t kPassesPerStep = 1u << 20; // above the passes of any usual step
// A contact supports a body only if its normal has a larger share than this along the acceleration.
constexpr Real kSteep = Real(0.25);
// A row that separates its bodies by less than this share of the slop within h does not count as
// touching. Its impulse may be a remnant of an underflowed speed, which other length units would
// round to zero.
constexpr Real kLeastHold = Real(1e-9);

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

RowMasses massesOf(const Bodies& bodies, const PropagationRow& row, bool frozenA, bool frozenB) {
    const BodyVelocity& a = bodies.motion[row.a];
    const BodyVelocity& b = bodies.motion[row.b];
    return {frozenA ? 0 : a.invMass, frozenA ? 0 : a.invInertia, frozenB ? 0 : b.invMass,
            frozenB ? 0 : b.invInertia};
}

} // namespace

template <typename Visit>
void Propagation::forEachRow(Visit visit) {
    StrideOrder order(rows_.size(), ++pass_);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        visit(rows_[order.next()]);
    }
    visits_ += rows_.size();
}

/// Visits the rows of level 1 `passes` times, then those of level 2, and so on.
template <typename Visit>
void Propagation::forEachLevel(int passes, Visit visit) {
    for (std::size_t level = 1; level + 1 < levelStart_.size(); ++level) {
        const std::size_t first = levelStart_[level];
        const std::size_t count = levelStart_[level + 1] - first;
        for (int pass = 0; pass < passes; ++pass) {
            StrideOrder order(count, ++pass_);
            for (std::size_t k = 0; k < count; ++k) {
                visit(rows_[byLevel_[first + order.next()]]);
            }
        }
        visits_ += count * static_cast<std::size_t>(passes);
    }
}

/// Predicts the contacts at the end of the substep; gaps_ gets the separations at its start.
void Propagation::predict(const Bodies& bodies, std::span<Contact> contacts,
                          const Prediction& prediction) {
    gaps_.resize(contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (!leftAlone(bodies, contacts[k])) {
            gaps_[k] = predictContact(contacts[k], bodies, prediction);
        }
    }
}

/// A contact with restitution is solved where it will touch. A contact without is solved once it
/// touches; until then the contact passes let it close the gap.
void Propagation::resolveCollisions(Bodies& bodies, std::span<Contact> contacts, const Step& step,
                                    Real h) {
    struck_.clear();
    reserveReusing(struck_, contacts.size()); // capacity for an impact of many
    if (!step.settings.has(Feature::Restitution)) {
        return;
    }
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& contact = contacts[k];
        const bool now = bounces(contact, step.settings) || gaps_[k][0] <= step.tolerances.slop;
        if (contact.manifold.count > 0 && now && !leftAlone(bodies, contact)) {
            struck_.push_back(static_cast<std::uint32_t>(k));
        }
    }
    bool any = !struck_.empty();
    for (int pass = 0; pass < step.own().impactPasses && any; ++pass) {
        any = false;
        StrideOrder order(struck_.size(), ++pass_);
        for (std::size_t k = 0; k < struck_.size(); ++k) {
            Contact& contact = contacts[struck_[order.next()]];
            any = solveImpact(bodies, contact, step.settings, step.tolerances, h) || any;
        }
        visits_ += struck_.size();
    }
}

/// Makes rows for contacts that may touch. A contact with restitution gets none before it touches:
/// braking would reduce its rebound.
void Propagation::makeRows(const Bodies& bodies, std::span<Contact> contacts, const Step& step) {
    rows_.clear();
    reserveReusing(rows_, contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        Contact& contact = contacts[k];
        if (contact.manifold.count == 0 || leftAlone(bodies, contact)) {
            continue;
        }
        const bool touches = contact.manifold.points[0].separation <= step.tolerances.slop;
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
            contact.manifold.points[i].separation = gaps_[k][i];
        }
        if (!touches && bounces(contact, step.settings)) {
            continue;
        }
        rows_.push_back(makeRow(contact, static_cast<std::uint32_t>(k)));
        PropagationRow& row = rows_.back();
        for (std::size_t i = 0; i < row.count; ++i) {
            if (isBlocked(bodies, contact, i)) {
                row.points[i].leverA = row.points[i].leverB = 0;
            }
        }
        if (step.settings.has(Feature::Friction)) {
            row.staticFriction = contact.material.staticFriction;
            row.kineticFriction = contact.material.kineticFriction;
        }
        if (step.settings.has(Feature::RollingResistance)) {
            row.rollingLever = rollingLever(contact, bodies.motion[row.a], bodies.motion[row.b]);
        }
    }
}

void Propagation::resolveContacts(Bodies& bodies, JointSet& joints, const JointPass& pass,
                                  const PropagationSettings& settings) {
    for (int k = 1; k <= settings.contactPasses; ++k) {
        const Real fraction = static_cast<Real>(k) / static_cast<Real>(settings.contactPasses);
        joints.solve(bodies, pass);
        forEachRow([&](PropagationRow& row) {
            solveRow(row, bodies, massesOf(bodies, row, false, false), fraction, 1 / pass.h);
        });
    }
}

/// Finds the levels of all bodies with rows, and sorts the rows by the higher level of their
/// bodies. Rows between bodies without support from the ground are left out.
void Propagation::findLevels(const Bodies& bodies) {
    constexpr std::uint32_t kNoNode = ~std::uint32_t{};
    node_.resize(bodies.size());
    levelOf_.resize(bodies.size());
    for (const PropagationRow& row : rows_) {
        node_[row.a] = node_[row.b] = kNoNode;
    }
    std::uint32_t nodes = 0;
    immovable_.clear();
    supports_.clear();
    reserveReusing(immovable_, 2 * rows_.size());
    reserveReusing(supports_, rows_.size());
    for (const PropagationRow& row : rows_) {
        for (const std::uint32_t body : {row.a, row.b}) {
            if (node_[body] == kNoNode) {
                node_[body] = nodes++;
                if (bodies.motion[body].invMass == 0) {
                    immovable_.push_back(node_[body]);
                }
            }
        }
        const Vec2 pull = bodies.acceleration[row.a].linear + bodies.acceleration[row.b].linear;
        const Real along = dot(row.normal, pull);
        if (std::abs(along) > kSteep * length(pull)) {
            supports_.push_back(along < 0 ? SupportEdge{node_[row.a], node_[row.b]}
                                          : SupportEdge{node_[row.b], node_[row.a]});
        }
    }
    const std::span<const std::uint32_t> found = levels_.find(nodes, immovable_, supports_);
    std::uint32_t highest = 0;
    for (PropagationRow& row : rows_) {
        levelOf_[row.a] = found[node_[row.a]];
        levelOf_[row.b] = found[node_[row.b]];
        row.level = std::max(levelOf_[row.a], levelOf_[row.b]);
        highest = row.level != ShockLevels::kUnreached ? std::max(highest, row.level) : highest;
    }
    sortByLevel(highest);
}

/// Counting sort: levelStart_[level] ends up as the first row of that level in byLevel_.
void Propagation::sortByLevel(std::uint32_t highest) {
    assignReusing(levelStart_, std::size_t{highest} + 3, 0u);
    for (const PropagationRow& row : rows_) {
        if (row.level != ShockLevels::kUnreached) {
            ++levelStart_[row.level + 2];
        }
    }
    for (std::size_t level = 2; level < levelStart_.size(); ++level) {
        levelStart_[level] += levelStart_[level - 1];
    }
    reserveReusing(byLevel_, rows_.size());
    byLevel_.resize(levelStart_.back());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].level != ShockLevels::kUnreached) {
            byLevel_[levelStart_[rows_[i].level + 1]++] = static_cast<std::uint32_t>(i);
        }
    }
    levelStart_.pop_back();
}

void Propagation::propagateShock(Bodies& bodies, const PropagationSettings& settings, Real invH) {
    forEachLevel(settings.shockPasses, [&](PropagationRow& row) {
        const bool frozenA = levelOf_[row.a] < row.level;
        const bool frozenB = levelOf_[row.b] < row.level;
        solveRow(row, bodies, massesOf(bodies, row, frozenA, frozenB), 1, invH);
    });
}

void Propagation::separate(Bodies& bodies, const Step& step, Real h) {
    const Real unit = step.tolerances.slop * Tolerances::kSlopsPerUnit;
    const SeparationLimits limits{step.tolerances.slop / 4, step.own().pushSpeed * unit * h};
    const bool any = std::any_of(rows_.begin(), rows_.end(), [&](const PropagationRow& row) {
        return std::min(row.points[0].gap, row.points[row.count - 1].gap) < -limits.allowed;
    });
    if (!any) {
        return;
    }
    parting_.resize(bodies.size());
    for (const PropagationRow& row : rows_) {
        parting_[row.a] = parting_[row.b] = {};
    }
    for (int pass = 0; pass < step.own().contactPasses; ++pass) {
        forEachRow([&](PropagationRow& row) {
            separateRow(row, parting_, massesOf(bodies, row, false, false), limits);
        });
    }
    if (step.own().shockPasses > 0) {
        forEachLevel(step.own().shockPasses, [&](PropagationRow& row) {
            const bool frozenA = levelOf_[row.a] < row.level;
            const bool frozenB = levelOf_[row.b] < row.level;
            separateRow(row, parting_, massesOf(bodies, row, frozenA, frozenB), limits);
        });
    }
    for (const PropagationRow& row : rows_) {
        for (const std::uint32_t body : {row.a, row.b}) { // applied once, then cleared
            bodies.motion[body].deltaPosition += parting_[body].deltaPosition;
            bodies.motion[body].deltaAngle += parting_[body].deltaAngle;
            parting_[body] = {};
        }
    }
}

/// Bodies with a noticeable impulse of a row move by their velocity, all others in free flight.
void Propagation::markExposure(const Bodies& bodies, const JointSet& joints, Real h, Real slop) {
    exposure_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        exposure_[body] = ContactExposure::Free;
    }
    for (const PropagationRow& row : rows_) {
        const RowMasses masses = massesOf(bodies, row, false, false);
        Real parted = 0; // m/s
        for (std::size_t i = 0; i < row.count; ++i) {
            parted += row.impulse[i] * masses.response(row.points[i].leverA, row.points[i].leverB);
        }
        if (h * parted > kLeastHold * slop) {
            exposure_[row.a] = exposure_[row.b] = ContactExposure::Touched;
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        exposure_[firstBody(joint.def).index] = ContactExposure::Touched;
        exposure_[secondBody(joint.def).index] = ContactExposure::Touched;
    });
}

/// Adds the impulses of this substep to the contacts.
void Propagation::store(std::span<Contact> contacts) {
    for (Contact& contact : contacts) {
        contact.carried = false;
        contact.row = {}; // not in a lane of the soft solver
        contact.hasStepImpulses = true;
        contact.friction = 0;
        contact.rolling = 0;
        for (PointImpulse& impulse : contact.impulse) {
            impulse.largest = std::max(impulse.largest, impulse.impact);
            contact.total += impulse.impact;
            impulse.impact = 0;
            impulse.normal = 0;
        }
    }
    for (const PropagationRow& row : rows_) {
        Contact& contact = contacts[row.contact];
        contact.friction = row.friction;
        contact.rolling = row.rolling;
        for (std::size_t i = 0; i < row.count; ++i) {
            PointImpulse& impulse = contact.impulse[i];
            impulse.normal = row.impulse[i];
            impulse.largest = std::max(impulse.largest, impulse.normal);
            contact.total += impulse.normal;
        }
    }
}

void Propagation::solve(Bodies& bodies, std::span<Contact> contacts, JointSet& joints,
                        const Step& step) {
    const PropagationSettings& settings = step.own();
    const Real h = step.dt / static_cast<Real>(settings.substeps);
    JointPass pass{h, Softness::from(settings.jointHertz, settings.jointDamping, h), true};
    pass_ = step.count * kPassesPerStep;
    visits_ = 0;
    joints.beginStep(bodies);
    for (int part = 0; part < settings.substeps; ++part) {
        predict(bodies, contacts,
                {step.tolerances, h, step.settings.has(Feature::ContinuousCollision), part == 0});
        resolveCollisions(bodies, contacts, step, h);
        integrateVelocities(bodies, bodies.awake, h);
        pass.biased = true;
        joints.warmStart(bodies, pass);
        makeRows(bodies, contacts, step);
        resolveContacts(bodies, joints, pass, settings);
        if (settings.shockPasses > 0) {
            findLevels(bodies);
            propagateShock(bodies, settings, 1 / h);
        }
        separate(bodies, step, h);
        markExposure(bodies, joints, h, step.tolerances.slop);
        integrateMoves(bodies, bodies.awake, exposure_, h);
        pass.biased = false;
        joints.solve(bodies, pass);
        store(contacts);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
