// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <world/snapshot_scenes.hpp>

#include <algorithm>
#include <map>
#include <string>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kEpsilon;
using support::near;

// R1, R2, R4, R10: a body reads back as it was defined.
TEST(WorldBodies, ABodyIsAsItWasDefined) {
    World world;
    const BodyId id = world.add({.shape = Box{2, 4},
                                 .position = {1, 2},
                                 .rotation = {0, 1},
                                 .velocity = {3, -4},
                                 .angularVelocity = Real(0.5),
                                 .density = 3,
                                 .flags = 0x0005 | kMatchAny,
                                 .required = 0x0003,
                                 .userData = 0xfedcba9876543210u});
    const BodyView body = world[id];
    EXPECT_EQ(body.id(), id);
    EXPECT_EQ(body.position(), (Vec2{1, 2}));
    EXPECT_EQ(body.center(), (Vec2{1, 2}));
    EXPECT_EQ(body.rotation(), (Rot{0, 1}));
    EXPECT_EQ(body.velocity(), (Vec2{3, -4}));
    EXPECT_EQ(body.angularVelocity(), Real(0.5));
    EXPECT_EQ(body.mass(), 24);
    EXPECT_EQ(body.inertia(), 40); // 24 (4 + 16) / 12
    EXPECT_EQ(body.area(), 8);
    EXPECT_EQ(body.flags(), 0x0005 | kMatchAny);
    EXPECT_EQ(body.required(), 0x0003);
    EXPECT_EQ(body.userData(), 0xfedcba9876543210u);
    EXPECT_EQ(body.bounds(), (Aabb{{-1, 1}, {3, 3}}));
    EXPECT_TRUE(body.contains({Real(2.9), Real(2.9)}));
    EXPECT_FALSE(body.contains({1, Real(3.1)}));
}

// R2, [Thesis06, eq. 4.5]: the velocity of a point is v + w x r.
TEST(WorldBodies, VelocityAtAPointIncludesTheSpin) {
    World world;
    BodyDef def = ballDef({1, 1}, 1);
    def.velocity = {3, 0};
    def.angularVelocity = 2;
    EXPECT_EQ(world[world.add(def)].velocityAt({1, 2}), (Vec2{1, 0}));
}

// R1, R4: an L of two boxes has its centre of mass at (5/6, 5/6) in its frame.
TEST(WorldBodies, ACompoundRotatesAboutItsCentreOfMass) {
    World world;
    const Compound ell{{Box{2, 1, {1, Real(0.5)}}, Box{1, 1, {Real(0.5), Real(1.5)}}}};
    const BodyId id = world.add({.shape = ell, .position = {10, 20}, .angularVelocity = 1});
    EXPECT_EQ(world[id].partCount(), 2u);
    EXPECT_TRUE(near(world[id].center(), Vec2{10 + Real(5) / 6, 20 + Real(5) / 6}, 40 * kEpsilon));
    EXPECT_TRUE(near(world[id].position(), Vec2{10, 20}, 40 * kEpsilon));
    const Vec2 center = world[id].center();
    support::run(world, 60);
    EXPECT_TRUE(near(world[id].center(), center, 20 * kEpsilon));
    // The origin has rotated about the centre by 1 rad, in 60 steps, each rounded at 20 m.
    const Vec2 arm = Rot::fromAngle(1) * Vec2{Real(-5) / 6, Real(-5) / 6};
    EXPECT_TRUE(near(world[id].position(), center + arm, support::byPrecision(2e-5, 4e-14)));
    EXPECT_TRUE(
        world[id].contains(world[id].position() + Rot::fromAngle(1) * (Vec2{1, Real(0.5)})));
    EXPECT_FALSE(world[id].contains(world[id].position() +
                                    Rot::fromAngle(1) * (Vec2{Real(1.5), Real(1.5)})));
}

TEST(WorldBodies, BodiesAreListedInTheOrderOfTheirIds) {
    World world;
    std::vector<BodyId> added;
    for (int i = 0; i < 5; ++i) {
        added.push_back(world.add(ballDef({static_cast<Real>(3 * i), 0}, 1)));
    }
    world.remove(added[1]);
    world.remove(added[3]);
    EXPECT_EQ(world.bodies(), (std::vector<BodyId>{added[0], added[2], added[4]}));
    EXPECT_EQ(world.bodyCount(), 3u);
}

// R1: a clone differs from the original in id and position only, and is independent of it.
TEST(WorldBodies, ACloneDiffersInIdAndPositionOnly) {
    World world;
    BodyDef def = boxDef({0, 0}, 2, 1, withFriction(Real(0.3), Real(0.7)));
    def.rotation = Rot::fromAngle(Real(0.5));
    def.velocity = {1, 2};
    def.angularVelocity = 3;
    def.density = 5;
    def.flags = 0x10 | kMatchAny;
    def.required = 7;
    def.userData = 99;
    const BodyId original = world.add(def);
    const BodyId copy = world.clone(original, {50, 0});
    EXPECT_NE(copy, original);
    EXPECT_EQ(world[copy].position(), (Vec2{50, 0}));
    EXPECT_EQ(world[copy].rotation(), world[original].rotation());
    EXPECT_EQ(world[copy].velocity(), (Vec2{1, 2}));
    EXPECT_EQ(world[copy].angularVelocity(), 3);
    EXPECT_EQ(world[copy].mass(), world[original].mass());
    EXPECT_EQ(world[copy].flags(), 0x10 | kMatchAny);
    EXPECT_EQ(world[copy].required(), 7);
    EXPECT_EQ(world[copy].userData(), 99u);
    EXPECT_EQ(world[copy].part(0).material, withFriction(Real(0.3), Real(0.7)));
    world[copy].setUserData(100);
    EXPECT_EQ(world[copy].userData(), 100u);
    EXPECT_EQ(world[original].userData(), 99u);
    world.remove(original);
    EXPECT_EQ(world[copy].mass(), 10);
}

