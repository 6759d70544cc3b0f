// SPDX-License-Identifier: MIT
// Number of parts that the soft solver divides each substep into.
#include "solve/soft_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Compression of contacts, in slops, above which substeps are divided. The substeps themselves add
// a quarter to it.
constexpr Real kMaxCompression = Real(1.6);
constexpr int kMostRefined = 8;

} // namespace

/// Number of parts of each substep, above 1 for large mass ratios or very large forces. A contact
/// is a spring as stiff as the lighter of its bodies allows. Its compression is
///
///   s = F (1/m_a + 1/m_b) / omega^2,  F = m_a acceleration_a, or that of b
///
/// and a quarter of that against a body of infinite mass. Stiffer contacts need shorter substeps.
/// Contacts store the impulses of a whole substep; a power of two divides them exactly.
int SoftSolver::substepParts(const Bodies& bodies, ContactSet& contactSet, Real hertz,
                             const Tolerances& tolerances) {
    const LoadRange& loads = bodies.loads;
    const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
    const Real most = kMaxCompression * tolerances.slop * omega * omega; // m/s^2
    if ((1 + loads.lightest / loads.heaviest) * std::sqrt(loads.strongest) <= most) {
        return 1;
    }
    Real load = 0; // m/s^2
    for (const std::uint32_t place : contactSet.live()) {
        const ContactSummary& summary = contactSet.summaries()[place];
        if (!contactSet.contacts()[place].responds() || summary.separation[0] > tolerances.slop) {
            continue;
        }
        const Real a = bodies.motion[summary.bodyA].invMass;
        const Real b = bodies.motion[summary.bodyB].invMass;
        for (const auto& [own, body] : {std::pair(a, summary.bodyA), std::pair(b, summary.bodyB)}) {
            if (own > 0) {
                load = std::max(load, (a + b) / own * length(bodies.acceleration[body].linear));
            }
        }
    }
    int parts = 1;
    while (parts < kMostRefined && load > most * static_cast<Real>(parts * parts)) {
        parts *= 2;
    }
    return parts;
}

} // namespace KODO_PRECISION
} // namespace kodo
