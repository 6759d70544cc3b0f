// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/sleeping.hpp>

namespace kodo {
namespace {

using support::kDt;
using support::kSolvers;
using support::near;
using support::run;
using support::settingsOf;
using support::Solver;

/// A fork over a wall that nearly fills the 1 m gap between its two prongs [Thesis06, fig. 4.3].
/// One manifold for both bodies would average the opposite normals to zero.
struct Fork {
    World world{{.gravity = support::kEarth}};
    BodyId wall;
    BodyId fork;

    /// `room`: m, gap between each prong and the wall; negative in overlap.
    Fork(Real room, Real above, Solver strategy) {
        StepSettings settings = settingsOf(strategy);
        world.setSettings(settings);
        wall = world.add(
            {.shape = Box{1 - 2 * room, 4}, .position = {0, -2}, .type = BodyType::Static});
        const Compound shape{{Box{2, Real(0.5), {0, Real(0.25)}},
                              Box{Real(0.5), 2, {-Real(0.75), -1}},
                              Box{Real(0.5), 2, {Real(0.75), -1}}}};
        fork = world.add(
            {.shape = shape, .position = {0, above}, .material = withFriction(Real(0.3))});
    }
    /// The record of a part of the fork (0: the handle, 1: left, 2: right), or nullptr.
    const CollisionRecord* recordOf(std::uint16_t part) const {
        for (const CollisionRecord& record : world.collisions()) {
            if (record.a == wall && record.b == fork && record.partB == part) {
                return &record;
            }
        }
        return nullptr;
    }
};

// R6: dropped over the wall, the fork falls asleep upright, with the wall between its prongs.
TEST(ForkOverAWall, FallsAsleepUpright) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Fork scene(Real(0.02), Real(0.5), strategy);
        scene.world[scene.fork].setVelocity({Real(0.5), 0}); // pushes the left prong
        EXPECT_LT(support::stepsUntilAsleep(scene.world, scene.fork, 300), 300);
        const BodyView fork = scene.world[scene.fork];
        EXPECT_TRUE(near(fork.position().y, 0, Real(0.01))); // the slop is 4 mm
        EXPECT_TRUE(near(fork.position().x, 0, Real(0.03)));
        EXPECT_TRUE(near(fork.rotation().s, 0, Real(0.01)));
    }
}

// R6: with an overlap of 1 mm on each side, both prongs have contacts with opposite normals, and
// the fork stays centred.
TEST(ForkOverAWall, HasOpposingNormalsOnBothSides) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Fork scene(Real(-0.001), 0, strategy);
        scene.world.step(kDt);
        const CollisionRecord* const handle = scene.recordOf(0);
        const CollisionRecord* const left = scene.recordOf(1);
        const CollisionRecord* const right = scene.recordOf(2);
        ASSERT_TRUE(handle != nullptr && left != nullptr && right != nullptr);
        EXPECT_EQ(handle->normal, (Vec2{0, 1}));
        EXPECT_EQ(left->normal, (Vec2{-1, 0}));
        EXPECT_EQ(right->normal, (Vec2{1, 0}));
        run(scene.world, 300);
        const BodyView fork = scene.world[scene.fork];
        EXPECT_TRUE(near(fork.position(), Vec2{}, Real(0.01)));
        EXPECT_LT(length(fork.velocity()), Real(0.01));
        EXPECT_TRUE(near(fork.rotation().s, 0, Real(0.01)));
    }
}

} // namespace
} // namespace kodo
