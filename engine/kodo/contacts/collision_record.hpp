// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/body_def.hpp>

#include <cstdint>

namespace kodo::inline KODO_PRECISION {

enum class TouchPhase : std::uint8_t { Begin, Persist, End };

/// What two parts of two bodies did to each other in one World::step(). A plain value: it stays
/// readable after its bodies are gone, which is what a game does on hearing of it.
///
/// The step pushes contacts in groups: one group for impacts (restitution), then one a substep.
struct CollisionRecord {
    BodyId a; // a.index < b.index, so a pair reads the same in every step and in every replay
    BodyId b;
    std::uint16_t partA = 0; // of a compound; 0 for a body of one part
    std::uint16_t partB = 0;
    TouchPhase phase = TouchPhase::Begin; // every Begin is followed by one End, removed or not
    std::uint8_t pointCount = 0;          // 1 or 2; 0 at End
    Vec2 point;                           // m, world; where maxImpulse acted, or the deepest point
    Vec2 normal;                          // unit, from a towards b
    Real separation = 0;                  // m, before the solver; negative in overlap
    Real approachSpeed = 0; // m/s along the normal before the solver, the fastest point; >= 0
    Real maxImpulse = 0;    // N s; the largest at one point within one group
    Real totalImpulse = 0;  // N s; of all points, summed over the step

    bool involves(BodyId body) const { return a == body || b == body; }
    BodyId other(BodyId body) const { return a == body ? b : a; }
};

} // namespace kodo::inline KODO_PRECISION
