// SPDX-License-Identifier: MIT
// The passes over joints.
#include "joints/joint_kinds.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Calls visit(frame, constraint, impulse, relax) for all constraints of a joint.
template <typename Visit>
void forConstraints(JointSet::Joint& joint, Bodies& bodies, BodyRotations& turned,
                    const JointPass& pass, Visit visit) {
    const auto list = [&](const JointFrame& frame, const auto& kind) {
        const auto one = [&](const auto& constraint, auto& impulse, Relax relax) {
            visit(frame, constraint, impulse, relax);
        };
        JointKinds(joint, frame, pass, one)(kind);
    };
    std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.ends; }) {
                list(frameOf(bodies, turned, kind.ends), kind);
            } else {
                BodyVelocity target;
                list(frameOf(bodies, turned, kind, target), kind);
            }
        },
        joint.def);
}

/// True for equality constraints without bounds; false for springs, limits and motors.
bool isHeld(const PointConstraint& point, Relax relax) {
    return relax == Relax::Rigid && point.maxImpulse == std::numeric_limits<Real>::infinity();
}
bool isHeld(const AxisConstraint& axis, Relax relax) {
    return relax == Relax::Rigid && axis.bounds == kUnbounded;
}

/// True for a limit that is reached, of an angle nearly: a limit that is held must not lose it by
/// rounding.
bool isReached(const AxisConstraint& axis) {
    return axis.bounds == kOneSided &&
           axis.error <= (axis.axis == Vec2{} ? HeldRows::kNear : Real(0));
}

/// Rotates the accumulated impulse at the anchors, if one of the bodies can only rotate. The angle
/// is that by which the body of the larger response rotated in the substep of h (s). So the impulse
/// has the same torque on it in the next substep. Otherwise a small body would rotate by any angle,
/// and the arcs of the anchors depend on that angle.
void rotateImpulse(JointSet::Joint& joint, const JointFrame& frame, Real h) {
    const Real a = frame.a.invInertia * lengthSquared(frame.commonArm());
    const Real b = frame.b.invInertia * lengthSquared(frame.armB);
    if (a != b && (turnsOnly(frame.a) || turnsOnly(frame.b))) {
        joint.point = Rot::fromAngle(h * (a > b ? frame.a : frame.b).angularVelocity) * joint.point;
    }
}

/// Applies the accumulated impulses of one joint. Constraints of the direct solve start with their
/// reaction to the other impulses.
class WarmStart {
public:
    WarmStart(JointSet::Joint& joint, const Bodies& bodies, bool inTree)
        : joint_(joint), inTree_(inTree), before_(spinOf(joint, bodies)) {}

    void operator()(const JointFrame& frame, const PointConstraint& point, Vec2& impulse,
                    Relax relax) const {
        const bool revolute = std::holds_alternative<RevoluteJoint>(joint_.def);
        if (inTree_ && isHeld(point, relax)) {
            const Real twist = joint_.axes[0] + joint_.axes[1] - joint_.axes[2] + joint_.axes[3];
            impulse = revolute ? point.reaction(frame.a, frame.b, twist) : Vec2{};
        }
        point.apply(frame.a, frame.b, impulse);
    }

    void operator()(const JointFrame& frame, const AxisConstraint& axis, Real& impulse,
                    Relax relax) const {
        if (isHeld(axis, relax)) {
            impulse = inTree_ ? Real(0) : impulse;
            keepAngle(frame, axis, impulse);
        }
        axis.apply(frame.a, frame.b, impulse);
    }

private:
    /// Where the angle is solved last, its impulse restores the relative rotation from before the
    /// other impulses.
    void keepAngle(const JointFrame& frame, const AxisConstraint& axis, Real& impulse) const {
        const Real sum = frame.a.invInertia + frame.b.invInertia;
        const bool fixed = std::holds_alternative<FixedJoint>(joint_.def);
        const bool small = fixed && (turnsOnly(frame.a) || turnsOnly(frame.b));
        if (axis.axis == Vec2{} && sum > 0 && (small || (inTree_ && !fixed))) {
            impulse = (before_ - (frame.b.angularVelocity - frame.a.angularVelocity)) / sum;
        }
    }

    JointSet::Joint& joint_;
    bool inTree_;
    Real before_; // rad/s, of b relative to a
};

