// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <functional>
#include <limits>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

/// A World with motion, contacts and a joint.
struct Scene {
    World world{{.gravity = support::kEarth}};
    BodyId floor;
    BodyId box;
    BodyId ball;
    JointId pin;

    Scene() {
        floor = support::addFloor(world);
        box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        ball = world.add(support::ballDef({0, 3}, Real(0.5)));
        pin = world.add(RevoluteJoint{.ends = {box, ball, {0, 3}, {0, Real(0.5)}}});
        support::run(world, 20);
    }
};

struct Bad {
    const char* field;
    std::function<void(Scene&)> call;
};

/// Expects each call to be refused with the field named, without any change of state.
void expectRefused(const std::vector<Bad>& rows) {
    int number = 0;
    for (const Bad& bad : rows) {
        SCOPED_TRACE(testing::Message() << "row " << number++ << ", " << bad.field);
        Scene scene;
        const std::uint64_t before = scene.world.stateHash();
        try {
            bad.call(scene);
            ADD_FAILURE() << "not refused";
        } catch (const BadDefinition& error) {
            EXPECT_EQ(error.problem().field, bad.field) << error.what();
            EXPECT_FALSE(error.problem().reason.empty());
        }
        EXPECT_EQ(scene.world.stateHash(), before);
        World untouched = Scene().world;
        untouched.step(support::kDt);
        scene.world.step(support::kDt);
        EXPECT_EQ(scene.world.stateHash(), untouched.stateHash());
    }
}

template <typename Change>
Bad body(const char* field, Change change) {
    return {field, [=](Scene& scene) {
                BodyDef def;
                change(def);
                scene.world.add(def);
            }};
}

// Invalid shapes, sizes, masses and flags, beyond the numbers of each primitive that tests/world
// covers.
TEST(BadInput, InABodyDefIsRefused) {
    const auto shape = [](const char* field, const Shape& bad) {
        return body(field, [=](BodyDef& d) { d.shape = bad; });
    };
    const auto ground = [](const char* field, const Shape& bad) {
        return body(field, [=](BodyDef& d) {
            d.shape = bad;
            d.type = BodyType::Static;
        });
    };
    expectRefused({
        shape("shape.position", Point{{kNan, 0}}),
        shape("shape.from", Segment{{kInf, 0}, {1, 0}}),
        shape("shape.to", Segment{{0, 0}, {0, kNan}}),
        shape("shape.to", Segment{{1, 1}, {1, 1}}),
        shape("shape.points", Chain{.points = {{0, 0}}}),
        shape("shape.points[1]", Chain{.points = {{0, 0}, {kNan, 0}}}),
        shape("shape.points[0]", Chain{.points = {{0, 0}, {1, 0}, {0, 0}}, .closed = true}),
        shape("shape.materials[0].restitution",
              Chain{.points = {{0, 0}, {1, 0}}, .materials = {withFriction(0, 3)}}),
        ground("shape.normal", Plane{{0, 2}, 0}),
        ground("shape.normal", Plane{{kNan, 0}, 0}),
        ground("shape.offset", Plane{{0, 1}, kInf}),
        ground("shape.origin", Heightmap{{kNan, 0}, 1, {0, 0}}),
        ground("shape.spacing", Heightmap{{0, 0}, 0, {0, 0}}),
        ground("shape.heights", Heightmap{{0, 0}, 1, {0}}),
        ground("shape.heights[1]", Heightmap{{0, 0}, 1, {0, kNan, 0}}),
        shape("type", Plane{{0, 1}, 0}),
        shape("type", Heightmap{{0, 0}, 1, {0, 0}}),
        shape("shape", Circle{2 * kMaxCoordinate}),
        shape("shape", Circle{1, {0, 2 * kMaxCoordinate}}),
        shape("shape", Box{1, 1, {-2 * kMaxCoordinate, 0}}),
        shape("shape", Segment{{0, 0}, {2 * kMaxCoordinate, 0}}),
        ground("shape", Plane{{0, 1}, 2 * kMaxCoordinate}),
        shape("shape.radius", Circle{std::numeric_limits<Real>::max()}),
        shape("shape", Circle{std::numeric_limits<Real>::min()}),
        shape("shape", Box{1, std::numeric_limits<Real>::denorm_min()}),
        shape("shape", Compound{{Circle{1}, Circle{std::numeric_limits<Real>::min()}}}),
        body("flags", [](BodyDef& d) { d.flags = kMatchAny | kMatchAll; }),
        body("flags", [](BodyDef& d) { d.flags = kMatchModes; }),
    });
}

