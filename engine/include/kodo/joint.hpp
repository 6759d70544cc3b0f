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
    std::uint64_t userData = 0;      // for the user
};

/// Revolute joint, also called hinge or pin: both anchors coincide, and the bodies rotate about
/// them. With a spring, a ratchet, or limits beyond -3 to 3 rad, the joint counts its turns.
struct RevoluteJoint {
    JointEnds ends{};
    Real reference = 0;            // rad, within 1e4; relative angle of b that counts as 0
    std::optional<Range> limits{}; // rad, within 1e4, of that angle
    Real motorSpeed = 0;           // rad/s, of b relative to a; within kMaxSpeed
    Real motorTorque = 0;          // N m, >= 0; the largest; 0: no motor
    Real target = 0;               // rad, within 1e4; rest angle of the spring
    Real hertz = 0;                // 0 to 1e4; stiffness, as frequency about the anchor; 0: none
    Real damping = 0;              // 0 to 1e4; damping ratio of the spring; 1 is critical
    /// rad, size 1e-6 to 1e4: distance of teeth, which lie at its multiples; needs limits. After
    /// each step the lower one follows the angle up to the last tooth. < 0: the upper one, down. 0:
    /// none.
    Real ratchet = 0;
};

/// Fixed joint: the anchors coincide and the relative angle is constant. Unlike World::weld() it
/// can break, and be soft.
struct FixedJoint {
    JointEnds ends{};
    Real reference = 0; // rad, within 1e4; relative angle of b
    Real hertz = 0;     // 0 to 1e4; stiffness, as frequency of the pair; 0: rigid
    Real damping = 0;   // 0 to 1e4; damping ratio of a soft joint; 1 is critical
};

/// Distance joint between the anchors: a spring, a rod (hertz 0, equal limits), a rope (hertz 0,
/// limits from 0 to its length) or a winch (motor). One of them must be set.
struct DistanceJoint {
    JointEnds ends{};
    Real length = 1;               // m, rest length of the spring; 0 to kMaxCoordinate
    Real hertz = 0;                // 0 to 1e4; stiffness, as frequency of the pair; 0: no spring
    Real damping = 0;              // 0 to 1e4; damping ratio of the spring; 1 is critical
    std::optional<Range> limits{}; // m, of the distance; 0 to kMaxCoordinate
    Real motorSpeed = 0;           // m/s, of the distance; within kMaxSpeed
    Real motorForce = 0;           // N, >= 0; the largest; 0: no motor
};

/// Prismatic joint: b slides along an axis fixed to a, without relative rotation.
struct PrismaticJoint {
    JointEnds ends{};
    Vec2 axis{1, 0};               // unit, in the frame of a's shape
    Real reference = 0;            // rad, within 1e4; relative angle of b
    std::optional<Range> limits{}; // m, of anchor b along the axis from anchor a
    Real motorSpeed = 0;           // m/s along the axis; within kMaxSpeed
    Real motorForce = 0;           // N, >= 0; the largest; 0: no motor
    Real target = 0;               // m, within kMaxCoordinate; rest translation of the spring
    Real hertz = 0;                // 0 to 1e4; stiffness, as frequency of the pair; 0: no spring
    Real damping = 0;              // 0 to 1e4; damping ratio of the spring; 1 is critical
};

/// Motor joint: drives b to a position and an angle relative to a, with limited force. With hertz
/// 0 it only brakes their relative motion, as friction does. Force and torque of 0 together are
/// refused.
struct MotorJoint {
    JointEnds ends{};   // anchor b is driven to anchor a
    Real reference = 0; // rad, within 1e4; target of the relative angle of b
    Real force = 0;     // N, >= 0; the largest
    Real torque = 0;    // N m, >= 0; the largest
    Real hertz = 30;    // 0, or 1e-3 to 1e4; stiffness, as frequency of the pair; 0: friction
    Real damping = 1;   // 0 to 1e4; damping ratio; 1 is critical
};

