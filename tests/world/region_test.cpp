// SPDX-License-Identifier: MIT
#include <support/outside.hpp>
#include <support/resting.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::ballDef;
using support::boxDef;
using support::kDt;
using support::near;
using support::run;
using support::State;
using support::stateOf;
using support::waits;

Aabb around(Real from, Real to) {
    return {{from, -10}, {to, 100}};
}

std::vector<State> statesOf(const World& world) {
    std::vector<State> states;
    for (const BodyId id : world.bodies()) {
        states.push_back(stateOf(world, id));
    }
    return states;
}

// F3: the cost of a step follows the region, not the world: of a thousand boxes on the floor, as
// many are worked on as the region meets.
TEST(Region, CostFollowsTheRegion) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    for (int i = 0; i < 1000; ++i) {
        BodyDef def = boxDef({static_cast<Real>(i - 500), Real(0.25)}, Real(0.5), Real(0.5));
        def.flags = kNeverRest;
        world.add(def);
    }
    world.step(kDt);
    ASSERT_EQ(world.bodyVisits(), 1000u);
    const std::size_t whole = world.contactVisits();
    for (const int width : {100, 10, 1, 0, 500}) {
        const auto reach = static_cast<Real>(width) / 2;
        world.setRegion(around(Real(0.3) - reach, Real(0.3) + reach));
        run(world, 2); // in the first of them, contacts that are left end
        EXPECT_GE(world.bodyVisits(), static_cast<std::size_t>(width));
        EXPECT_LE(world.bodyVisits(), static_cast<std::size_t>(width) + 1);
        EXPECT_EQ(world.contactVisits(), whole / 1000 * world.bodyVisits());
        EXPECT_EQ(world.collisions().size(), world.bodyVisits());
    }
    world.setRegion(std::nullopt);
    world.step(kDt);
    EXPECT_EQ(world.bodyVisits(), 1000u);
}

// F3: what is outside waits as it is, and goes on bit by bit as if nothing had happened.
TEST(Region, WhatFliesOutsideWaitsAndGoesOnAsIfNothingHadHappened) {
    World world({.gravity = support::kEarth});
    for (int i = 0; i < 6; ++i) {
        const Vec2 place{30 + 5 * static_cast<Real>(i), 60};
        BodyDef def = i % 2 == 0 ? ballDef(place, Real(0.5)) : boxDef(place, 1, 2);
        def.velocity = {Real(0.5), 3};
        def.angularVelocity = 1;
        world.add(def);
    }
    run(world, 10);
    World undisturbed = world;
    world.setRegion(around(-10, 10));
    const std::vector<State> before = statesOf(world);
    run(world, 100);
    EXPECT_EQ(statesOf(world), before);
    EXPECT_EQ(world.bodyVisits(), 0u);
    for (const BodyId id : world.bodies()) {
        EXPECT_TRUE(waits(world, id));
    }
    world.setRegion(std::nullopt);
    for (int step = 0; step < 300; ++step) {
        world.step(kDt);
        undisturbed.step(kDt);
        ASSERT_EQ(statesOf(world), statesOf(undisturbed)) << step;
    }
}

// F3: what is inside does not notice that the rest of the world waits.
TEST(Region, WhatIsInsideGoesOnAsItDoesAlone) {
    World alone({.gravity = support::kEarth});
    support::addHeap(alone, 17, 40);
    World together = alone;
    const std::size_t count = alone.bodies().size();
    for (int i = 0; i < 50; ++i) {
        together.add(ballDef({40 + 3 * static_cast<Real>(i), 5}, 1));
    }
    together.setRegion(around(-8, 8));
    for (int step = 0; step < 300; ++step) {
        alone.step(kDt);
        together.step(kDt);
        std::vector<State> states = statesOf(together);
        states.resize(count);
        ASSERT_EQ(states, statesOf(alone)) << step;
    }
    for (std::size_t i = count; i < together.bodies().size(); ++i) {
        EXPECT_EQ(together[together.bodies()[i]].position().y, 5);
    }
}