/// Moves the two bodies of a joint so that a share of its errors vanishes. The constraints act on
/// displacements as they do on velocities. So linear and angular momentum are conserved, and no
/// velocity changes.
class Displacement {
public:
    /// `most`: m or rad, of the errors; `allowed` (m or rad) is left to limits, whose velocities
    /// carry usual loads. Of a joint in a tree, limits alone are left to displacements.
    Displacement(Bodies& bodies, const JointEnds& ends, Real share, Real most, Real allowed,
                 bool inTree)
        : moveOfA_(bodies.motion[ends.a.index]),
          moveOfB_(bodies.motion[ends.b.index]),
          a_(atRest(moveOfA_)),
          b_(atRest(moveOfB_)),
          share_(share),
          allowed_(allowed),
          inTree_(inTree) {
        joint_.mostBias = most;
    }

    template <typename Kind>
    void remove(const Kind& kind, const JointFrame& now, Real counted) {
        if (turnsOnly(a_) || turnsOnly(b_)) {
            return; // see errorsOf()
        }
        joint_.counted = counted;
        const JointFrame frame{a_,         b_,       now.rotationA, now.rotationB, now.startA,
                               now.startB, now.armA, now.armB,      now.gap};
        const JointPass pass{.h = 1, .stiff = {share_, 1, 0}, .biased = true, .exact = inTree_};
        JointKinds(joint_, frame, pass, [&](const auto& constraint, auto& impulse, Relax relax) {
            if (relax != Relax::Rigid || constraint.softness.biasRate == 0) {
                return; // a motor, a spring, or a limit that is not reached
            }
            auto remaining = constraint;
            if constexpr (requires { remaining.bounds; }) {
                remaining.error += isHeld(constraint, relax) ? 0 : allowed_;
            }
            if (!isHeld(constraint, relax) || !inTree_) {
                remaining.solve(a_, b_, impulse, true);
            }
        })(kind);
        moveOfA_.deltaPosition += a_.velocity;
        moveOfA_.deltaAngle += a_.angularVelocity;
        moveOfB_.deltaPosition += b_.velocity;
        moveOfB_.deltaAngle += b_.angularVelocity;
    }

private:
    static BodyVelocity atRest(BodyVelocity motion) {
        motion.velocity = {};
        motion.angularVelocity = 0;
        return motion;
    }

    BodyVelocity& moveOfA_;
    BodyVelocity& moveOfB_;
    BodyVelocity a_; // displacements in place of velocities
    BodyVelocity b_;
    JointSet::Joint joint_; // without impulses
    Real share_;
    Real allowed_;
    bool inTree_;
};

} // namespace

void JointSet::warmStart(Bodies& bodies, const JointPass& pass) {
    lastPass_ = LastPass::WarmStart;
    for (const Hinge& hinge : hinges_) {
        // the direct solve starts from zero
        hinge.rows->pull = length(std::exchange(joints_[hinge.joint].point, Vec2{})) / pass.h;
    }
    for (const std::uint32_t index : own_) {
        Joint& joint = joints_[index];
        HeldRows* const rows = trees_.rowsOf(index);
        if (rows != nullptr) {
            rows->pull = length(joint.point) / pass.h;
            if (pass.errors == ErrorRemoval::ByVelocity &&
                std::holds_alternative<RevoluteJoint>(joint.def)) { // the direct solve holds limits
                rows->side =
                    std::exchange(joint.axes[1], Real(0)) - std::exchange(joint.axes[2], Real(0));
            }
        }
        WarmStart start(joint, bodies, rows != nullptr);
        forConstraints(joint, bodies, turned_, {pass.h, pass.stiff, pass.biased, rows != nullptr},
                       start);
    }
}

/// Raises inertia to the bounds that follow from the forces of springs, ropes and rods.
void JointSet::raiseInertias(Bodies& bodies, const JointPass& pass) {
    for (const std::uint32_t index : own_) {
        const Joint& joint = joints_[index];
        const auto* const kind = std::get_if<DistanceJoint>(&joint.def);
        if (kind == nullptr) {
            continue;
        }
        const JointFrame frame = frameOf(bodies, turned_, kind->ends);
        Real force = 0;
        for (const Real impulse : joint.axes) {
            force += std::abs(impulse) / pass.h;
        }
        if (kind->hertz > 0) {
            const Real extension = length(frame.gap) - kind->length;
            const Real carried = 1 + Softness::springLag(pass.h, joint.springBound);
            force = std::max(force, joint.stiffness / carried * std::abs(extension));
        }
        inertias_.add(bodies, kind->ends.a.index, force * length(frame.armA));
        inertias_.add(bodies, kind->ends.b.index, force * length(frame.armB));
    }
    inertias_.raise(bodies, pass.h);
}

