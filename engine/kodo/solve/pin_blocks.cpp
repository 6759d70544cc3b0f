// SPDX-License-Identifier: MIT
#include <kodo/solve/contact_block.hpp>
#include <kodo/solve/pin_blocks.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr int kColours = std::numeric_limits<std::uint64_t>::digits;
constexpr std::uint32_t kNone = ~std::uint32_t{};

void set(PinBlock::Both& to, std::size_t lane, Vec2 v) {
    to.x[lane] = v.x;
    to.y[lane] = v.y;
}
Vec2 get(const PinBlock::Both& from, std::size_t lane) {
    return {from.x[lane], from.y[lane]};
}

} // namespace

void PinBlocks::begin(Bodies& bodies, JointSet& joints) {
    blocks_.clear();
    use_.clear();
    jointOf_.clear();
    const std::span<const std::uint32_t> lent = joints.lendPins();
    if (lent.empty()) {
        return;
    }
    colours_.resize(bodies.size());
    open_.assign(kColours, Open{});
    for (const std::uint32_t index : lent) {
        const JointSet::Joint& joint = joints.at(index);
        const std::size_t lane = laneFor(bodies, std::get<Pin>(joint.def).ends);
        jointOf_[lane] = index;
        fill(bodies, joint, lane);
    }
    turn(bodies);
}

/// A lane in a block that does not push one of the two bodies yet. Of a body with more pins than
/// there are colours, each that is left has a block of its own.
std::size_t PinBlocks::laneFor(const Bodies& bodies, const JointEnds& ends) {
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
    if (open.lanes == PinBlock::kPins) {
        open = {blocks_.size(), 0};
        PinBlock& block = blocks_.emplace_back();
        std::fill_n(block.a, PinBlock::kPins, placeOfMotion(bodies.spare()));
        std::fill_n(block.b, PinBlock::kPins, placeOfMotion(bodies.spare()));
        use_.emplace_back();
        jointOf_.resize(jointOf_.size() + PinBlock::kPins, kNone);
    }
    PinUse& use = use_[open.block];
    use.movesA |= static_cast<std::uint8_t>((movesA ? 1 : 0) << open.lanes);
    use.movesB |= static_cast<std::uint8_t>((movesB ? 1 : 0) << open.lanes);
    return open.block * PinBlock::kPins + static_cast<std::size_t>(open.lanes++);
}

void PinBlocks::fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane) {
    const JointEnds& ends = std::get<Pin>(joint.def).ends;
    PinBlock& block = blocks_[lane / PinBlock::kPins];
    const std::size_t at = lane % PinBlock::kPins;
    block.a[at] = placeOfMotion(ends.a.index);
    block.b[at] = placeOfMotion(ends.b.index);
    const Transform& poseA = bodies.pose[ends.a.index];
    const Transform& poseB = bodies.pose[ends.b.index];
    set(block.startA, at, armOf(bodies, ends.a.index, poseA.rotation, ends.anchorA));
    set(block.startB, at, armOf(bodies, ends.b.index, poseB.rotation, ends.anchorB));
    set(block.between, at, poseB.position - poseA.position);
    const Motion& a = bodies.motion[ends.a.index];
    const Motion& b = bodies.motion[ends.b.index];
    block.mass[at] = a.invMass + b.invMass;
    block.inertiaA[at] = a.invInertia;
    block.inertiaB[at] = b.invInertia;
    set(block.impulse, at, joint.point);
}

void PinBlocks::end(JointSet& joints) {
    for (std::size_t lane = 0; lane < jointOf_.size(); ++lane) {
        if (jointOf_[lane] == kNone) {
            continue;
        }
        const PinBlock& block = blocks_[lane / PinBlock::kPins];
        const std::size_t at = lane % PinBlock::kPins;
        JointSet::Joint& joint = joints.at(jointOf_[lane]);
        joint.point = get(block.impulse, at);
        joint.pushSum = get(block.total, at);
        joint.solved = true;
        colours_[bodyOfPlace(block.a[at])] = colours_[bodyOfPlace(block.b[at])] = 0;
    }
}

void PinBlocks::run(Bodies& bodies, const JointPass& pass, PinPasses::Pass work) {
    work({blocks_.data(), use_.data(), blocks_.size(), bodies.motion.data(), pass.h, pass.stiff});
}

} // namespace kodo::inline KODO_PRECISION
