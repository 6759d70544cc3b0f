// SPDX-License-Identifier: MIT
// What draw() draws of a World, and where: from the figures alone.
#include <kodo/kodo.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kodo {
namespace {

constexpr Real kPixel = Real(0.1); // m

/// Distance (m) of a point from a line between two others.
Real distanceFrom(Vec2 from, Vec2 to, Vec2 point) {
    const Vec2 way = to - from;
    const Real share = lengthSquared(way) > 0 ? dot(point - from, way) / lengthSquared(way) : 0;
    return length(point - from - std::clamp(share, Real(0), Real(1)) * way);
}

/// Counts the figures by name, and tells whether one of them covers a point.
class Figures final : public DebugDraw {
public:
    explicit Figures(Vec2 watched = {}) : watched_(watched) {}

    Aabb view() const override { return {{-20, -20}, {20, 20}}; }
    Real pixel() const override { return kPixel; }
    void line(Vec2 from, Vec2 to, const DrawStyle& style) override {
        note("line", style, distanceFrom(from, to, watched_) <= halfWidth(style));
    }
    void circle(Vec2 center, Real radius, const DrawStyle& style) override {
        const Real beyond = length(watched_ - center) - radius;
        note("circle", style,
             style.fill.a > 0 ? beyond <= 0 : std::abs(beyond) <= halfWidth(style));
    }
    void polygon(std::span<const Vec2> corners, const DrawStyle& style) override {
        bool inside = style.fill.a > 0;
        bool onEdge = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 next = corners[(i + 1) % corners.size()];
            inside = inside && cross(next - corners[i], watched_ - corners[i]) >= 0;
            onEdge = onEdge || distanceFrom(corners[i], next, watched_) <= halfWidth(style);
        }
        note("polygon", style, inside || onEdge);
    }
    void text(Vec2 middle, std::string_view utf8, const DrawStyle& style) override {
        note("text", style, middle == watched_);
        texts.emplace_back(utf8);
    }
    void begin(const BodyView& body, DrawStyle& style) override {
        begun.emplace_back(body.id(), style);
        style.width = width;
    }

    bool covered() const { return covered_; }
    int count(const std::string& name) { return counts_[name]; }

    std::vector<std::pair<BodyId, DrawStyle>> begun;
    std::vector<std::string> texts;
    std::vector<DrawStyle> styles; // of all figures
    Real width = Real(1.5);        // pixels, that begin() sets

private:
    static Real halfWidth(const DrawStyle& style) { return style.width * kPixel / 2; }
    void note(const char* name, const DrawStyle& style, bool covers) {
        ++counts_[name];
        styles.push_back(style);
        covered_ = covered_ || covers;
    }

    Vec2 watched_; // m
    bool covered_ = false;
    std::map<std::string, int> counts_;
};

bool isDrawn(const World& world, Vec2 place, const DrawOptions& options = {}) {
    Figures figures(place);
    draw(world, figures, options);
    return figures.covered();
}

/// A body of each kind of shape, turned by a quarter of a turn, with points that it covers and
/// points that it does not. A kind that is left out does not compile.
struct ShapeCase {
    std::string name;
    Shape shape;
    std::vector<Vec2> covered; // m, in the frame of the shape
    std::vector<Vec2> bare;
};