void JointSet::solve(Bodies& bodies, const JointPass& pass) {
    const LastPass before =
        std::exchange(lastPass_, pass.biased ? LastPass::Biased : LastPass::Relax);
    if (before == LastPass::WarmStart && pass.biased) {
        raiseInertias(bodies, pass);
    }
    for (const std::uint32_t index : own_) {
        Joint& joint = joints_[index];
        joint.solved = true;
        joint.atLimit = joint.atLimit && !pass.settle;
        HeldRows* const rows = trees_.rowsOf(index);
        const Real pressed = rows != nullptr && pass.biased ? rows->side : Real(0);
        if (rows != nullptr) {
            *rows = {.armA = {}, .armB = {}, .pull = rows->pull};
        } else if (const JointEnds* const ends = endsOf(joint.def);
                   before == LastPass::Biased && !pass.biased && ends != nullptr &&
                   joint.point != Vec2{}) {
            rotateImpulse(joint, frameOf(bodies, turned_, *ends), pass.h);
        }
        JointPass own = pass;
        own.exact = rows != nullptr;
        forConstraints(
            joint, bodies, turned_, own,
            [&](const JointFrame& frame, const auto& constraint, auto& impulse, Relax relax) {
                if (rows != nullptr && isHeld(constraint, relax)) {
                    rows->armA = frame.commonArm();
                    rows->armB = frame.armB;
                    rows->add(constraint, impulse, joint.slotOf(impulse));
                    return;
                }
                if constexpr (requires { constraint.bounds; }) {
                    if (rows != nullptr && pass.errors == ErrorRemoval::ByVelocity &&
                        isReached(constraint) &&
                        rows->hold(constraint, impulse, pressed, joint.slotOf(impulse))) {
                        if ((bodies.filter[secondBody(joint.def).index].flags & kColliding) != 0) {
                            joint.addLoad(impulse * constraint.give(frame.a, frame.b, false) /
                                              pass.h,
                                          Joint::kMostTurn);
                        }
                        return;
                    }
                }
                if (pass.biased || relax != Relax::Done) {
                    constraint.solve(frame.a, frame.b, impulse,
                                     pass.biased || relax == Relax::Same);
                }
                if constexpr (requires { constraint.bounds; }) {
                    joint.atLimit =
                        joint.atLimit || (constraint.axis != Vec2{} && isReached(constraint) &&
                                          impulse > constraint.borne);
                }
                if (!pass.biased && pass.last) {
                    constraint.addToSums(impulse, joint.linearImpulseSum, joint.angularImpulseSum);
                }
            });
    }
    solveStiffSprings(bodies, pass);
    inertias_.restore(bodies);
    solveTrees(bodies, pass);
}

void JointSet::correct(Bodies& bodies, const JointPass& pass, int passes, Real allowed) {
    const Real share = pass.h * pass.stiff.biasRate * pass.stiff.massScale;
    for (int k = 0; k < passes; ++k) {
        for (const std::uint32_t index : own_) {
            const HeldRows* const rows = trees_.rowsOf(index);
            const Joint& joint = joints_[index];
            const Real most = joint.mostBias * pass.h / static_cast<Real>(passes);
            std::visit(
                [&](const auto& kind) {
                    if constexpr (requires { kind.ends; }) {
                        Displacement move(bodies, kind.ends, share, most, allowed, rows != nullptr);
                        move.remove(kind, frameOf(bodies, turned_, kind.ends), joint.counted);
                    }
                },
                joint.def);
        }
    }
}

/// Repeats the solution of springs with a lag. Their dampers couple all bodies of a row: after one
/// pass, impulses of the substep before would still add energy.
void JointSet::solveStiffSprings(Bodies& bodies, const JointPass& pass) {
    for (int k = 0; pass.biased && k < pass.springPasses; ++k) {
        for (const SpringRates::Spring& spring : springs_.all()) {
            const bool held = std::visit(
                [](const auto& kind) { return kHeldSpring<std::decay_t<decltype(kind)>>; },
                joints_[spring.joint].def);
            if (held || Softness::springLag(pass.h, spring.bound) == 0) {
                continue;
            }
            forConstraints(
                joints_[spring.joint], bodies, turned_, pass,
                [&](const JointFrame& frame, const auto& constraint, auto& impulse, Relax relax) {
                    if (relax == Relax::Done) {
                        constraint.solve(frame.a, frame.b, impulse, true);
                    }
                });
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
