// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// A call fails and names the pointer that is null.
void refused(const char* name, kodo_Status status) {
    EXPECT_EQ(KODO_WRONG_USE, status) << name;
    EXPECT_EQ(std::string(name) + ": must not be null", kodo_errorText());
}

/// A World with one body.
class CNull : public testing::Test {
protected:
    ~CNull() override {
        std::size_t bodies = 0;
        EXPECT_OK(kodo_bodyCount(world_, &bodies));
        EXPECT_EQ(1u, bodies); // nothing was added or removed
    }

    CWorld handle_;
    kodo_World* world_ = handle_;
    kodo_BodyId id_ = handle_.add(bodyAt(0, 0));
    std::size_t count_ = 0;
};

TEST_F(CNull, CallsOfAWorldRefuseNullPointers) {
    const kodo_SnapshotDef snapshot = kodo_snapshotDef();
    const std::array<kodo_World*, 2> worlds{world_, nullptr};
    kodo_World* made = nullptr;
    kodo_Aabb box{};
    refused("world", kodo_createWorld(nullptr, nullptr));
    refused("from", kodo_copyWorld(nullptr, &made));
    refused("world", kodo_copyWorld(world_, nullptr));
    refused("into", kodo_assignWorld(nullptr, world_));
    refused("from", kodo_assignWorld(world_, nullptr));
    refused("world", kodo_destroyWorld(nullptr));
    refused("settings", kodo_worldSettings(world_, nullptr));
    refused("settings", kodo_setSettings(world_, nullptr));
    refused("set", kodo_region(world_, &box, nullptr));
    refused("world", kodo_step(nullptr, kDt, nullptr));
    refused("worlds", kodo_stepWorlds(nullptr, 1, kDt, nullptr));
    refused("worlds[1]", kodo_stepWorlds(worlds.data(), 2, kDt, nullptr));
    refused("pool", kodo_createThreadPool(1, nullptr));
    refused("pool", kodo_destroyThreadPool(nullptr));
    refused("count", kodo_stepCount(world_, nullptr));
    refused("stats", kodo_stepStats(world_, nullptr));
    refused("hash", kodo_stateHash(world_, nullptr));
    refused("count", kodo_collisions(world_, nullptr, 0, nullptr));
    refused("count", kodo_toBytes(world_, nullptr, 0, nullptr));
    refused("bytes", kodo_toBytes(world_, nullptr, 1, &count_));
    refused("world", kodo_fromBytes(&snapshot, nullptr));
}

TEST_F(CNull, CallsOfABodyRefuseNullPointers) {
    const kodo_BodyDef body = kodo_bodyDef();
    kodo_BodyId added{};
    refused("kodo_BodyDef", kodo_initBodyDef(nullptr, body.head));
    refused("def", kodo_addBody(world_, nullptr, &added));
    refused("id", kodo_addBody(world_, &body, nullptr));
    refused("clone", kodo_cloneBody(world_, id_, {}, nullptr));
    refused("contained", kodo_containsBody(world_, id_, nullptr));
    refused("count", kodo_bodyCount(world_, nullptr));
    refused("count", kodo_bodies(world_, nullptr, 0, nullptr));
    refused("items", kodo_bodies(world_, nullptr, 1, &count_));
    refused("count", kodo_movedBodies(world_, nullptr, 0, nullptr));
    refused("asleep", kodo_sleep(world_, id_, nullptr));
    refused("state", kodo_bodyState(world_, id_, nullptr));
    refused("velocity", kodo_velocityAt(world_, id_, {}, nullptr));
    refused("contained", kodo_containsPoint(world_, id_, {}, nullptr));
    refused("part", kodo_part(world_, id_, 0, nullptr, nullptr, 0));
    refused("world", kodo_applyForce(nullptr, id_, {}));
    refused("material", kodo_setMaterial(world_, id_, nullptr));
    refused("mass", kodo_setMass(world_, id_, nullptr));
    refused("from", kodo_copyBodyFrom(world_, id_, nullptr, id_));
    refused("first", kodo_weld(world_, id_, id_, nullptr));
    refused("part", kodo_weldPart(world_, id_, nullptr, &count_));
    refused("id", kodo_unweld(world_, id_, 0, nullptr, nullptr));
}

