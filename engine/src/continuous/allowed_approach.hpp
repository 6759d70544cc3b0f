// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include <algorithm>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// Approach (m) that a pair with these core radii may have without continuous collision. The centre
/// of the thinner part is then still outside the other part, so contact points separate the pair to
/// the correct side. A locked body does not give way, so half of that is allowed against it.
inline Real allowedApproach(Real coreRadiusA, Real coreRadiusB, bool againstLocked) {
    return std::min(coreRadiusA, coreRadiusB) * (againstLocked ? Real(0.5) : Real(1));
}

/// True if manifolds of bodies that turn far or approach fast are found again within the step.
inline bool looksAgain(const StepSettings& settings) {
    return std::holds_alternative<SoftSettings>(settings.solver);
}

/// Approach (m) within a step up to which contact points hold a touching pair. Past the centres of
/// both parts, the pair would separate to the wrong side. With manifolds of the start of the step
/// alone, a blow may turn other corners into a locked body within the step.
inline Real heldApproach(const StepSettings& settings, Real coreA, Real coreB, bool againstLocked) {
    return againstLocked && !looksAgain(settings) ? allowedApproach(coreA, coreB, true)
                                                  : (coreA + coreB) / 2;
}

} // namespace KODO_PRECISION
} // namespace kodo
