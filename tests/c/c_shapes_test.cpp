// SPDX-License-Identifier: MIT
#include <array>

#include "c_world.hpp"

namespace {

using namespace c_test;

constexpr kodo_Real kHalf = kodo_Real(0.5);

/// One static body in C and one in C++ make equal Worlds, so all numbers of the shape arrived.
void expectSame(const kodo_Shape& shape, const kodo::Shape& expected) {
    const CWorld world;
    kodo_BodyDef def = bodyAt(1, 2, shape);
    def.rotation = kodo_rotation(kodo_Real(0.3));
    def.type = KODO_STATIC;
    world.add(def);
    kodo::World other = cppWorld();
    other.add({.shape = expected,
               .position = {1, 2},
               .rotation = kodo::Rot::fromAngle(kodo::Real(0.3)),
               .type = kodo::BodyType::Static});
    EXPECT_EQ(other.stateHash(), world.hash());
    EXPECT_EQ(kodo::toBytes(other), world.bytes());
}

TEST(CShapes, EachKindMakesTheBodyOfCpp) {
    kodo_Shape circle = kodo_circle(2);
    circle.circle.center = kodo_vec2(1, 3);
    expectSame(circle, kodo::Circle{2, {1, 3}});

    kodo_Shape box = kodo_box(2, 3);
    box.box.center = kodo_vec2(4, 5);
    box.box.rotation = kodo_rotation(1);
    box.box.radius = kHalf;
    expectSame(box, kodo::Box{2, 3, {4, 5}, kodo::Rot::fromAngle(kodo::Real(1)), kHalf});

    const std::array<kodo_Vec2, 3> corners{{{0, 0}, {2, 0}, {0, 3}}};
    kodo_Shape polygon = kodo_polygon(corners.data(), corners.size());
    polygon.polygon.radius = kHalf;
    expectSame(polygon, kodo::Polygon{{{0, 0}, {2, 0}, {0, 3}}, kHalf});

    expectSame(kodo_point(kodo_vec2(1, 2)), kodo::Point{{1, 2}});
    expectSame(kodo_plane(kodo_vec2(1, 0), 3), kodo::Plane{{1, 0}, 3});
    expectSame(kodo_capsule(kodo_vec2(0, 1), kodo_vec2(2, 3), kHalf),
               kodo::Capsule{{0, 1}, {2, 3}, kHalf});

    kodo_Shape segment = kodo_segment(kodo_vec2(0, 1), kodo_vec2(2, 3));
    segment.segment.oneSided = true;
    expectSame(segment, kodo::Segment{{0, 1}, {2, 3}, true, 0});
    segment.segment.oneSided = false;
    segment.segment.radius = kHalf;
    expectSame(segment, kodo::Segment{{0, 1}, {2, 3}, false, kHalf});

    const std::array<kodo_Real, 3> heights{0, 1, kHalf};
    kodo_Shape map = kodo_heightmap(2, heights.data(), heights.size());
    map.heightmap.origin = kodo_vec2(1, 2);
    expectSame(map, kodo::Heightmap{{1, 2}, 2, {0, 1, kHalf}});

    const std::array<kodo_Material, 3> ice{kodo_withFriction(0, 0), kodo_withFriction(1, kHalf),
                                           kodo_withFriction(2, 1)};
    kodo_Shape chain = kodo_chain(corners.data(), corners.size());
    chain.chain.closed = true;
    chain.chain.oneSided = true;
    chain.chain.materials = ice.data();
    chain.chain.materialCount = ice.size();
    expectSame(chain, kodo::Chain{{{0, 0}, {2, 0}, {0, 3}},
                                  true,
                                  true,
                                  {kodo::withFriction(0), kodo::withFriction(1, kHalf),
                                   kodo::withFriction(2, 1)}});

    const std::array<kodo_Shape, 3> parts{circle, box, polygon};
    expectSame(kodo_compound(parts.data(), parts.size()),
               kodo::Compound{{kodo::Circle{2, {1, 3}},
                               kodo::Box{2, 3, {4, 5}, kodo::Rot::fromAngle(kodo::Real(1)), kHalf},
                               kodo::Polygon{{{0, 0}, {2, 0}, {0, 3}}, kHalf}}});
}

/// The same parts, welded one by one as they were read, give the same body.
TEST(CShapes, APartThatIsReadMakesTheSamePart) {
    const std::array<kodo_Vec2, 3> corners{{{0, 0}, {2, 0}, {0, 3}}};
    kodo_Shape box = kodo_box(2, 3);
    box.box.rotation = kodo_rotation(1);
    kodo_Shape thick = kodo_segment(kodo_vec2(0, 1), kodo_vec2(2, 3));
    thick.segment.radius = kHalf;
    const std::array<kodo_Shape, 7> parts{kodo_circle(2),
                                          box,
                                          kodo_polygon(corners.data(), corners.size()),
                                          kodo_point(kodo_vec2(1, 2)),
                                          thick,
                                          kodo_plane(kodo_vec2(1, 0), 3),
                                          kodo_capsule(kodo_vec2(0, 1), kodo_vec2(2, 3), kHalf)};
    const CWorld world;
    kodo_BodyDef def = bodyAt(0, 0, kodo_compound(parts.data(), parts.size()));
    def.type = KODO_STATIC;
    def.density = 3;
    def.material = kodo_withFriction(2, kHalf);
    const kodo_BodyId body = world.add(def);
    ASSERT_EQ(parts.size(), world.state(body).partCount);

    def.shape = parts[0];
    const CWorld rebuilt;
    const kodo_BodyId other = rebuilt.add(def);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        kodo_Part part{};
        std::array<kodo_Vec2, 4> room{};
        EXPECT_OK(kodo_part(world, body, i, &part, room.data(), room.size()));
        EXPECT_EQ(parts[i].kind, part.shape.kind);
        EXPECT_EQ(3, part.density);
        part.hasFilter = true;
        part.filter = {KODO_SENSOR | KODO_MATCH_NONE, KODO_USER_FLAGS, -2};
        part.userData = 7;
        EXPECT_OK(kodo_setPart(world, body, i, &part));
        EXPECT_EQ(kHalf, part.material.restitution);
        std::size_t first = 0;
        EXPECT_OK(kodo_weldPart(rebuilt, other, &part, &first));
        EXPECT_EQ(i, first);
    }
    EXPECT_EQ(world.hash(), rebuilt.hash());
}