ShapeCase caseOf(const Circle& circle) {
    return {"circle", circle, {{0, 0}, {1.9f, 0}, {0, -1.9f}}, {{2.3f, 0}, {1.7f, 1.7f}}};
}
ShapeCase caseOf(const Box& box) {
    return {"box", box, {{0, 0}, {2.9f, 0.9f}, {-2.9f, -0.9f}}, {{0, 1.4f}, {3.4f, 0}}};
}
ShapeCase caseOf(const Polygon& polygon) {
    return {"polygon", polygon, {{1, 1}, {3.5f, 0.2f}}, {{3, 3}, {-0.5f, 2}}};
}
ShapeCase caseOf(const Compound& compound) {
    return {"compound", compound, {{-3, 0}, {3, 0}}, {{0, 2}, {5, 0}}};
}
ShapeCase caseOf(const Point& point) {
    return {"point", point, {{1, 2}}, {{2, 2}, {1, 3}}};
}
ShapeCase caseOf(const Segment& segment) {
    return {
        "segment", segment, {{-4, 1}, {0, 1}, {4, 1}, {0, 1.5f}}, {{0, 0.5f}, {5, 1}, {2, 1.5f}}};
}
ShapeCase caseOf(const Plane& plane) {
    return {"plane", plane, {{0, -0.1f}, {15, -0.1f}, {-15, -12}}, {{0, 0.5f}, {15, 0.5f}}};
}
ShapeCase caseOf(const Heightmap& map) {
    return {"heightmap", map, {{-4, 0}, {-2, 1}, {2, 1}}, {{-2, 0}, {0, 3}}};
}
ShapeCase caseOf(const Chain& chain) {
    return {"chain", chain, {{-2, 1}, {2, 1}}, {{0, 0}, {0, 3}}};
}
ShapeCase caseOf(const Capsule& capsule) {
    return {"capsule", capsule, {{0, 0.9f}, {3.8f, 0}, {-3.8f, 0}}, {{0, 1.3f}, {3.9f, 0.9f}}};
}

std::vector<ShapeCase> shapeCases() {
    const Compound pair{{Box{2, 2, {-3, 0}}, Circle{1, {3, 0}}}};
    const std::vector<Shape> shapes = {
        Circle{2},
        Box{6, 2},
        Polygon{{{0, 0}, {4, 0}, {0, 4}}},
        pair,
        Point{{1, 2}},
        Segment{.from = {-4, 1}, .to = {4, 1}, .oneSided = true},
        Plane{},
        Heightmap{.origin = {-4, 0}, .spacing = 4, .heights = {0, 2, 0}},
        Chain{.points = {{-4, 0}, {0, 2}, {4, 0}}},
        Capsule{{-3, 0}, {3, 0}, 1}};
    static_assert(std::variant_size_v<Shape> == 10, "a kind of shape is left out");
    std::vector<ShapeCase> cases;
    for (const Shape& shape : shapes) {
        cases.push_back(std::visit([](const auto& each) { return caseOf(each); }, shape));
        EXPECT_EQ(cases.size() - 1, shape.index());
    }
    return cases;
}

