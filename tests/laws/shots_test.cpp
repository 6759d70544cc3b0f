// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::near;
using support::slippery;

// No tunnelling through a thin wall at any speed, with and without restitution.
TEST(Shots, NoBodyTunnelsThroughAThinWall) {
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

// Two balls flying towards each other do not tunnel.
TEST(Shots, BallsDoNotTunnelThroughEachOther) {
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

// A spinning rod does not tunnel through a thin post.
TEST(Shots, ASpinningRodDoesNotTunnelThroughAPost) {
    for (const Real spin : {Real(20), Real(60), Real(150)}) {
        SCOPED_TRACE(spin);
        World world;
        BodyDef post = support::ballDef({0, Real(1.8)}, Real(0.05), slippery(1));
        post.type = BodyType::Static;
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
        EXPECT_GT(turns, 10); // thrown back repeatedly, from both sides
        EXPECT_LT(turns, 50);
        EXPECT_TRUE(support::nearShare(std::abs(world[id].angularVelocity()), spin,
                                       support::byPrecision(1e-4, 1e-9)));
    }
}

// A shot through a gap hits the wall behind: continuous collision does not stop it at the sides.
TEST(Shots, FlyFreelyThroughAGap) {
    World world;
    for (const Real y : {Real(5.2), Real(-5.2)}) {
        world.add({.shape = Box{Real(0.1), 10}, .position = {3, y}, .type = BodyType::Static});
    }
    support::addWall(world, 10, Real(0.1), slippery(1));
    BodyDef def = support::ballDef({0, 0}, Real(0.1), slippery(1)); // the gap is 0.4 m high
    def.velocity = {1000, 0};
    const BodyId ball = world.add(def);
    world.step(support::kDt);
    EXPECT_TRUE(near(world[ball].position().x, 9.9L, Real(0.01)));
}

// The impact has the position and time of the closed form. After one step the ball touches the wall
// at 4.9 m; in the next step it flies back. Continuous collision stops it slop / 1024 before the
// touch (slop / 65536 in double). The tolerance doubles that for rounding.
TEST(Shots, HitAtTheExactTimeAndPoint) {
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