TEST_F(CNull, CallsOfManyBodiesRefuseNullPointers) {
    kodo_World* none = nullptr;
    kodo_Transform pose{};
    kodo_Velocity velocity{};
    refused("poses", kodo_poses(&world_, 1, &id_, 1, nullptr));
    refused("ids", kodo_poses(&world_, 1, nullptr, 1, &pose));
    refused("worlds", kodo_poses(nullptr, 1, &id_, 1, &pose));
    refused("worlds", kodo_velocities(&none, 1, &id_, 1, &velocity));
    refused("loads", kodo_applyLoads(&world_, 1, &id_, 1, nullptr));
    refused("velocities", kodo_setVelocities(&world_, 1, &id_, 1, nullptr));
}

TEST_F(CNull, CallsOfJointsFieldsAndQueriesRefuseNullPointers) {
    const kodo_JointDef joint = kodo_jointDef(KODO_FIXED_JOINT);
    const kodo_Field own = kodo_field(KODO_OWN_FIELD);
    const kodo_Shape shape = kodo_circle(1);
    const kodo_PlacedShape placed{&shape, {{0, 0}, {1, 0}}};
    const kodo_PlacedShape shapeless{nullptr, {{0, 0}, {1, 0}}};
    const kodo_NearShape near{&shape, {{0, 0}, {1, 0}}, 1};
    const kodo_Ray ray{{0, 0}, {1, 0}};
    refused("id", kodo_addJoint(world_, &joint, nullptr));
    refused("count", kodo_joints(world_, nullptr, 0, nullptr));
    refused("field", kodo_addField(world_, nullptr));
    refused("field.own.at", kodo_addField(world_, &own));
    refused("fields", kodo_setFields(world_, nullptr, 1));
    refused("hit", kodo_rayCast(world_, ray, nullptr, nullptr));
    refused("visit", kodo_visitRay(world_, ray, nullptr, nullptr, nullptr));
    refused("shape", kodo_shapeCast(world_, nullptr, {1, 0}, nullptr, nullptr));
    refused("shape.shape", kodo_overlapShape(world_, &shapeless, nullptr, nullptr, 0, &count_));
    refused("visit", kodo_visitOverlaps(world_, &placed, nullptr, nullptr, nullptr));
    refused("closest", kodo_closestPoint(world_, {}, 1, nullptr, nullptr));
    refused("closest", kodo_closestPointOf(world_, id_, {}, nullptr));
    refused("points", kodo_distance(world_, id_, id_, nullptr));
    refused("def", kodo_castShape(world_, nullptr, nullptr, nullptr));
    refused("count", kodo_raySpans(world_, ray, nullptr, nullptr, 0, nullptr));
    refused("count", kodo_collide(world_, &near, nullptr, nullptr, 0, nullptr));
    refused("count", kodo_touching(world_, id_, nullptr, 0, nullptr));
}

TEST_F(CNull, ArraysOfShapesAreRefusedAsNull) {
    kodo_BodyId id{};
    const std::array<std::pair<kodo_Shape, const char*>, 4> shapes{{
        {kodo_polygon(nullptr, 3), "shape.polygon.corners: must not be null"},
        {kodo_compound(nullptr, 1), "shape.compound.parts: must not be null"},
        {kodo_heightmap(1, nullptr, 2), "shape.heightmap.heights: must not be null"},
        {kodo_chain(nullptr, 2), "shape.chain.points: must not be null"},
    }};
    for (const auto& [shape, sentence] : shapes) {
        const kodo_BodyDef def = bodyAt(0, 0, shape);
        EXPECT_EQ(KODO_WRONG_USE, kodo_addBody(world_, &def, &id));
        EXPECT_STREQ(sentence, kodo_errorText());
    }
}

} // namespace
