// SPDX-License-Identifier: MIT
// Included by contact_passes.inl, whose first lines hold here too.
#include "lanes/contact_lanes.inl"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Bound (m) of the displacement of any surface point by a rotation (rad); see
/// ConvexShape::rotationReach().
KODO_LANES_INLINE Lanes rotationReachOf(const Extent* extent, const std::uint32_t* places,
                                        Lanes turn) {
    Lanes rotationReach{};
    for (int i = 0; i < kLanes; ++i) {
        rotationReach[i] = extent[bodyOfPlace(places[i])].rotationReach;
    }
    return larger(turn, -turn) * rotationReach;
}

/// advanceContact() of contact_update.cpp for kLanes contacts, bit-identical.
template <int points>
KODO_LANES_INLINE void advanceLanes(const AdvanceArguments& pass, ContactBlock& block, int at) {
    BodyVelocity* const motion = pass.motion;
    const Lanes nx = load(block.normalX + at);
    const Lanes ny = load(block.normalY + at);
    const Quad moveA = gather(secondHalf(motion), block.a + at);
    const Quad moveB = gather(secondHalf(motion), block.b + at);
    const Quad speedA = gather(firstHalf(motion), block.a + at);
    const Quad speedB = gather(firstHalf(motion), block.b + at);
    const Lanes dx = moveB.x - moveA.x;
    const Lanes dy = moveB.y - moveA.y;
    const Lanes moved = nx * dx + ny * dy;
    const Lanes speed = nx * (speedB.x - speedA.x) + ny * (speedB.y - speedA.y);
    Lanes approach{}; // m/s
    for (int i = 0; i < points; ++i) {
        ContactBlock::Point& point = block.points[i];
        const Lanes leverA = load(point.leverA + at);
        const Lanes leverB = load(point.leverB + at);
        store(point.separation + at,
              load(point.separation + at) + (moved + (leverB * moveB.z - leverA * moveA.z)));
        approach = larger(-(speed + (leverB * speedB.z - leverA * speedA.z)), approach); // no -0
    }
    store(block.approachSpeed + at, approach);
    store(block.total[1] + at, Lanes{}); // impacts add to it before the passes do
    store(block.relativeDisplacement + at,
          load(block.relativeDisplacement + at) +
              (larger(dx, -dx) + larger(dy, -dy) +
               rotationReachOf(pass.extent, block.a + at, moveA.z) +
               rotationReachOf(pass.extent, block.b + at, moveB.z)));
}

void advanceBlocks(const AdvanceArguments& pass) {
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k, nullptr);
        const std::size_t i = pass.order[k];
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            if (pass.use[i].twoPoints) {
                advanceLanes<2>(pass, pass.blocks[i], at);
            } else {
                advanceLanes<1>(pass, pass.blocks[i], at);
            }
        }
    }
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