TEST(DebugDraw, EveryShapeIsDrawnWhereItIsAndNowhereElse) {
    for (const ShapeCase& each : shapeCases()) {
        World world;
        const BodyId body = world.add({.shape = each.shape,
                                       .position = {1, -2},
                                       .rotation = Rot::fromAngle(0.5f),
                                       .type = BodyType::Static});
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

TEST(DebugDraw, APlaneFillsThePictureFromAnyDistance) {
    World world;
    world.add({.shape = Plane{.normal = {0, 1}, .offset = 5000}, .type = BodyType::Static});
    EXPECT_TRUE(isDrawn(world, {-19, 19}));
    EXPECT_TRUE(isDrawn(world, {19, -19}));
}

/// Two small discs at (-5, 0) and (5, 0) with a joint, and points that its picture covers.
struct JointCase {
    std::string name;
    JointDef joint;
    std::vector<Vec2> covered; // m
};

const JointEnds kMiddle{.anchorA = {5, 0}, .anchorB = {-5, 0}};

JointCase caseOf(RevoluteJoint joint) {
    joint.ends = kMiddle;
    return {"revolute", joint, {{-2, 0}, {2, 0}, {0, 0.5f}, {0.5f, 0}}};
}
JointCase caseOf(FixedJoint joint) {
    joint.ends = kMiddle;
    return {"fixed", joint, {{-2, 0}, {2, 0}, {0.5f, 0.3f}, {-0.3f, -0.5f}}};
}
JointCase caseOf(DistanceJoint joint) {
    joint.limits = Range{0, 10};
    return {"rope", joint, {{-2, 0}, {0, 0}, {2, 0}}};
}
JointCase caseOf(PrismaticJoint joint) {
    joint.ends = kMiddle;
    joint.limits = Range{-3, 3};
    return {"prismatic", joint, {{-3, 0.5f}, {3, -0.5f}, {1, 0}, {0, 0}}};
}
JointCase caseOf(MotorJoint joint) {
    joint.force = 1;
    return {"motor", joint, {{0, 0}, {-4.2f, 0.4f}, {-4.2f, -0.4f}}};
}
JointCase caseOf(WheelJoint joint) {
    joint.ends = kMiddle;
    joint.axis = {1, 0};
    joint.limits = Range{-3, 3};
    return {"wheel", joint, {{-3, Real(0.5)}, {3, Real(-0.5)}, {1, 0}, {0, Real(0.5)}}};
}
JointCase caseOf(PulleyJoint joint) {
    joint.groundA = {-5, 4};
    joint.groundB = {5, 4};
    joint.length = 8;
    return {"pulley", joint, {{-5, 2}, {0, 4}, {5, 2}, {Real(-4.5), 4}}};
}
JointCase caseOf(GearJoint joint) {
    return {"gear", joint, {{0, 0}, {-5, 1}, {5, -1}}};
}
JointCase caseOf(FilterJoint joint) {
    return {"filter", joint, {{-2, 0}, {2, 0}}};
}
JointCase caseOf(MouseJoint joint) {
    joint.target = {5, 5};
    joint.force = 1;
    return {"mouse", joint, {{5, 2}, {5.3f, 5.3f}, {4.7f, 5.3f}}};
}

/// A joint of each kind; a kind without a case does not compile.
template <std::size_t... I>
std::vector<JointCase> jointCases(std::index_sequence<I...>) {
    return {caseOf(std::variant_alternative_t<I, JointDef>{})...};
}

void connect(JointDef& joint, BodyId a, BodyId b) {
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

TEST(DebugDraw, EveryJointIsDrawnFromAnchorToAnchor) {
    constexpr auto kKinds = std::make_index_sequence<std::variant_size_v<JointDef>>{};
    for (JointCase& each : jointCases(kKinds)) {
        World world;
        const BodyId a = world.add({.shape = Circle{0.1f}, .position = {-5, 0}});
        const BodyId b = world.add({.shape = Circle{0.1f}, .position = {5, 0}});
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

TEST(DebugDraw, ASpringIsAZigzagBesideItsLine) {
    World world;
    const BodyId a = world.add({.shape = Circle{0.1f}, .position = {-5, 0}});
    const BodyId b = world.add({.shape = Circle{0.1f}, .position = {5, 0}});
    const JointEnds ends{.a = a, .b = b};
    int beside = 0; // points 4 pixels from the line
    const auto count = [&] {
        beside = 0;
        for (float x = -4.8f; x < 4.8f; x += 0.05f) {
            beside += isDrawn(world, {x, 0.4f}) ? 1 : 0;
        }
        return beside;
    };
    const JointId joint = world.add(DistanceJoint{.ends = ends, .limits = Range{10, 10}});
    EXPECT_EQ(count(), 0);
    world.setJoint(joint, DistanceJoint{.ends = ends, .length = 10, .hertz = 2});
    EXPECT_GT(count(), 10);
}

bool same(DrawColor a, DrawColor b) {
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

/// The style that draw() gives to a body.
DrawStyle styleOf(const World& world, BodyId id, const DrawOptions& options = {}) {
    Figures figures;
    draw(world, figures, options);
    for (const auto& [body, style] : figures.begun) {
        if (body == id) {
            return style;
        }
    }
    ADD_FAILURE() << "body " << id.index << " is not drawn";
    return {};
}

TEST(DebugDraw, ColoursTellStaticKinematicAwakeAsleepSensorAndDisabledBodiesApart) {
    World world;
    const auto add = [&](BodyType type, Flags flags) {
        return world.add({.shape = Box{1, 1},
                          .position = {static_cast<Real>(3 * world.bodyCount()), 0},
                          .type = type,
                          .flags = flags});
    };
    const BodyId ground = add(BodyType::Static, 0);
    const BodyId lift = add(BodyType::Kinematic, 0);
    const BodyId awake = add(BodyType::Dynamic, kNeverSleep);
    const BodyId asleep = add(BodyType::Dynamic, 0);
    const BodyId sensor = add(BodyType::Dynamic, kSensor);
    const BodyId disabled = add(BodyType::Dynamic, kDisabled | kNeverSleep);
    for (int i = 0; i < 60; ++i) {
        world.step(Real(1) / 60);
    }
    ASSERT_TRUE(world[asleep].isAsleep());
    EXPECT_FALSE(same(styleOf(world, ground).line, styleOf(world, lift).line));
    EXPECT_FALSE(same(styleOf(world, ground).line, styleOf(world, awake).line));
    EXPECT_FALSE(same(styleOf(world, lift).line, styleOf(world, awake).line));
    EXPECT_LT(styleOf(world, asleep).fill.a, styleOf(world, awake).fill.a);
    EXPECT_GT(styleOf(world, asleep).fill.a, 0);
    EXPECT_EQ(styleOf(world, sensor).fill.a, 0);
    EXPECT_EQ(styleOf(world, sensor).line.a, 255);
    EXPECT_EQ(styleOf(world, disabled).fill.a, 0);
    EXPECT_LT(styleOf(world, disabled).line.a, 128);
}

TEST(DebugDraw, AFrozenBodyIsRed) {
    World world;
    const BodyId body = world.add({.shape = Box{1, 1}});
    world[body].applyForce({std::numeric_limits<Real>::max(), 0});
    world.step(Real(1) / 60);
    ASSERT_NE(world[body].flags() & kFrozen, 0u);
    EXPECT_GT(styleOf(world, body).line.r, 200);
    EXPECT_LT(styleOf(world, body).line.g, 100);
}

TEST(DebugDraw, IslandsHaveOneColourByContactsAndJoints) {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = Plane{}, .type = BodyType::Static});
    const BodyId lower = world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}});
    const BodyId upper = world.add({.shape = Box{1, 1}, .position = {0, Real(1.5)}});
    const BodyId alone = world.add({.shape = Box{1, 1}, .position = {4, Real(0.5)}});
    const BodyId tied = world.add({.shape = Box{1, 1}, .position = {8, 4}});
    world.add(DistanceJoint{.ends = {.a = upper, .b = tied}, .limits = Range{0, 20}});
    world.step(Real(1) / 60);
    const auto colour = [&](BodyId id) { return styleOf(world, id, {.islands = true}).line; };
    EXPECT_TRUE(same(colour(lower), colour(upper)));
    EXPECT_TRUE(same(colour(lower), colour(tied)));
    EXPECT_FALSE(same(colour(lower), colour(alone))); // though both lie on the plane
    EXPECT_FALSE(same(styleOf(world, lower).line, styleOf(world, upper).line));
}

TEST(DebugDraw, ContactsAndImpulsesAreThoseOfTheRecords) {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = Plane{}, .type = BodyType::Static});
    const BodyId box = world.add({.shape = Box{4, 2}, .position = {0, 1}});
    for (int i = 0; i < 20; ++i) {
        world.step(Real(1) / 60);
    }
    ASSERT_EQ(world.collisions().size(), 1u);
    ASSERT_EQ(world.collisions()[0].pointCount, 2);
    Figures figures;
    draw(world, figures, {.shapes = false, .contacts = true});
    EXPECT_EQ(figures.count("circle"), 2);
    EXPECT_EQ(figures.count("line"), 2);
    EXPECT_TRUE(isDrawn(world, {2, Real(0.15)}, {.shapes = false, .contacts = true})); // normal
    // The weight of 8 kg for 1/60 s is 1.33 N s, an arrow of 2.7 m from one corner.
    const DrawOptions arrows{.shapes = false, .impulses = true, .metresPerImpulse = 2};
    EXPECT_TRUE(isDrawn(world, {2, Real(2.5)}, arrows) || isDrawn(world, {-2, Real(2.5)}, arrows));
    EXPECT_FALSE(isDrawn(world, {2, 3}, arrows) || isDrawn(world, {-2, 3}, arrows));
    world.remove(box);
    EXPECT_TRUE(isDrawn(world, {2, 0}, {.shapes = false, .contacts = true})); // records stay
}

