// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "bodies/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// The two ends of a joint; nullptr for a MouseJoint, which has one body.
template <typename... Kinds>
const JointEnds* endsOf(const std::variant<Kinds...>& def) {
    const JointEnds* ends = nullptr;
    const auto look = [&](const auto* kind) {
        if constexpr (requires { kind->ends; }) {
            ends = kind != nullptr ? &kind->ends : ends;
        }
    };
    (look(std::get_if<Kinds>(&def)), ...); // std::visit() calls by a table, in WebAssembly
    return ends;
}

/// Vector (m, world axes) from the centre of mass to an anchor, which is in the frame of the shape.
inline Vec2 armOf(const Bodies& bodies, std::uint32_t body, Rot rotation, Vec2 anchor) {
    return rotation * (anchor - bodies.geometry(body).mass.center);
}

/// Inverse inertia (1/(kg m^2)) of a body about an anchor; about its centre of mass if it can only
/// rotate.
inline Real inverseAbout(const BodyVelocity& body, Vec2 arm) {
    const Real sum = body.invMass + body.invInertia * lengthSquared(arm);
    return body.invMass > 0 ? body.invInertia * (body.invMass / sum) : body.invInertia;
}

/// Vector (m) from the end of the tangent of an anchor to the end of its arc, if the body rotates
/// by `angle` (rad): R(angle) arm - arm - angle perp(arm). Small angles use the Taylor series,
/// where the difference would be rounding error. Beyond half a circle a substep has no meaning.
inline Vec2 fromTangentToArc(Real angle, Vec2 arm) {
    constexpr Real kSmall = Real(0.25);
    constexpr Real kMost = Real(3);
    if (std::abs(angle) < kSmall) {
        const Real square = angle * angle;
        const Real along = square * (square / 24 - Real(0.5));
        const Real across = square * angle * (square / 120 - Real(1) / 6);
        return along * arm + across * perp(arm);
    }
    const Real turn = std::clamp(angle, -kMost, kMost);
    return Rot::fromAngle(turn) * arm - arm - turn * perp(arm);
}

} // namespace KODO_PRECISION
} // namespace kodo
