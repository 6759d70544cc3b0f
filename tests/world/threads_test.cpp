// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <thread>

namespace kodo {
namespace {

std::uint64_t hashAfter(std::uint64_t seed) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, seed, 40);
    support::run(world, 200);
    return world.stateHash();
}

// W7: several worlds on several threads share nothing: each ends as it does alone.
TEST(Threads, WorldsDoNotDisturbEachOther) {
    constexpr std::size_t kWorlds = 4;
    std::uint64_t alone[kWorlds] = {};
    for (std::size_t i = 0; i < kWorlds; ++i) {
        alone[i] = hashAfter(i);
    }
    std::uint64_t together[kWorlds] = {};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < kWorlds; ++i) {
        threads.emplace_back([&together, i] { together[i] = hashAfter(i); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < kWorlds; ++i) {
        EXPECT_EQ(together[i], alone[i]) << i;
    }
}

// W7: copies of one world share its immutable shapes and fields, and may run apart all the same.
TEST(Threads, CopiesRunApart) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 9, 40);
    World copy = world;
    std::thread other([&copy] { support::run(copy, 200); });
    support::run(world, 200);
    other.join();
    EXPECT_EQ(copy.stateHash(), world.stateHash());
}

// W7: turn by turn in one thread.
TEST(Threads, WorldsMayTakeTurns) {
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
