// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/real.hpp>

#include <cstdint>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// How a coefficient of a contact follows from those of its two parts. Of two rules, the later one
/// in this list counts.
enum class MixRule : std::uint8_t {
    GeometricMean, // sqrt(a b)
    Minimum,
    Mean,     // (a + b) / 2
    Multiply, // a b
    Maximum,
};

/// Largest restitution of a material. Above 1, an impact adds energy, as a bumper does.
inline constexpr Real kMaxRestitution = 2;

/// Surface of a body or of one of its parts.
struct Material {
    Real staticFriction = Real(0.6);  // >= kineticFriction; limit while nothing slides
    Real kineticFriction = Real(0.6); // >= 0; while sliding
    Real restitution = 0;             // 0 to kMaxRestitution; 1 keeps all of the approach speed
    Real rollingResistance = 0; // >= 0; lever arm of the braking torque, as share of the radius
    /// m/s, of the surface along itself, as of a belt that runs clockwise around the body: to the
    /// right on top of a floor, for a speed > 0. Friction brings what touches it to this speed.
    Real surfaceSpeed = 0;
    MixRule frictionRule = MixRule::GeometricMean; // for both coefficients
    MixRule restitutionRule = MixRule::Minimum;    // [Thesis06, 4.3.3]

    friend bool operator==(const Material&, const Material&) = default;
};

/// A material with equal static and kinetic friction.
constexpr Material withFriction(Real friction, Real restitution = 0) {
    Material material;
    material.staticFriction = material.kineticFriction = friction;
    material.restitution = restitution;
    return material;
}

KODO_API std::optional<Problem> check(const Material& material);

/// Material of a contact. Friction and restitution by their rules; unless a part asks for another,
/// the geometric mean, so ice makes everything slippery, and the smaller one. Rolling resistance:
/// the larger one. Surface speed: the sum, which is the speed of both surfaces against each other.
KODO_API Material mix(const Material& a, const Material& b);

} // namespace KODO_PRECISION
} // namespace kodo