template <typename Joint, typename Change>
Bad joint(const char* field, Change change) {
    return {field, [=](Scene& scene) {
                Joint def;
                if constexpr (requires { def.ends; }) {
                    def.ends = {scene.box, scene.ball};
                } else {
                    def.body = scene.ball;
                }
                change(def);
                const auto problem = check(JointDef(def));
                ASSERT_TRUE(problem.has_value());
                EXPECT_EQ(problem->field, field);
                scene.world.add(def);
            }};
}

TEST(BadInput, InJointEndsIsRefused) {
    const auto ends = [](const char* field, auto change) {
        return joint<FixedJoint>(field, [=](FixedJoint& d) { change(d.ends); });
    };
    expectRefused({
        ends("ends", [](JointEnds& e) { e.b = e.a; }),
        ends("ends.anchorA", [](JointEnds& e) { e.anchorA.x = kNan; }),
        ends("ends.anchorB", [](JointEnds& e) { e.anchorB.y = -kInf; }),
        ends("ends.anchorB", [](JointEnds& e) { e.anchorB.y = 2 * kMaxCoordinate; }),
        ends("ends.breakForce", [](JointEnds& e) { e.breakForce = 0; }),
        ends("ends.breakForce", [](JointEnds& e) { e.breakForce = kNan; }),
        ends("ends.breakTorque", [](JointEnds& e) { e.breakTorque = -1; }),
    });
}

TEST(BadInput, InARevoluteOrFixedJointIsRefused) {
    expectRefused({
        joint<FixedJoint>("reference", [](FixedJoint& d) { d.reference = kNan; }),
        joint<RevoluteJoint>("reference", [](RevoluteJoint& d) { d.reference = kInf; }),
        joint<RevoluteJoint>("limits.lower",
                             [](RevoluteJoint& d) {
                                 d.limits = Range{kNan, 0};
                             }),
        joint<RevoluteJoint>("limits.lower",
                             [](RevoluteJoint& d) {
                                 d.limits = Range{Real(-2e4), 0};
                             }),
        joint<RevoluteJoint>("limits.upper",
                             [](RevoluteJoint& d) {
                                 d.limits = Range{1, 0};
                             }),
        joint<RevoluteJoint>("limits.upper",
                             [](RevoluteJoint& d) {
                                 d.limits = Range{0, kInf};
                             }),
        joint<RevoluteJoint>("motorSpeed", [](RevoluteJoint& d) { d.motorSpeed = kNan; }),
        joint<RevoluteJoint>("motorSpeed", [](RevoluteJoint& d) { d.motorSpeed = 2 * kMaxSpeed; }),
        joint<RevoluteJoint>("motorTorque", [](RevoluteJoint& d) { d.motorTorque = -1; }),
        joint<RevoluteJoint>("motorTorque", [](RevoluteJoint& d) { d.motorTorque = kInf; }),
    });
}

TEST(BadInput, InADistanceOrPrismaticJointIsRefused) {
    expectRefused({
        joint<DistanceJoint>("length", [](DistanceJoint& d) { d.length = -1; }),
        joint<DistanceJoint>("length", [](DistanceJoint& d) { d.length = kNan; }),
        joint<DistanceJoint>("hertz", [](DistanceJoint& d) { d.hertz = -1; }),
        joint<DistanceJoint>("hertz", [](DistanceJoint& d) { d.hertz = kInf; }),
        joint<DistanceJoint>("damping", [](DistanceJoint& d) { d.damping = kNan; }),
        joint<DistanceJoint>("limits.lower",
                             [](DistanceJoint& d) {
                                 d.limits = Range{-1, 1};
                             }),
        joint<DistanceJoint>("limits.upper",
                             [](DistanceJoint& d) {
                                 d.limits = Range{2, 1};
                             }),
        joint<PrismaticJoint>("axis",
                              [](PrismaticJoint& d) {
                                  d.axis = {1, 1};
                              }),
        joint<PrismaticJoint>("axis",
                              [](PrismaticJoint& d) {
                                  d.axis = {kNan, 0};
                              }),
        joint<PrismaticJoint>("reference", [](PrismaticJoint& d) { d.reference = kNan; }),
        joint<PrismaticJoint>("limits.lower",
                              [](PrismaticJoint& d) {
                                  d.limits = Range{-kInf, 1};
                              }),
        joint<PrismaticJoint>("limits.upper",
                              [](PrismaticJoint& d) {
                                  d.limits = Range{0, kNan};
                              }),
        joint<PrismaticJoint>("motorSpeed", [](PrismaticJoint& d) { d.motorSpeed = kInf; }),
        joint<PrismaticJoint>("motorForce", [](PrismaticJoint& d) { d.motorForce = -1; }),
    });
}

