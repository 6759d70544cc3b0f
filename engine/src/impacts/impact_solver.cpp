// SPDX-License-Identifier: MIT
#include "impacts/impact_solver.hpp"

#include "base/vector_reuse.hpp"
#include "contacts/contact_update.hpp"
#include "math/friction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Relative velocity at one point per impulse there, along normal and tangent.
struct Response {
    Real nn; // (m/s along n) per (N s along n), and so on
    Real nt;
    Real tt;
};

// Ratio of a determinant to the product it is subtracted from, below which it is a rounding error.
constexpr Real kSingular = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-12);
// Largest ratio of an impact impulse on both points to that on one of them.
constexpr Real kHardest = 16;

/// The friction impulse of one point, along t (N s). The impulses with the correct rebound speed
/// are
///
///   p = p_0 n + j (t - K_nt/K_nn n),  p_0 = (1 + e) stop,  stop = -v_n / K_nn
///
/// j stops all sliding, or is the nearest value within the friction cone |j| <= mu p_n. No impact
/// may gain energy, as friction together with restitution could [Chatterjee98]:
///
///   m j^2 + 2 u j <= max(1 - e^2, 0) K_nn stop^2,  m = K_tt - K_nt^2/K_nn,  u = v_t + K_nt stop
Real frictionOf(const Response& k, const Material& material, Real stop, Real sliding) {
    const Real e = material.restitution;
    const Real coupling = k.nt / k.nn;
    const Real m = k.tt - k.nt * coupling;
    const Real plain = (1 + e) * stop;
    Real j = -(sliding + k.nt * plain) / m;
    const auto answer = frictionImpulse<Real>(
        {material.staticFriction, material.kineticFriction, plain - coupling * j, 1}, j);
    if (answer.impulse != j) {
        const Real mu = j > 0 ? answer.coefficient : -answer.coefficient;
        const Real steep = 1 + mu * coupling; // <= 0: this side of the cone has no end
        const Real most = steep > 0 ? mu * plain / steep : j;
        j = j > 0 ? std::min(j, most) : std::max(j, most);
    }
    const Real u = sliding + k.nt * stop;
    const Real root = std::sqrt(u * u + m * std::max(1 - e * e, Real(0)) * k.nn * stop * stop);
    return std::clamp(j, (-u - root) / m, (-u + root) / m);
}

/// Impact at one point. Bodies that can only rotate give way along one line, so K is singular:
/// friction stops nothing that the normal impulse does not stop.
void hitPoint(const Impact& hit, std::size_t i) {
    const Vec2 n = hit.normal();
    const Vec2 t = hit.tangent();
    const Response k{response(hit, i, n, i, n), response(hit, i, n, i, t),
                     response(hit, i, t, i, t)};
    const Material& material = hit.contact->material;
    const Real stop = -dot(n, hit.relativeVelocity(i)) / k.nn;
    const bool slides = !hit.frictionless && material.staticFriction > 0;
    const bool givesWay = k.nn * k.tt - k.nt * k.nt >= kSingular * k.nn * k.tt;
    const Real frictionImpulse =
        slides && givesWay ? frictionOf(k, material, stop, hit.slidingSpeed(i)) : 0;
    hit.push(i, (1 + material.restitution) * stop - k.nt / k.nn * frictionImpulse, frictionImpulse);
}

/// Friction at a point that has just received the normal impulse jn (N s).
void applyFriction(const Impact& hit, std::size_t i, Real jn) {
    const Vec2 t = hit.tangent();
    const Real k = response(hit, i, t, i, t);
    if (!(k > 0)) {
        return; // neither body gives way along the tangent
    }
    const Real stopping = -hit.slidingSpeed(i) / k;
    const Material& material = hit.contact->material;
    const FrictionLimits<Real> limits{material.staticFriction, material.kineticFriction, jn, 1};
    hit.push(i, 0, frictionImpulse(limits, stopping).impulse);
}

void applyFrictionToBoth(const Impact& hit, Real j1, Real j2) {
    if (!hit.frictionless && hit.contact->material.staticFriction > 0) {
        applyFriction(hit, 0, j1);
        applyFriction(hit, 1, j2);
    }
}

