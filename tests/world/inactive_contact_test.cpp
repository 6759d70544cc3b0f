// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::boxDef;
using support::kDt;

/// A box on the floor, in the state just before the step in which it falls asleep.
struct NearlyAtRest {
    World world{{.gravity = support::kEarth}};
    BodyId box;

    /// `addMore` adds further bodies before the first step.
    template <typename AddMore>
    explicit NearlyAtRest(AddMore addMore) {
        support::addFloor(world);
        box = world.add(boxDef({0, Real(0.5)}, 1, 1));
        addMore(world);
        for (World next = world; (next[box].flags() & kAsleep) == 0; next.step(kDt)) {
            world = next;
        }
    }
};

// Regression: a contact of two bodies that are neither asleep nor active belongs to no island.
// Storing it in one crashed.
TEST(InactiveContact, APlatformStopsInASensorWhileABodyFallsAsleep) {
    BodyId platform;
    BodyId sensor;
    NearlyAtRest scene([&](World& world) {
        BodyDef def = boxDef({20, 5}, 1, 1);
        def.velocity = {Real(0.125), 0};
        def.type = BodyType::Kinematic;
        platform = world.add(def);
        sensor = world.add({.shape = Circle{1},
                            .position = {20, 5},
                            .type = BodyType::Kinematic,
                            .flags = kSensor});
    });
    World& world = scene.world;
    ASSERT_NE(support::recordOf(world, platform, sensor), nullptr);
    world[platform].setVelocity({});
    world.step(kDt);
    EXPECT_NE(world[scene.box].flags() & kAsleep, 0u);
    world[scene.box].applyImpulse({0, 1}); // wakes the island with its contacts
    EXPECT_NO_THROW(support::run(world, 10));
}

TEST(InactiveContact, ABodyFreezesOnTheFloorWhileAnotherFallsAsleep) {
    BodyId wild;
    NearlyAtRest scene([&](World& world) {
        BodyDef def = boxDef({5, Real(0.5)}, 1, 1);
        def.flags = kNeverSleep;
        wild = world.add(def);
    });
    World& world = scene.world;
    world[wild].applyForce({Real(1e12), 0}); // far beyond kMaxSpeed within one step
    world.step(kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    EXPECT_EQ(world.frozenBodies()[0], wild);
    EXPECT_NE(world[scene.box].flags() & kAsleep, 0u);
    EXPECT_NO_THROW(support::run(world, 10));
}

// Regression: the gap of two boxes lies between the slop (1/256 m) and the margin (1/64 m). Each
// time one woke and fell asleep again, the other's island stored their contact once more.
TEST(InactiveContact, IsStoredOnceWhenANeighbourWakesRepeatedly) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId still = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId woken = world.add(boxDef({Real(1.01), Real(0.5)}, 1, 1));
    std::vector<std::size_t> sizes;
    for (int cycle = 0; cycle < 4; ++cycle) {
        world[woken].applyForce({0, -1});
        support::run(world, 100);
        for (const BodyId id : {still, woken}) {
            ASSERT_NE(world[id].flags() & kAsleep, 0u) << cycle;
        }
        sizes.push_back(toBytes(world).size());
    }
    EXPECT_EQ(sizes, std::vector<std::size_t>(sizes.size(), sizes[0]));
}

// A frozen body stays immovable after a change of its material, until a velocity is set.
TEST(FrozenBody, StaysImmovableWhenItsMaterialChanges) {
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
