// SPDX-License-Identifier: MIT
// How finely the soft step divides its substeps.
#include <kodo/solve/soft_step.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

// Contacts may give by so many slops, and a quarter more in substeps, before these get finer.
constexpr Real kMostGive = Real(1.6);
constexpr int kMostRefined = 8;

} // namespace

/// Into how many parts each substep is divided, since something heavy presses on something light,
/// or forces are very large. A contact is a spring as stiff as the lighter of its two bodies needs
/// it, and gives by
///
///   s = F (1/m_a + 1/m_b) / omega^2,  F = m_a acceleration_a, or that of b,
///
/// of what cannot be pushed by a quarter of that. Stiffer ones need shorter substeps. Impulses are
/// kept as of a whole substep; a power of two changes no digit of them.
int SoftStep::refinement(const Bodies& bodies, ContactSet& contactSet, Real hertz,
                         const Tolerances& tolerances) {
    const Loads& loads = bodies.loads;
    const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
    const Real most = kMostGive * tolerances.slop * omega * omega; // m/s^2
    if ((1 + loads.lightest / loads.heaviest) * std::sqrt(loads.strongest) <= most) {
        return 1;
    }
    Real load = 0; // m/s^2
    for (const std::uint32_t place : contactSet.live()) {
        const ContactHead& head = contactSet.heads()[place];
        if (!contactSet.contacts()[place].responds() || head.separation[0] > tolerances.slop) {
            continue;
        }
        const Real a = bodies.motion[head.bodyA].invMass;
        const Real b = bodies.motion[head.bodyB].invMass;
        for (const auto& [own, body] : {std::pair(a, head.bodyA), std::pair(b, head.bodyB)}) {
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

} // namespace kodo::inline KODO_PRECISION