// What leaves the region stops where it is out of it, with its speed; what the region follows does
// not.
TEST(Region, WhatLeavesItStopsAndWhatItFollowsGoesOn) {
    World world;
    BodyDef def = ballDef({0, 0}, Real(0.5));
    def.velocity = {6, 0};
    const BodyId leaver = world.add(def);
    world.setRegion(around(-5, 5));
    run(world, 120);
    EXPECT_TRUE(waits(world, leaver));
    // Its bounds end at x - 0.5; it has moved by up to one step of 0.1 m farther.
    EXPECT_TRUE(near(world[leaver].position().x, Real(5.55), Real(0.0501)));
    EXPECT_EQ(world[leaver].velocity(), (Vec2{6, 0}));
    for (int step = 0; step < 60; ++step) {
        const Real x = world[leaver].position().x;
        world.setRegion(around(x - 5, x + 5));
        world.step(kDt);
        ASSERT_FALSE(waits(world, leaver));
    }
    EXPECT_TRUE(near(world[leaver].position().x, Real(11.55), Real(0.051)));
}

// It is asked where a body is now: one that comes, or jumps, waits or goes on at once.
TEST(Region, NewcomersAndJumpersAreAskedAtOnce) {
    World world({.gravity = support::kEarth});
    world.setRegion(around(-5, 5));
    const BodyId newcomer = world.add(ballDef({20, 0}, 1));
    world.step(kDt);
    EXPECT_EQ(world[newcomer].position(), (Vec2{20, 0}));
    EXPECT_TRUE(waits(world, newcomer));
    const BodyId twin = world.clone(newcomer, {0, 0});
    const BodyId copy = world.clone(newcomer, {30, 0});
    world[newcomer].setPosition({3, 0});
    world.step(kDt);
    EXPECT_LT(world[newcomer].position().y, 0);
    EXPECT_LT(world[twin].position().y, 0);
    EXPECT_EQ(world[copy].position().y, 0);
    world[newcomer].setPosition({20, 0});
    world.step(kDt);
    EXPECT_EQ(world[newcomer].position(), (Vec2{20, 0}));
}

// What rests goes on resting, whether the region meets it or not.
TEST(Region, DoesNotWakeWhatRests) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    support::addStack(world, 5, 3);
    run(world, 120);
    ASSERT_EQ(support::countResting(world), 5u);
    for (const Real x : {Real(3), Real(50), Real(0)}) {
        world.setRegion(around(x - 1, x + 1));
        run(world, 10);
        EXPECT_EQ(support::countResting(world), 5u);
        EXPECT_EQ(world.bodyVisits(), 0u);
    }
}

// F3, O4: what has come to rest on something that waited wakes when that goes on, and goes with it.
TEST(Region, WhatRestsOnWhatGoesOnAgainWakes) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    BodyDef def = boxDef({0, Real(0.5)}, 1, 1);
    def.velocity = {5, 0};
    const BodyId carrier = world.add(def);
    def.velocity = {};
    def.position = {0, Real(1.5)};
    const BodyId rider = world.add(def);
    world.setRegion(Aabb{{-100, Real(1.2)}, {100, 100}}); // meets the rider alone
    run(world, 120);
    ASSERT_TRUE(waits(world, carrier));
    ASSERT_TRUE(support::rests(world, rider));
    world.setRegion(std::nullopt);
    EXPECT_FALSE(support::rests(world, rider));
    run(world, 30);
    EXPECT_GT(world[rider].position().x, Real(0.1)); // drawn along by friction
}

TEST(Region, RefusesOneThatIsInsideOut) {
    World world;
    EXPECT_THROW(world.setRegion(Aabb{{1, 0}, {0, 1}}), BadDefinition);
    EXPECT_FALSE(world.region());
}

// A velocity for one of two that wait on each other does not make them go on, as it once did: the
// pair was then solved and reported in every step.
TEST(Region, WhatGetsAVelocityWhileItWaitsGoesOnWaiting) {
    World world({.gravity = support::kEarth});
    const BodyId floor =
        world.add({.shape = Box{40, 1}, .position = {0, Real(-0.5)}, .flags = kLocked});
    world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}, .flags = kNeverRest});
    support::run(world, 30);
    world.setRegion(Aabb{{100, 0}, {110, 5}});
    support::run(world, 2);
    world[floor].setVelocity({1, 0});
    for (int step = 0; step < 4; ++step) {
        world.step(support::kDt);
        EXPECT_TRUE(world.collisions().empty()) << "step " << step;
        EXPECT_EQ(world.contactVisits(), 0u);
    }
}

} // namespace
} // namespace kodo