TEST(DebugDraw, BoundsVelocitiesCentresAndLabelsAreDrawnWhenAskedFor) {
    World world;
    const BodyId body = world.add(
        {.shape = Circle{2}, .position = {5, 5}, .velocity = {30, 0}, .flags = kNeverSleep});
    const Vec2 corner{7, 7};
    EXPECT_FALSE(isDrawn(world, corner));
    EXPECT_TRUE(isDrawn(world, corner, {.bounds = true}));
    EXPECT_FALSE(isDrawn(world, {Real(7.8), 5}));
    EXPECT_TRUE(isDrawn(world, {Real(7.8), 5}, {.velocities = true})); // 0.1 s: to x = 8
    EXPECT_FALSE(isDrawn(world, {Real(8.2), 5}, {.velocities = true}));
    const DrawOptions centers{.shapes = false, .centers = true};
    EXPECT_TRUE(isDrawn(world, {5, 5}, centers));
    Figures figures({5, 5});
    draw(world, figures, {.shapes = false, .labels = true});
    EXPECT_EQ(figures.texts, std::vector<std::string>{std::to_string(body.index)});
    EXPECT_TRUE(figures.covered());
}

TEST(DebugDraw, BeginChangesTheStyleAndWhatIsNotShownIsLeftOut) {
    World world;
    world.add({.shape = Box{1, 1}});
    world.add({.shape = Box{1, 1}, .position = {100, 0}});
    Figures figures;
    figures.width = 7;
    draw(world, figures);
    EXPECT_EQ(figures.begun.size(), 1u);
    ASSERT_EQ(figures.styles.size(), 2u); // the box and its spoke
    EXPECT_EQ(figures.styles[0].width, 7);
    Figures nothing;
    draw(world, nothing, {.shapes = false, .joints = false});
    EXPECT_TRUE(nothing.styles.empty());
}

