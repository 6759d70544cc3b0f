// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// Under a sanitizer each of these runs has a tenth of its steps.

// A sleeping stack does not change by one bit in 1e7 steps (46 hours).
TEST(Soak, ASleepingStackKeepsItsBits) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 600);
    ASSERT_NE(world[boxes[4]].flags() & kAsleep, 0u);
    const World before = world;
    support::run(world, support::draws(10000000));
    for (const BodyId box : boxes) {
        EXPECT_EQ(world[box].position(), before[box].position());
        EXPECT_EQ(world[box].rotation(), before[box].rotation());
        EXPECT_EQ(world[box].velocity(), Vec2{});
    }
}

// An awake stack creeps by at most 1e-6 m in 1e5 steps. In float, positions at 5 m are rounded to
// 5e-7 m, and the boxes settle on rounded positions.
TEST(Soak, AnAwakeStackDoesNotCreep) {
    StepSettings settings;
    settings.leaveOut = Feature::Sleep;
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 1000);
    std::vector<Vec2> before;
    for (const BodyId box : boxes) {
        before.push_back(world[box].position());
    }
    support::run(world, support::draws(100000));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(near(world[boxes[i]].position(), before[i], byPrecision(2e-5, 1e-6))) << i;
    }
}

// In 1e6 steps (4.6 hours) the spin of a rod keeps its bits, and its rotation stays a unit vector.
TEST(Soak, ASpinningRodKeepsItsSpin) {
    World world;
    BodyDef def = support::boxDef({}, 2, Real(0.1));
    def.angularVelocity = Real(7.3);
    const BodyId rod = world.add(def);
    support::run(world, support::draws(1000000));
    EXPECT_EQ(world[rod].angularVelocity(), Real(7.3));
    EXPECT_EQ(world[rod].position(), Vec2{});
    const Rot q = world[rod].rotation();
    EXPECT_TRUE(near(length(Vec2{q.c, q.s}), 1, 4 * support::kEpsilon));
}

// A ball without losses bounces between four walls and three pegs. It keeps its speed and stays
// inside for 1e6 steps. Each of more than 5e4 impacts rounds its speed by some epsilons, up or
// down. A bias of a tenth of an epsilon per impact would show.
TEST(Soak, ABallBetweenWallsKeepsItsSpeed) {
    World world;
    const Material bouncing = support::slippery(1);
    const auto addSolid = [&](const Shape& shape, Vec2 position) {
        world.add(
            {.shape = shape, .position = position, .material = bouncing, .type = BodyType::Static});
    };
    addSolid(Box{12, 1}, {0, 5});
    addSolid(Box{12, 1}, {0, -5});
    addSolid(Box{1, 12}, {5, 0});
    addSolid(Box{1, 12}, {-5, 0});
    for (const Vec2 place : {Vec2{0, 2}, Vec2{2, -1}, Vec2{-2, -1}}) {
        addSolid(Circle{Real(0.5)}, place);
    }
    BodyDef def = support::ballDef({}, Real(0.25), bouncing);
    def.velocity = {Real(5.1), Real(7.3)};
    const BodyId ball = world.add(def);
    const Real speed = length(def.velocity);
    std::size_t hits = 0;
    for (int i = 0; i < support::draws(1000000); ++i) {
        world.step(support::kDt);
        hits += world.collisions().empty() ? 0 : 1;
        ASSERT_TRUE(std::abs(world[ball].position().x) < Real(4.5) &&
                    std::abs(world[ball].position().y) < Real(4.5))
            << "step " << i;
    }
    EXPECT_GT(hits, static_cast<std::size_t>(support::draws(50000)));
    EXPECT_TRUE(nearShare(length(world[ball].velocity()), speed, 5000 * support::kEpsilon));
}

} // namespace
} // namespace kodo