/// Impact at both points at once, so that a box that lands flat rebounds flat. False if one impulse
/// would be negative or far too large; the points are then solved singly.
bool hitBoth(const Impact& hit) {
    const Vec2 n = hit.normal();
    const Real k11 = response(hit, 0, n, 0, n);
    const Real k22 = response(hit, 1, n, 1, n);
    const Real k12 = response(hit, 0, n, 1, n);
    const Real gain = -(1 + hit.contact->material.restitution);
    const Real w1 = gain * dot(n, hit.relativeVelocity(0));
    const Real w2 = gain * dot(n, hit.relativeVelocity(1));
    const Real determinant = k11 * k22 - k12 * k12;
    if (determinant < kSingular * k11 * k22) {
        // The bodies mostly rotate, and give way more at one point than at the other.
        if (k12 < Real(0.9) * std::max(k11, k22)) {
            return false;
        }
        // The bodies cannot rotate: both points act as one.
        const Real half = w1 / (2 * k11);
        hit.push(0, half, 0);
        hit.push(1, half, 0);
        applyFrictionToBoth(hit, half, half);
        return true;
    }
    if (k12 < 0 && determinant * kHardest < k11 * k22) {
        return false; // pinched: giving way at one point presses on the other
    }
    const Real j1 = (k22 * w1 - k12 * w2) / determinant;
    const Real j2 = (k11 * w2 - k12 * w1) / determinant;
    if (j1 < 0 || j2 < 0) {
        return false;
    }
    hit.push(0, j1, 0);
    hit.push(1, j2, 0);
    applyFrictionToBoth(hit, j1, j2);
    return true;
}

/// True if an impact impulse was applied.
bool hitContact(const Impact& hit, const Tolerances& tolerances, Real restSpeed) {
    Real speed[2] = {0, 0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(hit.contact->manifold.count); ++i) {
        if (hit.separation(i) <= tolerances.slop && !hit.blocked(i)) {
            speed[i] = approach(hit, i, restSpeed);
        }
    }
    if (speed[0] == 0 && speed[1] == 0) {
        return false;
    }
    if (speed[0] > 0 && speed[1] > 0 && hitBoth(hit)) {
        return true;
    }
    hitPoint(hit, speed[0] >= speed[1] ? 0 : 1);
    return true;
}

/// Speed (m/s) of the fastest approach of a point that touches; 0: none.
Real fastestApproach(const Impact& hit, Real slop) {
    Real fastest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(hit.contact->manifold.count); ++i) {
        if (hit.separation(i) <= slop) {
            fastest = std::max(fastest, approach(hit, i, 0));
        }
    }
    return fastest;
}

/// A body that can only rotate, pinched between moving walls, would get ever larger impulses.
bool isPinched(const Impact& hit) {
    const bool hinged = hit.a->invMass == 0 && hit.b->invMass == 0;
    return hinged && hit.lane.impacts() > 0;
}

constexpr std::size_t kContactsPerPiece = 512;
constexpr Real kNearly = Real(0.999); // margin for rounding

Real accelerationSquared(const Bodies& bodies, std::uint32_t bodyA, std::uint32_t bodyB) {
    return std::max(lengthSquared(bodies.acceleration[bodyA].linear),
                    lengthSquared(bodies.acceleration[bodyB].linear));
}

/// Speed (m/s) that forces alone cause within the step.
Real restSpeedOf(const Bodies& bodies, const Contact& contact, Real dt) {
    return dt * std::sqrt(accelerationSquared(bodies, contact.key.bodyA, contact.key.bodyB));
}

/// True if any contact was measured as fast; not so in a pile.
template <typename WasFast>
bool anyFast(std::span<const std::uint32_t> live, WorkerTeam& team, WasFast wasFast) {
    std::uint8_t any = 0;
    team.forEach(live.size(), kContactsPerPiece, [&](std::size_t first, std::size_t last) {
        while (first < last && !wasFast(live[first])) {
            ++first;
        }
        if (first < last) {
            WorkerTeam::mark(any);
        }
    });
    return any != 0;
}

} // namespace

