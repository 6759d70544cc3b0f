// SPDX-License-Identifier: MIT
// Motors and limits of revolute joints in lanes.
#include <support/near.hpp>

#include <gtest/gtest.h>
#include <solve/random_revolutes.hpp>

#include <algorithm>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;

/// Constraints of one joint, solved one by one as JointSet does.
struct SingleJoint {
    BodyVelocity& a;
    BodyVelocity& b;
    const RevoluteBlock& block;
    const RevoluteAngles& angles;
    std::size_t lane;
    Softness soft;
    bool biased;

    void solve() const {
        constexpr Real kH = RandomPins::kStep;
        const PointConstraint point{
            RandomPins::get(block.armA, lane), RandomPins::get(block.armB, lane), {}, soft};
        Vec2 impulse = RandomPins::get(block.impulse, lane);
        AxisConstraint axis{
            .axis = {}, .leverA = 1, .leverB = 1, .beside = {&point, &impulse, biased}};
        Real motor = angles.motor[lane];
        axis.speed = angles.speed[lane];
        axis.bounds = {-kH * angles.torque[lane], kH * angles.torque[lane]};
        axis.solve(a, b, motor, biased);
        axis.speed = 0;
        axis.bounds = {0, kUnbounded.upper};
        const auto limit = [&](Real room, Real before, Real pushed) {
            axis.borne = std::max(pushed, Real(0));
            axis.error = room;
            axis.softness = room > 0 ? Softness::rigid(kH) : soft;
            axis.solve(a, b, before, biased || room > 0);
        };
        limit(angles.angle[lane] - angles.lower[lane], angles.below[lane], -motor);
        axis.leverA = axis.leverB = -1;
        limit(angles.upper[lane] - angles.angle[lane], angles.above[lane], motor);
        point.solve(a, b, impulse, biased);
    }
};

// The result of the scalar constraints for a single joint, in both passes. There, gaps are zero and
// bodies do not rotate beforehand, since only lanes rotate the gap. Tolerance: the rounding of some
// dozen operations on numbers of size 100.
TEST(RevoluteAngles, AgreeWithTheScalarConstraintsOfAJoint) {
    const Softness soft = Softness::from(60, 2, RandomPins::kStep);
    for (const bool biased : {false, true}) {
        RandomPins pins(11, true);
        for (BodyVelocity& body : pins.motion) {
            body.clearDisplacement();
            body.angularVelocity = biased ? 0 : body.angularVelocity;
        }
        for (RevoluteBlock& block : pins.blocks) {
            for (std::size_t lane = 0; lane < kPinLanes; ++lane) {
                RandomPins::set(block.between, lane,
                                RandomPins::get(block.startA, lane) -
                                    RandomPins::get(block.startB, lane));
                RandomPins::set(block.impulse, lane, {}); // no torque of rotated arms
            }
        }
        pins.run(RevolutePasses::best().rotate, {});
        RandomPins solved = pins;
        solved.run(biased ? RevolutePasses::best().solve : RevolutePasses::best().relax, soft);
        std::size_t twisted = 0;
        for (std::size_t i = 0; i < kPinBlocks; i += 2) {
            const RevoluteBlock& block = pins.blocks[i];
            const RevoluteAngles& angles = pins.angles[pins.use[i].angles];
            for (std::size_t lane = 0; lane < kPinLanes && block.a[lane] != block.b[lane]; ++lane) {
                const std::uint32_t a = bodyOfPlace(block.a[lane]);
                const std::uint32_t b = bodyOfPlace(block.b[lane]);
                SingleJoint{pins.motion[a], pins.motion[b], block, angles, lane, soft, biased}
                    .solve();
                const Real most = byPrecision(2e-3, 1e-10);
                for (const std::uint32_t body : {a, b}) {
                    const BodyVelocity& now = solved.motion[body];
                    EXPECT_TRUE(near(now.velocity, pins.motion[body].velocity, most));
                    EXPECT_TRUE(near(now.angularVelocity, pins.motion[body].angularVelocity, most));
                }
                const RevoluteAngles& after = solved.angles[pins.use[i].angles];
                twisted += after.motor[lane] != 0 ? 1 : 0;
                twisted += after.below[lane] != 0 || after.above[lane] != 0 ? 1 : 0;
            }
        }
        EXPECT_GT(twisted, kPinBlocks);
    }
}

} // namespace
} // namespace kodo
