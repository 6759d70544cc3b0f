// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

/// Approach (m) that a pair with these core radii may have without continuous collision. The centre
/// of the thinner part is then still outside the other part, so contact points separate the pair to
/// the correct side. A locked body does not give way, so half of that is allowed against it.
inline Real allowedApproach(Real coreRadiusA, Real coreRadiusB, bool againstLocked) {
    return std::min(coreRadiusA, coreRadiusB) * (againstLocked ? Real(0.5) : Real(1));
}

} // namespace KODO_PRECISION
} // namespace kodo
