// SPDX-License-Identifier: MIT
// Where the parts and joints of a World are drawn, from their triangles alone: needs no display.
#include <kodo/kodo.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kodo_sfml {
namespace {

using kodo::Vec2;

// One metre is 10 pixels; the origin is in the middle.
const Camera kCamera({{-20, -20}, {20, 20}}, {400, 400});

/// Largest opacity, 0..255, of the triangles that cover a pixel.
int opacityAtPixel(const Painter& painter, Pixel pixel) {
    const auto vertices = painter.vertices();
    int most = 0;
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const auto side = [&](std::size_t from, std::size_t to) {
            const Pixel edge = vertices[i + to].place - vertices[i + from].place;
            const Pixel way = pixel - vertices[i + from].place;
            return edge.x * way.y - edge.y * way.x;
        };
        const float a = side(0, 1);
        const float b = side(1, 2);
        const float c = side(2, 0);
        const bool covers = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
        for (std::size_t k = 0; covers && a + b + c != 0 && k < 3; ++k) {
            most = std::max(most, static_cast<int>(vertices[i + k].color.a));
        }
    }
    return most;
}

bool isDrawn(const kodo::World& world, Vec2 place, WorldLook look = {}) {
    Painter painter;
    paintWorld(painter, kCamera, world, look);
    return opacityAtPixel(painter, kCamera.toPixels(place)) > 0;
}

/// A body of each kind of shape, turned by a quarter of a turn, with points that it covers and
/// points that it does not. A kind that is left out does not compile.
struct ShapeCase {
    std::string name;
    kodo::Shape shape;
    std::vector<Vec2> covered; // m, in the frame of the shape
    std::vector<Vec2> bare;
};

ShapeCase caseOf(const kodo::Circle& circle) {
    return {"circle", circle, {{0, 0}, {1.9f, 0}, {0, -1.9f}}, {{2.3f, 0}, {1.7f, 1.7f}}};
}
ShapeCase caseOf(const kodo::Box& box) {
    return {"box", box, {{0, 0}, {2.9f, 0.9f}, {-2.9f, -0.9f}}, {{0, 1.4f}, {3.4f, 0}}};
}
ShapeCase caseOf(const kodo::Polygon& polygon) {
    return {"polygon", polygon, {{1, 1}, {3.5f, 0.2f}}, {{3, 3}, {-0.5f, 2}}};
}
ShapeCase caseOf(const kodo::Compound& compound) {
    return {"compound", compound, {{-3, 0}, {3, 0}}, {{0, 2}, {5, 0}}};
}
ShapeCase caseOf(const kodo::Point& point) {
    return {"point", point, {{1, 2}}, {{2, 2}, {1, 3}}};
}
ShapeCase caseOf(const kodo::Segment& segment) {
    return {
        "segment", segment, {{-4, 1}, {0, 1}, {4, 1}, {0, 1.5f}}, {{0, 0.5f}, {5, 1}, {2, 1.5f}}};
}
ShapeCase caseOf(const kodo::Plane& plane) {
    return {"plane", plane, {{0, -0.1f}, {15, -0.1f}, {-15, -12}}, {{0, 0.5f}, {15, 0.5f}}};
}
ShapeCase caseOf(const kodo::Heightmap& map) {
    return {"heightmap", map, {{-4, 0}, {-2, 1}, {2, 1}}, {{-2, 0}, {0, 3}}};
}
ShapeCase caseOf(const kodo::Chain& chain) {
    return {"chain", chain, {{-2, 1}, {2, 1}}, {{0, 0}, {0, 3}}};
}
ShapeCase caseOf(const kodo::Capsule& capsule) {
    return {"capsule", capsule, {{0, 0.9f}, {3.8f, 0}, {-3.8f, 0}}, {{0, 1.3f}, {3.9f, 0.9f}}};
}

std::vector<ShapeCase> shapeCases() {
    const kodo::Compound pair{{kodo::Box{2, 2, {-3, 0}}, kodo::Circle{1, {3, 0}}}};
    const std::vector<kodo::Shape> shapes = {
        kodo::Circle{2},
        kodo::Box{6, 2},
        kodo::Polygon{{{0, 0}, {4, 0}, {0, 4}}},
        pair,
        kodo::Point{{1, 2}},
        kodo::Segment{.from = {-4, 1}, .to = {4, 1}, .oneSided = true},
        kodo::Plane{},
        kodo::Heightmap{.origin = {-4, 0}, .spacing = 4, .heights = {0, 2, 0}},
        kodo::Chain{.points = {{-4, 0}, {0, 2}, {4, 0}}},
        kodo::Capsule{{-3, 0}, {3, 0}, 1}};
    static_assert(std::variant_size_v<kodo::Shape> == 10, "a kind of shape is left out");
    std::vector<ShapeCase> cases;
    for (const kodo::Shape& shape : shapes) {
        cases.push_back(std::visit([](const auto& each) { return caseOf(each); }, shape));
        EXPECT_EQ(cases.size() - 1, shape.index());
    }
    return cases;
}

