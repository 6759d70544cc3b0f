// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_frame.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace kodo {
inline namespace KODO_PRECISION {

/// A spring of a joint that also holds its bodies. That is solved after the springs, so the damper
/// of a lag would act on bodies as if they were free: rows of such springs gained energy. These
/// springs become softer instead, see Softness::spring(), or lag less where passes repeat them:
/// with a lag of 32, three boxes of 1 : 1000 gain four times their energy at 240 Hz; with 8, half
/// of it.
template <typename Kind>
inline constexpr bool kHeldSpring =
    std::is_same_v<Kind, RevoluteJoint> || std::is_same_v<Kind, PrismaticJoint>;

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
        const Real angle = !joint.limits && joint.hertz == 0 ? Real(0)
                           : countsTurns(joint)
                               ? frame_.countedAngle(joint.reference, joint_.counted)
                               : frame_.angle(joint.reference);
        if (joint.hertz > 0) {
            const AxisConstraint turn = angularBeside(point);
            spring(turn, 3, angle - joint.target,
                   springOf(joint, turn.give(frame_.a, frame_.b, pass_.biased),
                            inverseAbout(frame_.a, frame_.armA) +
                                inverseAbout(frame_.b, frame_.armB)));
        }
        if (joint.limits) {
            limits(angularBeside(point), 1, angle, *joint.limits, joint_.axes[0]);
        }
        visit_(point, joint_.point, Relax::Rigid);
    }

    void operator()(const FixedJoint& joint) {
        const Real error = frame_.angle(joint.reference);
        if (joint.hertz > 0) {
            const Real sum = frame_.a.invInertia + frame_.b.invInertia;
            spring(angular(), 0, error, springOf(joint, sum, sum));
            for (const bool up : {false, true}) { // equally stiff in all directions
                const AxisConstraint row = linear(up ? Vec2{0, 1} : Vec2{1, 0}, frame_.gap);
                spring(row, up ? 2 : 1, up ? frame_.gap.y : frame_.gap.x, springOf(joint, row));
            }
            return;
        }
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
        const AxisConstraint along = linear(distance > 0 ? frame_.gap / distance : Vec2{0, 1}, {});
        if (joint.hertz > 0) {
            spring(along, 0, distance - joint.length, springOf(joint, along));
        }
        motor(along, 3, joint.motorSpeed, joint.motorForce);
        if (joint.limits) {
            limits(along, 1, distance, *joint.limits, joint_.axes[3]);
        }
    }

    void operator()(const PrismaticJoint& joint) {
        const Vec2 axis = frame_.rotationA * joint.axis;
        const AxisConstraint along = linear(axis, frame_.gap);
        motor(along, 2, joint.motorSpeed, joint.motorForce);
        const Real place = dot(axis, frame_.gap);
        if (joint.hertz > 0) {
            spring(along, 5, place - joint.target, springOf(joint, along));
        }
        if (joint.limits) {
            limits(along, 3, place, *joint.limits, joint_.axes[2]);
        }
        const AxisConstraint angle = fixed(angular(), frame_.angle(joint.reference));
        AxisConstraint across = fixed(linear(perp(axis), frame_.gap), dot(perp(axis), frame_.gap));
        across.angle = {&angle, joint_.axes[1]};
        visit_(across, joint_.axes[0], Relax::Rigid);
        visit_(angle, joint_.axes[1], Relax::Rigid);
    }

    void operator()(const MotorJoint& joint) {
        const Softness soft = joint.hertz > 0 ? Softness::from(joint.hertz, joint.damping, pass_.h)
                                              : Softness{}; // brakes alone
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
        const Softness soft = Softness::from(mouse.hertz, mouse.damping, pass_.h);
        const Real most = mouse.force * pass_.h;
        visit_(PointConstraint{frame_.armA, frame_.armB, frame_.gap, soft, {}, most}, joint_.point,
               Relax::Same);
    }

    void operator()(const WheelJoint& joint) {
        const Vec2 axis = frame_.rotationA * joint.axis;
        const AxisConstraint along = linear(axis, frame_.gap);
        const Real place = dot(axis, frame_.gap);
        motor(angular(), 1, joint.motorSpeed, joint.motorTorque);
        if (joint.hertz > 0) {
            spring(along, 2, place, springOf(joint, along));
        }
        if (joint.limits) {
            limits(along, 3, place, *joint.limits, 0);
        }
        visit_(fixed(linear(perp(axis), frame_.gap), dot(perp(axis), frame_.gap)), joint_.axes[0],
               Relax::Rigid);
    }

    void operator()(const PulleyJoint& joint) {
        limit(ropeOf(joint, frame_), 0, joint.length - lengthOf(joint, frame_));
    }

    void operator()(const GearJoint& joint) {
        const Real slip = slipOf(joint, frame_, joint_.counted);
        visit_(fixed(teethOf(joint, frame_), slip), joint_.axes[0], Relax::Rigid);
    }

    void operator()(const FilterJoint&) {}

