// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::kDt;
using support::run;

// R2: a World is a value: a copy continues with the same bits.
TEST(WorldValue, ACopyOfANewWorldContinuesWithTheSameBits) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 1, 60);
    World copy = world;
    EXPECT_EQ(copy.stateHash(), world.stateHash());
    run(world, 300);
    run(copy, 300);
    EXPECT_EQ(copy.stateHash(), world.stateHash());
}

// In a moving heap the solver state matters; it is part of the value.
TEST(WorldValue, ACopyOfAMovingHeapContinuesWithTheSameBits) {
    for (const int moment : {1, 45, 100, 250}) {
        SCOPED_TRACE(moment);
        World world({.gravity = support::kEarth});
        support::addHeap(world, 2, 60);
        run(world, moment);
        World copy = world;
        for (int i = 0; i < (support::kSanitized ? 60 : 300); ++i) {
            world.step(kDt);
            copy.step(kDt);
            ASSERT_EQ(copy.stateHash(), world.stateHash()) << "step " << i << " after the copy";
        }
    }
}

TEST(WorldValue, ACopyDoesNotAffectTheOriginal) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 3, 30);
    World alone = world;
    run(alone, 100);
    for (int i = 0; i < 100; ++i) {
        World copy = world;
        copy.remove(copy.bodies().back());
        run(copy, 3);
        world.step(kDt);
    }
    EXPECT_EQ(world.stateHash(), alone.stateHash());
}

TEST(WorldValue, CanBeAssignedAndMoved) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 4, 30);
    run(world, 60);
    const World saved = world;
    run(world, 60);
    const std::uint64_t later = world.stateHash();
    world = saved; // rewind
    EXPECT_EQ(world.stateHash(), saved.stateHash());
    run(world, 60);
    EXPECT_EQ(world.stateHash(), later);
    const World moved = std::move(world);
    EXPECT_EQ(moved.stateHash(), later);
}

TEST(WorldValue, TheSameCallsGiveTheSameBits) {
    std::uint64_t first = 0;
    for (int repeat = 0; repeat < 3; ++repeat) {
        World world({.gravity = support::kEarth});
        support::addHeap(world, 5, 60);
        run(world, 200);
        world.remove(world.bodies()[10]);
        run(world, 100);
        first = repeat == 0 ? world.stateHash() : first;
        EXPECT_EQ(world.stateHash(), first);
    }
}

// The hash covers positions, velocities, flags, steps and pending forces.
TEST(WorldValue, TheHashDistinguishesStates) {
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(support::ballDef({}, 1));
    const std::uint64_t before = world.stateHash();
    const auto changed = [&](auto change) {
        World copy = world;
        change(copy);
        return copy.stateHash() != before;
    };
    EXPECT_TRUE(changed([&](World& w) { w.step(kDt); }));
    EXPECT_TRUE(changed([&](World& w) { w[ball].setPosition({support::kEpsilon, 0}); }));
    EXPECT_TRUE(changed([&](World& w) { w[ball].setVelocity({0, support::kEpsilon}); }));
    EXPECT_TRUE(changed([&](World& w) { w[ball].applyForce({1, 0}); }));
    EXPECT_TRUE(changed([&](World& w) { w[ball].setFlags(1); }));
    EXPECT_TRUE(changed([&](World& w) { w.remove(ball); }));
    EXPECT_FALSE(changed([](World&) {}));
}

// An id of a copy names the same body as in the original.
TEST(WorldValue, IdsAreValidInACopy) {
    World world;
    const BodyId ball = world.add(support::ballDef({1, 2}, 1));
    World copy = world;
    EXPECT_EQ(copy[ball].position(), (Vec2{1, 2}));
    EXPECT_EQ(copy.add(support::ballDef({}, 1)), world.add(support::ballDef({}, 1)));
}

// D9: the hash covers all that decides the future, also where nothing has moved yet.
TEST(WorldValue, TheHashCoversWhatDecidesTheFuture) {
    struct Change {
        const char* name;
        void (*apply)(World& world, BodyId ball, JointId joint);
    };
    const Change changes[] = {
        {"gravity",
         [](World& w, BodyId, JointId) {
             w.setFields({{std::make_shared<Gravity>(Vec2{0, -9})}});
         }},
        {"no field", [](World& w, BodyId, JointId) { w.setFields({}); }},
        {"settings",
         [](World& w, BodyId, JointId) {
             StepSettings settings;
             settings.soft().contactHertz = 61;
             w.setSettings(settings);
         }},
        {"features",
         [](World& w, BodyId, JointId) {
             StepSettings settings;
             settings.leaveOut = Feature::Records;
             w.setSettings(settings);
         }},
        {"region",
         [](World& w, BodyId, JointId) {
             w.setRegion(Aabb{{-9, -9}, {9, 9}});
         }},
        {"material", [](World& w, BodyId b, JointId) { w[b].setMaterial(withFriction(0, 1)); }},
        {"user data", [](World& w, BodyId b, JointId) { w[b].setUserData(7); }},
        {"joint",
         [](World& w, BodyId, JointId j) {
             auto def = std::get<DistanceJoint>(w.joint(j));
             def.length += 1;
             w.setJoint(j, def);
         }},
    };
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(support::ballDef({0, 3}, 1));
    const BodyId other = world.add(support::ballDef({4, 3}, 1));
    const JointId joint =
        world.add(DistanceJoint{.ends = {.a = ball, .b = other}, .length = 4, .hertz = 2});
    for (const Change& change : changes) {
        World changed = world;
        change.apply(changed, ball, joint);
        EXPECT_NE(changed.stateHash(), world.stateHash()) << change.name;
    }
    World sameButShape({.gravity = support::kEarth});
    World shape({.gravity = support::kEarth});
    sameButShape.add({.shape = Box{1, 2}});
    shape.add({.shape = Box{2, 1}, .rotation = Rot{}});
    EXPECT_NE(sameButShape.stateHash(), shape.stateHash());
}

} // namespace
} // namespace kodo
