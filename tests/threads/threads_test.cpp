// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <thread>

namespace kodo {
namespace {

using support::settingsOf;
using support::Solver;

/// A heap with a chain and a wind: all data that a step reads.
World busyWorld(std::uint64_t seed, Solver strategy = Solver::Soft) {
    StepSettings settings = settingsOf(strategy);
    World world({.gravity = support::kEarth, .settings = settings});
    support::addHeap(world, seed, 40);
    BodyId last =
        world.add({.shape = Circle{Real(0.1)}, .position = {0, 12}, .type = BodyType::Static});
    for (int i = 1; i <= 5; ++i) {
        const BodyId link =
            world.add(support::ballDef({Real(0.5) * static_cast<Real>(i), 12}, Real(0.2)));
        world.add(RevoluteJoint{.ends = {last, link, {Real(0.25), 0}, {Real(-0.25), 0}}});
        last = link;
    }
    world.addField({std::make_shared<Drag>(DragLaw{Real(0.1), 0}, Vec2{1, 0}), {}});
    return world;
}

std::uint64_t hashAfter(std::uint64_t seed, Solver strategy) {
    World world = busyWorld(seed, strategy);
    support::run(world, 200);
    return world.stateHash();
}

// W7: worlds on several threads share no state: each ends as it does alone.
TEST(Threads, WorldsOnSeveralThreadsAreIndependent) {
    constexpr std::size_t kWorlds = 4;
    const auto strategyOf = [](std::size_t i) {
        return i % 2 == 0 ? Solver::Soft : Solver::Propagation;
    };
    std::uint64_t alone[kWorlds] = {};
    for (std::size_t i = 0; i < kWorlds; ++i) {
        alone[i] = hashAfter(i, strategyOf(i));
    }
    std::uint64_t together[kWorlds] = {};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < kWorlds; ++i) {
        threads.emplace_back(
            [&together, i, strategyOf] { together[i] = hashAfter(i, strategyOf(i)); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < kWorlds; ++i) {
        EXPECT_EQ(together[i], alone[i]) << i;
    }
}

// W7: copies of a World share immutable shapes and fields, and may run on different threads.
TEST(Threads, CopiesMayRunOnDifferentThreads) {
    World world = busyWorld(9);
    World copy = world;
    std::thread other([&copy] { support::run(copy, 200); });
    support::run(world, 200);
    other.join();
    EXPECT_EQ(copy.stateHash(), world.stateHash());
}

// W7: copies may release shared data on either thread, in any order.
TEST(Threads, CopiesMayReleaseSharedDataOnDifferentThreads) {
    World world = busyWorld(12);
    World copy = world;
    const auto takeApart = [](World& own) {
        for (const BodyId id : own.bodies()) {
            own.remove(id);
            own.step(support::kDt);
            own.add(support::ballDef({0, 20}, Real(0.3)));
        }
        own.setFields({});
    };
    std::thread other([&] { takeApart(copy); });
    takeApart(world);
    other.join();
    EXPECT_EQ(copy.stateHash(), world.stateHash());
}

// W7: several threads may read, copy and query a World that is not modified.
TEST(Threads, OneWorldMayBeReadConcurrently) {
    World world = busyWorld(13);
    support::run(world, 60);
    const World& shared = world;
    const auto ask = [&shared] {
        std::size_t found = 0;
        for (int i = 0; i < 50; ++i) {
            const Real x = static_cast<Real>(i % 10) - 5;
            found += rayCast(shared, {x, 30}, {x, -1}) ? 1u : 0u;
            found += overlap(shared, Aabb{{x, 0}, {x + 1, 1}}).size();
        }
        World own = shared;
        support::run(own, 5);
        return found + static_cast<std::size_t>(own.stateHash() % 1000);
    };
    const std::size_t alone = ask();
    std::size_t results[3] = {};
    std::vector<std::thread> threads;
    for (std::size_t& result : results) {
        threads.emplace_back([&result, &ask] { result = ask(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const std::size_t result : results) {
        EXPECT_EQ(result, alone);
    }
}

// W7: two worlds stepped alternately on one thread.
TEST(Threads, WorldsMayBeSteppedAlternately) {
    World one({.gravity = support::kEarth});
    World two({.gravity = {3, -7}});
    support::addHeap(one, 10, 30);
    support::addHeap(two, 11, 30);
    World alone = one;
    support::run(alone, 100);
    for (int i = 0; i < 100; ++i) {
        one.step(support::kDt);
        two.step(support::kDt);
    }
    EXPECT_EQ(one.stateHash(), alone.stateHash());
}

} // namespace
} // namespace kodo