private:
    PointConstraint anchors() const { return anchorsOf(frame_, pass_, mostError(pass_.stiff)); }

    /// Largest error (m or rad) that counts, see JointSet::boundBias().
    Real mostError(const Softness& softness) const {
        return joint_.mostBias / (softness.biasRate * softness.massScale);
    }

    /// Stiffness and damping of a spring are those of the reduced mass of its bodies, whatever the
    /// levers of its anchors are: a stiffness that varies with the direction would add energy.
    /// Levers raise the frequency and the damping ratio along its axis by the same factor.
    template <typename Kind>
    Softness springOf(const Kind& joint, const AxisConstraint& along) const {
        const Real free = frame_.a.invMass + frame_.b.invMass;
        // of bodies that can only rotate: at the anchors, across their arms
        const Real mass = free > 0 ? free
                                   : frame_.a.invInertia * lengthSquared(frame_.armA) +
                                         frame_.b.invInertia * lengthSquared(frame_.armB);
        const Real give = free + frame_.a.invInertia * along.leverA * along.leverA +
                          frame_.b.invInertia * along.leverB * along.leverB;
        return springOf(joint, give, mass);
    }
    /// `give`: relative velocity per impulse of the row; `mass`: the same of what `hertz` is about.
    template <typename Kind>
    Softness springOf(const Kind& joint, Real give, Real mass) const {
        const Real factor = mass > 0 ? std::sqrt(give / mass) : Real(1);
        const Real held = pass_.errors == ErrorRemoval::ByDisplacement ? 8 : 0;
        return Softness::spring(factor * joint.hertz, factor * joint.damping, pass_.h,
                                joint_.springBound, kHeldSpring<Kind> ? held : Softness::kMostLag);
    }

    void spring(AxisConstraint axis, std::size_t slot, Real error, const Softness& softness) {
        axis.softness = softness;
        axis.beside.held = false; // SpringRates bounds rows of springs as if they were solved so
        axis.error = std::clamp(error, -mostError(softness), mostError(softness));
        visit_(axis, joint_.axes[slot], Relax::Done);
    }

    /// An angular constraint that accounts for the point solved right after it.
    AxisConstraint angularBeside(const PointConstraint& point) const {
        AxisConstraint axis = angular();
        axis.beside = {&point, &joint_.point, pass_.biased, pass_.exact};
        return axis;
    }

    AxisConstraint linear(Vec2 axis, Vec2 gap) const { return linearAlong(axis, gap, frame_); }

    static AxisConstraint angular() { return {.axis = {}, .leverA = 1, .leverB = 1}; }

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
            const bool again = pass_.errors == ErrorRemoval::ByVelocity; // else contacts are last
            visit_(axis, joint_.axes[slot], again ? Relax::Rigid : Relax::Done);
        }
    }

    /// `motor`: impulse of a motor along the axis. The limit that it pushes into bears it.
    void limits(const AxisConstraint& axis, std::size_t slot, Real now, Range range, Real motor) {
        limit(axis, slot, now - range.lower, -motor);
        limit(reversed(axis), slot + 1, range.upper - now, motor);
    }

    /// Keeps `room` (m or rad) at or above zero; a substep may close a positive one.
    void limit(AxisConstraint axis, std::size_t slot, Real room, Real pushed = 0) {
        axis.borne = std::max(pushed, Real(0));
        axis.error = std::max(room, -mostError(pass_.stiff));
        axis.softness = room > 0 ? Softness::rigid(pass_.h) : pass_.stiff;
        axis.bounds = kOneSided;
        visit_(axis, joint_.axes[slot], room > 0 ? Relax::Same : Relax::Rigid);
    }

    JointSet::Joint& joint_;
    const JointFrame& frame_;
    const JointPass& pass_;
    Visit visit_;
};

} // namespace KODO_PRECISION
} // namespace kodo
