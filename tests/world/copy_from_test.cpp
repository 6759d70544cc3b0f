// SPDX-License-Identifier: MIT
// X4: state, flags and physical data of a body are copied onto another one.
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <string>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kDt;
using support::kEpsilon;
using support::near;
using support::run;

BodyDef richDef() {
    return {.shape = Compound{{Box{2, 1}, Circle{Real(0.5), {1, 0}}}},
            .position = {3, 4},
            .rotation = Rot::fromAngle(Real(0.7)),
            .velocity = {1, -2},
            .angularVelocity = 3,
            .material = withFriction(Real(0.3), Real(0.6)),
            .density = 5,
            .flags = 0x3 | kMatchAll | kNeverSleep,
            .required = 0x6,
            .group = 7,
            .userData = 9};
}

// X4: the target has the state, flags and physical data of the source; shape and user data stay.
TEST(CopyFrom, CopiesStateFlagsAndPhysicalData) {
    World world;
    const BodyId source = world.add(richDef());
    world[source].setMass({.mass = 17, .center = Vec2{Real(0.25), 0}, .inertia = 2});
    BodyDef def = ballDef({-5, -5}, Real(0.5));
    def.userData = 4;
    const BodyId id = world.add(def);
    world[id].copyFrom(world[source]);
    const BodyView from = world[source];
    const BodyView to = world[id];
    EXPECT_EQ(to.position(), from.position());
    EXPECT_EQ(to.center(), from.center());
    EXPECT_EQ(to.rotation(), from.rotation());
    EXPECT_EQ(to.velocity(), from.velocity());
    EXPECT_EQ(to.angularVelocity(), from.angularVelocity());
    EXPECT_EQ(to.flags(), from.flags());
    EXPECT_EQ(to.required(), from.required());
    EXPECT_EQ(to.group(), 7);
    EXPECT_EQ(to.type(), from.type());
    EXPECT_EQ(to.mass(), 17);
    EXPECT_EQ(to.inertia(), 2);
    EXPECT_EQ(to.localCenter(), from.localCenter());
    EXPECT_EQ(to.part(0).material, from.part(0).material);
    EXPECT_EQ(to.partCount(), 1u);
    EXPECT_EQ(to.part(0).convex.radius, Real(0.5));
    EXPECT_EQ(to.userData(), 4u);
}

// X4: the two then move alike, to the bit.
TEST(CopyFrom, ThenBothMoveAlike) {
    World world({.gravity = support::kEarth});
    BodyDef def = richDef();
    def.flags |= kDisabled;
    const BodyId source = world.add(def);
    def.shape = Box{Real(0.5), 3};
    def.density = 2;
    def.position = {-9, 0};
    const BodyId id = world.add(def);
    run(world, 10);
    world[id].copyFrom(world[source]);
    for (int i = 0; i < 60; ++i) {
        world[source].applyForce({3, 1}, {2, 2});
        world[id].applyForce({3, 1}, {2, 2});
        world.step(kDt);
        ASSERT_EQ(world[id].massFrame().position, world[source].massFrame().position);
        ASSERT_EQ(world[id].rotation(), world[source].rotation());
        ASSERT_EQ(world[id].velocity(), world[source].velocity());
    }
}

// A copy of a state onto the same body changes nothing, also where masses of several parts were
// set.
TEST(CopyFrom, OfItsOwnStateChangesNothing) {
    World world;
    const BodyId body = world.add({.shape = Circle{Real(0.1)}, .mass = MassDef{1000}});
    const BodyId crate =
        world.add({.shape = Box{6, Real(0.1)}, .position = {0, 1}, .mass = MassDef{1}});
    world.weld(body, crate);
    const World before = world;
    world[body].copyFrom(before[body]);
    EXPECT_EQ(world[body].mass(), before[body].mass());
    EXPECT_EQ(world[body].inertia(), before[body].inertia());
    EXPECT_TRUE(support::near(world[world.unweld(body, 1)].mass(), 1, Real(1e-5)));
    EXPECT_TRUE(support::near(world[body].mass(), 1000, Real(1e-3)));
}

// A body of equal shapes keeps its mass from density: nothing is set.
TEST(CopyFrom, BetweenEqualShapesSetsNoMass) {
    World world;
    const BodyId source = world.add(richDef());
    const BodyId id = world.clone(source, {});
    world[id].copyFrom(world[source]);
    EXPECT_FALSE(world[id].hasSetMass());
    EXPECT_EQ(world[id].massFrame().position, world[source].massFrame().position);
    world[source].setMass(3);
    world[id].copyFrom(world[source]);
    EXPECT_EQ(world[id].mass(), 3);
    world[source].setMassFromDensity();
    world[id].copyFrom(world[source]);
    EXPECT_FALSE(world[id].hasSetMass());
}

