// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <functional>
#include <string>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

struct BadDef {
    const char* name;
    std::function<void(BodyDef&)> spoil;
    const char* field;
};

std::ostream& operator<<(std::ostream& out, const BadDef& bad) {
    return out << bad.name;
}

Polygon manyCorners(std::size_t n) {
    Polygon polygon;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307 * static_cast<double>(i) / static_cast<double>(n);
        polygon.corners.push_back(
            {static_cast<Real>(1000 * std::cos(angle)), static_cast<Real>(1000 * std::sin(angle))});
    }
    return polygon;
}

class BadBodyDef : public testing::TestWithParam<BadDef> {};

// Every invalid value is refused with a sentence that names the field. check() and add() report the
// same text. The World keeps its bits.
TEST_P(BadBodyDef, IsRefusedByFieldWithoutAnyChange) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 1, 10);
    support::run(world, 30);
    BodyDef def;
    GetParam().spoil(def);
    const std::uint64_t before = world.stateHash();
    const std::size_t count = world.bodyCount();

    const auto problem = check(def);
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(problem->field, GetParam().field);
    EXPECT_FALSE(problem->reason.empty());
    try {
        world.add(def);
        FAIL() << "add() took what check() refuses";
    } catch (const BadDefinition& bad) {
        EXPECT_EQ(bad.problem().text(), problem->text());
        EXPECT_EQ(std::string(bad.what()), problem->text());
    }
    EXPECT_EQ(world.bodyCount(), count);
    EXPECT_EQ(world.stateHash(), before);
}

const BadDef kBadDefs[] = {
    {"PositionNan", [](BodyDef& d) { d.position.x = kNan; }, "position"},
    {"PositionInf", [](BodyDef& d) { d.position.y = -kInf; }, "position"},
    {"PositionTooFar", [](BodyDef& d) { d.position.x = 2 * kMaxCoordinate; }, "position"},
    {"RotationNan", [](BodyDef& d) { d.rotation.s = kNan; }, "rotation"},
    {"RotationZero",
     [](BodyDef& d) {
         d.rotation = {0, 0};
     },
     "rotation"},
    {"RotationNotUnit",
     [](BodyDef& d) {
         d.rotation = {2, 0};
     },
     "rotation"},
    {"VelocityNan", [](BodyDef& d) { d.velocity.x = kNan; }, "velocity"},
    {"VelocityInf", [](BodyDef& d) { d.velocity.y = kInf; }, "velocity"},
    {"VelocityTooHigh", [](BodyDef& d) { d.velocity.x = 2 * kMaxSpeed; }, "velocity"},
    {"SpinNan", [](BodyDef& d) { d.angularVelocity = kNan; }, "angularVelocity"},
    {"SpinInf", [](BodyDef& d) { d.angularVelocity = kInf; }, "angularVelocity"},
    {"DensityZero", [](BodyDef& d) { d.density = 0; }, "density"},
    {"DensityNegative", [](BodyDef& d) { d.density = -1; }, "density"},
    {"DensityNan", [](BodyDef& d) { d.density = kNan; }, "density"},
    {"DensityInf", [](BodyDef& d) { d.density = kInf; }, "density"},
    {"DensityDenormal", [](BodyDef& d) { d.density = Real(1e-40); }, "density"},
    {"RestitutionNegative", [](BodyDef& d) { d.material.restitution = -1; },
     "material.restitution"},
    {"RestitutionThree", [](BodyDef& d) { d.material.restitution = 3; }, "material.restitution"},
    {"RestitutionNan", [](BodyDef& d) { d.material.restitution = kNan; }, "material.restitution"},
    {"KineticFrictionNegative", [](BodyDef& d) { d.material.kineticFriction = -1; },
     "material.kineticFriction"},
    {"StaticFrictionNegative", [](BodyDef& d) { d.material.staticFriction = -1; },
     "material.staticFriction"},
    {"StaticBelowKinetic",
     [](BodyDef& d) {
         d.material.kineticFriction = Real(0.5);
         d.material.staticFriction = Real(0.4);
     },
     "material.staticFriction"},
    {"FrictionHuge", [](BodyDef& d) { d.material.staticFriction = Real(1e30); },
     "material.staticFriction"},
    {"FrictionNan", [](BodyDef& d) { d.material.kineticFriction = kNan; },
     "material.kineticFriction"},
    {"RollingNegative", [](BodyDef& d) { d.material.rollingResistance = -1; },
     "material.rollingResistance"},
    {"RollingNan", [](BodyDef& d) { d.material.rollingResistance = kNan; },
     "material.rollingResistance"},
    {"RadiusZero", [](BodyDef& d) { d.shape = Circle{0}; }, "shape.radius"},
    {"RadiusNegative", [](BodyDef& d) { d.shape = Circle{-1}; }, "shape.radius"},
    {"RadiusNan", [](BodyDef& d) { d.shape = Circle{kNan}; }, "shape.radius"},
    {"RadiusInf", [](BodyDef& d) { d.shape = Circle{kInf}; }, "shape.radius"},
    {"CircleCenterNan",
     [](BodyDef& d) {
         d.shape = Circle{1, {kNan, 0}};
     },
     "shape.center"},
    {"WidthZero",
     [](BodyDef& d) {
         d.shape = Box{0, 1};
     },
     "shape.width"},
    {"HeightNegative",
     [](BodyDef& d) {
         d.shape = Box{1, -1};
     },
     "shape.height"},
    {"BoxRotation",
     [](BodyDef& d) {
         d.shape = Box{1, 1, {}, {3, 4}};
     },
     "shape.rotation"},
    {"TwoCorners",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {1, 0}}};
     },
     "shape.corners"},
    {"TooManyCorners", [](BodyDef& d) { d.shape = manyCorners(kMaxCorners + 1); }, "shape.corners"},
    {"CornerNan",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {1, 0}, {kNan, 1}}};
     },
     "shape.corners[2]"},
    {"Clockwise",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {0, 1}, {1, 0}}};
     },
     "shape.corners"},
    {"Collinear",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {1, 0}, {2, 0}}};
     },
     "shape.corners[2]"},
    {"AreaTiny",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {1, 0}, {Real(0.5), Real(1e-20)}}};
     },
     "shape.corners[2]"},
    {"OnePoint",
     [](BodyDef& d) {
         d.shape = Polygon{{{1, 1}, {1, 1}, {1, 1}}};
     },
     "shape.corners[1]"},
    {"Concave",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}};
     },
     "shape.corners[2]"},
    {"Duplicate",
     [](BodyDef& d) {
         d.shape = Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}};
     },
     "shape.corners[2]"},
    {"NoParts", [](BodyDef& d) { d.shape = Compound{}; }, "shape.parts"},
    {"BadPart",
     [](BodyDef& d) {
         d.shape = Compound{{Circle{1}, Circle{-1}}};
     },
     "shape.parts[1].radius"},
};

