// SPDX-License-Identifier: MIT
// The passes over joints that are solved one by one, and over those of articulated trees.
#include "joints/joint_kinds.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

JointFrame frameOf(Bodies& bodies, BodyRotations& turned, const JointEnds& ends) {
    const std::uint32_t a = ends.a.index;
    const std::uint32_t b = ends.b.index;
    JointFrame frame{bodies.motion[a],           bodies.motion[b],          {}, {}, {},
                     turned.rotation(bodies, a), turned.rotation(bodies, b)};
    frame.armA = armOf(bodies, a, frame.rotationA, ends.anchorA);
    frame.armB = armOf(bodies, b, frame.rotationB, ends.anchorB);
    frame.gap = (bodies.pose[b].position - bodies.pose[a].position) +
                (frame.b.deltaPosition - frame.a.deltaPosition) + (frame.armB - frame.armA);
    return frame;
}

/// Body a of a mouse joint is the target: an immovable body.
JointFrame frameOf(Bodies& bodies, BodyRotations& turned, const MouseJoint& mouse,
                   BodyVelocity& hand) {
    const std::uint32_t b = mouse.body.index;
    JointFrame frame{hand, bodies.motion[b], {}, {}, {}, {}, turned.rotation(bodies, b)};
    frame.armB = armOf(bodies, b, frame.rotationB, mouse.anchor);
    frame.gap = bodies.pose[b].position + frame.b.deltaPosition + frame.armB - mouse.target;
    return frame;
}

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
                BodyVelocity hand;
                list(frameOf(bodies, turned, kind, hand), kind);
            }
        },
        joint.def);
}

/// True for equality constraints without bounds; false for springs, limits and motors.
bool isHeld(const PointConstraint& point) {
    return point.maxImpulse == std::numeric_limits<Real>::infinity();
}
bool isHeld(const AxisConstraint& axis) {
    return axis.bounds == kUnbounded;
}

// A pin is rigid: the body on its axle may turn towards the force at most at 1 / sqrt(8) of the
// angle of InertiaBounds a substep. With 4, it gains 6 % of the energy at 240 Hz; with 8, 1 %.
constexpr Real kPinMargin = 8;

/// The most (N) that keeps the anchor of a body on its circles about its centre of mass and about
/// the axle of another body, which only turns. The angular velocity of that one is not used: it may
/// be wrong by much between the warm start and the solve.
Real centripetalOf(const BodyVelocity& body, Vec2 arm, const BodyVelocity& axle, Real axleArm) {
    const Vec2 speed = velocityAt(body, arm) - axle.velocity;
    const Real spin = body.angularVelocity;
    return (spin * spin * length(arm) + (axleArm > 0 ? lengthSquared(speed) / axleArm : Real(0))) /
           body.invMass;
}

} // namespace

void JointSet::warmStart(Bodies& bodies, const JointPass& pass) {
    warmStarted_ = true;
    for (const std::uint32_t index : own_) {
        HeldRows* const rows = trees_.rowsOf(index);
        const bool inTree = rows != nullptr;
        if (inTree) {
            rows->pull = length(joints_[index].point) / pass.h;
            if (rows->hinge) {
                joints_[index].point = {}; // the direct solve starts from zero
                continue;
            }
        }
        forConstraints(
            joints_[index], bodies, turned_, {pass.h, pass.stiff, pass.biased, inTree},
            [&](const JointFrame& frame, const auto& constraint, auto& impulse, Relax relax) {
                if (inTree && relax == Relax::Rigid && isHeld(constraint)) {
                    impulse = {}; // the direct solve starts from zero
                } else {
                    constraint.push(frame.a, frame.b, impulse);
                }
            });
    }
}

/// Raises inertia to the bounds that follow from the forces of springs, ropes and rods, and of pins
/// on bodies that can only rotate.
void JointSet::raiseInertias(Bodies& bodies, const JointPass& pass) {
    for (const std::uint32_t index : own_) {
        const Joint& joint = joints_[index];
        if (const auto* const pin = std::get_if<RevoluteJoint>(&joint.def);
            pin != nullptr && trees_.rowsOf(index) == nullptr) {
            const JointFrame frame = frameOf(bodies, turned_, pin->ends);
            const bool aTurns = turnsOnly(frame.a);
            const BodyVelocity& body = aTurns ? frame.b : frame.a;
            if (aTurns != turnsOnly(frame.b) && body.invMass > 0) {
                const Real armA = length(frame.commonArm());
                const Real armB = length(frame.armB);
                const Real centripetal =
                    aTurns ? centripetalOf(body, frame.armB, frame.a, armA)
                           : centripetalOf(body, frame.commonArm(), frame.b, armB);
                const Real force = kPinMargin * std::max(length(joint.point) / pass.h, centripetal);
                inertias_.add(bodies, pin->ends.a.index, force * armA);
                inertias_.add(bodies, pin->ends.b.index, force * armB);
            }
        }
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
            force = std::max(force, joint.stiffness * std::abs(extension));
        }
        inertias_.add(bodies, kind->ends.a.index, force * length(frame.armA));
        inertias_.add(bodies, kind->ends.b.index, force * length(frame.armB));
    }
    inertias_.raise(bodies, pass.h);
}

