// SPDX-License-Identifier: MIT
#include <support/outside.hpp>
#include <support/sleeping.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::ballDef;
using support::boxDef;
using support::isOutside;
using support::kDt;
using support::near;
using support::run;
using support::State;
using support::stateOf;

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

// F3: the cost of a step depends on the region: of 1000 boxes on the floor, only those that overlap
// it are stepped.
TEST(Region, CostFollowsTheRegion) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    for (int i = 0; i < 1000; ++i) {
        BodyDef def = boxDef({static_cast<Real>(i - 500), Real(0.25)}, Real(0.5), Real(0.5));
        def.flags = kNeverSleep;
        world.add(def);
    }
    world.step(kDt);
    ASSERT_EQ(stepStats(world).bodies, 1000u);
    const std::size_t whole = stepStats(world).contacts;
    for (const int width : {100, 10, 1, 0, 500}) {
        const auto reach = static_cast<Real>(width) / 2;
        world.setRegion(around(Real(0.3) - reach, Real(0.3) + reach));
        run(world, 2); // the first step ends contacts that were left
        EXPECT_GE(stepStats(world).bodies, static_cast<std::size_t>(width));
        EXPECT_LE(stepStats(world).bodies, static_cast<std::size_t>(width) + 1);
        EXPECT_EQ(stepStats(world).contacts, whole / 1000 * stepStats(world).bodies);
        EXPECT_EQ(world.collisions().size(), stepStats(world).bodies);
    }
    world.setRegion(std::nullopt);
    world.step(kDt);
    EXPECT_EQ(stepStats(world).bodies, 1000u);
}

// F3: bodies outside keep their pose and velocity. Afterwards they continue with the same bits.
TEST(Region, BodiesOutsidePauseAndContinueWithTheSameBits) {
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
    EXPECT_EQ(stepStats(world).bodies, 0u);
    for (const BodyId id : world.bodies()) {
        EXPECT_TRUE(isOutside(world, id));
    }
    world.setRegion(std::nullopt);
    for (int step = 0; step < 300; ++step) {
        world.step(kDt);
        undisturbed.step(kDt);
        ASSERT_EQ(statesOf(world), statesOf(undisturbed)) << step;
    }
}

// F3: bodies outside do not affect those inside.
TEST(Region, BodiesInsideMoveAsWithoutThoseOutside) {
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

// A body that leaves the region stops outside and keeps its velocity. A body that the region
// follows keeps moving.
TEST(Region, ABodyThatLeavesItStopsUnlessItIsFollowed) {
    World world;
    BodyDef def = ballDef({0, 0}, Real(0.5));
    def.velocity = {6, 0};
    const BodyId leaver = world.add(def);
    world.setRegion(around(-5, 5));
    run(world, 120);
    EXPECT_TRUE(isOutside(world, leaver));
    // Its bounds begin at x - 0.5; the last step moved it by up to 0.1 m beyond.
    EXPECT_TRUE(near(world[leaver].position().x, Real(5.55), Real(0.0501)));
    EXPECT_EQ(world[leaver].velocity(), (Vec2{6, 0}));
    for (int step = 0; step < 60; ++step) {
        const Real x = world[leaver].position().x;
        world.setRegion(around(x - 5, x + 5));
        world.step(kDt);
        ASSERT_FALSE(isOutside(world, leaver));
    }
    EXPECT_TRUE(near(world[leaver].position().x, Real(11.55), Real(0.051)));
}

TEST(Region, AppliesAtOnceToAddedClonedAndTeleportedBodies) {
    World world({.gravity = support::kEarth});
    world.setRegion(around(-5, 5));
    const BodyId newcomer = world.add(ballDef({20, 0}, 1));
    world.step(kDt);
    EXPECT_EQ(world[newcomer].position(), (Vec2{20, 0}));
    EXPECT_TRUE(isOutside(world, newcomer));
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

TEST(Region, DoesNotWakeSleepingBodies) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    support::addStack(world, 5, 3);
    run(world, 120);
    ASSERT_EQ(support::countAsleep(world), 5u);
    for (const Real x : {Real(3), Real(50), Real(0)}) {
        world.setRegion(around(x - 1, x + 1));
        run(world, 10);
        EXPECT_EQ(support::countAsleep(world), 5u);
        EXPECT_EQ(stepStats(world).bodies, 0u);
    }
}

// F3, O4: a body asleep on a body outside wakes when that one is active again, and moves with it.
TEST(Region, ABodyAsleepOnAReactivatedBodyWakes) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    BodyDef def = boxDef({0, Real(0.5)}, 1, 1);
    def.velocity = {5, 0};
    const BodyId carrier = world.add(def);
    def.velocity = {};
    def.position = {0, Real(1.5)};
    const BodyId rider = world.add(def);
    world.setRegion(Aabb{{-100, Real(1.2)}, {100, 100}}); // overlaps the rider alone
    run(world, 120);
    ASSERT_TRUE(isOutside(world, carrier));
    ASSERT_TRUE(support::isAsleep(world, rider));
    world.setRegion(std::nullopt);
    EXPECT_FALSE(support::isAsleep(world, rider));
    run(world, 30);
    EXPECT_GT(world[rider].position().x, Real(0.1)); // dragged by friction
}

TEST(Region, RefusesInvertedBounds) {
    World world;
    EXPECT_THROW(world.setRegion(Aabb{{1, 0}, {0, 1}}), BadDefinition);
    EXPECT_FALSE(world.region());
}

// Regression: a velocity set on one of two touching bodies outside made their contact active. It
// was solved and reported in every step.
TEST(Region, ABodyOutsideStaysOutsideWhenItsVelocityIsSet) {
    World world({.gravity = support::kEarth});
    const BodyId floor =
        world.add({.shape = Box{40, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Kinematic});
    world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}, .flags = kNeverSleep});
    support::run(world, 30);
    world.setRegion(Aabb{{100, 0}, {110, 5}});
    support::run(world, 2);
    world[floor].setVelocity({1, 0});
    for (int step = 0; step < 4; ++step) {
        world.step(support::kDt);
        EXPECT_TRUE(world.collisions().empty()) << "step " << step;
        EXPECT_EQ(stepStats(world).contacts, 0u);
    }
}

} // namespace
} // namespace kodo