// R1: a stale id is refused for ever, also when its slot is reused.
TEST(WorldBodies, AStaleIdIsRefusedForEver) {
    World world;
    const BodyId stale = world.add(ballDef({}, 1));
    world.remove(stale);
    for (int i = 0; i < 1000; ++i) {
        const BodyId next = world.add(ballDef({}, 1));
        EXPECT_EQ(next.index, stale.index);
        EXPECT_FALSE(world.contains(stale));
        EXPECT_THROW(world.remove(stale), BadBodyId);
        world.remove(next);
    }
}

// R1: a slot has 2^32 generations and is retired after the last one, so no stale id becomes valid
// again. The test writes the last generation into the bytes of a snapshot.
TEST(WorldBodies, ASlotIsRetiredAfterItsLastGeneration) {
    World world;
    BodyId last = world.add(ballDef({}, 1));
    const BodyId first = last;
    for (int life = 0; life < 70000; ++life) {
        world.remove(last);
        last = world.add(ballDef({}, 1));
    }
    support::Bytes bytes = toBytes(world);
    const auto lives = [&](std::size_t at) { // lowest byte first
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            number |= std::to_integer<std::uint32_t>(bytes[at + i]) << 8 * i;
        }
        return number;
    };
    int places = 0;
    for (std::size_t at = 0; at + 4 <= bytes.size(); ++at) {
        if (lives(at) == last.generation) {
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), 4, std::byte{0xff});
            ++places;
        }
    }
    ASSERT_EQ(places, 1);
    support::seal(bytes);
    World old = fromBytes(bytes);
    const BodyId final = old.bodies().front();
    ASSERT_EQ(final.generation, 0xffffffffu);
    old.remove(final);
    const BodyId next = old.add(ballDef({}, 1));
    EXPECT_NE(next.index, final.index);
    for (const BodyId stale : {first, last, final, BodyId{first.index, 0}}) {
        EXPECT_FALSE(old.contains(stale));
        EXPECT_THROW(old[stale], BadBodyId);
    }
    old.remove(next);
    EXPECT_EQ(old.add(ballDef({}, 1)).index, next.index);
}

TEST(WorldBodies, EveryFunctionRefusesAStaleId) {
    World world;
    const BodyId alive = world.add(ballDef({}, 1));
    const BodyId dead = world.add(ballDef({5, 0}, 1));
    world.remove(dead);
    const std::uint64_t before = world.stateHash();
    for (const BodyId id : {dead, BodyId{}, BodyId{77, 1}}) {
        EXPECT_THROW(world[id], BadBodyId);
        EXPECT_THROW(std::as_const(world)[id], BadBodyId);
        EXPECT_THROW(world.remove(id), BadBodyId);
        EXPECT_THROW(world.clone(id, {}), BadBodyId);
        EXPECT_THROW(world.weld(alive, id), BadBodyId);
        EXPECT_THROW(world.weld(id, alive), BadBodyId);
    }
    EXPECT_EQ(world.stateHash(), before);
    try {
        world.remove(dead);
    } catch (const BadBodyId& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("body 1 of generation 1 is not in this World"), std::string::npos)
            << text;
    }
}

// W1: 100,000 random calls against a map as model, with steps in between.
TEST(WorldBodies, AgreesWithAModelOverRandomAddsAndRemoves) {
    constexpr std::uint64_t kSeed = 111;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    World world;
    std::map<BodyId, std::uint64_t> model;
    std::vector<BodyId> alive;
    for (std::uint64_t call = 0; call < 100000; ++call) {
        if (alive.empty() || (alive.size() < 40 && random.below(2) == 0)) {
            BodyDef def = ballDef(random.point(20), 1);
            def.userData = call;
            const BodyId id = world.add(def);
            ASSERT_TRUE(model.emplace(id, call).second) << "an id was given out twice";
            alive.push_back(id);
        } else {
            std::swap(alive[random.below(alive.size())], alive.back());
            world.remove(alive.back());
            model.erase(alive.back());
            ASSERT_FALSE(world.contains(alive.back()));
            alive.pop_back();
        }
        ASSERT_EQ(world.bodyCount(), model.size());
        if (call % 1000 == 0) {
            world.step(support::kDt);
            const std::vector<BodyId> listed = world.bodies();
            ASSERT_EQ(listed.size(), model.size());
            for (const BodyId id : listed) {
                ASSERT_EQ(world[id].userData(), model.at(id));
            }
        }
    }
}

// W1: bodies may be added and removed while the collisions of a step are read.
TEST(WorldBodies, MayBeAddedAndRemovedWhileCollisionsAreRead) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 5, 40);
    int changes = 0;
    for (int step = 0; step < 300; ++step) {
        world.step(support::kDt);
        for (const CollisionRecord& hit : world.collisions()) {
            for (const BodyId id : {hit.a, hit.b}) {
                if (world.contains(id) && world[id].type() == BodyType::Dynamic && changes < 30 &&
                    hit.maxImpulse > Real(0.5)) {
                    const Vec2 place = world[id].position() + Vec2{0, 5};
                    world.remove(id);
                    world.add(ballDef(place, Real(0.3)));
                    ++changes;
                }
            }
        }
    }
    EXPECT_EQ(changes, 30);
    EXPECT_EQ(world.bodyCount(), 43u);
}

} // namespace
} // namespace kodo
