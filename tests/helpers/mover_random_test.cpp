// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/random_numbers.hpp>

#include <helpers/mover_scenes.hpp>

namespace kodo {
namespace {

using support::addStatic;
using support::kGravity;
using support::kShapes;
using support::kStep;

/// Hills as boxes, discs and a chain with steep and flat pieces, between two walls.
World randomLevel(support::RandomNumbers& random) {
    World world;
    Chain chain{.points = {{-30, 20}}, .oneSided = true};
    for (Real x = -30; x < 30; x += random.between(0.2, 3)) {
        chain.points.push_back({x, random.between(-1, random.below(5) == 0 ? 3 : 0.5)});
    }
    chain.points.push_back({30, 20});
    addStatic(world, chain);
    for (int i = 0; i < 25; ++i) {
        const Vec2 at{random.between(-28, 28), random.between(0, 8)};
        const Real angle = random.between(-3, 3);
        if (random.below(3) == 0) {
            addStatic(world, Circle{random.between(0.2, 2)}, at);
        } else {
            addStatic(world, Box{random.between(0.2, 4), random.between(0.2, 2)}, at, angle);
        }
    }
    return world;
}

/// m; the deepest overlap of a mover with its level, 0 if none.
Real depth(const World& world, const Mover& mover) {
    Real deepest = 0;
    for (const QueryContact& touch :
         collide(world, shapeOf(mover.shape), {mover.position, {}}, 0)) {
        deepest = std::max(deepest, -touch.separation);
    }
    return deepest;
}

// 10,000 moves in 20 levels, with walks, jumps and dashes up to 40 m/s.
TEST(Mover, IsNeverInsideStaticGround) {
    for (int seed = 0; seed < support::draws(20); ++seed) {
        support::RandomNumbers random(static_cast<std::uint64_t>(seed) + 1);
        World world = randomLevel(random);
        Mover mover{.shape = kShapes[static_cast<std::size_t>(seed) % 4], .position = {0, 14}};
        Real speed = 0;
        for (int i = 0; i < 500; ++i) {
            speed = i % 20 == 0 ? random.between(-8, 8) * (random.below(6) == 0 ? 5 : 1) : speed;
            Vec2 wish{speed, mover.velocity.y - kGravity * kStep};
            wish.y = mover.grounded && random.below(20) == 0 ? random.between(2, 12) : wish.y;
            mover.move(world, wish, kStep);
            // Two steep sides may hold it nearer than skin, but never in them.
            ASSERT_LT(depth(world, mover), 0.001) << "seed " << seed << " move " << i;
            ASSERT_GT(mover.position.y, -2) << "seed " << seed << " move " << i;
            ASSERT_LT(length(mover.velocity), 100);
        }
    }
}

TEST(Mover, ContinuesWithTheSameBitsAsItsCopy) {
    support::RandomNumbers random(7);
    World world = randomLevel(random);
    Mover mover{.position = {0, 14}};
    const auto moves = [](World& where, Mover& who, int count) {
        for (int i = 0; i < count; ++i) {
            const Real speed = i / 40 % 2 == 0 ? Real(5) : Real(-4);
            support::tick(where, who, speed, i % 50 == 0 ? Real(7) : Real(0));
        }
    };
    moves(world, mover, 100);
    World otherWorld = world;
    Mover other = mover;
    moves(world, mover, 200);
    moves(otherWorld, other, 200);
    EXPECT_EQ(mover.position, other.position);
    EXPECT_EQ(mover.velocity, other.velocity);
    EXPECT_EQ(mover.grounded, other.grounded);
}

} // namespace
} // namespace kodo
