// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint_set.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {

/// The two ends of a joint at this moment within the step, in world axes.
struct JointFrame {
    Motion& a;
    Motion& b;
    Vec2 armA; // m, from a's centre of mass to its anchor
    Vec2 armB;
    Vec2 gap; // m, anchor b minus anchor a
    Rot rotationA;
    Rot rotationB;

    /// Of b relative to a, minus a reference; -pi..pi.
    Real angle(Real reference) const {
        return (rotationB * rotationA.inverse() * Rot::fromAngle(-reference)).angle();
    }
};

/// How a constraint is solved in the pass that takes the bias out again.
enum class Relax : std::uint8_t {
    Rigid, // without its error, so that it leaves no speed behind
    Same,  // as before: a spring is meant to give, a limit not yet reached to wait
};

/// Lists the constraints that make up a joint. `visit` gets (PointConstraint, Vec2& impulse, Relax)
/// or (AxisConstraint, Real& impulse, Relax).
template <typename Visit>
class JointKinds {
public:
    JointKinds(JointSet::Joint& joint, const JointFrame& frame, const JointPass& pass, Visit visit)
        : joint_(joint), frame_(frame), pass_(pass), visit_(visit) {}

    void operator()(const Pin& pin) {
        const PointConstraint point = anchors();
        motor(angularBeside(point), 0, pin.motorSpeed, pin.motorTorque);
        if (pin.limits) {
            const Real angle = frame_.angle(pin.reference);
            limit(angularBeside(point), 1, angle - pin.limits->lower);
            limit(reversed(angularBeside(point)), 2, pin.limits->upper - angle);
        }
        visit_(point, joint_.point, Relax::Rigid);
    }

    void operator()(const Weld& weld) {
        const PointConstraint point = anchors();
        fix(angularBeside(point), 0, frame_.angle(weld.reference));
        visit_(point, joint_.point, Relax::Rigid);
    }

    void operator()(const Spring& spring) {
        const Real distance = length(frame_.gap);
        AxisConstraint along = linear(distance > 0 ? frame_.gap / distance : Vec2{0, 1}, {});
        if (spring.hertz > 0) {
            along.error = distance - spring.length;
            along.softness = Softness::from(spring.hertz, spring.damping, pass_.h);
            visit_(along, joint_.axes[0], Relax::Same);
        }
        if (spring.limits) {
            limit(along, 1, distance - spring.limits->lower);
            limit(reversed(along), 2, spring.limits->upper - distance);
        }
    }

    void operator()(const Slider& slider) {
        const Vec2 axis = frame_.rotationA * slider.axis;
        fix(linear(perp(axis), frame_.gap), 0, dot(perp(axis), frame_.gap));
        fix(angular(), 1, frame_.angle(slider.reference));
        const AxisConstraint along = linear(axis, frame_.gap);
        motor(along, 2, slider.motorSpeed, slider.motorForce);
        if (slider.limits) {
            const Real place = dot(axis, frame_.gap);
            limit(along, 3, place - slider.limits->lower);
            limit(reversed(along), 4, slider.limits->upper - place);
        }
    }

    void operator()(const Motor& motor) {
        const Softness soft = Softness::from(motor.hertz, motor.damping, pass_.h);
        if (motor.force > 0) {
            visit_(
                PointConstraint{frame_.armA, frame_.armB, frame_.gap, soft, motor.force * pass_.h},
                joint_.point, Relax::Same);
        }
        if (motor.torque > 0) {
            AxisConstraint turn = angular();
            turn.error = frame_.angle(motor.reference);
            turn.softness = soft;
            turn.bounds = {-motor.torque * pass_.h, motor.torque * pass_.h};
            visit_(turn, joint_.axes[0], Relax::Same);
        }
    }

    void operator()(const Mouse& mouse) {
        visit_(PointConstraint{frame_.armA, frame_.armB, frame_.gap,
                               Softness::from(mouse.hertz, mouse.damping, pass_.h),
                               mouse.force * pass_.h},
               joint_.point, Relax::Same);
    }

private:
    /// The anchors move on circles about their centres of mass, but a velocity moves them along the
    /// tangents. By the end of the substep the difference opens the gap further: that part is taken
    /// out in full, and of the gap that is there now the share that the stiffness says. The angles
    /// include what the joints are expected to change of the spins.
    PointConstraint anchors() const {
        const Vec2 bent = bend(frame_.b, pass_.foreseen.spinB, frame_.armB) -
                          bend(frame_.a, pass_.foreseen.spinA, frame_.armA);
        const Vec2 error = frame_.gap + bent / (pass_.stiff.biasRate * pass_.h);
        const Softness rigid{pass_.stiff.biasRate, 1, 0};
        return {frame_.armA, frame_.armB, error, pass_.exact ? rigid : pass_.stiff};
    }

    /// From the end of the tangent to that of the arc, for up to a radian: (cos - 1) r and (sin -
    /// angle) r', as far as their fourth order.
    Vec2 bend(const Motion& motion, Real gain, Vec2 arm) const {
        const Real turn = std::clamp(pass_.h * (motion.angularVelocity + gain), Real(-1), Real(1));
        const Real square = turn * turn;
        return square * ((square / 24 - Real(0.5)) * arm - turn / 6 * perp(arm));
    }

    AxisConstraint angular() const { return {{}, 1, 1, 0, 0, {}, kUnbounded, {}}; }

    /// With the point solved right after it.
    AxisConstraint angularBeside(const PointConstraint& point) const {
        AxisConstraint axis = angular();
        axis.beside = {&point, joint_.point, pass_.biased};
        return axis;
    }

    /// Along an axis that turns with a; `gap` is how far b's anchor lies from a's.
    AxisConstraint linear(Vec2 axis, Vec2 gap) const {
        return {
            axis, cross(frame_.armA + gap, axis), cross(frame_.armB, axis), 0, 0, {}, kUnbounded,
            {}};
    }

    static AxisConstraint reversed(AxisConstraint axis) {
        axis.axis = -axis.axis;
        axis.leverA = -axis.leverA;
        axis.leverB = -axis.leverB;
        return axis;
    }

    void fix(AxisConstraint axis, std::size_t slot, Real error) {
        axis.error = error;
        axis.softness = pass_.stiff;
        visit_(axis, joint_.axes[slot], Relax::Rigid);
    }

    void motor(AxisConstraint axis, std::size_t slot, Real speed, Real most) {
        if (most > 0) {
            axis.speed = speed;
            axis.bounds = {-most * pass_.h, most * pass_.h};
            visit_(axis, joint_.axes[slot], Relax::Rigid);
        }
    }

    /// Keeps `room` from falling below zero. While there is room, it may be used up within the
    /// substep, and no more.
    void limit(AxisConstraint axis, std::size_t slot, Real room) {
        axis.error = room;
        axis.softness = room > 0 ? Softness::rigid(pass_.h) : pass_.stiff;
        axis.bounds.lower = 0;
        visit_(axis, joint_.axes[slot], room > 0 ? Relax::Same : Relax::Rigid);
    }

    JointSet::Joint& joint_;
    const JointFrame& frame_;
    const JointPass& pass_;
    Visit visit_;
};

} // namespace kodo::inline KODO_PRECISION
