// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

#include <compare>
#include <limits>
#include <optional>
#include <variant>

namespace kodo::inline KODO_PRECISION {

/// Names a joint in its World, as BodyId names a body.
struct JointId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0; // 0 is never alive
    friend constexpr auto operator<=>(JointId, JointId) = default;
};

/// From lower to upper, both included; lower <= upper.
struct Range {
    Real lower = 0;
    Real upper = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

inline constexpr Real kUnbreakable = std::numeric_limits<Real>::infinity();

/// The two bodies of a joint, and where on them it holds. All of a joint's forces and torques are
/// those on b; a feels the opposite.
struct JointEnds {
    BodyId a;
    BodyId b;
    Vec2 anchorA{};                  // m, in the frame of a's shape; within kFarthest
    Vec2 anchorB{};                  // m, in the frame of b's shape; within kFarthest
    Real breakForce = kUnbreakable;  // N, > 0; a greater pull, as the mean of a step, breaks it
    Real breakTorque = kUnbreakable; // N m, > 0
    bool collide = false;            // may the two bodies touch each other?
};

/// Both anchors stay on one point; the bodies turn about it.
struct Pin {
    JointEnds ends;
    Real reference = 0;            // rad, within 1e4; angle of b relative to a that counts as 0
    std::optional<Range> limits{}; // rad, -3..3, of that angle
    Real motorSpeed = 0;           // rad/s, of b relative to a; within kHighestSpeed
    Real motorTorque = 0;          // N m at most, >= 0; 0: no motor
};

/// Both anchors on one point, and no turning: two bodies as one, until it breaks.
struct Weld {
    JointEnds ends;
    Real reference = 0; // rad, within 1e4; the angle of b relative to a that is held
};

/// Holds the distance of the anchors: a spring, a rod (hertz 0 and equal limits) or a rope.
struct Spring {
    JointEnds ends;
    Real length = 1;               // m, at rest; 0..kFarthest
    Real hertz = 0;                // 0..1e4; stiffness, with the bodies' masses; 0: no spring
    Real damping = 0;              // 0..1e4; damping ratio of the spring; 1 is critical
    std::optional<Range> limits{}; // m, of the distance; 0..kFarthest
};

/// b slides along a line that is fixed to a, and does not turn against it.
struct Slider {
    JointEnds ends;
    Vec2 axis{1, 0};               // unit, in the frame of a's shape
    Real reference = 0;            // rad, within 1e4; the angle of b relative to a that is held
    std::optional<Range> limits{}; // m, of anchor b along the axis from anchor a; within kFarthest
    Real motorSpeed = 0;           // m/s along the axis; within kHighestSpeed
    Real motorForce = 0;           // N at most, >= 0; 0: no motor
};

/// Drives b to a place and an angle relative to a, with limited force.
struct Motor {
    JointEnds ends;     // anchor b is driven to anchor a
    Real reference = 0; // rad, within 1e4; the angle of b relative to a that is wanted
    Real force = 0;     // N at most, >= 0
    Real torque = 0;    // N m at most, >= 0
    Real hertz = 30;    // 1e-3..1e4; how eagerly: stiffness, with the bodies' masses
    Real damping = 1;   // 0..1e4; damping ratio; 1 is critical
};

/// Draws one body by a point on it towards a target, as a hand does.
struct Mouse {
    BodyId body;
    Vec2 anchor{};            // m, in the frame of the body's shape; within kFarthest
    Vec2 target{};            // m, world; within kFarthest
    Real force = 0;           // N at most, >= 0
    Real hertz = 5;           // 1e-3..1e4; stiffness, with the body's mass
    Real damping = Real(0.7); // 0..1e4; damping ratio; 1 is critical
};

/// Any joint, as World::add takes it.
using JointDef = std::variant<Pin, Weld, Spring, Slider, Motor, Mouse>;

/// What is wrong with a joint's numbers in a World of that length unit, or nothing. Whether its
/// bodies are alive only their World can tell.
std::optional<Problem> check(const JointDef& def, Real lengthUnit = 1);

/// The bodies of a joint; a Mouse has the same one twice.
BodyId firstBody(const JointDef& def);
BodyId secondBody(const JointDef& def);

/// From the centre of mass of a body that is turned so to an anchor in the frame of its shape, m.
inline Vec2 armOf(const Bodies& bodies, std::uint32_t body, Rot rotation, Vec2 anchor) {
    return rotation * (anchor - bodies.form(body).mass.center);
}

} // namespace kodo::inline KODO_PRECISION
