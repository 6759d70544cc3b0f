// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "joints/articulated_trees.hpp"
#include "joints/body_rotations.hpp"
#include "joints/joint_rows.hpp"

#include <cmath>
#include <numbers>

namespace kodo {
inline namespace KODO_PRECISION {

/// How a constraint is solved in the relax pass.
enum class Relax : std::uint8_t {
    Rigid, // without its error, so that the bias leaves no velocity
    Same,  // with its error: limits that are not reached yet, and motor and mouse joints
    Done,  // not at all: the force of a spring has acted in full
};

/// True for a body that impulses turn, but do not move.
inline bool turnsOnly(const BodyVelocity& motion) {
    return motion.invMass == 0 && motion.invInertia > 0;
}

/// The angle (rad) of that direction which is nearest to another one.
inline Real withTurns(Real angle, Real near) {
    constexpr Real kTurn = 2 * std::numbers::pi_v<Real>;
    return angle + kTurn * std::round((near - angle) / kTurn);
}

/// The two bodies and anchors of a joint, current within the step, in world axes.
struct JointFrame {
    BodyVelocity& a;
    BodyVelocity& b;
    Rot rotationA;
    Rot rotationB;
    const Transform& startA; // pose at the start of the step
    const Transform& startB;
    Vec2 armA{}; // m, from a's centre of mass to its anchor
    Vec2 armB{};
    Vec2 gap{}; // m, anchor b minus anchor a

    /// Arm of a (m) to anchor b. Both impulses of a joint act at anchor b, so that they conserve
    /// angular momentum however wide the gap is. The gap is then measured in the frame of a.
    Vec2 commonArm() const { return armA + gap; }

    /// Angle of b relative to a (rad), minus a reference; -pi to pi.
    Real angle(Real reference) const {
        return (rotationB * rotationA.inverse() * Rot::fromAngle(-reference)).angle();
    }
    /// The same with whole turns; `start` (rad) is that angle at the start of the step.
    Real countedAngle(Real reference, Real start) const {
        return withTurns(angle(reference), start + (b.deltaAngle - a.deltaAngle));
    }

    Vec2 placeA() const { return startA.position + a.deltaPosition + armA; } // m, world
    Vec2 placeB() const { return startB.position + b.deltaPosition + armB; }
    /// The gap at the start of the step (m).
    Vec2 startGap() const {
        const auto arm = [](Rot start, Rot now, Vec2 v) { return start * (now.inverse() * v); };
        return startB.position - startA.position + arm(startB.rotation, rotationB, armB) -
               arm(startA.rotation, rotationA, armA);
    }
};

/// True for a joint that stores how many turns its angle has made.
inline bool countsTurns(const RevoluteJoint& joint) {
    constexpr Real kWithin = 3; // rad; such limits need no turns
    return joint.hertz > 0 || joint.ratchet != 0 ||
           (joint.limits && (joint.limits->lower < -kWithin || joint.limits->upper > kWithin));
}

/// False if the axles of a gear are so near, beside the size of its bodies, that the direction of
/// their line is noise: as on one axle. The bodies then rotate as seen from the World.
inline bool hasLine(const JointFrame& frame) {
    constexpr Real kLeast = Real(1) / 16; // of the radius of gyration about the axle
    const auto gyration = [](const BodyVelocity& body, Vec2 arm) {
        return body.invInertia > 0 ? body.invMass / body.invInertia + lengthSquared(arm) : Real(0);
    };
    return lengthSquared(frame.gap) >
           kLeast * kLeast * std::max(gyration(frame.a, frame.armA), gyration(frame.b, frame.armB));
}

/// Way of a gear from its initial mesh, at the end of the displacements: rad, or m along the rack.
/// `start`: the same at the start of the step.
inline Real slipOf(const GearJoint& joint, const JointFrame& frame, Real start) {
    const Real turnA = frame.a.deltaAngle;
    const Real turnB = frame.b.deltaAngle;
    const Vec2 before = frame.startGap();
    if (joint.rack) {
        return start + dot(frame.rotationA * *joint.rack, frame.gap) -
               dot(frame.startA.rotation * *joint.rack, before) - joint.ratio * (turnB - turnA);
    }
    const Real line = hasLine(frame) && before != Vec2{}
                          ? Rot{dot(before, frame.gap), cross(before, frame.gap)}.angle()
                          : Real(0);
    return start + turnB - joint.ratio * turnA - (1 - joint.ratio) * line;
}

/// Constraint along an axis fixed to a; `gap` (m) is from anchor a to the point where it acts on a.
inline AxisConstraint linearAlong(Vec2 axis, Vec2 gap, const JointFrame& frame) {
    return {
        .axis = axis, .leverA = cross(frame.armA + gap, axis), .leverB = cross(frame.armB, axis)};
}

/// Length (m) of the taut rope of a pulley.
inline Real lengthOf(const PulleyJoint& joint, const JointFrame& frame) {
    return length(frame.placeA() - joint.groundA) +
           joint.ratio * length(frame.placeB() - joint.groundB);
}

/// The row that shortens the rope of a pulley: it pulls both bodies towards points of the world.
inline AxisConstraint ropeOf(const PulleyJoint& joint, const JointFrame& frame) {
    const auto along = [](Vec2 rope) {
        const Real size = length(rope);
        return size > 0 ? rope / size : Vec2{0, -1};
    };
    const Vec2 alongA = along(frame.placeA() - joint.groundA);
    const Vec2 alongB = -joint.ratio * along(frame.placeB() - joint.groundB);
    return {.axis = alongB,
            .leverA = cross(frame.armA, alongA),
            .leverB = cross(frame.armB, alongB),
            .axisA = alongA};
}

/// The row of a gear. Teeth act where both bodies move alike: on the line through the anchors. So
/// they conserve angular momentum, whatever holds the axles. On one axle only the World holds them.
inline AxisConstraint teethOf(const GearJoint& joint, const JointFrame& frame) {
    AxisConstraint row;
    if (joint.rack) {
        row = linearAlong(frame.rotationA * *joint.rack, frame.gap, frame);
        row.couple = -joint.ratio;
        row.leverA -= joint.ratio;
    } else {
        const Vec2 across = hasLine(frame) ? perp(frame.gap) / lengthSquared(frame.gap) : Vec2{};
        row = linearAlong((joint.ratio - 1) * across, {}, frame);
        row.couple = 1;
        row.leverA += joint.ratio;
    }
    row.leverB += row.couple;
    return row;
}

/// Joints of a body that can only rotate are solved exactly, one at a time.
inline ErrorRemoval errorsOf(const JointFrame& frame, const JointPass& pass) {
    return turnsOnly(frame.a) || turnsOnly(frame.b) ? ErrorRemoval::ByVelocity : pass.errors;
}

/// Of the equality constraints that are solved one by one.
inline Softness softnessOf(const JointFrame& frame, const JointPass& pass) {
    return errorsOf(frame, pass) == ErrorRemoval::ByVelocity ? pass.stiff : Softness{};
}

/// Anchors move on circles about the centres of mass, but the velocity constraint is tangential.
/// The difference widens the gap within the substep and is removed in full, or left to the
/// displacements: as a velocity it conserves the energy of loops, but what the passes leave of it
/// adds energy, and constraints that exclude each other would add up impulses without end. The
/// present gap, as rotated with body a, is removed at the rate of the stiffness; at most
/// `mostError` (m) of it counts.
inline PointConstraint anchorsOf(const JointFrame& frame, const JointPass& pass, Real mostError) {
    const Real angleA = pass.h * frame.a.angularVelocity;
    Vec2 gap = frame.gap + angleA * perp(frame.gap) + fromTangentToArc(angleA, frame.gap);
    const Real size = length(gap);
    if (size > mostError) {
        gap = (mostError / size) * gap;
    }
    Vec2 arc;
    if (pass.exact || errorsOf(frame, pass) == ErrorRemoval::ByVelocity) {
        arc = fromTangentToArc(pass.h * frame.b.angularVelocity, frame.armB) -
              fromTangentToArc(angleA, frame.commonArm());
    }
    const Softness rigid{pass.stiff.biasRate, 1, 0};
    return {frame.commonArm(), frame.armB, gap, pass.exact ? rigid : softnessOf(frame, pass),
            (1 / pass.h) * arc};
}

inline JointFrame frameOf(Bodies& bodies, BodyRotations& turned, const JointEnds& ends) {
    const std::uint32_t a = ends.a.index;
    const std::uint32_t b = ends.b.index;
    JointFrame frame{bodies.motion[a],           bodies.motion[b], turned.rotation(bodies, a),
                     turned.rotation(bodies, b), bodies.pose[a],   bodies.pose[b]};
    frame.armA = armOf(bodies, a, frame.rotationA, ends.anchorA);
    frame.armB = armOf(bodies, b, frame.rotationB, ends.anchorB);
    frame.gap = (bodies.pose[b].position - bodies.pose[a].position) +
                (frame.b.deltaPosition - frame.a.deltaPosition) + (frame.armB - frame.armA);
    return frame;
}

/// Body a of a mouse joint is its target: an immovable body.
inline JointFrame frameOf(Bodies& bodies, BodyRotations& turned, const MouseJoint& mouse,
                          BodyVelocity& target) {
    const std::uint32_t b = mouse.body.index;
    static constexpr Transform kOrigin{};
    JointFrame frame{target,  bodies.motion[b], {}, turned.rotation(bodies, b),
                     kOrigin, bodies.pose[b]};
    frame.armB = armOf(bodies, b, frame.rotationB, mouse.anchor);
    frame.gap = bodies.pose[b].position + frame.b.deltaPosition + frame.armB - mouse.target;
    return frame;
}

} // namespace KODO_PRECISION
} // namespace kodo
