// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "c_world.hpp"

namespace {

using namespace c_test;

constexpr std::array<kodo_Vec2, 4> kHill{{{-20, 0}, {0, 0}, {10, 4}, {30, 4}}};

kodo_BodyDef hillDef() {
    kodo_BodyDef def = bodyAt(0, 0, kodo_chain(kHill.data(), kHill.size()));
    def.shape.chain.oneSided = true;
    def.type = KODO_STATIC;
    return def;
}

/// m/s, as of a platformer that jumps once.
template <typename Vec2>
Vec2 wishOf(Vec2 velocity, int step) {
    velocity.x = 4;
    velocity.y = step == 100 ? kodo_Real(6) : velocity.y - 20 * kDt;
    return velocity;
}

TEST(CHelpers, AMoverWalksOverAHillWithTheBitsOfCpp) {
    const CWorld world;
    const kodo_BodyId hill = world.add(hillDef());
    kodo_BodyDef crateDef = bodyAt(14, kodo_Real(4.5), kodo_box(1, 1));
    crateDef.flags = KODO_NEVER_SLEEP;
    const kodo_BodyId crate = world.add(crateDef);
    kodo::World other = cppWorld();
    other.add(
        {.shape = kodo::Chain{.points = {{-20, 0}, {0, 0}, {10, 4}, {30, 4}}, .oneSided = true},
         .type = kodo::BodyType::Static});
    const kodo::BodyId otherCrate = other.add(
        {.shape = kodo::Box{1, 1}, .position = {14, kodo::Real(4.5)}, .flags = kodo::kNeverSleep});

    kodo_Mover mover = kodo_mover();
    mover.position = kodo_vec2(-3, 1);
    mover.pushForce = 20;
    kodo::Mover expected{.position = {-3, 1}, .pushForce = 20};
    bool climbed = false;
    for (int step = 0; step < 300; ++step) {
        world.step();
        EXPECT_OK(kodo_moveMover(world, &mover, wishOf(mover.velocity, step), kDt));
        other.step(kDt);
        expected.move(other, wishOf(expected.velocity, step), kDt);
        ASSERT_EQ(expected.position.x, mover.position.x) << step;
        ASSERT_EQ(expected.position.y, mover.position.y) << step;
        ASSERT_EQ(expected.velocity.y, mover.velocity.y) << step;
        ASSERT_EQ(expected.grounded, mover.grounded) << step;
        ASSERT_EQ(expected.groundNormal.x, mover.groundNormal.x) << step;
        ASSERT_EQ(expected.groundPose.position.x, mover.groundPose.position.x) << step;
        ASSERT_EQ(expected.wallNormal.x, mover.wallNormal.x) << step;
        climbed = climbed || (mover.grounded && mover.groundNormal.x < kodo_Real(-0.3));
    }
    EXPECT_TRUE(climbed);
    EXPECT_GT(mover.position.y, 4);
    EXPECT_TRUE(kodo_sameBody(hill, mover.groundBody));
    EXPECT_EQ(other[otherCrate].position().x, world.state(crate).transform.position.x);
    EXPECT_GT(world.state(crate).transform.position.x, kodo_Real(14.1)); // it was pushed
}

TEST(CHelpers, AMoverKeepsItsShapeAndDefaults) {
    const kodo_Mover mover = kodo_mover();
    const kodo::Mover defaults;
    const auto& capsule = std::get<kodo::Capsule>(defaults.shape);
    EXPECT_EQ(KODO_CAPSULE, mover.shape.kind);
    EXPECT_EQ(capsule.radius, mover.shape.capsule.radius);
    EXPECT_EQ(capsule.to.y, mover.shape.capsule.to.y);
    EXPECT_EQ(defaults.slopeLimit, mover.slopeLimit);
    EXPECT_EQ(defaults.stepHeight, mover.stepHeight);
    EXPECT_EQ(defaults.skin, mover.skin);
    EXPECT_EQ(1, mover.groundPose.rotation.c);

    const CWorld world;
    world.add(groundDef());
    const std::array<kodo_Vec2, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    kodo_Mover wedge = kodo_mover();
    wedge.shape = kodo_polygon(corners.data(), corners.size());
    wedge.position.y = 1;
    EXPECT_OK(kodo_moveMover(world, &wedge, kodo_vec2(0, -10), kDt));
    EXPECT_EQ(corners.data(), wedge.shape.polygon.corners);
    EXPECT_LT(wedge.position.y, 1);
}

TEST(CHelpers, ABadMoverIsRefusedAndStaysAsItIs) {
    const CWorld world;
    kodo_Mover mover = kodo_mover();
    mover.position.x = 7;
    mover.skin = 0;
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_moveMover(world, &mover, kodo_vec2(1, 0), kDt));
    EXPECT_EQ(7, mover.position.x);
    mover = kodo_mover();
    mover.shape = kodo_compound(nullptr, 0);
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_moveMover(world, &mover, kodo_vec2(1, 0), kDt));
    mover = {};
    EXPECT_EQ(KODO_WRONG_USE, kodo_moveMover(world, &mover, kodo_vec2(1, 0), kDt));
    EXPECT_EQ(KODO_WRONG_USE, kodo_moveMover(world, nullptr, kodo_vec2(1, 0), kDt));
}

