// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::near;
using support::slippery;

// Whatever the speed and however thin the wall, nothing passes, with and without bounce.
TEST(Shots, NothingPassesAThinWall) {
    for (const Real speed :
         {Real(10), Real(30), Real(100), Real(1e3), Real(1e4), Real(1e5), Real(1e6)}) {
        for (const Real thickness : {Real(0.2), Real(0.02)}) {
            for (const Real e : {Real(0), Real(0.5), Real(1)}) {
                SCOPED_TRACE(testing::Message()
                             << speed << " m/s, wall " << thickness << " m, e " << e);
                World world;
                support::addWall(world, 5, thickness, slippery(e));
                BodyDef def = support::ballDef({0, 0}, Real(0.1), slippery(e));
                def.velocity = {speed, 0};
                const BodyId ball = world.add(def);
                for (int i = 0; i < 60 && world[ball].position().x > -1; ++i) {
                    world.step(support::kDt);
                    ASSERT_LT(world[ball].position().x, 5 + thickness / 2);
                }
                EXPECT_TRUE(support::nearShare(world[ball].velocity().x,
                                               -static_cast<long double>(e * speed),
                                               support::byPrecision(1e-5, 1e-9)) ||
                            e == 0);
            }
        }
    }
}

// Two balls that fly at each other do not pass through each other.
TEST(Shots, BallsDoNotPassThroughEachOther) {
    for (const Real speed : {Real(10), Real(100), Real(1e3), Real(1e4), Real(1e5), Real(1e6)}) {
        SCOPED_TRACE(speed);
        World world;
        BodyDef def = support::ballDef({-3, 0}, Real(0.1), slippery(1));
        def.velocity = {speed, 0};
        const BodyId left = world.add(def);
        def.position = {3, Real(0.05)};
        def.velocity = {-speed, 0};
        const BodyId right = world.add(def);
        for (int i = 0; i < 60 && world[left].velocity().x > 0; ++i) {
            world.step(support::kDt);
            ASSERT_LT(world[left].position().x, world[right].position().x);
        }
        EXPECT_LT(world[left].velocity().x, 0);
        EXPECT_GT(world[right].velocity().x, 0);
    }
}

// A spinning rod does not skip a thin post.
TEST(Shots, ASpinningRodDoesNotSkipAPost) {
    for (const Real spin : {Real(20), Real(60), Real(150)}) {
        SCOPED_TRACE(spin);
        World world;
        BodyDef post = support::ballDef({0, Real(1.8)}, Real(0.05), slippery(1));
        post.flags = kLocked;
        world.add(post);
        BodyDef rod = support::boxDef({0, 0}, 4, Real(0.1), slippery(1));
        rod.flags = kLockMove;
        rod.angularVelocity = spin;
        const BodyId id = world.add(rod);
        int turns = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(support::kDt);
            turns += world[id].angularVelocity() < 0 ? 1 : 0;
        }
        EXPECT_GT(turns, 10); // it was thrown back, and back again from the other side
        EXPECT_LT(turns, 50);
        EXPECT_TRUE(support::nearShare(std::abs(world[id].angularVelocity()), spin,
                                       support::byPrecision(1e-4, 1e-9)));
    }
}

// A shot through an open frame hits what is behind it: nothing is stopped that is not in the
// way.
TEST(Shots, FlyFreelyThroughAGap) {
    World world;
    for (const Real y : {Real(5.2), Real(-5.2)}) {
        world.add({.shape = Box{Real(0.1), 10}, .position = {3, y}, .flags = kLocked});
    }
    support::addWall(world, 10, Real(0.1), slippery(1));
    BodyDef def = support::ballDef({0, 0}, Real(0.1), slippery(1)); // the gap is 0.4 m high
    def.velocity = {1000, 0};
    const BodyId ball = world.add(def);
    world.step(support::kDt);
    EXPECT_TRUE(near(world[ball].position().x, 9.9L, Real(0.01)));
}

// The hit happens where and when geometry says: the ball's face meets the wall after 4.9 m, so
// after a step it is there, and flies back from there in what is left of the next. It is stopped a
// 1024th of the slop (in double a 65536th) before it touches; as much again is for roundings.
TEST(Shots, HitWhereGeometrySays) {
    for (const Real speed : {Real(400), Real(1e4), Real(1e6)}) {
        SCOPED_TRACE(speed);
        World world;
        const Real nearly = 2 * world.tolerances().slop / support::byPrecision(1024, 65536);
        const BodyId wall = support::addWall(world, 5, Real(0.02), slippery(1));
        BodyDef def = support::ballDef({0, 0}, Real(0.1), slippery(1));
        def.velocity = {speed, 0};
        const BodyId ball = world.add(def);
        world.step(support::kDt);
        EXPECT_TRUE(near(world[ball].position(), Vec2{Real(4.9), 0}, nearly));
        EXPECT_EQ(world[ball].velocity(), (Vec2{speed, 0}));
        world.step(support::kDt);
        const CollisionRecord* hit = support::recordOf(world, wall, ball);
        ASSERT_NE(hit, nullptr);
        EXPECT_TRUE(near(hit->point, Vec2{5, 0}, nearly));
        EXPECT_EQ(hit->approachSpeed, speed);
        EXPECT_LT(world[ball].velocity().x, 0);
    }
}

} // namespace
} // namespace kodo
