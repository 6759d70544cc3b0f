// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace kodo {
inline namespace KODO_PRECISION {

/// Each Begin is followed by exactly one End, also when a body is removed.
enum class TouchPhase : std::uint8_t { Begin, Persist, End };

/// One of the points at which two parts touch.
struct RecordPoint {
    Vec2 position{};     // m, world
    Real separation = 0; // m, before the solver; < 0 in overlap
    Real maxImpulse = 0; // N s; largest normal impulse at this point in one group

    friend bool operator==(const RecordPoint&, const RecordPoint&) = default;
};

/// Contact of two parts of two bodies in one World::step(). A plain value: it stays readable after
/// its bodies are removed.
///
/// At End the parts are apart, or one is gone: point and normal are then left over from the last
/// manifold, which may have had no point, and the numbers are 0.
///
/// The solver applies impulses in groups: one group for impacts (restitution), then one per
/// substep. Where the normal changes within a step, that of the record is the mean, weighted with
/// the impulses: `totalImpulse` along it and `tangentImpulse` together have the direction of what
/// acted. maxImpulse is that of the pair: a box that lands flat on two corners has the same as
/// one that lands on a corner below its centre.
struct CollisionRecord {
    BodyId a{}; // a.index < b.index
    BodyId b{};
    std::uint16_t partA = 0; // index of the part of a
    std::uint16_t partB = 0;
    TouchPhase phase = TouchPhase::Begin;
    std::uint8_t pointCount = 0;         // 1 or 2; 0 at End
    std::array<RecordPoint, 2> points{}; // the first pointCount of them
    Vec2 point{};           // m, world; that of the largest impulse, else the deepest one
    Vec2 normal{};          // unit, from a to b
    Real separation = 0;    // m, before the solver; < 0 in overlap; of the deepest point
    Real approachSpeed = 0; // m/s along the normal before the solver, of the fastest point; >= 0
    /// N s; largest normal impulse of all points in one group, at most totalImpulse. If the points
    /// have their largest in different substeps, the sum of these. Where substeps are refined, an
    /// upper bound.
    Real maxImpulse = 0;
    Real totalImpulse = 0; // N s; normal impulses of all points, summed over the step
    /// N s; impulse of friction, summed over the step: on b along perp(normal), on a against it. It
    /// acts on the middle of the points, so it is one number for the pair.
    Real tangentImpulse = 0;

    bool involves(BodyId body) const { return a == body || b == body; }
    BodyId other(BodyId body) const { return a == body ? b : a; }
    /// N s; largest normal impulse at a single point in one group.
    Real maxPointImpulse() const { return (std::max)(points[0].maxImpulse, points[1].maxImpulse); }
};

} // namespace KODO_PRECISION
} // namespace kodo
