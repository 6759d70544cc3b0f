// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_set.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {

/// True for a body that impulses turn, but do not move.
inline bool turnsOnly(const BodyVelocity& motion) {
    return motion.invMass == 0 && motion.invInertia > 0;
}

/// The two bodies and anchors of a joint, current within the step, in world axes.
struct JointFrame {
    BodyVelocity& a;
    BodyVelocity& b;
    Vec2 armA; // m, from a's centre of mass to its anchor
    Vec2 armB;
    Vec2 gap; // m, anchor b minus anchor a
    Rot rotationA;
    Rot rotationB;

    /// Arm of a (m) to anchor b. Both impulses of a joint act at anchor b, so that they conserve
    /// angular momentum however wide the gap is. The gap is then measured in the frame of a.
    Vec2 commonArm() const { return armA + gap; }

    /// Angle of b relative to a (rad), minus a reference; -pi to pi.
    Real angle(Real reference) const {
        return (rotationB * rotationA.inverse() * Rot::fromAngle(-reference)).angle();
    }
};

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

/// How a constraint is solved in the relax pass.
enum class Relax : std::uint8_t {
    Rigid, // without its error, so that the bias leaves no velocity
    Same,  // with its error: limits that are not reached yet, and motor and mouse joints
    Done,  // not at all: the force of a spring has acted in full
};

/// Visits the constraints of a joint: visit(PointConstraint, Vec2& impulse, Relax) or
/// visit(AxisConstraint, Real& impulse, Relax).
template <typename Visit>
class JointKinds {
public:
    JointKinds(JointSet::Joint& joint, const JointFrame& frame, const JointPass& pass, Visit visit)
        : joint_(joint), frame_(frame), pass_(pass), visit_(visit) {}

    void operator()(const RevoluteJoint& joint) {
        const PointConstraint point = anchors();
        motor(angularBeside(point), 0, joint.motorSpeed, joint.motorTorque);
        if (joint.limits) {
            const Real angle = frame_.angle(joint.reference);
            limit(angularBeside(point), 1, angle - joint.limits->lower);
            limit(reversed(angularBeside(point)), 2, joint.limits->upper - angle);
        }
        visit_(point, joint_.point, Relax::Rigid);
    }

    void operator()(const FixedJoint& joint) {
        const Real error = frame_.angle(joint.reference);
        PointConstraint point = anchors();
        if (!turnsOnly(frame_.a) && !turnsOnly(frame_.b)) {
            visit_(fixed(angularBeside(point), error), joint_.axes[0], Relax::Rigid);
            visit_(point, joint_.point, Relax::Rigid);
            return;
        }
        const AxisConstraint angle = fixed(angular(), error); // last: it holds a small body best
        point.angle = {&angle, joint_.axes[0]};
        visit_(point, joint_.point, Relax::Rigid);
        visit_(angle, joint_.axes[0], Relax::Rigid);
    }

    void operator()(const DistanceJoint& joint) {
        const Real distance = length(frame_.gap);
        AxisConstraint along = linear(distance > 0 ? frame_.gap / distance : Vec2{0, 1}, {});
        if (joint.hertz > 0) {
            along.error = distance - joint.length;
            along.softness = springOf(joint, along);
            const Real most = mostError(along.softness);
            along.error = std::clamp(along.error, -most, most);
            visit_(along, joint_.axes[0], Relax::Done);
        }
        if (joint.limits) {
            limit(along, 1, distance - joint.limits->lower);
            limit(reversed(along), 2, joint.limits->upper - distance);
        }
    }

    void operator()(const PrismaticJoint& joint) {
        const Vec2 axis = frame_.rotationA * joint.axis;
        const AxisConstraint along = linear(axis, frame_.gap);
        motor(along, 2, joint.motorSpeed, joint.motorForce);
        if (joint.limits) {
            const Real place = dot(axis, frame_.gap);
            limit(along, 3, place - joint.limits->lower);
            limit(reversed(along), 4, joint.limits->upper - place);
        }
        const AxisConstraint angle = fixed(angular(), frame_.angle(joint.reference));
        AxisConstraint across = fixed(linear(perp(axis), frame_.gap), dot(perp(axis), frame_.gap));
        across.angle = {&angle, joint_.axes[1]};
        visit_(across, joint_.axes[0], Relax::Rigid);
        visit_(angle, joint_.axes[1], Relax::Rigid);
    }