bool solveImpact(Bodies& bodies, Contact& contact, const ContactLane& lane,
                 const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    if (!contact.responds()) {
        return false;
    }
    const Impact hit{&bodies,
                     &contact,
                     lane,
                     &bodies.motion[contact.key.bodyA],
                     &bodies.motion[contact.key.bodyB],
                     !settings.has(Feature::Friction)};
    return !isPinched(hit) && hitContact(hit, tolerances, restSpeedOf(bodies, contact, dt));
}

void ImpactSolver::solve(const StepInput& step) {
    if (!step.settings.has(Feature::Restitution) || !(step.contactSet.fastestApproach() > 0)) {
        return;
    }
    // Forces alone cause this speed on every body within the step, so slower contacts have no
    // impact. Within rounding, solveImpact() decides.
    const Real restSpeed = kNearly * step.dt * std::sqrt(step.bodies.loads.minAccelerationSquared);
    if (!(step.contactSet.fastestApproach() > restSpeed)) {
        return;
    }
    const Inputs inputs{step, restSpeed};
    if (!anyFast(step.contactSet.live(), step.team,
                 [&](std::uint32_t slot) { return wasFast(inputs, slot); })) {
        return;
    }
    round_ = 0;
    listCandidates(inputs);
    const int passes = std::max(1, step.solver<SoftSettings>().impactPasses);
    bool again = true;
    for (int pass = 1; pass <= passes && again; ++pass) {
        again = solvePass(inputs, static_cast<std::uint32_t>(pass));
    }
    for (const std::uint32_t body : hitBodies_) {
        lastHit_[body] = 0;
    }
    hitBodies_.clear();
}

/// True if the measured approach is faster than that, up to rounding; solveImpact() decides
/// exactly.
bool ImpactSolver::wasFast(const Inputs& inputs, std::uint32_t slot) {
    const ContactSummary& summary = inputs.contactSet.summaries()[slot];
    const Real speed = inputs.contactSet.store().approachSpeed(slot);
    const Real dt = inputs.dt;
    return speed > inputs.restSpeed &&
           speed * speed > kNearly * (dt * dt) *
                               accelerationSquared(inputs.bodies, summary.bodyA, summary.bodyB);
}

void ImpactSolver::listCandidates(const Inputs& inputs) {
    const Bodies& bodies = inputs.bodies;
    const std::span<const ContactSummary> summaries = inputs.contactSet.summaries();
    candidates_.clear();
    reserveReusing(candidates_, summaries.size());
    inputs.contactSet.store().forEachInOrder([&](std::uint32_t slot) {
        const ContactSummary& summary = summaries[slot];
        if (summary.idle || (bodies.locked(summary.bodyA) && bodies.locked(summary.bodyB))) {
            return;
        }
        candidates_.push_back({.slot = slot,
                               .bodyA = summary.bodyA,
                               .bodyB = summary.bodyB,
                               .round = wasFast(inputs, slot) ? 0u : 1u,
                               .bounces = summary.bounces});
    });
}

/// True if the contact touches and approaches. It is checked again only if one of its bodies was
/// hit since.
bool ImpactSolver::approachesNow(const Inputs& inputs, Candidate& candidate) const {
    if (std::max(lastHit_[candidate.bodyA], lastHit_[candidate.bodyB]) >= candidate.round) {
        const Impact hit = impactOf(inputs, candidate.slot);
        const Real speed = fastestApproach(hit, inputs.tolerances.slop);
        candidate.round = round_;
        candidate.approaches = speed > inputs.restSpeed && hit.contact->responds() &&
                               speed > restSpeedOf(inputs.bodies, *hit.contact, inputs.dt);
    }
    return candidate.approaches;
}

/// Solves each contact at most once: in each round, all that approach. True if a contact approaches
/// again.
bool ImpactSolver::solvePass(const Inputs& inputs, std::uint32_t pass) {
    for (;;) {
        bool again = false;
        ++round_;
        approaching_.clear();
        for (Candidate& candidate : candidates_) {
            if (approachesNow(inputs, candidate)) {
                const bool solved = candidate.lastPass == pass;
                again = again || solved;
                if (!solved) {
                    approaching_.push_back(
                        static_cast<std::uint32_t>(&candidate - candidates_.data()));
                }
            }
        }
        if (approaching_.empty()) {
            return again;
        }
        solveRound(inputs, pass);
        if (round_ == 1) { // without restitution once; the contact solver follows
            std::erase_if(candidates_, [](const Candidate& one) { return !one.bounces; });
        }
    }
}

