// SPDX-License-Identifier: MIT
#include "soft/revolute_blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lanes/contact_block.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{};
constexpr std::size_t kJoints = RevoluteBlock::kJoints;

bool hasAngles(const RevoluteJoint& pin) {
    return pin.motorTorque > 0 || pin.limits.has_value();
}

void set(RevoluteBlock::Both& to, std::size_t lane, Vec2 v) {
    to.x[lane] = v.x;
    to.y[lane] = v.y;
}
Vec2 get(const RevoluteBlock::Both& from, std::size_t lane) {
    return {from.x[lane], from.y[lane]};
}

} // namespace

void RevoluteBlocks::begin(Bodies& bodies, JointSet& joints) {
    blocks_.clear();
    angles_.clear();
    use_.clear();
    jointOf_.clear();
    const std::span<const std::uint32_t> list = joints.takeRevolutes(bodies);
    if (list.empty()) {
        return;
    }
    assignColours(bodies, joints, list);
    openBlocks(bodies);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const JointSet::Joint& joint = joints.at(list[i]);
        const bool angular = hasAngles(std::get<RevoluteJoint>(joint.def));
        const std::size_t lane = takeLane(colourOf_[i], angular);
        jointOf_[lane] = list[i];
        fill(bodies, joint, lane);
        if (angular) {
            fillAngles(bodies, joint, lane);
        }
    }
    rotate(bodies);
}

/// The lowest colour that is free at both bodies, or kNoColour.
std::size_t RevoluteBlocks::colourFor(const Bodies& bodies, const JointEnds& ends) {
    const bool movesA = !bodies.locked(ends.a.index);
    const bool movesB = !bodies.locked(ends.b.index);
    Colours& ofA = colours_[ends.a.index];
    Colours& ofB = colours_[ends.b.index];
    const auto colour =
        static_cast<std::size_t>(std::countr_one((movesA ? ofA : 0) | (movesB ? ofB : 0)));
    if (colour < kNoColour) {
        ofA |= Colours{1} << colour;
        ofB |= Colours{1} << colour;
    }
    return colour;
}

/// Finds the colours of the joints, and counts the lanes of each colour.
void RevoluteBlocks::assignColours(const Bodies& bodies, JointSet& joints,
                                   std::span<const std::uint32_t> list) {
    resizeByBody(colours_, bodies);
    colourOf_.clear();
    batches_ = {};
    for (const std::uint32_t index : list) {
        const auto& pin = std::get<RevoluteJoint>(joints.at(index).def);
        const std::size_t colour = colourFor(bodies, pin.ends);
        colourOf_.push_back(static_cast<std::uint8_t>(colour));
        batches_[hasAngles(pin) ? 1 : 0][colour].lanes += colour == kNoColour ? kJoints : 1;
    }
    for (const std::uint32_t index : list) {
        const JointEnds& ends = std::get<RevoluteJoint>(joints.at(index).def).ends;
        colours_[ends.a.index] = colours_[ends.b.index] = 0;
    }
}

/// Appends empty blocks for the lanes of all colours.
void RevoluteBlocks::openBlocks(const Bodies& bodies) {
    for (std::size_t colour = 0; colour <= kNoColour; ++colour) {
        for (const bool angular : {false, true}) {
            Batch& batch = batches_[angular ? 1 : 0][colour];
            batch.firstBlock = blocks_.size();
            for (std::size_t lane = 0; lane < batch.lanes; lane += kJoints) {
                RevoluteBlock& block = blocks_.emplace_back();
                std::fill_n(block.a, kJoints, velocityOffset(bodies.spare()));
                std::fill_n(block.b, kJoints, velocityOffset(bodies.spare()));
                RevoluteUse& use = use_.emplace_back();
                if (angular) {
                    use.angles = static_cast<std::uint32_t>(angles_.size());
                    angles_.emplace_back();
                }
            }
            batch.lanes = 0;
        }
    }
    jointOf_.resize(kJoints * blocks_.size(), kNone);
}

/// The next free lane of a colour.
std::size_t RevoluteBlocks::takeLane(std::size_t colour, bool angular) {
    Batch& batch = batches_[angular ? 1 : 0][colour];
    const std::size_t lane = kJoints * batch.firstBlock + batch.lanes;
    batch.lanes += colour == kNoColour ? kJoints : 1;
    return lane;
}