TEST(DebugDraw, ARoundedShapeReachesItsRadiusAndNoFarther) {
    World world;
    world.add({.shape = Box{.width = 4, .height = 2, .radius = 1}, .flags = kNeverSleep});
    EXPECT_TRUE(isDrawn(world, {Real(2.97), 0}));
    EXPECT_TRUE(isDrawn(world, {Real(2.68), Real(1.68)}));  // 0.96 m from the corner
    EXPECT_FALSE(isDrawn(world, {Real(2.85), Real(1.85)})); // 1.2 m
    EXPECT_FALSE(isDrawn(world, {Real(3.2), 0}));
}

TEST(DebugDraw, DrawingChangesNothing) {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = Plane{}, .type = BodyType::Static});
    world.add({.shape = Box{1, 1}, .position = {0, 1}});
    world.step(Real(1) / 60);
    const std::uint64_t before = world.stateHash();
    const std::string first = svg(world, {true, true, true, true, true, true, true, true});
    EXPECT_EQ(world.stateHash(), before);
    EXPECT_EQ(svg(world, {true, true, true, true, true, true, true, true}), first);
}

TEST(DebugDraw, TheViewOfAWorldHoldsItsBodiesAndAPointOfEachPlane) {
    World world;
    EXPECT_EQ(viewOf(world), (Aabb{{-1, -1}, {1, 1}}));
    world.add({.shape = Plane{}, .type = BodyType::Static});
    world.add({.shape = Box{10, 2}, .position = {0, 9}});
    EXPECT_TRUE(viewOf(world).contains(Aabb{{-5, 0}, {5, 10}}));
    EXPECT_TRUE((Aabb{{-6, -1}, {6, 11}}).contains(viewOf(world)));
}

} // namespace
} // namespace kodo