TEST(WorldPainter, EveryShapeIsDrawnWhereItIsAndNowhereElse) {
    for (const ShapeCase& each : shapeCases()) {
        kodo::World world;
        const kodo::BodyId body = world.add({.shape = each.shape,
                                             .position = {1, -2},
                                             .rotation = kodo::Rot::fromAngle(0.5f),
                                             .type = kodo::BodyType::Static});
        for (const Vec2 point : each.covered) {
            EXPECT_TRUE(isDrawn(world, world[body].transform() * point))
                << each.name << " at " << point.x << ", " << point.y;
        }
        for (const Vec2 point : each.bare) {
            EXPECT_FALSE(isDrawn(world, world[body].transform() * point))
                << each.name << " at " << point.x << ", " << point.y;
        }
        EXPECT_FALSE(isDrawn(world, world[body].transform() * each.covered[0], {.shapes = false}));
    }
}

TEST(WorldPainter, APlaneFillsThePictureFromAnyDistance) {
    kodo::World world;
    world.add(
        {.shape = kodo::Plane{.normal = {0, 1}, .offset = 5000}, .type = kodo::BodyType::Static});
    EXPECT_TRUE(isDrawn(world, {-19, 19}));
    EXPECT_TRUE(isDrawn(world, {19, -19}));
}

/// Two small discs at (-5, 0) and (5, 0) with a joint, and points that its picture covers.
struct JointCase {
    std::string name;
    kodo::JointDef joint;
    std::vector<Vec2> covered; // m
};

const kodo::JointEnds kMiddle{.anchorA = {5, 0}, .anchorB = {-5, 0}};

JointCase caseOf(kodo::RevoluteJoint joint) {
    joint.ends = kMiddle;
    return {"revolute", joint, {{-2, 0}, {2, 0}, {0, 0.5f}, {0.5f, 0}}};
}
JointCase caseOf(kodo::FixedJoint joint) {
    joint.ends = kMiddle;
    return {"fixed", joint, {{-2, 0}, {2, 0}, {0.5f, 0.3f}, {-0.3f, -0.5f}}};
}
JointCase caseOf(kodo::DistanceJoint joint) {
    joint.limits = kodo::Range{0, 10};
    return {"rope", joint, {{-2, 0}, {0, 0}, {2, 0}}};
}
JointCase caseOf(kodo::PrismaticJoint joint) {
    joint.ends = kMiddle;
    joint.limits = kodo::Range{-3, 3};
    return {"prismatic", joint, {{-3, 0.5f}, {3, -0.5f}, {1, 0}, {0, 0}}};
}
JointCase caseOf(kodo::MotorJoint joint) {
    joint.force = 1;
    return {"motor", joint, {{0, 0}, {-4.2f, 0.4f}, {-4.2f, -0.4f}}};
}
JointCase caseOf(kodo::MouseJoint joint) {
    joint.target = {5, 5};
    joint.force = 1;
    return {"mouse", joint, {{5, 2}, {5.3f, 5.3f}, {4.7f, 5.3f}}};
}

/// A joint of each kind; a kind without a case does not compile.
template <std::size_t... I>
std::vector<JointCase> jointCases(std::index_sequence<I...>) {
    return {caseOf(std::variant_alternative_t<I, kodo::JointDef>{})...};
}

void connect(kodo::JointDef& joint, kodo::BodyId a, kodo::BodyId b) {
    std::visit(
        [&](auto& each) {
            if constexpr (requires { each.ends; }) {
                each.ends.a = a;
                each.ends.b = b;
            } else {
                each.body = b;
            }
        },
        joint);
}

TEST(WorldPainter, EveryJointIsDrawnFromAnchorToAnchor) {
    constexpr auto kKinds = std::make_index_sequence<std::variant_size_v<kodo::JointDef>>{};
    for (JointCase& each : jointCases(kKinds)) {
        kodo::World world;
        const kodo::BodyId a = world.add({.shape = kodo::Circle{0.1f}, .position = {-5, 0}});
        const kodo::BodyId b = world.add({.shape = kodo::Circle{0.1f}, .position = {5, 0}});
        connect(each.joint, a, b);
        world.add(each.joint);
        for (const Vec2 place : each.covered) {
            EXPECT_TRUE(isDrawn(world, place)) << each.name << " at " << place.x << ", " << place.y;
            EXPECT_FALSE(isDrawn(world, place, {.joints = false})) << each.name;
        }
        EXPECT_FALSE(isDrawn(world, {0, 8})) << each.name;
        EXPECT_FALSE(isDrawn(world, {0, -8})) << each.name;
    }
}

TEST(WorldPainter, ASpringIsAZigzagBesideItsLine) {
    kodo::World world;
    const kodo::BodyId a = world.add({.shape = kodo::Circle{0.1f}, .position = {-5, 0}});
    const kodo::BodyId b = world.add({.shape = kodo::Circle{0.1f}, .position = {5, 0}});
    const kodo::JointEnds ends{.a = a, .b = b};
    int beside = 0; // points 4 pixels from the line
    const auto count = [&] {
        beside = 0;
        for (float x = -4.8f; x < 4.8f; x += 0.05f) {
            beside += isDrawn(world, {x, 0.4f}) ? 1 : 0;
        }
        return beside;
    };
    const kodo::JointId joint =
        world.add(kodo::DistanceJoint{.ends = ends, .limits = kodo::Range{10, 10}});
    EXPECT_EQ(count(), 0);
    world.setJoint(joint, kodo::DistanceJoint{.ends = ends, .length = 10, .hertz = 2});
    EXPECT_GT(count(), 10);
}

} // namespace
} // namespace kodo_sfml