TEST(BadInput, InAMotorOrMouseJointIsRefused) {
    expectRefused({
        joint<MotorJoint>("reference", [](MotorJoint& d) { d.reference = kNan; }),
        joint<MotorJoint>("force", [](MotorJoint& d) { d.force = -1; }),
        joint<MotorJoint>("torque", [](MotorJoint& d) { d.torque = kInf; }),
        joint<MotorJoint>("hertz", [](MotorJoint& d) { d.hertz = Real(1e-4); }),
        joint<MotorJoint>("damping", [](MotorJoint& d) { d.damping = -1; }),
        joint<MouseJoint>("anchor", [](MouseJoint& d) { d.anchor.x = kNan; }),
        joint<MouseJoint>("target", [](MouseJoint& d) { d.target.y = kInf; }),
        joint<MouseJoint>("force", [](MouseJoint& d) { d.force = kNan; }),
        joint<MouseJoint>("hertz", [](MouseJoint& d) { d.hertz = 0; }),
        joint<MouseJoint>("damping", [](MouseJoint& d) { d.damping = kNan; }),
    });
}

template <typename Joint>
std::vector<Bad> badSprings() {
    return {joint<Joint>("hertz", [](Joint& d) { d.hertz = -1; }),
            joint<Joint>("hertz", [](Joint& d) { d.hertz = kNan; }),
            joint<Joint>("damping", [](Joint& d) { d.damping = kInf; })};
}

TEST(BadInput, InSpringsOfJointsIsRefused) {
    expectRefused(badSprings<RevoluteJoint>());
    expectRefused(badSprings<FixedJoint>());
    expectRefused(badSprings<PrismaticJoint>());
    expectRefused(badSprings<WheelJoint>());
    expectRefused({
        joint<RevoluteJoint>("target", [](RevoluteJoint& d) { d.target = kNan; }),
        joint<PrismaticJoint>("target", [](PrismaticJoint& d) { d.target = 2 * kMaxCoordinate; }),
        joint<DistanceJoint>("motorSpeed", [](DistanceJoint& d) { d.motorSpeed = kInf; }),
        joint<DistanceJoint>("motorForce", [](DistanceJoint& d) { d.motorForce = -1; }),
    });
}

TEST(BadInput, InAWheelPulleyOrGearJointIsRefused) {
    const auto limits = [](Range range) { return [=](WheelJoint& d) { d.limits = range; }; };
    const auto rack = [](Vec2 axis) { return [=](GearJoint& d) { d.rack = axis; }; };
    expectRefused({
        joint<WheelJoint>("axis", [](WheelJoint& d) { d.axis = Vec2{}; }),
        joint<WheelJoint>("limits.upper", limits({1, 0})),
        joint<WheelJoint>("limits.lower", limits({kNan, 0})),
        joint<WheelJoint>("motorSpeed", [](WheelJoint& d) { d.motorSpeed = kNan; }),
        joint<WheelJoint>("motorTorque", [](WheelJoint& d) { d.motorTorque = -1; }),
        joint<PulleyJoint>("groundA", [](PulleyJoint& d) { d.groundA.x = kNan; }),
        joint<PulleyJoint>("groundB", [](PulleyJoint& d) { d.groundB.y = 2 * kMaxCoordinate; }),
        joint<PulleyJoint>("length", [](PulleyJoint& d) { d.length = -1; }),
        joint<PulleyJoint>("ratio", [](PulleyJoint& d) { d.ratio = 0; }),
        joint<GearJoint>("ratio", [](GearJoint& d) { d.ratio = 0; }),
        joint<GearJoint>("ratio", [](GearJoint& d) { d.ratio = Real(-1e-30); }),
        joint<FilterJoint>("ends.breakForce", [](FilterJoint& d) { d.ends.breakForce = 1; }),
        joint<FilterJoint>("ends.breakTorque", [](FilterJoint& d) { d.ends.breakTorque = 1; }),
        joint<GearJoint>("ratio", [](GearJoint& d) { d.ratio = kNan; }),
        joint<GearJoint>("ratio", [](GearJoint& d) { d.ratio = 2000; }),
        joint<GearJoint>("rack", rack({1, 1})),
        joint<FilterJoint>("ends.collide", [](FilterJoint& d) { d.ends.collide = true; }),
    });
}