void JointSet::solve(Bodies& bodies, const JointPass& pass) {
    if (pass.biased && std::exchange(warmStarted_, false)) {
        raiseInertias(bodies, pass);
    }
    for (const std::uint32_t index : own_) {
        Joint& joint = joints_[index];
        joint.solved = true;
        HeldRows* const rows = trees_.rowsOf(index);
        if (rows != nullptr && rows->hinge) {
            continue;
        }
        if (rows != nullptr) {
            *rows = {.pull = rows->pull};
        }
        forConstraints(
            joint, bodies, turned_, {pass.h, pass.stiff, pass.biased, rows != nullptr},
            [&](const JointFrame& frame, const auto& constraint, auto& impulse, Relax relax) {
                if (rows != nullptr && relax == Relax::Rigid && isHeld(constraint)) {
                    rows->add(constraint, impulse, joint.slotOf(impulse));
                    return;
                }
                if (pass.biased || relax != Relax::Done) {
                    constraint.solve(frame.a, frame.b, impulse,
                                     pass.biased || relax == Relax::Same);
                }
                if (!pass.biased && pass.last) {
                    constraint.addToSums(impulse, joint.linearImpulseSum, joint.angularImpulseSum);
                }
            });
    }
    if (pass.biased && pass.springPasses > 0) {
        solveStiffSprings(bodies, pass);
    }
    inertias_.restore(bodies);
    measureHinges(bodies, pass);
    solveTrees(bodies, pass);
}

/// Updates the rows of the hinges of trees.
void JointSet::measureHinges(Bodies& bodies, const JointPass& pass) {
    constexpr Real kAll = std::numeric_limits<Real>::infinity();
    for (const Hinge& hinge : hinges_) {
        JointFrame frame{bodies.motion[hinge.a],
                         bodies.motion[hinge.b],
                         {},
                         {},
                         {},
                         turned_.rotation(bodies, hinge.a),
                         turned_.rotation(bodies, hinge.b)};
        frame.armA = frame.rotationA * hinge.anchorA;
        frame.armB = frame.rotationB * hinge.anchorB;
        frame.gap = (bodies.pose[hinge.b].position - bodies.pose[hinge.a].position) +
                    (frame.b.deltaPosition - frame.a.deltaPosition) + (frame.armB - frame.armA);
        hinge.rows->count = 0;
        hinge.rows->add(pass.biased ? anchorsOf(frame, pass, kAll)
                                    : PointConstraint{frame.commonArm(), frame.armB, {}, {}},
                        joints_[hinge.joint].point, 0);
    }
}

/// Repeats the solution of springs with a lag. Their dampers couple all bodies of a row: after one
/// pass, impulses of the substep before would still add energy.
void JointSet::solveStiffSprings(Bodies& bodies, const JointPass& pass) {
    for (int k = 0; k < pass.springPasses; ++k) {
        for (const SpringRates::Spring& spring : springs_.all()) {
            if (Softness::springLag(pass.h, spring.bound) == 0) {
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

/// Solves the articulated trees and stores the impulses of their rows in the joints.
void JointSet::solveTrees(Bodies& bodies, const JointPass& pass) {
    if (trees_.empty()) {
        return;
    }
    trees_.solve(bodies, pass);
    for (const ArticulatedTrees::Edge& edge : treeCandidates_) {
        const HeldRows* const rows = trees_.rowsOf(edge.joint);
        if (rows == nullptr) {
            continue;
        }
        Joint& joint = joints_[edge.joint];
        for (std::size_t r = 0; r < rows->count; ++r) {
            const Real impulse = rows->impulse[r];
            const Vec2 along{rows->b[r][0], rows->b[r][1]};
            joint.impulseAt(rows->slot[r]) = impulse;
            if (pass.biased || !pass.last) {
                continue;
            }
            if (along == Vec2{}) {
                joint.angularImpulseSum += impulse * rows->b[r][2];
            } else {
                joint.linearImpulseSum += impulse * along;
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