INSTANTIATE_TEST_SUITE_P(Definitions, BadBodyDef, testing::ValuesIn(kBadDefs),
                         [](const testing::TestParamInfo<BadDef>& row) {
                             return std::string(row.param.name);
                         });

TEST(BodyDef, DefaultIsAccepted) {
    const BodyDef def;
    EXPECT_FALSE(check(def).has_value());
    World world;
    EXPECT_NO_THROW(world.add(def));
}

TEST(BodyDef, ValuesAtTheLimitsAreAccepted) {
    World world;
    BodyDef def;
    def.position = {kMaxCoordinate, -kMaxCoordinate};
    def.velocity = {kMaxSpeed, 0};
    def.material = {0, 0, 1, 0};
    def.density = kMinDensity;
    EXPECT_FALSE(check(def).has_value());
    def.density = kMaxDensity;
    EXPECT_NO_THROW(world.add(def));
}

// Parts within the limits may exceed them together. Such a body is refused, as one definition and
// part by part. In float, two heavy discs far apart would have an infinite moment of inertia.
TEST(BodyDef, PartsThatExceedTheLimitsTogetherAreRefused) {
    World world({.lengthUnit = Real(1e6)});
    const Real farthest = kMaxCoordinate * world.tolerances().unit() / 2;
    int refused = 0;
    for (const Real share : {Real(0), Real(1e-9), Real(1e-3), Real(0.1), Real(1)}) {
        SCOPED_TRACE(share);
        const Circle left{Real(5e3), {-share * farthest, 0}};
        const Circle right{Real(5e3), {share * farthest, 0}}; // 8e16 kg
        BodyDef def{.shape = Compound{{left, right}}, .density = kMaxDensity};
        const bool fits = !check(def, world.tolerances().unit());
        refused += fits ? 0 : 1;
        if (fits) {
            EXPECT_LE(world[world.add(def)].inertia(), kMaxMass * kMaxMass);
        }
        def.shape = left;
        const BodyId whole = world.add(def);
        const auto weldsShape = [&] { world.weld(whole, right, {}, kMaxDensity); };
        def.shape = Circle{Real(5e3)};
        def.position = right.center;
        const BodyId part = world.add(def);
        const auto weldsBody = [&] { world.weld(world.clone(whole, {}), part); };
        if (fits) {
            EXPECT_NO_THROW(weldsShape());
        } else {
            EXPECT_THROW(weldsShape(), BadDefinition);
            EXPECT_THROW(weldsBody(), BadDefinition);
            EXPECT_TRUE(world.contains(part));
        }
    }
    EXPECT_EQ(refused, sizeof(Real) == 4 ? 2 : 0); // kMaxMass is 1e18 or 1e100 kg
}

TEST(BodyDef, RefusalNamesFieldAndValue) {
    BodyDef def;
    def.density = -1;
    EXPECT_EQ(check(def)->text().find("density: must be from 1e-09 to 1e+09 kg/m^2, but is -1"), 0u)
        << check(def)->text();
    def = {};
    def.shape = Circle{-3};
    EXPECT_EQ(check(def)->text().find("shape.radius: must be "), 0u) << check(def)->text();
}

} // namespace
} // namespace kodo