/// Solves the contacts in approaching_. Those that share bodies are solved together.
void ImpactSolver::solveRound(const Inputs& inputs, std::uint32_t pass) {
    const Bodies& bodies = inputs.bodies;
    const auto forMovable = [&](const Candidate& candidate, auto work) {
        for (const std::uint32_t body : {candidate.bodyA, candidate.bodyB}) {
            if (!bodies.locked(body)) {
                work(body);
            }
        }
    };
    for (const std::uint32_t index : approaching_) {
        forMovable(candidates_[index], [&](std::uint32_t body) { sets_.makeSet(body); });
    }
    for (const std::uint32_t index : approaching_) {
        const Candidate& candidate = candidates_[index];
        if (!bodies.locked(candidate.bodyA) && !bodies.locked(candidate.bodyB)) {
            sets_.join(candidate.bodyA, candidate.bodyB);
        }
    }
    grouped_.clear();
    for (const std::uint32_t index : approaching_) {
        Candidate& candidate = candidates_[index];
        const bool movesA = !bodies.locked(candidate.bodyA);
        grouped_.emplace_back(sets_.rootOf(movesA ? candidate.bodyA : candidate.bodyB), index);
        candidate.lastPass = pass;
        candidate.round = 0;
    }
    std::sort(grouped_.begin(), grouped_.end()); // total order: the second numbers are unique
    for (const std::uint32_t index : approaching_) {
        forMovable(candidates_[index], [&](std::uint32_t body) { sets_.drop(body); });
    }
    for (std::size_t first = 0; first < grouped_.size();) {
        group_.clear();
        const std::uint32_t root = grouped_[first].first;
        for (; first < grouped_.size() && grouped_[first].first == root; ++first) {
            group_.push_back(candidates_[grouped_[first].second].slot);
        }
        solveGroup(inputs);
    }
}

/// Solves the contacts in group_ together.
void ImpactSolver::solveGroup(const Inputs& inputs) {
    Bodies& bodies = inputs.bodies;
    ContactSet& contactSet = inputs.contactSet;
    ContactStore& store = contactSet.store();
    hits_.clear();
    for (const std::uint32_t slot : group_) {
        Contact& contact = store.change(slot, bodies);
        const ContactLane lane = store.lane(slot);
        if (contact.bounces && lane.relativeDisplacement() > 0 && lane.impacts() == 0) {
            // Arms that are off by this would change the angular momentum.
            findContact(contact, lane, bodies, inputs.tolerances, inputs.dt);
            contact.filled = false;
            contactSet.manifoldChanged(slot);
        }
        if (group_.size() > 1) {
            const Impact hit = impactOf(inputs, slot);
            if (hit.contact->responds() && !isPinched(hit)) {
                hits_.push_back(hit);
            }
        } else if (!solveImpact(bodies, contact, lane, inputs.settings, inputs.tolerances,
                                inputs.dt)) {
            return;
        }
    }
    together_.solve(hits_, inputs.tolerances);
    for (const std::uint32_t slot : group_) {
        const ContactSummary& summary = contactSet.summaries()[slot];
        for (const std::uint32_t body : {summary.bodyA, summary.bodyB}) {
            if (!bodies.locked(body)) {
                if (std::exchange(lastHit_[body], round_) == 0) {
                    hitBodies_.push_back(body);
                }
                inputs.bodies.noteLostLoad(body);
            }
        }
    }
}

/// One contact with its bodies.
Impact ImpactSolver::impactOf(const Inputs& inputs, std::uint32_t slot) {
    const ContactSummary& summary = inputs.contactSet.summaries()[slot];
    return {&inputs.bodies,
            &inputs.contactSet.contacts()[slot],
            inputs.contactSet.store().lane(slot),
            &inputs.bodies.motion[summary.bodyA],
            &inputs.bodies.motion[summary.bodyB],
            !inputs.settings.has(Feature::Friction)};
}

} // namespace KODO_PRECISION
} // namespace kodo