template <typename Change>
Bad settings(const char* field, Change change) {
    return {field, [=](Scene& scene) {
                StepSettings bad;
                change(bad);
                EXPECT_TRUE(check(WorldDef{.settings = bad}).has_value());
                EXPECT_THROW(World({.settings = bad}), BadDefinition);
                scene.world.setSettings(bad);
            }};
}

TEST(BadInput, InSettingsIsRefused) {
    const auto number = [](const char* field, Real SoftSettings::*member, Real value) {
        return settings(field, [=](StepSettings& s) { s.soft().*member = value; });
    };
    std::vector<Bad> rows{
        settings("settings.substeps", [](StepSettings& s) { s.soft().substeps = -1; }),
        settings("settings.contactPasses",
                 [](StepSettings& s) { s = thesis2006(), s.propagation().contactPasses = 0; }),
        settings("settings.contactPasses",
                 [](StepSettings& s) { s = thesis2006(), s.propagation().contactPasses = 1001; }),
        settings("settings.shockPasses",
                 [](StepSettings& s) { s = thesis2006(), s.propagation().shockPasses = -1; }),
        settings("settings.shockPasses",
                 [](StepSettings& s) { s = thesis2006(), s.propagation().shockPasses = 1001; }),
        settings("settings.sleepSteps", [](StepSettings& s) { s.sleepSteps = 0; }),
        settings("settings.sleepSteps", [](StepSettings& s) { s.sleepSteps = 1000001; }),
    };
    // The largest number would overflow in the products of a spring.
    for (const Real value : {Real(0), Real(-1), kNan, kInf, std::numeric_limits<Real>::max()}) {
        rows.push_back(number("settings.contactHertz", &SoftSettings::contactHertz, value));
        rows.push_back(number("settings.contactDamping", &SoftSettings::contactDamping, value));
        rows.push_back(number("settings.jointHertz", &SoftSettings::jointHertz, value));
        rows.push_back(number("settings.jointDamping", &SoftSettings::jointDamping, value));
        rows.push_back(number("settings.jointGap", &SoftSettings::jointGap, value));
        rows.push_back(number("settings.pushSpeed", &SoftSettings::pushSpeed, value));
    }
    expectRefused(rows);
}

