// SPDX-License-Identifier: MIT
#include "solve/revolute_blocks.hpp"

#include "solve/contact_block.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr int kColours = std::numeric_limits<std::uint64_t>::digits;
constexpr std::uint32_t kNone = ~std::uint32_t{};

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
    use_.clear();
    jointOf_.clear();
    const std::span<const std::uint32_t> resident = joints.takeRevolutes();
    if (resident.empty()) {
        return;
    }
    colours_.resize(bodies.size());
    open_.assign(kColours, Open{});
    for (const std::uint32_t index : resident) {
        const JointSet::Joint& joint = joints.at(index);
        const std::size_t lane = laneFor(bodies, std::get<RevoluteJoint>(joint.def).ends);
        jointOf_[lane] = index;
        fill(bodies, joint, lane);
    }
    rotate(bodies);
}

/// A free lane of a block that moves neither body yet. If a body has more joints than there are
/// colours, each further joint gets a block of its own.
std::size_t RevoluteBlocks::laneFor(const Bodies& bodies, const JointEnds& ends) {
    const bool movesA = !bodies.locked(ends.a.index);
    const bool movesB = !bodies.locked(ends.b.index);
    Colours& ofA = colours_[ends.a.index];
    Colours& ofB = colours_[ends.b.index];
    const int colour = std::countr_one((movesA ? ofA : 0) | (movesB ? ofB : 0));
    Open alone;
    Open& open = colour < kColours ? open_[static_cast<std::size_t>(colour)] : alone;
    if (colour < kColours) {
        ofA |= Colours{1} << colour;
        ofB |= Colours{1} << colour;
    }
    if (open.lanes == RevoluteBlock::kPins) {
        open = {blocks_.size(), 0};
        RevoluteBlock& block = blocks_.emplace_back();
        std::fill_n(block.a, RevoluteBlock::kPins, velocityOffset(bodies.spare()));
        std::fill_n(block.b, RevoluteBlock::kPins, velocityOffset(bodies.spare()));
        use_.emplace_back();
        jointOf_.resize(jointOf_.size() + RevoluteBlock::kPins, kNone);
    }
    RevoluteUse& use = use_[open.block];
    use.movesA |= static_cast<std::uint8_t>((movesA ? 1 : 0) << open.lanes);
    use.movesB |= static_cast<std::uint8_t>((movesB ? 1 : 0) << open.lanes);
    return open.block * RevoluteBlock::kPins + static_cast<std::size_t>(open.lanes++);
}

void RevoluteBlocks::fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane) {
    const JointEnds& ends = std::get<RevoluteJoint>(joint.def).ends;
    RevoluteBlock& block = blocks_[lane / RevoluteBlock::kPins];
    const std::size_t at = lane % RevoluteBlock::kPins;
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

void RevoluteBlocks::end(JointSet& joints) {
    for (std::size_t lane = 0; lane < jointOf_.size(); ++lane) {
        if (jointOf_[lane] == kNone) {
            continue;
        }
        const RevoluteBlock& block = blocks_[lane / RevoluteBlock::kPins];
        const std::size_t at = lane % RevoluteBlock::kPins;
        JointSet::Joint& joint = joints.at(jointOf_[lane]);
        joint.point = get(block.impulse, at);
        joint.linearImpulseSum = get(block.total, at);
        joint.solved = true;
        colours_[bodyOfPlace(block.a[at])] = colours_[bodyOfPlace(block.b[at])] = 0;
    }
}

void RevoluteBlocks::run(Bodies& bodies, const JointPass& pass, RevolutePasses::Pass work) {
    work({blocks_.data(), use_.data(), blocks_.size(), bodies.motion.data(), pass.h, pass.stiff});
}

} // namespace KODO_PRECISION
} // namespace kodo