    void operator()(const MotorJoint& joint) {
        const Softness soft = Softness::from(joint.hertz, joint.damping, pass_.h);
        if (joint.force > 0) {
            visit_(
                PointConstraint{
                    frame_.commonArm(), frame_.armB, frame_.gap, soft, {}, joint.force * pass_.h},
                joint_.point, Relax::Same);
        }
        if (joint.torque > 0) {
            AxisConstraint turn = angular();
            turn.error = frame_.angle(joint.reference);
            turn.softness = soft;
            turn.bounds = {-joint.torque * pass_.h, joint.torque * pass_.h};
            visit_(turn, joint_.axes[0], Relax::Same);
        }
    }

    void operator()(const MouseJoint& mouse) {
        visit_(PointConstraint{frame_.armA,
                               frame_.armB,
                               frame_.gap,
                               Softness::from(mouse.hertz, mouse.damping, pass_.h),
                               {},
                               mouse.force * pass_.h},
               joint_.point, Relax::Same);
    }

private:
    PointConstraint anchors() const { return anchorsOf(frame_, pass_, mostError(pass_.stiff)); }

    /// Largest error (m or rad) that counts, see JointSet::boundBias().
    Real mostError(const Softness& softness) const {
        return joint_.mostBias / (softness.biasRate * softness.massScale);
    }

    /// Stiffness and damping of a spring are those of the reduced mass of its bodies, whatever the
    /// levers of its anchors are: a stiffness that varies with the direction would add energy.
    /// Levers raise the frequency and the damping ratio along its axis by the same factor.
    Softness springOf(const DistanceJoint& joint, const AxisConstraint& along) const {
        const Real free = frame_.a.invMass + frame_.b.invMass;
        // of bodies that can only rotate: at the anchors, across their arms
        const Real mass = free > 0 ? free
                                   : frame_.a.invInertia * lengthSquared(frame_.armA) +
                                         frame_.b.invInertia * lengthSquared(frame_.armB);
        const Real give = free + frame_.a.invInertia * along.leverA * along.leverA +
                          frame_.b.invInertia * along.leverB * along.leverB;
        const Real factor = mass > 0 ? std::sqrt(give / mass) : Real(1);
        return Softness::spring(factor * joint.hertz, factor * joint.damping, pass_.h,
                                joint_.springBound);
    }

    AxisConstraint angular() const { return {.axis = {}, .leverA = 1, .leverB = 1}; }

    /// An angular constraint that accounts for the point solved right after it.
    AxisConstraint angularBeside(const PointConstraint& point) const {
        AxisConstraint axis = angular();
        axis.beside = {&point, joint_.point, pass_.biased};
        return axis;
    }

    /// Constraint along an axis fixed to a; `gap` (m) is anchor b minus anchor a.
    AxisConstraint linear(Vec2 axis, Vec2 gap) const {
        return {.axis = axis,
                .leverA = cross(frame_.armA + gap, axis),
                .leverB = cross(frame_.armB, axis)};
    }

    static AxisConstraint reversed(AxisConstraint axis) {
        axis.axis = -axis.axis;
        axis.leverA = -axis.leverA;
        axis.leverB = -axis.leverB;
        return axis;
    }

    AxisConstraint fixed(AxisConstraint axis, Real error) const {
        const Real most = mostError(pass_.stiff);
        axis.error = std::clamp(error, -most, most);
        axis.softness = pass_.exact ? pass_.stiff : softnessOf(frame_, pass_);
        return axis;
    }

    void motor(AxisConstraint axis, std::size_t slot, Real speed, Real most) {
        if (most > 0) {
            axis.speed = speed;
            axis.bounds = {-most * pass_.h, most * pass_.h};
            visit_(axis, joint_.axes[slot], Relax::Rigid);
        }
    }

    /// Keeps `room` (m or rad) at or above zero. A positive room may be closed within the substep,
    /// but not exceeded.
    void limit(AxisConstraint axis, std::size_t slot, Real room) {
        axis.error = std::max(room, -mostError(pass_.stiff));
        axis.softness = room > 0 ? Softness::rigid(pass_.h) : pass_.stiff;
        axis.bounds.lower = 0;
        visit_(axis, joint_.axes[slot], room > 0 ? Relax::Same : Relax::Rigid);
    }

    JointSet::Joint& joint_;
    const JointFrame& frame_;
    const JointPass& pass_;
    Visit visit_;
};

} // namespace KODO_PRECISION
} // namespace kodo
