// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>

#include "base/checks.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {

std::optional<Problem> check(const Material& material) {
    constexpr Real kMost = Real(1e6);
    if (auto problem = checkRange("material.kineticFriction", material.kineticFriction, 0, kMost)) {
        return problem;
    }
    if (auto problem = checkRange("material.staticFriction", material.staticFriction,
                                  material.kineticFriction, kMost)) {
        if (material.staticFriction < material.kineticFriction) {
            problem->reason += "; the lower limit is material.kineticFriction: set both, as "
                               "withFriction() does";
        }
        return problem;
    }
    if (auto problem = checkRange("material.restitution", material.restitution, 0, 1)) {
        return problem;
    }
    return checkRange("material.rollingResistance", material.rollingResistance, 0, kMost);
}

Material mix(const Material& a, const Material& b) {
    return {std::sqrt(a.staticFriction * b.staticFriction),
            std::sqrt(a.kineticFriction * b.kineticFriction),
            std::min(a.restitution, b.restitution),
            std::max(a.rollingResistance, b.rollingResistance)};
}

} // namespace KODO_PRECISION
} // namespace kodo