/// A wall to the right of the origin, a box behind it, and one in the open.
struct Yard {
    CWorld world{kodo_Real(0)};
    kodo_BodyId behind = world.add(bodyAt(3, 0, kodo_box(1, 1)));
    kodo_BodyId open = world.add(bodyAt(-3, 0, kodo_box(1, 1)));

    Yard() {
        kodo_BodyDef wall = bodyAt(1, 0, kodo_box(kodo_Real(0.2), 4));
        wall.type = KODO_STATIC;
        world.add(wall);
    }
};

TEST(CHelpers, AnExplosionHitsNothingBehindAWall) {
    const Yard yard;
    kodo_Explosion explosion = kodo_explosion();
    explosion.radius = 5;
    explosion.impulse = 2;
    std::array<kodo_ExplosionHit, 2> hits{};
    std::size_t count = 0;
    EXPECT_OK(kodo_explode(yard.world, &explosion, hits.data(), hits.size(), &count));
    ASSERT_EQ(1u, count);
    EXPECT_TRUE(kodo_sameBody(yard.open, hits[0].body));
    EXPECT_LT(hits[0].impulse.x, 0);
    EXPECT_GT(hits[0].width, 0);
    const kodo_BodyState pushed = yard.world.state(yard.open);
    EXPECT_NEAR(hits[0].impulse.x, pushed.mass * pushed.velocity.x, 1e-5);
    EXPECT_EQ(0, yard.world.state(yard.behind).velocity.x);

    kodo::World other = cppWorld(0);
    other.add({.shape = kodo::Box{1, 1}, .position = {3, 0}});
    const kodo::BodyId open = other.add({.shape = kodo::Box{1, 1}, .position = {-3, 0}});
    other.add({.shape = kodo::Box{kodo::Real(0.2), 4},
               .position = {1, 0},
               .type = kodo::BodyType::Static});
    kodo::explode(other, {.radius = 5, .impulse = 2});
    EXPECT_EQ(other[open].velocity().x, pushed.velocity.x);
}

TEST(CHelpers, AnExplosionThatIsRefusedPushesNothing) {
    const Yard yard;
    kodo_Explosion explosion = kodo_explosion();
    explosion.radius = 5;
    std::size_t count = 0;
    EXPECT_EQ(KODO_WRONG_USE, kodo_explode(yard.world, &explosion, nullptr, 0, nullptr));
    EXPECT_EQ(KODO_WRONG_USE, kodo_explode(yard.world, &explosion, nullptr, 1, &count));
    EXPECT_EQ(KODO_WRONG_USE, kodo_explode(yard.world, nullptr, nullptr, 0, &count));
    explosion.radius = 0;
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_explode(yard.world, &explosion, nullptr, 0, &count));
    EXPECT_EQ(0, yard.world.state(yard.open).velocity.x);
}

TEST(CHelpers, ALockedAxisEndsWithItsGroove) {
    const CWorld world;
    kodo_BodyDef def = bodyAt(0, 3, kodo_box(1, 1));
    def.velocity = {2, 5};
    const kodo_BodyId body = world.add(def);
    kodo_BodyId groove{};
    EXPECT_EQ(KODO_WRONG_USE, kodo_lockAxis(world, body, {0, 1}, nullptr));
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_lockAxis(world, body, {0, 2}, &groove));
    EXPECT_EQ(KODO_BAD_ID, kodo_lockAxis(world, {}, {0, 1}, &groove));
    EXPECT_OK(kodo_lockAxis(world, body, {0, 1}, &groove));
    world.step(60);
    EXPECT_NEAR(world.state(body).transform.position.x, 2, 0.01);
    EXPECT_NEAR(world.state(body).transform.position.y, 3, 0.01);
    EXPECT_OK(kodo_removeBody(world, groove));
    world.step(60);
    EXPECT_NEAR(world.state(body).transform.position.x, 4, 0.01);
}

TEST(CHelpers, TouchingListsSleepingBodiesToo) {
    const CWorld world;
    const kodo_BodyId ground = world.add(groundDef());
    const kodo_BodyId low = world.add(bodyAt(0, kodo_Real(0.5), kodo_box(1, 1)));
    const kodo_BodyId high = world.add(bodyAt(0, kodo_Real(1.5), kodo_box(1, 1)));
    world.step(200);
    EXPECT_TRUE(world.state(low).isAsleep);
    std::array<kodo_BodyId, 3> ids{};
    std::size_t count = 0;
    EXPECT_OK(kodo_touching(world, low, ids.data(), ids.size(), &count));
    ASSERT_EQ(2u, count);
    EXPECT_TRUE(kodo_sameBody(ground, ids[0]));
    EXPECT_TRUE(kodo_sameBody(high, ids[1]));
    EXPECT_EQ(KODO_BAD_ID, kodo_touching(world, {}, ids.data(), ids.size(), &count));
}

} // namespace
