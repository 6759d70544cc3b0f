// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// Names a joint of a World, as BodyId names a body.
struct JointId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0; // of the slot; 0 is never valid
    std::uint32_t world = 0;      // see BodyId::world

    friend constexpr bool operator==(JointId a, JointId b) {
        return a.index == b.index && a.generation == b.generation;
    }
    friend constexpr std::strong_ordering operator<=>(JointId a, JointId b) {
        const auto byIndex = a.index <=> b.index;
        return byIndex != 0 ? byIndex : a.generation <=> b.generation;
    }
};

/// From lower to upper, both included; lower <= upper.
struct Range {
    Real lower = 0;
    Real upper = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

inline constexpr Real kUnbreakable = std::numeric_limits<Real>::infinity();

/// What all joints between two bodies have. Forces and torques of a joint are those on b; a feels
/// the opposite.
struct JointEnds {
    BodyId a{};
    BodyId b{};
    Vec2 anchorA{};                  // m, in the frame of a's shape; within kMaxCoordinate
    Vec2 anchorB{};                  // m, in the frame of b's shape; within kMaxCoordinate
    Real breakForce = kUnbreakable;  // N, > 0; a larger force, as mean of a step, breaks the joint
    Real breakTorque = kUnbreakable; // N m, > 0; likewise
    bool collide = false;            // true: the two bodies collide with each other
};

/// Revolute joint, also called hinge or pin: both anchors coincide, and the bodies rotate about
/// them.
struct RevoluteJoint {
    JointEnds ends{};
    Real reference = 0;            // rad, within 1e4; relative angle of b that counts as 0
    std::optional<Range> limits{}; // rad, -3 to 3, of that angle
    Real motorSpeed = 0;           // rad/s, of b relative to a; within kMaxSpeed
    Real motorTorque = 0;          // N m, >= 0; the largest; 0: no motor
};

/// Fixed joint: the anchors coincide and the relative angle is constant. Unlike World::weld() it
/// can break.
struct FixedJoint {
    JointEnds ends{};
    Real reference = 0; // rad, within 1e4; relative angle of b
};

/// Distance joint between the anchors: a spring, a rod (hertz 0, equal limits) or a rope (hertz 0,
/// limits from 0 to its length). One of both must be set: hertz 0 without limits is refused.
struct DistanceJoint {
    JointEnds ends{};
    Real length = 1;               // m, rest length of the spring; 0 to kMaxCoordinate
    Real hertz = 0;                // 0 to 1e4; stiffness, as frequency of the pair; 0: no spring
    Real damping = 0;              // 0 to 1e4; damping ratio of the spring; 1 is critical
    std::optional<Range> limits{}; // m, of the distance; 0 to kMaxCoordinate
};

/// Prismatic joint: b slides along an axis fixed to a, without relative rotation.
struct PrismaticJoint {
    JointEnds ends{};
    Vec2 axis{1, 0};               // unit, in the frame of a's shape
    Real reference = 0;            // rad, within 1e4; relative angle of b
    std::optional<Range> limits{}; // m, of anchor b along the axis from anchor a
    Real motorSpeed = 0;           // m/s along the axis; within kMaxSpeed
    Real motorForce = 0;           // N, >= 0; the largest; 0: no motor
};

/// Motor joint: drives b to a position and an angle relative to a, with limited force. Force and
/// torque of 0 together are refused.
struct MotorJoint {
    JointEnds ends{};   // anchor b is driven to anchor a
    Real reference = 0; // rad, within 1e4; target of the relative angle of b
    Real force = 0;     // N, >= 0; the largest
    Real torque = 0;    // N m, >= 0; the largest
    Real hertz = 30;    // 1e-3 to 1e4; stiffness, as frequency of the pair
    Real damping = 1;   // 0 to 1e4; damping ratio; 1 is critical
};

/// Mouse joint: pulls a point of one body towards a target.
struct MouseJoint {
    BodyId body{};
    Vec2 anchor{};            // m, in the frame of the body's shape; within kMaxCoordinate
    Vec2 target{};            // m, world; within kMaxCoordinate
    Real force = 0;           // N, > 0; the largest
    Real hertz = 5;           // 1e-3 to 1e4; stiffness, with the body's mass
    Real damping = Real(0.7); // 0 to 1e4; damping ratio; 1 is critical
};

/// Any joint, as World::add() takes it.
using JointDef =
    std::variant<RevoluteJoint, FixedJoint, DistanceJoint, PrismaticJoint, MotorJoint, MouseJoint>;

/// The reason why World::add() would refuse a joint, in a World with that length unit (m). It
/// does not check that the bodies exist.
KODO_API std::optional<Problem> check(const JointDef& def, Real lengthUnit = 1);

/// The bodies of a joint; those of a MouseJoint are equal.
KODO_API BodyId firstBody(const JointDef& def);
KODO_API BodyId secondBody(const JointDef& def);

/// A joint that its load broke in the last step. Its id is no longer valid.
struct BrokenJoint {
    JointId id{};
    BodyId a{};
    BodyId b{};
    Real force = 0;  // N, mean over the step
    Real torque = 0; // N m, likewise
};

} // namespace KODO_PRECISION
} // namespace kodo

/// By slot and generation, as == compares.
template <>
struct std::hash<kodo::JointId> {
    std::size_t operator()(kodo::JointId id) const noexcept {
        return kodo::detail::hashOf(id.index, id.generation);
    }
};
