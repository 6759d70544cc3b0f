// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <span>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// A pyramid on a plane and a disc that falls on it, the same in both languages.
struct Scene {
    CWorld world;
    kodo::World other = cppWorld();
    std::vector<kodo_BodyId> ids;

    Scene() {
        world.add(groundDef());
        other.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
        for (int row = 0; row < 5; ++row) {
            for (int i = 0; i < 5 - row; ++i) {
                const auto x = kodo_Real(i) - kodo_Real(0.5) * kodo_Real(4 - row);
                const auto y = kodo_Real(0.5) + kodo_Real(row);
                ids.push_back(world.add(bodyAt(x, y, kodo_box(kodo_Real(0.9), 1))));
                other.add({.shape = kodo::Box{kodo::Real(0.9), 1}, .position = {x, y}});
            }
        }
        kodo_BodyDef ball = bodyAt(-6, 2);
        ball.velocity = kodo_vec2(20, 0);
        ids.push_back(world.add(ball));
        other.add({.position = {-6, 2}, .velocity = {20, 0}});
    }
    void step(int count) {
        world.step(count);
        for (int i = 0; i < count; ++i) {
            other.step(kDt);
        }
    }
};

TEST(CWorlds, TheSameSceneHasTheBitsOfCpp) {
    Scene scene;
    for (int i = 0; i < 10; ++i) {
        scene.step(12);
        ASSERT_EQ(scene.other.stateHash(), scene.world.hash()) << i;
    }
    EXPECT_EQ(kodo::toBytes(scene.other), scene.world.bytes());
}

TEST(CWorlds, EachProfileIsThatOfCpp) {
    const std::array<std::pair<kodo_Profile, kodo::StepSettings>, 4> profiles{{
        {KODO_FAST, kodo::fast()},
        {KODO_BALANCED, kodo::balanced()},
        {KODO_ACCURATE, kodo::accurate()},
        {KODO_THESIS_2006, kodo::thesis2006()},
    }};
    for (auto [profile, expected] : profiles) {
        Scene scene;
        kodo_Settings settings = kodo_settings(profile);
        settings.sleepSteps = 7;
        settings.leaveOut = KODO_FRICTION | KODO_ROTATION | KODO_COLLISION;
        EXPECT_OK(kodo_setSettings(scene.world, &settings));
        expected.sleepSteps = 7;
        expected.leaveOut =
            kodo::Feature::Friction | kodo::Feature::Rotation | kodo::Feature::Collision;
        scene.other.setSettings(expected);
        EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
        kodo_Settings read{};
        EXPECT_OK(kodo_worldSettings(scene.world, &read));
        EXPECT_OK(kodo_setSettings(scene.world, &read));
        EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
    }
}

TEST(CWorlds, ACopyContinuesAlikeAndAnAssignedWorldGoesBack) {
    Scene scene;
    scene.step(20);
    const CWorld copy(scene.world);
    const std::uint64_t before = scene.world.hash();
    scene.world.step(20);
    EXPECT_NE(before, scene.world.hash());
    copy.step(20);
    EXPECT_EQ(scene.world.hash(), copy.hash());
    const CWorld earlier(scene.world);
    scene.world.step();
    EXPECT_OK(kodo_assignWorld(scene.world, earlier));
    EXPECT_EQ(earlier.hash(), scene.world.hash());
}

TEST(CWorlds, SnapshotsContinueInTheOtherLanguage) {
    Scene scene;
    scene.step(20);
    const std::vector<std::byte> bytes = scene.world.bytes();
    kodo::World fromC = kodo::fromBytes(bytes);
    const std::vector<std::byte> cppBytes = kodo::toBytes(scene.other);
    kodo_SnapshotDef def = kodo_snapshotDef();
    def.bytes = cppBytes.data();
    def.byteCount = cppBytes.size();
    kodo_World* made = nullptr;
    ASSERT_EQ(KODO_OK, kodo_fromBytes(&def, &made)) << kodo_errorText();
    const CWorld fromCpp(made);
    EXPECT_EQ(fromC.stateHash(), fromCpp.hash());
    scene.step(20);
    fromCpp.step(20);
    for (int i = 0; i < 20; ++i) {
        fromC.step(kDt);
    }
    EXPECT_EQ(scene.world.hash(), fromCpp.hash());
    EXPECT_EQ(scene.world.hash(), fromC.stateHash());
}

