// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::boxDef;
using support::kDt;

/// A box on the floor, up to just before the step in which it comes to rest.
struct NearlyAtRest {
    World world{{.gravity = support::kEarth}};
    BodyId box;

    /// `addMore` adds what else there is to be, before anything moves.
    template <typename AddMore>
    explicit NearlyAtRest(AddMore addMore) {
        support::addFloor(world);
        box = world.add(boxDef({0, Real(0.5)}, 1, 1));
        addMore(world);
        for (World next = world; (next[box].flags() & kResting) == 0; next.step(kDt)) {
            world = next;
        }
    }
};

// Neither body of such a contact rests, so no island keeps it: writing it into none crashed.
TEST(IdleContact, APlatformMayStopInASensorWhileSomethingComesToRest) {
    BodyId platform;
    BodyId sensor;
    NearlyAtRest scene([&](World& world) {
        BodyDef def = boxDef({20, 5}, 1, 1);
        def.velocity = {Real(0.125), 0};
        def.flags = kLocked;
        platform = world.add(def);
        sensor = world.add({.shape = Circle{1}, .position = {20, 5}, .flags = kLocked | kSensor});
    });
    World& world = scene.world;
    ASSERT_NE(support::recordOf(world, platform, sensor), nullptr);
    world[platform].setVelocity({});
    world.step(kDt);
    EXPECT_NE(world[scene.box].flags() & kResting, 0u);
    world[scene.box].applyImpulse({0, 1}); // wakes the island, and with it all that it keeps
    EXPECT_NO_THROW(support::run(world, 10));
}

TEST(IdleContact, ABodyMayFreezeOnTheFloorWhileAnotherComesToRest) {
    BodyId wild;
    NearlyAtRest scene([&](World& world) {
        BodyDef def = boxDef({5, Real(0.5)}, 1, 1);
        def.flags = kNeverRest;
        wild = world.add(def);
    });
    World& world = scene.world;
    world[wild].applyForce({Real(1e12), 0}); // far beyond kHighestSpeed within one step
    world.step(kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    EXPECT_EQ(world.frozenBodies()[0], wild);
    EXPECT_NE(world[scene.box].flags() & kResting, 0u);
    EXPECT_NO_THROW(support::run(world, 10));
}

// Two boxes whose gap is wider than what touches (1/256 m), but narrower than what contacts are
// kept ready for (1/64 m). Whenever one woke and came to rest again, the other's island kept their
// contact once more, and gave all of them back when it woke.
TEST(IdleContact, IsKeptOnceHoweverOftenANeighbourWakes) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId still = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId woken = world.add(boxDef({Real(1.01), Real(0.5)}, 1, 1));
    std::vector<std::size_t> sizes;
    for (int cycle = 0; cycle < 4; ++cycle) {
        world[woken].applyForce({0, -1});
        support::run(world, 100);
        for (const BodyId id : {still, woken}) {
            ASSERT_NE(world[id].flags() & kResting, 0u) << cycle;
        }
        sizes.push_back(toBytes(world).size());
    }
    EXPECT_EQ(sizes, std::vector<std::size_t>(sizes.size(), sizes[0]));
}

// Another form or material is no way out: it stands as if locked until a velocity is set.
TEST(Frozen, StaysAsIfLockedWhenItsMaterialChanges) {
    World world;
    const BodyId box = world.add(boxDef({}, 1, 1));
    world[box].applyForce({Real(1e12), 0});
    world.step(kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    world[box].setMaterial(support::slippery());
    world[box].applyImpulse({0, 1}, {1, 0});
    EXPECT_EQ(world[box].angularVelocity(), 0);
    world[box].setVelocity({});
    world[box].applyImpulse({0, 1}, {1, 0});
    EXPECT_GT(world[box].angularVelocity(), 0);
}

} // namespace
} // namespace kodo
