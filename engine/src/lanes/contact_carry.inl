// SPDX-License-Identifier: MIT
// Included by contact_passes.inl, whose first lines hold here too.
#include "lanes/contact_lanes.inl"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// The members of Carried as an array.
KODO_LANES_INLINE Real* numbers(Carried* carried) {
    return carried->separation.data();
}
static_assert(sizeof(Carried) == 4 * sizeof(Real));

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

/// carry() of contact_update.cpp for kLanes contacts, bit-identical.
template <int points>
KODO_LANES_INLINE void carryLanes(const CarryArguments& pass, ContactBlock& block, Carried* carried,
                                  int at) {
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
    // x, y: separations (m), z: approach speed (m/s), w: relative displacement (m)
    Quad now = gather(numbers(carried + at), kRowStarts);
    now.z = Lanes{};
    now.w += larger(dx, -dx) + larger(dy, -dy) +
             rotationReachOf(pass.extent, block.a + at, moveA.z) +
             rotationReachOf(pass.extent, block.b + at, moveB.z);
    const auto carry = [&](ContactBlock::Point& point, Lanes& separation) {
        const Lanes leverA = load(point.leverA + at);
        const Lanes leverB = load(point.leverB + at);
        separation += moved + (leverB * moveB.z - leverA * moveA.z);
        store(point.separation + at, separation);
        now.z = larger(-(speed + (leverB * speedB.z - leverA * speedA.z)), now.z); // no -0
    };
    carry(block.points[0], now.x);
    if constexpr (points == 2) {
        carry(block.points[1], now.y);
    }
    scatter(numbers(carried + at), kRowStarts, now);
}

void carryBlocks(const CarryArguments& pass) {
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k, nullptr);
        const std::size_t i = pass.order[k];
        Carried* const carried = pass.carried + i * ContactBlock::kContacts;
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            if (pass.use[i].twoPoints) {
                carryLanes<2>(pass, pass.blocks[i], carried, at);
            } else {
                carryLanes<1>(pass, pass.blocks[i], carried, at);
            }
        }
    }
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