TEST(CWorlds, ASnapshotTakesFieldsOfTheUser) {
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    field.own.at = [](void*, const kodo_FieldBody* body, kodo_Real, kodo_FieldForce* force) {
        force->force.x = body->mass;
    };
    const CWorld world;
    world.add(bodyAt(0, 0));
    EXPECT_OK(kodo_addField(world, &field));
    world.step();
    const std::vector<std::byte> bytes = world.bytes();
    kodo_SnapshotDef def = kodo_snapshotDef();
    def.bytes = bytes.data();
    def.byteCount = bytes.size();
    kodo_World* made = nullptr;
    EXPECT_EQ(KODO_BAD_SNAPSHOT, kodo_fromBytes(&def, &made)); // without its field
    def.ownFields = &field;
    def.ownFieldCount = 1;
    ASSERT_EQ(KODO_OK, kodo_fromBytes(&def, &made)) << kodo_errorText();
    const CWorld again(made);
    world.step(10);
    again.step(10);
    EXPECT_EQ(world.hash(), again.hash());
}

TEST(CWorlds, RecordsAreThoseOfCpp) {
    Scene scene;
    scene.step(17); // the disc has struck
    const auto expectSame = [&](auto&& list, std::size_t size,
                                std::span<const kodo::CollisionRecord> expected) {
        std::vector<kodo_CollisionRecord> records(size);
        std::size_t count = 0;
        EXPECT_OK(list(records.data(), records.size(), &count));
        ASSERT_EQ(expected.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(expected[i].a.index, records[i].a.index);
            EXPECT_EQ(expected[i].b.index, records[i].b.index);
            EXPECT_EQ(static_cast<int>(expected[i].phase), records[i].phase);
            EXPECT_EQ(expected[i].pointCount, records[i].pointCount);
            EXPECT_EQ(expected[i].points[1].position.x, records[i].points[1].position.x);
            EXPECT_EQ(expected[i].normal.y, records[i].normal.y);
            EXPECT_EQ(expected[i].approachSpeed, records[i].approachSpeed);
            EXPECT_EQ(expected[i].totalImpulse, records[i].totalImpulse);
        }
    };
    const auto of = [&](auto function) {
        return [&scene, function](kodo_CollisionRecord* records, std::size_t room,
                                  std::size_t* count) {
            return function(scene.world, records, room, count);
        };
    };
    ASSERT_FALSE(scene.other.collisions().empty());
    expectSame(of(&kodo_collisions), 99, scene.other.collisions());
    expectSame(of(&kodo_begunCollisions), 99, scene.other.begunCollisions());
    expectSame(of(&kodo_endedCollisions), 99, scene.other.endedCollisions());
    const kodo_BodyId ball = scene.ids.back();
    expectSame(
        [&](kodo_CollisionRecord* records, std::size_t room, std::size_t* count) {
            return kodo_collisionsOf(scene.world, ball, records, room, count);
        },
        99, scene.other.collisions(kodo::BodyId{ball.index, ball.generation, 0}));
    expectSame(
        [&](kodo_CollisionRecord* records, std::size_t room, std::size_t* count) {
            return kodo_hits(scene.world, kodo_Real(0.5), records, room, count);
        },
        99, scene.other.hits(kodo::Real(0.5)));
}

TEST(CWorlds, AListWithoutRoomIsCountedAlone) {
    const Scene scene;
    std::size_t count = 0;
    EXPECT_OK(kodo_bodies(scene.world, nullptr, 0, &count));
    EXPECT_EQ(17u, count);
    std::array<kodo_BodyId, 3> ids{};
    EXPECT_OK(kodo_bodies(scene.world, ids.data(), 2, &count));
    EXPECT_EQ(17u, count);
    EXPECT_EQ(1u, ids[1].index);
    EXPECT_EQ(0u, ids[2].generation);
}

TEST(CWorlds, RegionAndCountersAreThoseOfCpp) {
    Scene scene;
    const kodo_Aabb box{{-1, -1}, {1, 1}};
    EXPECT_OK(kodo_setRegion(scene.world, &box));
    scene.other.setRegion(kodo::Aabb{{-1, -1}, {1, 1}});
    scene.step(3);
    EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
    kodo_Aabb read{};
    bool set = false;
    EXPECT_OK(kodo_region(scene.world, &read, &set));
    EXPECT_TRUE(set);
    EXPECT_EQ(1, read.upper.y);
    kodo_StepStats stats{};
    EXPECT_OK(kodo_stepStats(scene.world, &stats));
    const kodo::StepStats expected = kodo::stepStats(scene.other);
    EXPECT_EQ(expected.bodies, stats.bodies);
    EXPECT_EQ(expected.contacts, stats.contacts);
    EXPECT_EQ(expected.mostParts, stats.mostParts);
    EXPECT_EQ(expected.pairs, stats.pairs);
    EXPECT_EQ(expected.continuousPairs, stats.continuousPairs);
    EXPECT_EQ(expected.continuousStops, stats.continuousStops);
    EXPECT_EQ(expected.refinedBodies, stats.refinedBodies);
    EXPECT_EQ(expected.pairWork, stats.pairWork);
    std::uint64_t steps = 0;
    EXPECT_OK(kodo_stepCount(scene.world, &steps));
    EXPECT_EQ(3u, steps);
    EXPECT_OK(kodo_setRegion(scene.world, nullptr));
    EXPECT_OK(kodo_region(scene.world, &read, &set));
    EXPECT_FALSE(set);
}

