// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <cstdint>

namespace kodo {
inline namespace KODO_PRECISION {

/// Each Begin is followed by exactly one End, also when a body is removed.
enum class TouchPhase : std::uint8_t { Begin, Persist, End };

/// Contact of two parts of two bodies in one World::step(). A plain value: it stays readable after
/// its bodies are removed.
///
/// At End the parts are apart, or one is gone: point and normal are then left over from the last
/// manifold, which may have had no point, and the numbers are 0.
///
/// The solver applies impulses in groups: one group for impacts (restitution), then one per
/// substep.
struct CollisionRecord {
    BodyId a{}; // a.index < b.index
    BodyId b{};
    std::uint16_t partA = 0; // index of the part of a
    std::uint16_t partB = 0;
    TouchPhase phase = TouchPhase::Begin;
    std::uint8_t pointCount = 0; // 1 or 2; 0 at End
    Vec2 point{};                // m, world; the point of maxImpulse, else the deepest point
    Vec2 normal{};               // unit, from a to b
    Real separation = 0;         // m, before the solver; < 0 in overlap
    Real approachSpeed = 0; // m/s along the normal before the solver, of the fastest point; >= 0
    Real maxImpulse = 0;    // N s; largest normal impulse at one point in one group
    Real totalImpulse = 0;  // N s; normal impulses of all points, summed over the step

    bool involves(BodyId body) const { return a == body || b == body; }
    BodyId other(BodyId body) const { return a == body ? b : a; }
};

} // namespace KODO_PRECISION
} // namespace kodo
