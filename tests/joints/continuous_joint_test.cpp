// SPDX-License-Identifier: MIT
// Joints of bodies that continuous collision stops.
#include <joints/rig.hpp>

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

/// Five rods of 0.5 m in a column, which are joined end to end, do not collide with each other and
/// fall obliquely on the ground.
struct FallingRods {
    World world{{.gravity = support::kEarth}};
    std::vector<JointEnds> joints;

    template <typename Join>
    FallingRods(Real speed, Join join) {
        constexpr Flags kGround = 1;
        constexpr Flags kRod = 2 | kMatchAny;
        world.add({.shape = Box{100, 1},
                   .position = {0, Real(-0.5)},
                   .type = BodyType::Static,
                   .flags = kGround});
        BodyId last{};
        for (int i = 0; i < 5; ++i) {
            const BodyId rod = world.add({.shape = Box{Real(0.1), Real(0.5)},
                                          .position = {0, 1 + Real(0.5) * static_cast<Real>(i)},
                                          .velocity = {Real(0.3) * speed, -speed},
                                          .flags = kRod,
                                          .required = kGround});
            if (i > 0) {
                joints.push_back(
                    {.a = last, .b = rod, .anchorA = {0, Real(0.25)}, .anchorB = {0, Real(-0.25)}});
                world.add(join(joints.back()));
            }
            last = rod;
        }
    }
    /// m, over two seconds.
    Real largestGap() {
        Real most = 0;
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
            for (const JointEnds& ends : joints) {
                most = std::max(most, length(joints::gapOf(world, ends)));
            }
        }
        return most;
    }
};

// G2: a rod that is stopped at the ground does not lose the others, which would move on by the rest
// of their displacement: 0.12, 0.27 and 0.52 m here. They open by at most 16 slops of 5 mm, and by
// what the impact leaves in soft joints. Ropes have a length of 10 mm.
TEST(ContinuousJoints, AStoppedBodyKeepsItsJointsClosed) {
    struct Case {
        Real speed;
        Real most;
    };
    for (const auto& [speed, most] :
         {Case{10, Real(0.09)}, Case{20, Real(0.13)}, Case{40, Real(0.2)}}) {
        FallingRods hinged(speed, [](const JointEnds& e) { return RevoluteJoint{.ends = e}; });
        EXPECT_LT(hinged.largestGap(), most) << "hinges, " << speed;
        FallingRods fixed(speed, [](const JointEnds& e) { return FixedJoint{.ends = e}; });
        EXPECT_LT(fixed.largestGap(), most) << "fixed joints, " << speed;
        FallingRods roped(speed, [](const JointEnds& e) {
            return DistanceJoint{.ends = e, .limits = Range{0, Real(0.01)}};
        });
        EXPECT_LT(roped.largestGap(), most) << "ropes, " << speed;
    }
}

// G2: a long row that is stopped at one end does not stop as a whole: each joint takes up a part.
TEST(ContinuousJoints, AStopDoesNotSpreadThroughALongRow) {
    World world({.gravity = {}});
    world.add({.shape = Box{1, 10}, .position = {Real(0.8), 0}, .type = BodyType::Static});
    BodyId last{};
    for (int i = 0; i < 40; ++i) {
        const BodyId link = world.add({.shape = Circle{Real(0.1)},
                                       .position = {Real(-0.2) * static_cast<Real>(i), 0},
                                       .velocity = {15, 0}});
        if (i > 0) {
            world.add(RevoluteJoint{
                .ends = {
                    .a = last, .b = link, .anchorA = {Real(-0.1), 0}, .anchorB = {Real(0.1), 0}}});
        }
        last = link;
    }
    const Vec2 start = world[last].position();
    world.step(support::kDt);
    EXPECT_NEAR(world[last].position().x - start.x, 0.25, 0.01);
}

} // namespace
} // namespace kodo