TEST(CWorlds, ABodyThatIsPushedBeyondBoundsIsFrozen) {
    const CWorld world;
    const kodo_BodyId ball = world.add(bodyAt(0, 0));
    EXPECT_OK(kodo_applyForce(world, ball, kodo_vec2(kodo_Real(1e12), 0)));
    world.step();
    kodo_BodyId frozen{};
    std::size_t count = 0;
    EXPECT_OK(kodo_frozenBodies(world, &frozen, 1, &count));
    EXPECT_EQ(1u, count);
    EXPECT_TRUE(kodo_sameBody(ball, frozen));
}

/// Each setter does in C what it does in C++.
TEST(CWorlds, SettersAreThoseOfCpp) {
    Scene scene;
    kodo::World& other = scene.other;
    const kodo_BodyId id = scene.ids[3];
    const kodo::BodyId same{id.index, id.generation, 0};
    const kodo_BodyId second = scene.ids[5];
    const kodo::BodyId otherSecond{second.index, second.generation, 0};
    kodo_World* world = scene.world;
    const kodo_Material slick = kodo_withFriction(0, kodo_Real(0.5));
    const kodo_MassDef mass{3, false, {}, true, 2};
    const kodo_Rot turn = kodo_rotation(kodo_Real(0.25));
    const kodo::Rot otherTurn = kodo::Rot::fromAngle(kodo::Real(0.25));
    const auto compare = [&](const char* name, kodo_Status status) {
        EXPECT_EQ(KODO_OK, status) << name << ": " << kodo_errorText();
        EXPECT_EQ(other.stateHash(), scene.world.hash()) << name;
    };
    other[same].setPosition({1, 9});
    compare("setPosition", kodo_setPosition(world, id, kodo_vec2(1, 9)));
    other[same].setRotation(otherTurn);
    compare("setRotation", kodo_setRotation(world, id, turn));
    other[same].setVelocity({1, 2});
    compare("setVelocity", kodo_setVelocity(world, id, kodo_vec2(1, 2)));
    other[same].setAngularVelocity(3);
    compare("setAngularVelocity", kodo_setAngularVelocity(world, id, 3));
    other[same].moveTo({1, 8}, kDt);
    compare("moveTo", kodo_moveTo(world, id, kodo_vec2(1, 8), kDt));
    other[same].moveTo({1, 8}, otherTurn, kDt);
    compare("moveToPose", kodo_moveToPose(world, id, {{1, 8}, turn}, kDt));
    other[same].applyImpulse({1, 2});
    compare("applyImpulse", kodo_applyImpulse(world, id, kodo_vec2(1, 2)));
    other[same].applyImpulse({1, 2}, {3, 4});
    compare("applyImpulseAt", kodo_applyImpulseAt(world, id, kodo_vec2(1, 2), kodo_vec2(3, 4)));
    other[same].applyAngularImpulse(2);
    compare("applyAngularImpulse", kodo_applyAngularImpulse(world, id, 2));
    other[same].setLinearDamping(kodo::Real(0.5));
    compare("setLinearDamping", kodo_setLinearDamping(world, id, kodo_Real(0.5)));
    other[same].setAngularDamping(kodo::Real(0.25));
    compare("setAngularDamping", kodo_setAngularDamping(world, id, kodo_Real(0.25)));
    other[same].setGravityScale(-1);
    compare("setGravityScale", kodo_setGravityScale(world, id, -1));
    other[same].setContinuousMode(kodo::ContinuousMode::Never);
    compare("setContinuousMode", kodo_setContinuousMode(world, id, KODO_CONTINUOUS_NEVER));
    other[same].setFlags(5 | kodo::kMatchAny);
    compare("setFlags", kodo_setFlags(world, id, 5 | KODO_MATCH_ANY));
    other[same].setGroup(-5);
    compare("setGroup", kodo_setGroup(world, id, -5));
    other[same].setRequired(6);
    compare("setRequired", kodo_setRequired(world, id, 6));
    other[same].setUserData(7);
    compare("setUserData", kodo_setUserData(world, id, 7));
    other[same].setMaterial(kodo::withFriction(0, kodo::Real(0.5)));
    compare("setMaterial", kodo_setMaterial(world, id, &slick));
    other[same].setMass({3, std::nullopt, kodo::Real(2)});
    compare("setMass", kodo_setMass(world, id, &mass));
    other[otherSecond].copyFrom(std::as_const(other)[same]);
    compare("copyBodyFrom", kodo_copyBodyFrom(world, second, world, id));
    other[same].setMassFromDensity();
    compare("setMassFromDensity", kodo_setMassFromDensity(world, id));
    other[same].applyForce({1, 2});
    other[same].applyForce({3, 4}, {5, 6});
    other[same].applyTorque(7);
    EXPECT_OK(kodo_applyForce(world, id, kodo_vec2(1, 2)));
    EXPECT_OK(kodo_applyForceAt(world, id, kodo_vec2(3, 4), kodo_vec2(5, 6)));
    compare("applyTorque", kodo_applyTorque(world, id, 7));
    scene.step(1);
    compare("step", KODO_OK);
    other[same].setType(kodo::BodyType::Kinematic);
    compare("setType", kodo_setType(world, id, KODO_KINEMATIC));
    other[same].wake();
    compare("wake", kodo_wake(world, id));
    kodo_BodyId clone{};
    other.clone(same, {9, 9});
    compare("cloneBody", kodo_cloneBody(world, id, kodo_vec2(9, 9), &clone));
    other.remove(otherSecond);
    compare("removeBody", kodo_removeBody(world, second));
}