TEST(CShapes, CornersBeyondTheRoomAreCountedButNotWritten) {
    const std::array<kodo_Vec2, 3> corners{{{0, 0}, {2, 0}, {0, 3}}};
    const CWorld world;
    const kodo_BodyId body = world.add(bodyAt(0, 0, kodo_polygon(corners.data(), corners.size())));
    kodo_Part part{};
    std::array<kodo_Vec2, 3> room{{{7, 7}, {7, 7}, {7, 7}}};
    EXPECT_OK(kodo_part(world, body, 0, &part, room.data(), 2));
    EXPECT_EQ(3u, part.shape.polygon.cornerCount);
    EXPECT_EQ(2, room[1].x);
    EXPECT_EQ(7, room[2].x);
}

TEST(CShapes, DefaultsAreThoseOfCpp) {
    const CWorld world(kodo_Real(0));
    kodo_BodyDef def = kodo_bodyDef();
    world.add(def);
    kodo::World other;
    other.add(kodo::BodyDef{});
    EXPECT_EQ(other.stateHash(), world.hash());

    kodo_World* plain = nullptr;
    EXPECT_OK(kodo_createWorld(nullptr, &plain));
    EXPECT_EQ(kodo::World().stateHash(), CWorld(plain).hash());
}

TEST(CShapes, AllOtherNumbersOfADefinitionArrive) {
    const CWorld world;
    kodo_BodyDef def = bodyAt(1, 2);
    def.velocity = kodo_vec2(3, 4);
    def.angularVelocity = 5;
    def.material = {kodo_Real(0.7), kodo_Real(0.6), kodo_Real(0.5), kodo_Real(0.4),
                    kodo_Real(0.3), KODO_MULTIPLY,  KODO_MAXIMUM};
    def.density = 6;
    def.hasMass = true;
    def.mass = {7, true, {kodo_Real(0.1), kodo_Real(0.2)}, true, 8};
    def.linearDamping = kodo_Real(0.25);
    def.angularDamping = kodo_Real(0.5);
    def.gravityScale = -2;
    def.continuousMode = KODO_CONTINUOUS_STATIC;
    def.flags = KODO_MATCH_ALL | KODO_NEVER_SLEEP | 3;
    def.required = KODO_USER_FLAGS;
    def.group = -4;
    def.userData = 0x123456789abcdef0;
    const kodo_BodyId id = world.add(def);

    kodo::World other = cppWorld();
    const kodo::BodyId same = other.add(
        {.position = {1, 2},
         .velocity = {3, 4},
         .angularVelocity = 5,
         .material = {kodo_Real(0.7), kodo_Real(0.6), kodo_Real(0.5), kodo_Real(0.4),
                      kodo_Real(0.3), kodo::MixRule::Multiply, kodo::MixRule::Maximum},
         .density = 6,
         .mass = kodo::MassDef{7, kodo::Vec2{kodo_Real(0.1), kodo_Real(0.2)}, kodo::Real(8)},
         .linearDamping = kodo_Real(0.25),
         .angularDamping = kodo_Real(0.5),
         .gravityScale = -2,
         .continuousMode = kodo::ContinuousMode::Static,
         .flags = kodo::kMatchAll | kodo::kNeverSleep | 3,
         .required = kodo::kUserFlags,
         .group = -4,
         .userData = 0x123456789abcdef0});
    EXPECT_EQ(other.stateHash(), world.hash());

    const kodo_BodyState state = world.state(id);
    const kodo::BodyView view = std::as_const(other)[same];
    EXPECT_EQ(view.mass(), state.mass);
    EXPECT_EQ(view.inertia(), state.inertia);
    EXPECT_EQ(view.area(), state.area);
    EXPECT_EQ(kodo_Real(0.25), state.linearDamping);
    EXPECT_EQ(kodo_Real(0.5), state.angularDamping);
    EXPECT_EQ(-2, state.gravityScale);
    EXPECT_EQ(KODO_CONTINUOUS_STATIC, state.continuousMode);
    EXPECT_EQ(view.bounds().upper.x, state.bounds.upper.x);
    EXPECT_EQ(view.center().x, state.massFrame.position.x);
    EXPECT_EQ(view.localCenter().y, state.localCenter.y);
    EXPECT_EQ(view.velocity().y, state.velocity.y);
    EXPECT_EQ(view.flags(), state.flags);
    EXPECT_EQ(KODO_USER_FLAGS, state.required);
    EXPECT_EQ(-4, state.group);
    EXPECT_EQ(def.userData, state.userData);
    EXPECT_TRUE(state.hasSetMass);
    EXPECT_FALSE(state.isAsleep);
}

} // namespace