TEST(CopyFrom, CopiesMaterialsPartByPart) {
    World world;
    const auto rough = withFriction(1);
    const auto smooth = withFriction(Real(0.1));
    const BodyId source = world.add({.material = rough});
    world.weld(source, Circle{1, {3, 0}}, smooth, 1);
    const BodyId id =
        world.add({.shape = Compound{{Circle{1}, Circle{1, {2, 0}}, Circle{1, {4, 0}}}}});
    world[id].copyFrom(world[source]);
    EXPECT_EQ(world[id].part(0).material, rough);
    EXPECT_EQ(world[id].part(1).material, smooth);
    EXPECT_EQ(world[id].part(2).material, smooth);
}

// One body goes back to a state of a copy of its World, while the others go on.
TEST(CopyFrom, ReadsBodiesOfAnotherWorld) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId ball = world.add(ballDef({0, 5}, Real(0.5)));
    const BodyId other = world.add(ballDef({5, 5}, Real(0.5)));
    run(world, 10);
    const World saved = world;
    run(world, 200);
    ASSERT_TRUE(world[ball].isAsleep());
    world[ball].copyFrom(saved[ball]);
    EXPECT_FALSE(world[ball].isAsleep());
    EXPECT_EQ(world[ball].position(), saved[ball].position());
    EXPECT_EQ(world[ball].velocity(), saved[ball].velocity());
    EXPECT_TRUE(world[other].isAsleep());
    World again = saved;
    for (int i = 0; i < 30; ++i) {
        world.step(kDt);
        again.step(kDt);
        ASSERT_EQ(world[ball].position(), again[ball].position());
    }
}

// Status, forces and user data are not copied; what rested on the target wakes.
TEST(CopyFrom, WakesWhatTouchedTheTarget) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId low = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId high = world.add(boxDef({0, Real(1.5)}, 1, 1));
    const BodyId away = world.add(boxDef({50, Real(0.5)}, 1, 1));
    run(world, 120);
    ASSERT_TRUE(world[high].isAsleep() && world[away].isAsleep());
    world[low].copyFrom(world[away]);
    EXPECT_FALSE(world[high].isAsleep());
    world[away].setPosition({70, Real(0.5)});
    run(world, 120);
    EXPECT_TRUE(near(world[high].position(), Vec2{0, Real(0.5)}, Real(0.01)));
    EXPECT_TRUE(near(world[low].position(), Vec2{50, Real(0.5)}, Real(0.01)));
    EXPECT_EQ(world[floor].type(), BodyType::Static);
}

TEST(CopyFrom, TakesTheTypeOver) {
    for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic, BodyType::Static}) {
        World world({.gravity = support::kEarth});
        BodyDef def = boxDef({1, 2}, 1, 1);
        def.type = type;
        def.velocity = type == BodyType::Static ? Vec2{} : Vec2{3, 0};
        const BodyId source = world.add(def);
        const BodyId id = world.add({.position = {9, 9}, .velocity = {1, 1}, .angularVelocity = 1});
        world[id].copyFrom(world[source]);
        EXPECT_EQ(world[id].type(), type);
        EXPECT_EQ(world[id].velocity(), def.velocity);
        EXPECT_EQ(world[id].angularVelocity(), 0);
        world[source].setFlags(kDisabled);
        run(world, 30);
        const bool falls = type == BodyType::Dynamic;
        EXPECT_EQ(world[id].position().y < 2, falls);
    }
}

TEST(CopyFrom, OntoItselfChangesNothing) {
    World world;
    const BodyId id = world.add(richDef());
    world[id].setMass({.mass = 17, .center = Vec2{Real(0.25), 0}, .inertia = 2});
    World other = world;
    world[id].copyFrom(world[id]);
    EXPECT_EQ(world[id].mass(), 17);
    run(world, 10);
    run(other, 10);
    EXPECT_EQ(world[id].position(), other[id].position());
}

// What a setter would refuse is refused, by name, and nothing changes.
TEST(CopyFrom, RefusesWhatTheBodyCannotBe) {
    World world;
    const BodyId ball = world.add({});
    const BodyId soft = world.add({.shape = Circle{Real(0.01)}});
    const BodyId ground = world.add({.shape = Plane{}, .type = BodyType::Static});
    World wide({.lengthUnit = 100});
    const BodyId far = wide.add({.position = {10 * kMaxCoordinate, 0}});
    const BodyId gone = world.add({});
    world.remove(gone);
    const std::uint64_t before = world.stateHash();
    const auto refusal = [](const std::function<void()>& call) -> std::string {
        try {
            call();
            return "accepted";
        } catch (const BadDefinition& bad) {
            return bad.problem().field;
        }
    };
    EXPECT_EQ(refusal([&] { world[ground].copyFrom(world[ball]); }), "type");
    EXPECT_EQ(refusal([&] { world[ball].copyFrom(world[soft]); }), "other.mass.inertia");
    EXPECT_EQ(refusal([&] { world[ball].copyFrom(wide[far]); }), "other.position");
    EXPECT_THROW(world[ball].copyFrom(world[gone]), BadBodyId);
    EXPECT_EQ(world.stateHash(), before);
}

} // namespace
} // namespace kodo
