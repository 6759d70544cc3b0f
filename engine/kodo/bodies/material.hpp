// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/problem.hpp>

#include <optional>

namespace kodo::inline KODO_PRECISION {

/// What the surface of a body, or of one of its parts, is like. No units.
struct Material {
    Real staticFriction = Real(0.6);  // >= kineticFriction; holds while nothing slides
    Real kineticFriction = Real(0.6); // >= 0; while sliding
    Real restitution = 0;             // 0..1; 1 keeps all of the approach speed
    Real rollingResistance = 0;       // >= 0; brakes rolling with this share of the radius as lever

    friend bool operator==(const Material&, const Material&) = default;
};

/// The same friction at rest and in motion.
constexpr Material withFriction(Real friction, Real restitution = 0) {
    return {friction, friction, restitution, 0};
}

std::optional<Problem> check(const Material& material);

/// The material that two surfaces in contact make. Friction: the geometric mean, so that ice makes
/// everything slippery. Restitution: the smaller [Thesis06, 4.3.3], so a lossless bounce needs two
/// lossless sides. Rolling resistance: the larger.
Material mix(const Material& a, const Material& b);

} // namespace kodo::inline KODO_PRECISION