/// Mouse joint: pulls a point of one body towards a target.
struct MouseJoint {
    BodyId body{};
    Vec2 anchor{};              // m, in the frame of the body's shape; within kMaxCoordinate
    Vec2 target{};              // m, world; within kMaxCoordinate
    Real force = 0;             // N, > 0; the largest
    Real hertz = 5;             // 1e-3 to 1e4; stiffness, with the body's mass
    Real damping = Real(0.7);   // 0 to 1e4; damping ratio; 1 is critical
    std::uint64_t userData = 0; // for the user
};

/// Wheel joint: anchor b, the axle, stays on a line through anchor a that is fixed to a, and b
/// rotates freely. A spring pulls the axle to anchor a. Without spring and motor it is a groove.
struct WheelJoint {
    JointEnds ends{};
    Vec2 axis{0, 1};               // unit, in the frame of a's shape
    std::optional<Range> limits{}; // m, of the axle along the axis from anchor a
    Real hertz = 0;                // 0 to 1e4; stiffness, as frequency of the pair; 0: no spring
    Real damping = 0;              // 0 to 1e4; damping ratio of the spring; 1 is critical
    Real motorSpeed = 0;           // rad/s, of b relative to a; within kMaxSpeed
    Real motorTorque = 0;          // N m, >= 0; the largest; 0: no motor
};

/// Pulley joint: a rope from anchor a over two points of the world to anchor b. It pulls alone:
/// distance of a from groundA + ratio times distance of b from groundB is at most `length`.
struct PulleyJoint {
    JointEnds ends{};
    Vec2 groundA{};  // m, world; within kMaxCoordinate
    Vec2 groundB{};  // m, world; within kMaxCoordinate
    Real length = 1; // m; 0 to kMaxCoordinate
    Real ratio = 1;  // 1e-3 to 1e3; above 1, b moves less and is pulled harder
};

/// Gear joint. Both bodies rotate, as seen from the line between their anchors, so that the speed
/// of b is `ratio` times that of a: negative for teeth, positive for a belt. With a rack, which is
/// fixed to a, b rolls along it instead: `ratio` is its way (m) per rad. If the axle of b is held,
/// the rack moves by -ratio per rad. On one axle, or nearly so, speeds are those in the World.
struct GearJoint {
    JointEnds ends{};           // anchors: the axles; other joints hold them
    Real ratio = -1;            // size 1e-3 to 1e3
    std::optional<Vec2> rack{}; // unit, in the frame of a's shape
};

/// Filter joint: the two bodies do not collide with each other. Like those of each joint, they
/// sleep and wake together; nothing else connects them, so it has no load and cannot break.
struct FilterJoint {
    JointEnds ends{};
};

/// Any joint, as World::add() takes it.
using JointDef = std::variant<RevoluteJoint, FixedJoint, DistanceJoint, PrismaticJoint, MotorJoint,
                              MouseJoint, WheelJoint, PulleyJoint, GearJoint, FilterJoint>;

/// The reason why World::add() would refuse a joint, in a World with that length unit (m). It
/// does not check that the bodies exist.
KODO_API std::optional<Problem> check(const JointDef& def, Real lengthUnit = 1);

/// The bodies of a joint; those of a MouseJoint are equal.
KODO_API BodyId firstBody(const JointDef& def);
KODO_API BodyId secondBody(const JointDef& def);

/// Where a joint is, and how it moves. All speeds are those of b relative to a.
struct JointState {
    Vec2 anchorA{};        // m, world; of a MouseJoint: the target
    Vec2 anchorB{};        // m, world
    Real angle = 0;        // rad, of b relative to a, from `reference`; -pi to pi, or counted
    Real angularSpeed = 0; // rad/s
    Real length = 0;       // m, between the anchors; of a PulleyJoint: of the taut rope
    Real lengthSpeed = 0;  // m/s
    Real translation = 0;  // m, along the axis of a PrismaticJoint or WheelJoint; else 0
    Real speed = 0;        // m/s, likewise
};

/// Numbers of a spring, as the joints have them.
struct Spring {
    Real hertz = 0;
    Real damping = 0; // damping ratio
};

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
