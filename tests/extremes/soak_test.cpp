// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// What rests does not move in ten million steps, 46 hours, by a single bit.
TEST(Soak, ARestingStackKeepsItsBits) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 600);
    ASSERT_NE(world[boxes[4]].flags() & kResting, 0u);
    const World before = world;
    support::run(world, 10000000);
    for (const BodyId box : boxes) {
        EXPECT_EQ(world[box].position(), before[box].position());
        EXPECT_EQ(world[box].rotation(), before[box].rotation());
        EXPECT_EQ(world[box].velocity(), Vec2{});
    }
}

// Awake, a stack does not creep either: by a millionth of a metre at most in 1e5 steps; in float a
// place 5 m up is known to 5e-7 m, and the boxes settle on what they come to.
TEST(Soak, AWakefulStackDoesNotCreep) {
    StepSettings settings;
    settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 1000);
    std::vector<Vec2> before;
    for (const BodyId box : boxes) {
        before.push_back(world[box].position());
    }
    support::run(world, 100000);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(near(world[boxes[i]].position(), before[i], byPrecision(2e-5, 1e-6))) << i;
    }
}

// A rod spins for a million steps, 4.6 hours: its spin keeps its bits, its orientation its length.
TEST(Soak, ASpinningRodGoesOn) {
    World world;
    BodyDef def = support::boxDef({}, 2, Real(0.1));
    def.angularVelocity = Real(7.3);
    const BodyId rod = world.add(def);
    support::run(world, 1000000);
    EXPECT_EQ(world[rod].angularVelocity(), Real(7.3));
    EXPECT_EQ(world[rod].position(), Vec2{});
    const Rot q = world[rod].rotation();
    EXPECT_TRUE(near(length(Vec2{q.c, q.s}), 1, 4 * support::kEpsilon));
}

// A rally: a ball between four walls and three pegs, without loss, for a million steps: it keeps
// its speed, and stays inside. Each of more than 5e4 blows rounds its speed by some epsilons, up or
// down. To go one way by a tenth of one each time would be seen.
TEST(Soak, ARallyKeepsItsSpeed) {
    World world;
    const Material bouncing = support::slippery(1);
    const auto addSolid = [&](const Shape& shape, Vec2 position) {
        world.add({.shape = shape, .position = position, .material = bouncing, .flags = kLocked});
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
    for (int i = 0; i < 1000000; ++i) {
        world.step(support::kDt);
        hits += world.collisions().empty() ? 0 : 1;
        ASSERT_TRUE(std::abs(world[ball].position().x) < Real(4.5) &&
                    std::abs(world[ball].position().y) < Real(4.5))
            << "step " << i;
    }
    EXPECT_GT(hits, 50000u);
    EXPECT_TRUE(nearShare(length(world[ball].velocity()), speed, 5000 * support::kEpsilon));
}

} // namespace
} // namespace kodo
