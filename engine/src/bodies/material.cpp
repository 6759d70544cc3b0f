// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>

#include "base/checks.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Real mixed(MixRule rule, Real a, Real b) {
    switch (rule) {
    case MixRule::GeometricMean:
        break;
    case MixRule::Minimum:
        return std::min(a, b);
    case MixRule::Mean:
        return (a + b) / 2;
    case MixRule::Multiply:
        return a * b;
    case MixRule::Maximum:
        return std::max(a, b);
    }
    return std::sqrt(a * b);
}

std::optional<Problem> checkRule(const char* field, MixRule rule) {
    return problemIf(rule > MixRule::Maximum, field, "must be one of the enumerators of MixRule");
}

} // namespace

std::optional<Problem> check(const Material& material) {
    constexpr Real kMost = Real(1e6);
    auto statics = checkRange("material.staticFriction", material.staticFriction,
                              material.kineticFriction, kMost);
    if (statics && material.staticFriction < material.kineticFriction) {
        statics->reason += "; the lower limit is material.kineticFriction: set both, as "
                           "withFriction() does";
    }
    return firstOf(
        {checkRange("material.kineticFriction", material.kineticFriction, 0, kMost), statics,
         checkRange("material.restitution", material.restitution, 0, kMaxRestitution),
         checkRange("material.rollingResistance", material.rollingResistance, 0, kMost),
         checkRange("material.surfaceSpeed", material.surfaceSpeed, -kMaxSpeed, kMaxSpeed, "m/s"),
         checkRule("material.frictionRule", material.frictionRule),
         checkRule("material.restitutionRule", material.restitutionRule)});
}

Material mix(const Material& a, const Material& b) {
    const MixRule friction = std::max(a.frictionRule, b.frictionRule);
    const MixRule restitution = std::max(a.restitutionRule, b.restitutionRule);
    return {mixed(friction, a.staticFriction, b.staticFriction),
            mixed(friction, a.kineticFriction, b.kineticFriction),
            mixed(restitution, a.restitution, b.restitution),
            std::max(a.rollingResistance, b.rollingResistance),
            a.surfaceSpeed + b.surfaceSpeed,
            friction,
            restitution};
}

} // namespace KODO_PRECISION
} // namespace kodo
