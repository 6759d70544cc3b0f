// SPDX-License-Identifier: MIT
// A World without Feature::Collision: particles, or joints alone.
#include "support/solver.hpp"
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <vector>

namespace kodo {
namespace {

using support::kSolvers;
using support::Solver;

StepSettings collisionLeftOut(Solver solver) {
    StepSettings settings = support::settingsOf(solver);
    settings.leaveOut |= Feature::Collision;
    return settings;
}

// A heap falls freely through the ground and through itself; nothing is searched.
TEST(LeaveOutCollision, AHeapFallsThroughTheGround) {
    for (const Solver solver : kSolvers) {
        World world({.gravity = support::kEarth, .settings = collisionLeftOut(solver)});
        support::addHeap(world, 7, 30);
        std::vector<Vec2> before;
        for (const BodyId id : world.bodies()) {
            before.push_back(world[id].center());
        }
        support::run(world, 60);
        std::size_t next = 0;
        for (const BodyId id : world.bodies()) {
            const BodyView body = std::as_const(world)[id];
            const bool falls = body.type() == BodyType::Dynamic;
            const Vec2 way = body.center() - before[next++];
            EXPECT_TRUE(support::near(way, Vec2{0, falls ? Real(-5) : Real(0)}, Real(1e-3)));
            EXPECT_EQ(body.flags() & kColliding, 0u);
        }
        EXPECT_TRUE(world.collisions().empty());
        EXPECT_EQ(stepStats(world).pairs, 0u);
        EXPECT_EQ(stepStats(world).pairWork, 0u);
        EXPECT_EQ(stepStats(world).contacts, 0u);
    }
}

// Between steps: what touched ends with a record, and begins again. Sleeping bodies wake. A copy
// and a snapshot from each moment go on with the same bits.
TEST(LeaveOutCollision, MayBeSwitchedBetweenSteps) {
    for (const Solver solver : kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        support::addFloor(world);
        world.add({.shape = Box{20, 1}, .position = {0, -5}, .type = BodyType::Static});
        const std::vector<BodyId> boxes = support::addStack(world, 2);
        support::run(world, 120);
        ASSERT_TRUE(world[boxes[0]].isAsleep());
        const auto goesOnAlike = [&] {
            World copy = world;
            World read = fromBytes(toBytes(world));
            World same = world;
            for (World* one : {&copy, &read, &same}) {
                support::run(*one, 45);
            }
            EXPECT_EQ(copy.stateHash(), same.stateHash());
            EXPECT_EQ(toBytes(read), toBytes(same));
        };
        world.setSettings(collisionLeftOut(solver));
        EXPECT_FALSE(world[boxes[0]].isAsleep());
        goesOnAlike();
        world.step(support::kDt);
        EXPECT_EQ(world.endedCollisions().size(), 2u);
        EXPECT_EQ(world.collisions().size(), 2u);
        EXPECT_EQ(world[boxes[0]].flags() & kColliding, 0u);
        goesOnAlike();
        world.step(support::kDt);
        EXPECT_TRUE(world.collisions().empty());
        while (world[boxes[1]].position().y > -2) {
            world.step(support::kDt);
        }
        goesOnAlike();
        world.setSettings(support::settingsOf(solver));
        goesOnAlike();
        std::size_t begins = 0;
        for (int step = 0; step < 240; ++step) {
            world.step(support::kDt);
            begins += world.begunCollisions().size();
        }
        EXPECT_GE(begins, 2u);
        EXPECT_TRUE(support::near(world[boxes[0]].position().y, -4, Real(0.02)));
        EXPECT_TRUE(support::near(world[boxes[1]].position().y, -3, Real(0.02)));
        EXPECT_TRUE(world[boxes[0]].isAsleep());
    }
}

// Contacts that wait outside the region end when their bodies are back.
TEST(LeaveOutCollision, EndsTheContactsThatReturnFromOutsideTheRegion) {
    for (const Solver solver : kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({50, Real(0.5)}, 1, 1));
        support::run(world, 10);
        ASSERT_NE(world[box].flags() & kColliding, 0u);
        world.setRegion(Aabb{{-5, -5}, {5, 5}});
        support::run(world, 5);
        world.setSettings(collisionLeftOut(solver));
        support::run(world, 5);
        EXPECT_EQ(world[box].position().y > Real(0.4), true);
        world.setRegion(std::nullopt);
        world.step(support::kDt);
        EXPECT_EQ(world.endedCollisions().size(), 1u);
        support::run(world, 30);
        EXPECT_LT(world[box].position().y, 0);
    }
}

/// Bodies of all kinds that move, some of them removed.
World mixture(std::uint64_t seed) {
    World world({.settings = collisionLeftOut(Solver::Soft)});
    support::RandomNumbers random(seed);
    world.add({.shape = Plane{{0, 1}, -9}, .type = BodyType::Static});
    std::vector<BodyId> all;
    for (int i = 0; i < 60; ++i) {
        BodyDef def;
        const Real size = random.between(0.2, 0.8);
        if (i % 4 == 0) {
            def.shape = Circle{size};
        } else if (i % 4 == 1) {
            def.shape = Box{2 * size, size};
        } else if (i % 4 == 2) {
            def.shape = Compound{{Box{size, 1}, Circle{size, {1, 0}}}};
        } else {
            def.shape = Capsule{{-size, 0}, {size, 0}, size};
        }
        def.position = {random.between(-8, 8), random.between(-8, 8)};
        def.rotation = random.rotation();
        def.velocity = {random.between(-9, 9), random.between(-9, 9)};
        def.angularVelocity = random.between(-9, 9);
        def.type = i % 5 == 0 ? BodyType::Kinematic : BodyType::Dynamic;
        all.push_back(world.add(def));
    }
    support::run(world, 20);
    for (std::size_t i = 0; i < all.size(); i += 7) {
        world.remove(all[i]);
    }
    world.add({.shape = Box{1, 3}, .position = {1, 1}});
    support::run(world, 20);
    world[all[1]].setPosition({3, 3});
    return world;
}

// Queries find what those of a World with trees find, and a region keeps the same bodies.
TEST(LeaveOutCollision, QueriesAndRegionsAgreeWithThoseOfAWorldWithCollisions) {
    for (int seed = 0; seed < support::draws(20); ++seed) {
        World without = mixture(static_cast<std::uint64_t>(seed));
        World with = without;
        with.setSettings({}); // its trees are complete at once
        support::RandomNumbers random(static_cast<std::uint64_t>(seed));
        for (int i = 0; i < 20; ++i) {
            const Vec2 a{random.between(-9, 9), random.between(-9, 9)};
            const Vec2 b{random.between(-9, 9), random.between(-9, 9)};
            const auto ray = rayCastAll(without, a, b);
            const auto same = rayCastAll(with, a, b);
            ASSERT_EQ(ray.size(), same.size());
            for (std::size_t k = 0; k < ray.size(); ++k) {
                EXPECT_EQ(ray[k].body, same[k].body);
                EXPECT_EQ(ray[k].fraction, same[k].fraction);
            }
            EXPECT_EQ(overlap(without, Aabb{a, a + Vec2{2, 1}}),
                      overlap(with, Aabb{a, a + Vec2{2, 1}}));
            EXPECT_EQ(closestPoint(without, a, 5)->body, closestPoint(with, a, 5)->body);
            const auto cast = shapeCast(without, Circle{Real(0.3)}, {a, {}}, b - a);
            const auto sameCast = shapeCast(with, Circle{Real(0.3)}, {a, {}}, b - a);
            ASSERT_EQ(cast.has_value(), sameCast.has_value());
            EXPECT_TRUE(!cast ||
                        (cast->body == sameCast->body && cast->fraction == sameCast->fraction));
        }
        for (World* world : {&without, &with}) {
            world->setRegion(Aabb{{-6, -6}, {6, 6}});
            world->setRegion(Aabb{{-4, -6}, {8, 6}});
        }
        for (const BodyId id : without.bodies()) {
            EXPECT_EQ(without[id].flags() & kOutside, with[id].flags() & kOutside);
        }
    }
}

// Joints and sleep go on: two pendulums that would meet swing through each other, and a pair at
// rest in weightlessness sleeps.
TEST(LeaveOutCollision, JointsAndSleepGoOn) {
    for (const Solver solver : kSolvers) {
        World world({.gravity = support::kEarth, .settings = collisionLeftOut(solver)});
        const BodyId wall = world.add({.position = {0, 0}, .type = BodyType::Static});
        std::vector<BodyId> bobs;
        for (const Real side : {Real(-1), Real(1)}) {
            const BodyId bob = world.add(support::ballDef({3 * side, 0}, Real(0.4)));
            world.add(RevoluteJoint{.ends = {wall, bob, {}, {-3 * side, 0}}});
            bobs.push_back(bob);
        }
        Real crossed = 0;
        for (int step = 0; step < 90; ++step) {
            world.step(support::kDt);
            crossed = std::max(crossed, world[bobs[0]].position().x);
        }
        EXPECT_GT(crossed, Real(2.5));
        World calm({.settings = collisionLeftOut(solver)});
        const BodyId a = calm.add(support::boxDef({0, 0}, 1, 1));
        support::run(calm, 120);
        EXPECT_TRUE(calm[a].isAsleep());
    }
}

} // namespace
} // namespace kodo
