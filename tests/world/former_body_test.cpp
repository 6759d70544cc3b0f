// SPDX-License-Identifier: MIT
// X7: a welded part stays what it was as a body of its own, for its removal.
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kEpsilon;
using support::near;
using support::run;

BodyDef arrowDef() {
    BodyDef def = boxDef({2, 0}, 1, Real(0.25));
    def.flags = 0x4 | kMatchAny | kLockRotate | kNeverSleep;
    def.required = 0x3;
    def.userData = 77;
    return def;
}

void expectAnArrow(const World& world, BodyId id) {
    const BodyDef def = arrowDef();
    EXPECT_EQ(world[id].flags() & ~kStatusFlags, def.flags);
    EXPECT_EQ(world[id].required(), def.required);
    EXPECT_EQ(world[id].userData(), def.userData);
    EXPECT_EQ(world[id].type(), def.type);
}

// X7: flags, required categories and user data come back.
TEST(FormerBody, ComesBackWithItsFlagsAndUserData) {
    World world;
    const BodyId wall = world.add({.shape = Box{3, 3}, .type = BodyType::Static, .userData = 5});
    const BodyId arrow = world.add(arrowDef());
    const std::size_t part = world.weld(wall, arrow);
    run(world, 3);
    EXPECT_EQ(world[wall].userData(), 5u);
    EXPECT_EQ(world[wall].flags() & kUserFlags, 0u);
    expectAnArrow(world, world.unweld(wall, part));
    EXPECT_EQ(world[wall].type(), BodyType::Static);
}

TEST(FormerBody, ComesBackWithItsType) {
    for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic, BodyType::Static}) {
        World world;
        BodyDef def = boxDef({2, 0}, 1, 1);
        def.type = type;
        const BodyId into = world.add({.velocity = {1, 2}, .angularVelocity = 3});
        const std::size_t part = world.weld(into, world.add(def));
        const BodyId freed = world.unweld(into, part);
        EXPECT_EQ(world[freed].type(), type);
        const bool stands = type != BodyType::Dynamic;
        EXPECT_EQ(world[freed].velocity() == Vec2{}, stands);
        EXPECT_EQ(world[freed].angularVelocity() == 0, stands);
    }
}

// Flags that are given count; the part then is a dynamic body with its user data.
TEST(FormerBody, FlagsThatAreGivenReplaceItsOwn) {
    World world;
    BodyDef def = arrowDef();
    def.type = BodyType::Kinematic;
    const BodyId into = world.add({});
    const std::size_t part = world.weld(into, world.add(def));
    const BodyId freed = world.unweld(into, part, 0x8);
    EXPECT_EQ(world[freed].flags(), 0x8u);
    EXPECT_EQ(world[freed].required(), 0);
    EXPECT_EQ(world[freed].type(), BodyType::Dynamic);
    EXPECT_EQ(world[freed].userData(), 77u);
}

// Status is not kept: neither sleep, nor a touch.
TEST(FormerBody, ComesBackWithoutStatus) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId other = world.add(boxDef({5, Real(0.5)}, 1, 1));
    run(world, 120);
    ASSERT_TRUE(world[other].isAsleep());
    const BodyId freed = world.unweld(box, world.weld(box, other));
    EXPECT_EQ(world[freed].flags(), 0u);
}

// Parts that never were bodies are as before: dynamic, without flags and user data.
TEST(FormerBody, IsUnknownOfAShape) {
    World world;
    BodyDef def = arrowDef();
    def.shape = Compound{{Box{1, 1}, Box{1, 1, {1, 0}}}};
    const BodyId whole = world.add(def);
    world.weld(whole, world.add(ballDef({0, 2}, Real(0.5))));
    world.weld(whole, Circle{Real(0.5), {0, -2}}, {}, 1);
    for (const std::size_t part : {std::size_t{3}, std::size_t{1}}) {
        const BodyId freed = world.unweld(whole, part);
        EXPECT_EQ(world[freed].flags(), 0u);
        EXPECT_EQ(world[freed].userData(), 0u);
    }
}

// A part of a part stays what it was first; the other parts of that body become parts of it.
TEST(FormerBody, StaysAcrossSeveralWelds) {
    World world;
    const BodyId wall = world.add({.shape = Box{3, 3}, .userData = 1});
    BodyDef def = boxDef({4, 0}, 1, 1);
    def.userData = 2;
    const BodyId knight = world.add(def);
    const BodyId arrow = world.add(arrowDef());
    EXPECT_EQ(world.weld(knight, arrow), 1u);
    world.weld(knight, Circle{Real(0.5), {0, 1}}, {}, 1);
    EXPECT_EQ(world.weld(wall, knight), 1u); // the knight's box, the arrow, the circle
    const BodyId circle = world.unweld(wall, 3);
    EXPECT_EQ(world[circle].userData(), 2u);
    expectAnArrow(world, world.unweld(wall, 2));
    EXPECT_EQ(world[world.unweld(wall, 1)].userData(), 2u);
    EXPECT_EQ(world[wall].partCount(), 1u);
}

// After its removal a body is welded as what it is then.
TEST(FormerBody, IsWhatTheBodyWasAtTheLastWeld) {
    World world;
    const BodyId into = world.add({});
    BodyId arrow = world.unweld(into, world.weld(into, world.add(arrowDef())));
    world[arrow].setUserData(78);
    world[arrow].setFlags(0x10);
    arrow = world.unweld(into, world.weld(into, arrow));
    EXPECT_EQ(world[arrow].userData(), 78u);
    EXPECT_EQ(world[arrow].flags(), 0x10u);
}

TEST(FormerBody, IsHeldByClonesCopiesAndBytes) {
    World world;
    const BodyId into = world.add({});
    const std::size_t part = world.weld(into, world.add(arrowDef()));
    const BodyId clone = world.clone(into, {9, 9});
    World copy = world;
    World loaded = fromBytes(toBytes(world));
    EXPECT_EQ(loaded.stateHash(), world.stateHash());
    for (World* each : {&world, &copy, &loaded}) {
        (*each)[into].setMaterial(support::slippery());
        expectAnArrow(*each, each->unweld(into, part));
        expectAnArrow(*each, each->unweld(clone, part));
        EXPECT_EQ(each->stateHash(), world.stateHash());
    }
}

// The future differs, so the hash does.
TEST(FormerBody, CountsForTheStateHash) {
    const auto hashOf = [](std::uint64_t userData) {
        World world;
        const BodyId into = world.add({});
        BodyDef def = arrowDef();
        def.userData = userData;
        world.weld(into, world.add(def));
        return world.stateHash();
    };
    EXPECT_NE(hashOf(1), hashOf(2));
    EXPECT_EQ(hashOf(1), hashOf(1));
}

// A plane of a static body comes back without flags being named.
TEST(FormerBody, APlaneComesBackStatic) {
    World world;
    const BodyId floor = world.add({.shape = Plane{}, .type = BodyType::Static});
    const BodyId wall = world.add({.shape = Box{1, 4}, .type = BodyType::Static});
    const std::size_t part = world.weld(wall, floor);
    EXPECT_THROW(world.unweld(wall, part, 0), BadDefinition);
    EXPECT_EQ(world[world.unweld(wall, part)].type(), BodyType::Static);
}

} // namespace
} // namespace kodo
