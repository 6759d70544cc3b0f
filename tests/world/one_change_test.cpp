// SPDX-License-Identifier: MIT
#include <support/same_records.hpp>
#include <support/sleeping.hpp>

namespace kodo {
namespace {

constexpr int kBodies = 1000;
constexpr int kSteps = 30;
constexpr Vec2 kAway{0, 500};

/// A heap of discs without sleep, and one immovable disc far away.
struct Heap {
    World world{support::withoutSleep()};
    BodyId apart;

    Heap() {
        support::addFloor(world);
        for (int i = 0; i < kBodies; ++i) {
            const auto column = static_cast<Real>(i % 50);
            const auto row = static_cast<Real>(i / 50);
            world.add(support::ballDef({column - 25, row + Real(0.5)}, Real(0.5)));
        }
        apart = addApart();
        support::run(world, 20);
    }
    BodyId addApart() {
        BodyDef def = support::ballDef(kAway, Real(0.5));
        def.flags = kLockMove | kLockRotate;
        return world.add(def);
    }
    /// Pairs of nodes that the pair search compares, mean per step; calls change() before each.
    template <typename Change>
    std::uint64_t pairWork(Change change) {
        const std::uint64_t before = stepStats(world).pairWork;
        for (int step = 0; step < kSteps; ++step) {
            change();
            world.step(support::kDt);
        }
        return (stepStats(world).pairWork - before) / kSteps;
    }
};

// Regression: one body that was teleported, added or removed triggered a search for all pairs, at
// three times the cost.
TEST(OneChange, DoesNotCauseASearchForAllPairs) {
    Heap still;
    Heap jumping;
    Heap coming;
    const std::uint64_t none = still.pairWork([] {});
    const std::uint64_t teleports =
        jumping.pairWork([&] { jumping.world[jumping.apart].setPosition(kAway); });
    const std::uint64_t comes = coming.pairWork([&] {
        coming.world.remove(coming.apart);
        coming.apart = coming.addApart();
    });
    constexpr std::uint64_t kOne = 20; // pairs of nodes; there are some 150 nodes
    EXPECT_LE(teleports, none + none / 10 + kOne);
    EXPECT_LE(comes, none + none / 10 + kOne);
}

// Neither does a fast body over a sleeping World.
TEST(OneChange, NeitherWakesNorSearchesASleepingWorld) {
    World world(WorldDef{.gravity = support::kEarth});
    support::addFloor(world);
    for (int i = 0; i < kBodies; ++i) {
        world.add(support::boxDef({static_cast<Real>(i - kBodies / 2) / 2, Real(0.125)}, Real(0.25),
                                  Real(0.25)));
    }
    support::run(world, 200);
    ASSERT_EQ(support::countAsleep(world), static_cast<std::size_t>(kBodies));
    const std::uint64_t before = stepStats(world).pairWork;
    for (int step = 0; step < kSteps; ++step) {
        BodyDef def = support::ballDef({-20, 500}, Real(0.5));
        def.velocity = {10, 0};
        const BodyId shot = world.add(def);
        world.step(support::kDt);
        EXPECT_EQ(stepStats(world).bodies, 1u);
        world.remove(shot);
    }
    EXPECT_LE(stepStats(world).pairWork - before, std::uint64_t{4} * kSteps);
    EXPECT_EQ(support::countAsleep(world), static_cast<std::size_t>(kBodies));
}

// S2: the records of the last step do not change when their bodies are removed.
TEST(OneChange, RemovalKeepsTheRecordsOfTheLastStep) {
    Heap heap;
    const World before = heap.world;
    ASSERT_GT(before.collisions().size(), std::size_t{kBodies});
    const std::vector<BodyId> all = heap.world.bodies();
    for (std::size_t i = 1; i < all.size(); i += 7) {
        heap.world.remove(all[i]);
    }
    EXPECT_TRUE(support::sameRecords(before, heap.world));
}

// Each contact of a removed body gets one End in the next step. A body without other contacts loses
// kColliding.
TEST(OneChange, RemovalEndsEachContactOnce) {
    World world(support::withoutSleep());
    support::addFloor(world);
    const std::vector<BodyId> stack = support::addStack(world, 3);
    support::run(world, 30);
    world.remove(stack[1]);
    world.add(support::boxDef({50, 50}, 1, 1)); // reuses its slot
    world.step(support::kDt);
    std::size_t ends = 0;
    for (const CollisionRecord& record : world.collisions()) {
        ends += record.phase == TouchPhase::End ? 1u : 0u;
    }
    EXPECT_EQ(ends, 2u);
    EXPECT_EQ(world[stack[2]].flags() & kColliding, 0u);
    EXPECT_NE(world[stack[0]].flags() & kColliding, 0u);
}

} // namespace
} // namespace kodo