TEST(CWorlds, SleepAndMovedBodiesAreThoseOfCpp) {
    Scene scene;
    scene.step(2);
    const kodo_BodyId id = scene.ids[3];
    const kodo::BodyId same{id.index, id.generation, 0};
    bool asleep = false;
    EXPECT_TRUE(scene.other[same].sleep());
    EXPECT_OK(kodo_sleep(scene.world, id, &asleep));
    EXPECT_TRUE(asleep);
    EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
    std::vector<kodo_BodyId> moved(scene.ids.size());
    std::size_t count = 0;
    EXPECT_OK(kodo_movedBodies(scene.world, moved.data(), moved.size(), &count));
    EXPECT_GT(count, 1u);
    EXPECT_EQ(scene.other.movedBodies().size(), count);
}

TEST(CWorlds, WeldAndUnweldAreThoseOfCpp) {
    Scene scene;
    const kodo_BodyId a = scene.ids[0];
    const kodo_BodyId b = scene.ids[1];
    std::size_t first = 0;
    EXPECT_OK(kodo_weld(scene.world, a, b, &first));
    EXPECT_EQ(1u, first);
    const kodo::BodyId otherA{a.index, a.generation, 0};
    scene.other.weld(otherA, {b.index, b.generation, 0});
    EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
    const kodo_Flags flags = KODO_NEVER_SLEEP;
    kodo_BodyId part{};
    EXPECT_OK(kodo_unweld(scene.world, a, 1, &flags, &part));
    scene.other.unweld(otherA, 1, kodo::kNeverSleep);
    scene.step(10);
    EXPECT_EQ(scene.other.stateHash(), scene.world.hash());
    EXPECT_EQ(flags, scene.world.state(part).flags & flags);
}

TEST(CWorlds, PosesAndVelocitiesOfManyBodiesAreThoseOfEach) {
    Scene scene;
    scene.step(20);
    const CWorld copy(scene.world);
    copy.step(7);
    const std::array<kodo_World*, 2> worlds{scene.world, copy};
    const std::size_t n = scene.ids.size();
    std::vector<kodo_Transform> poses(2 * n);
    std::vector<kodo_Velocity> velocities(2 * n);
    EXPECT_OK(kodo_poses(worlds.data(), 2, scene.ids.data(), n, poses.data()));
    EXPECT_OK(kodo_velocities(worlds.data(), 2, scene.ids.data(), n, velocities.data()));
    for (std::size_t i = 0; i < n; ++i) {
        const kodo_BodyState one = scene.world.state(scene.ids[i]);
        const kodo_BodyState two = copy.state(scene.ids[i]);
        EXPECT_EQ(one.transform.position.y, poses[i].position.y);
        EXPECT_EQ(two.transform.rotation.s, poses[n + i].rotation.s);
        EXPECT_EQ(one.velocity.x, velocities[i].linear.x);
        EXPECT_EQ(two.angularVelocity, velocities[n + i].angular);
    }
    EXPECT_OK(kodo_setVelocities(worlds.data(), 1, scene.ids.data(), n, velocities.data() + n));
    EXPECT_EQ(copy.state(scene.ids[2]).velocity.x, scene.world.state(scene.ids[2]).velocity.x);
    std::vector<kodo_Load> loads(2 * n, kodo_Load{{3, 4}, 5});
    EXPECT_OK(kodo_applyLoads(worlds.data(), 2, scene.ids.data(), n, loads.data()));
    const CWorld single(copy);
    scene.step(1);
    copy.step();
    single.step(); // a copy has the forces too
    EXPECT_EQ(copy.hash(), single.hash());
}

} // namespace
