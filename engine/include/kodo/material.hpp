// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/real.hpp>

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Surface of a body or of one of its parts. No units.
struct Material {
    Real staticFriction = Real(0.6);  // >= kineticFriction; limit while nothing slides
    Real kineticFriction = Real(0.6); // >= 0; while sliding
    Real restitution = 0;             // 0 to 1; 1 keeps all of the approach speed
    Real rollingResistance = 0; // >= 0; lever arm of the braking torque, as share of the radius

    friend bool operator==(const Material&, const Material&) = default;
};

/// A material with equal static and kinetic friction.
constexpr Material withFriction(Real friction, Real restitution = 0) {
    return {friction, friction, restitution, 0};
}

KODO_API std::optional<Problem> check(const Material& material);

/// Material of a contact. Friction: geometric mean, so ice makes everything slippery. Restitution:
/// the smaller one [Thesis06, 4.3.3]. Rolling resistance: the larger one.
KODO_API Material mix(const Material& a, const Material& b);

} // namespace KODO_PRECISION
} // namespace kodo
