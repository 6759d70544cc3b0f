// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace kodo {
namespace {

using support::ballDef;

struct Use {
    const char* name;
    std::function<void(BodyRef&)> call;
};

// Each function of BodyView and BodyRef that reads or writes the World.
std::vector<Use> uses() {
    const auto read = [](const char* name, auto function) {
        return Use{name, [function](BodyRef& body) { (void)std::invoke(function, body); }};
    };
    return {
        read("type", &BodyView::type),
        read("position", &BodyView::position),
        read("rotation", &BodyView::rotation),
        read("transform", &BodyView::transform),
        read("center", &BodyView::center),
        read("velocity", &BodyView::velocity),
        read("angularVelocity", &BodyView::angularVelocity),
        read("mass", &BodyView::mass),
        read("inertia", &BodyView::inertia),
        read("area", &BodyView::area),
        read("flags", &BodyView::flags),
        read("required", &BodyView::required),
        read("userData", &BodyView::userData),
        read("isAsleep", &BodyView::isAsleep),
        read("partCount", &BodyView::partCount),
        read("massFrame", &BodyView::massFrame),
        read("bounds", &BodyView::bounds),
        {"velocityAt", [](BodyRef& body) { (void)body.velocityAt({}); }},
        {"part", [](BodyRef& body) { (void)body.part(0); }},
        {"contains", [](BodyRef& body) { (void)body.contains({}); }},
        {"setPosition",
         [](BodyRef& body) {
             body.setPosition({1, 1});
         }},
        {"setRotation",
         [](BodyRef& body) {
             body.setRotation({0, 1});
         }},
        {"setVelocity",
         [](BodyRef& body) {
             body.setVelocity({1, 0});
         }},
        {"setAngularVelocity", [](BodyRef& body) { body.setAngularVelocity(1); }},
        {"moveTo",
         [](BodyRef& body) {
             body.moveTo({1, 1}, 1);
         }},
        {"applyForce",
         [](BodyRef& body) {
             body.applyForce({1, 0});
         }},
        {"applyForce at",
         [](BodyRef& body) {
             body.applyForce({1, 0}, {});
         }},
        {"applyTorque", [](BodyRef& body) { body.applyTorque(1); }},
        {"applyImpulse",
         [](BodyRef& body) {
             body.applyImpulse({1, 0});
         }},
        {"applyImpulse at",
         [](BodyRef& body) {
             body.applyImpulse({1, 0}, {});
         }},
        {"setType", [](BodyRef& body) { body.setType(BodyType::Kinematic); }},
        {"setFlags", [](BodyRef& body) { body.setFlags(1); }},
        {"setRequired", [](BodyRef& body) { body.setRequired(1); }},
        {"setUserData", [](BodyRef& body) { body.setUserData(1); }},
        {"setMaterial", [](BodyRef& body) { body.setMaterial(withFriction(0)); }},
    };
}

TEST(Handles, EachUseAfterRemoveThrowsAndChangesNothing) {
    for (const bool reused : {false, true}) {
        World world;
        const BodyId id = world.add(ballDef({}, 1));
        BodyRef kept = world[id];
        world.remove(id);
        if (reused) {
            ASSERT_EQ(world.add(ballDef({3, 0}, 1)).index, id.index);
        }
        const std::uint64_t before = world.stateHash();
        for (const Use& use : uses()) {
            EXPECT_THROW(use.call(kept), BadBodyId) << use.name << (reused ? ", slot reused" : "");
        }
        EXPECT_EQ(world.stateHash(), before);
    }
}

TEST(Handles, EachUseOfALivingBodyIsAllowed) {
    for (const Use& use : uses()) {
        World world;
        BodyRef body = world[world.add(ballDef({}, 1))];
        EXPECT_NO_THROW(use.call(body)) << use.name;
    }
}

TEST(Handles, AnIdOfAnotherWorldIsRefusedUnlessThatIsACopy) {
    World world;
    World other;
    const BodyId id = world.add(ballDef({}, 1));
    const BodyId foreign = other.add(ballDef({}, 1));
    ASSERT_EQ(id, foreign); // same slot, same generation
    EXPECT_TRUE(world.contains(id));
    EXPECT_FALSE(world.contains(foreign));
    EXPECT_THROW(world[foreign], BadBodyId);
    EXPECT_THROW(world.remove(foreign), BadBodyId);
    EXPECT_THROW(world.add(RevoluteJoint{.ends = {id, foreign}}), BadBodyId);
    EXPECT_THROW(world.clone(foreign, {}), BadBodyId);

    World copy = world;
    World assigned;
    assigned = world;
    World moved = std::move(other);
    World restored = fromBytes(toBytes(world));
    EXPECT_EQ(copy[id].id(), id);
    EXPECT_EQ(assigned[id].id(), id);
    EXPECT_EQ(moved[foreign].id(), foreign);
    EXPECT_EQ(restored[id].id(), id); // bytes from another process carry no mark of their World
}

// A copy that replaces a World by assignment keeps handles into it valid: rewinding in a game.
TEST(Handles, StayValidWhenTheirWorldIsRewound) {
    World world;
    BodyRef body = world[world.add(ballDef({}, 1))];
    const World before = world;
    body.setVelocity({1, 0});
    support::run(world, 1);
    const Vec2 there = body.position();
    world = before;
    EXPECT_EQ(body.position(), Vec2{});
    EXPECT_NE(there, Vec2{});
}

TEST(Handles, EmptyBracesAddTheDefaultBody) {
    World world;
    const BodyId id = world.add({});
    EXPECT_EQ(world[id].type(), BodyType::Dynamic);
    EXPECT_EQ(world[id].part(0).convex.radius, Real(0.5));
}

// Ids are keys of unordered containers. Equal ids have equal hashes, also of different Worlds.
TEST(Ids, AreKeysOfUnorderedContainers) {
    World world;
    std::unordered_map<BodyId, int> numbers;
    std::unordered_set<JointId> joints;
    std::unordered_set<std::size_t> hashes;
    const BodyId wall = world.add({.type = BodyType::Static});
    for (int i = 0; i < 1000; ++i) {
        const BodyId id = world.add(ballDef({Real(3 * i), 0}, 1));
        numbers[id] = i;
        hashes.insert(std::hash<BodyId>{}(id));
        joints.insert(world.add(RevoluteJoint{.ends = {.a = wall, .b = id}}));
        if (i % 3 == 0) {
            world.remove(id); // the slot is used again, with another generation
        }
    }
    EXPECT_EQ(numbers.size(), 1000u);
    EXPECT_EQ(joints.size(), 1000u);
    EXPECT_EQ(hashes.size(), 1000u);
    BodyId other = wall;
    other.world = wall.world + 1;
    EXPECT_EQ(std::hash<BodyId>{}(other), std::hash<BodyId>{}(wall));
}

} // namespace
} // namespace kodo
