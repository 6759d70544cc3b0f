// SPDX-License-Identifier: MIT
// The joints of articulated trees in a pass.
#include "joints/anchor.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// Updates the rows of the hinges of trees.
void JointSet::measureHinges(Bodies& bodies, const JointPass& pass) {
    const Real perH = 1 / pass.h;
    for (const Hinge& hinge : hinges_) {
        if (hinge.rows->lazy && !pass.biased && !pass.settle) {
            continue;
        }
        HeldRows& rows = *hinge.rows;
        const BodyVelocity& a = bodies.motion[hinge.a];
        const BodyVelocity& b = bodies.motion[hinge.b];
        const Vec2 armA = turned_.rotation(bodies, hinge.a) * hinge.anchorA;
        rows.armB = turned_.rotation(bodies, hinge.b) * hinge.anchorB;
        const Vec2 gap = (bodies.pose[hinge.b].position - bodies.pose[hinge.a].position) +
                         (b.deltaPosition - a.deltaPosition) + (rows.armB - armA);
        rows.armA = armA + gap; // see JointFrame::commonArm()
        rows.arc = pass.biased ? perH * (fromTangentToArc(pass.h * b.angularVelocity, rows.armB) -
                                         fromTangentToArc(pass.h * a.angularVelocity, rows.armA))
                               : Vec2{};
        const Vec2 turned = gap + pass.h * a.angularVelocity * perp(gap);
        rows.error = {turned.x, turned.y, 0};
        const Vec2 point = joints_[hinge.joint].point;
        rows.impulse = {point.x, point.y, 0};
        rows.point = true;
    }
}

/// Takes back the impulses of held limits that pull instead of pressing. True if there is one.
bool JointSet::releasePulls(Bodies& bodies) {
    bool any = false;
    for (const std::uint32_t index : own_) {
        HeldRows* const rows = trees_.rowsOf(index);
        if (rows == nullptr || !rows->angle || !(rows->side * rows->impulse[2] < 0)) {
            continue;
        }
        Joint& joint = joints_[index];
        BodyVelocity& a = bodies.motion[firstBody(joint.def).index];
        BodyVelocity& b = bodies.motion[secondBody(joint.def).index];
        const Real pull = std::exchange(rows->impulse[2], Real(0));
        a.angularVelocity += a.invInertia * pull;
        b.angularVelocity -= b.invInertia * pull;
        joint.impulseAt(rows->angleAt) = 0;
        rows->angle = false;
        any = true;
    }
    return any;
}

/// Solves the articulated trees and stores the impulses of their rows in the joints.
void JointSet::solveTrees(Bodies& bodies, const JointPass& pass) {
    if (trees_.empty()) {
        return;
    }
    measureHinges(bodies, pass);
    trees_.solve(bodies, pass);
    while (releasePulls(bodies)) { // at most once for each limit
        trees_.solve(bodies, pass);
    }
    for (const Hinge& hinge : hinges_) {
        Joint& joint = joints_[hinge.joint];
        const Vec2 impulse{hinge.rows->impulse[0], hinge.rows->impulse[1]};
        joint.linearImpulseSum += impulse - joint.point; // the substep begins at zero
        joint.point = impulse;
    }
    for (const std::uint32_t index : own_) {
        const HeldRows* const rows = trees_.rowsOf(index);
        if (rows == nullptr) {
            continue;
        }
        Joint& joint = joints_[index];
        Vec2 point{rows->impulse[0], rows->impulse[1]};
        if (rows->across != Vec2{}) {
            const Real across = dot(rows->across, point);
            joint.impulseAt(rows->acrossAt) = across;
            point = across * rows->across;
        } else {
            joint.point = point;
        }
        if (rows->angle) {
            const Real impulse = rows->impulse[2];
            joint.impulseAt(rows->angleAt) =
                rows->side == 0 ? impulse : std::max(rows->side * impulse, Real(0));
        } else if (rows->side * spinOf(joint, bodies) < 0) { // the next pass holds it
            joint.impulseAt(rows->angleAt) = std::numeric_limits<Real>::min();
        }
        if (!pass.biased && pass.last) {
            joint.linearImpulseSum += point;
            joint.angularImpulseSum += rows->angle ? rows->impulse[2] : 0;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