void RevoluteBlocks::fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane) {
    const JointEnds& ends = std::get<RevoluteJoint>(joint.def).ends;
    RevoluteBlock& block = blocks_[lane / kJoints];
    const std::size_t at = lane % kJoints;
    RevoluteUse& use = use_[lane / kJoints];
    use.movesA |= static_cast<std::uint8_t>((bodies.locked(ends.a.index) ? 0 : 1) << at);
    use.movesB |= static_cast<std::uint8_t>((bodies.locked(ends.b.index) ? 0 : 1) << at);
    block.a[at] = velocityOffset(ends.a.index);
    block.b[at] = velocityOffset(ends.b.index);
    const Transform& poseA = bodies.pose[ends.a.index];
    const Transform& poseB = bodies.pose[ends.b.index];
    set(block.startA, at, armOf(bodies, ends.a.index, poseA.rotation, ends.anchorA));
    set(block.startB, at, armOf(bodies, ends.b.index, poseB.rotation, ends.anchorB));
    set(block.between, at, poseB.position - poseA.position);
    const BodyVelocity& a = bodies.motion[ends.a.index];
    const BodyVelocity& b = bodies.motion[ends.b.index];
    block.mass[at] = a.invMass + b.invMass;
    block.inertiaA[at] = a.invInertia;
    block.inertiaB[at] = b.invInertia;
    set(block.impulse, at, joint.point);
}

void RevoluteBlocks::fillAngles(const Bodies& bodies, const JointSet::Joint& joint,
                                std::size_t lane) {
    const auto& pin = std::get<RevoluteJoint>(joint.def);
    RevoluteAngles& angles = angles_[use_[lane / kJoints].angles];
    const std::size_t at = lane % kJoints;
    angles.lower[at] = -RevoluteAngles::kFarAngle;
    angles.upper[at] = RevoluteAngles::kFarAngle;
    if (pin.limits) {
        const Rot turned = bodies.pose[pin.ends.b.index].rotation *
                           bodies.pose[pin.ends.a.index].rotation.inverse() *
                           Rot::fromAngle(-pin.reference);
        angles.start[at] = turned.angle();
        angles.lower[at] = pin.limits->lower;
        angles.upper[at] = pin.limits->upper;
        angles.below[at] = joint.axes[1];
        angles.above[at] = joint.axes[2];
    }
    if (pin.motorTorque > 0) {
        angles.speed[at] = pin.motorSpeed;
        angles.torque[at] = pin.motorTorque;
        angles.motor[at] = joint.axes[0];
    }
}

void RevoluteBlocks::end(const Bodies& bodies, JointSet& joints, Real h, Real slop) {
    constexpr Real kShare = Real(0.08); // of the radius of the smaller body: how far pins may open
    const auto sizeOf = [&](BodyId body) {
        return bodies.motion[body.index].invMass > 0 ? bodies.geometry(body.index).boundingRadius
                                                     : std::numeric_limits<Real>::infinity();
    };
    for (std::size_t lane = 0; lane < jointOf_.size(); ++lane) {
        if (jointOf_[lane] == kNone) {
            continue;
        }
        const RevoluteBlock& block = blocks_[lane / kJoints];
        const std::size_t at = lane % kJoints;
        JointSet::Joint& joint = joints.at(jointOf_[lane]);
        joint.point = get(block.impulse, at);
        joint.linearImpulseSum = get(block.total, at);
        joint.solved = true;
        const JointEnds& ends = std::get<RevoluteJoint>(joint.def).ends;
        const BodyVelocity& a = bodies.motion[ends.a.index];
        const BodyVelocity& b = bodies.motion[ends.b.index];
        const PointConstraint anchors{
            .armA = get(block.armA, at), .armB = get(block.armB, at), .error = {}};
        joint.addLoad(length(anchors.give(a, b, joint.point)) / h,
                      std::max(kShare * std::min(sizeOf(ends.a), sizeOf(ends.b)), slop));
        if (const std::uint32_t k = use_[lane / kJoints].angles; k != RevoluteUse::kNoAngles) {
            const RevoluteAngles& angles = angles_[k];
            joint.axes = {angles.motor[at], angles.below[at], angles.above[at]};
            joint.angularImpulseSum = angles.total[at];
            // what a motor presses on it, a limit bears without giving way
            const Real limit = std::max(joint.axes[1], joint.axes[2]) - std::abs(joint.axes[0]);
            joint.addLoad(limit * anchors.hinged(a, b) / h, JointSet::Joint::kMostTurn);
        }
    }
}

void RevoluteBlocks::run(Bodies& bodies, const JointPass& pass, RevolutePasses::Pass work) {
    work({blocks_.data(), use_.data(), angles_.data(), blocks_.size(), bodies.motion.data(), pass.h,
          pass.stiff});
}

} // namespace KODO_PRECISION
} // namespace kodo