TEST(BadInput, InOtherCallsOfAWorldIsRefused) {
    expectRefused({
        {"region",
         [](Scene& s) {
             s.world.setRegion(Aabb{{1, 0}, {0, 1}});
         }},
        {"region",
         [](Scene& s) {
             s.world.setRegion(Aabb{{kNan, 0}, {1, 1}});
         }},
        {"field", [](Scene& s) { s.world.addField({}); }},
        {"field",
         [](Scene& s) {
             s.world.setFields({s.world.fields()[0], {}});
         }},
        {"force",
         [](Scene& s) {
             s.world.applyForceToAll({kNan, 0});
         }},
        {"torque", [](Scene& s) { s.world.applyTorqueToAll(kInf); }},
        {"position",
         [](Scene& s) {
             s.world.clone(s.box, {0, kInf});
         }},
        {"part", [](Scene& s) { s.world.weld(s.ball, s.ball); }},
        {"radius", [](Scene& s) { s.world.weld(s.box, Circle{-1}, {}, 1); }},
        {"shape", [](Scene& s) { s.world.weld(s.box, Circle{2 * kMaxCoordinate}, {}, 1); }},
        {"material.restitution",
         [](Scene& s) { s.world.weld(s.box, Circle{1}, withFriction(1, 3), 1); }},
        {"density", [](Scene& s) { s.world.weld(s.box, Circle{1}, {}, 0); }},
        {"shape", [](Scene& s) { s.world.weld(s.box, Plane{}, {}, 1); }},

        {"part", [](Scene& s) { s.world.unweld(s.box, 0); }},
        {"part", [](Scene& s) { s.world.unweld(s.box, 5); }},
        {"flags", [](Scene& s) { s.world[s.box].setFlags(kMatchAll | kMatchEqual); }},
        {"joint",
         [](Scene& s) {
             s.world.remove(JointId{7, 1});
         }},
        {"joint",
         [](Scene& s) {
             s.world.setJoint({}, FixedJoint{.ends = {s.box, s.ball}});
         }},
        {"joint",
         [](Scene& s) {
             s.world.setJoint(s.pin, FixedJoint{.ends = {s.box, s.ball}});
         }},
        {"joint",
         [](Scene& s) {
             s.world.setJoint(s.pin, RevoluteJoint{.ends = {s.ball, s.box}});
         }},
        {"motorSpeed",
         [](Scene& s) {
             s.world.setJoint(s.pin, RevoluteJoint{.ends = {s.box, s.ball}, .motorSpeed = kNan});
         }},
    });
}

// A removed body is refused by its id, with BadBodyId.
TEST(BadInput, AJointOfARemovedBodyIsRefused) {
    Scene scene;
    const BodyId gone = scene.world.add(support::ballDef({20, 5}, 1));
    scene.world.remove(gone);
    const std::uint64_t before = scene.world.stateHash();
    EXPECT_THROW(scene.world.add(FixedJoint{.ends = {scene.box, gone}}), BadBodyId);
    EXPECT_THROW(scene.world.add(FixedJoint{.ends = {gone, scene.box}}), BadBodyId);
    EXPECT_THROW(scene.world.add(MouseJoint{.body = gone}), BadBodyId);
    EXPECT_EQ(scene.world.stateHash(), before);
}

// Invalid corners are refused and never corrected. An edge of 1 um beside 1 m is flat in float and
// refused at its corner. In double it is an edge on which the body lies.
TEST(BadInput, AnEdgeOfAMicrometreIsRefusedInFloatOnly) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyDef def{.shape = Polygon{{{0, 0}, {1, 0}, {1, Real(1e-6)}, {0, 1}}}};
    if (sizeof(Real) == 4) {
        const auto problem = check(def);
        ASSERT_TRUE(problem.has_value());
        EXPECT_EQ(problem->field, "shape.corners[2]");
        EXPECT_THROW(world.add(def), BadDefinition);
        return;
    }
    const BodyId body = world.add(def);
    EXPECT_EQ(world[body].part(0).convex.vertices.size(), 4u);
    support::run(world, 300);
    EXPECT_NE(world[body].flags() & kAsleep, 0u);
    EXPECT_TRUE(support::near(world[body].position().y, 0, world.tolerances().slop));
}

// Bodies of the smallest and largest sizes and densities stay finite in one World.
TEST(BadInput, ExtremesThatAreAllowedStayFinite) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    Real x = -40;
    for (const Real size : {Real(1e-4), Real(0.01), Real(1), Real(10)}) {
        for (const Real density : {kMinDensity, Real(1), kMaxDensity}) {
            BodyDef def = support::boxDef({x, size}, size, size);
            def.density = density;
            if (check(def)) {
                continue; // too light
            }
            world.add(def);
            def.shape = Circle{size / 2};
            def.position.y = 3 * size;
            world.add(def);
            x += 15;
        }
    }
    support::run(world, 300);
    for (const BodyId id : world.bodies()) {
        EXPECT_TRUE(isFinite(world[id].position()));
        EXPECT_LT(length(world[id].velocity()), 20);
    }
    EXPECT_GE(world.bodyCount(), 19u);
}

} // namespace
} // namespace kodo
