// SPDX-License-Identifier: MIT
// What the engine answers to typical mistakes: the field, the value, the range with its unit, and
// what to do.
#include <kodo/query.hpp>
#include <support/every_kind.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <string>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

struct Beginning {
    World world{{.gravity = support::kEarth}};
    BodyId box = world.add({.shape = Box{1, 1}, .position = {0, 5}});
    BodyId ball = world.add({.shape = Circle{1}, .position = {5, 5}});
    BodyId wall = world.add({.shape = Box{1, 4}, .type = BodyType::Static});
    BodyId ground = world.add({.shape = Plane{}, .type = BodyType::Static});

    JointEnds ends() const { return {.a = box, .b = ball}; }
};

struct Mistake {
    std::string sentence; // how it begins
    std::function<void(Beginning&)> make;
};

void expectSentences(const std::vector<Mistake>& mistakes) {
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(mistake.sentence);
        Beginning scene;
        const std::uint64_t before = scene.world.stateHash();
        try {
            mistake.make(scene);
            ADD_FAILURE() << "accepted";
        } catch (const BadDefinition& bad) {
            EXPECT_EQ(std::string(bad.what()).substr(0, mistake.sentence.size()), mistake.sentence)
                << bad.what();
        }
        EXPECT_EQ(scene.world.stateHash(), before);
    }
}

const bool kFloat = sizeof(Real) == 4;

TEST(Sentences, OfABody) {
    const auto add = [](const char* sentence, BodyDef def) {
        return Mistake{sentence, [=](Beginning& s) { s.world.add(def); }};
    };
    const Real far = 2 * kMaxCoordinate;
    expectSentences({
        add("shape.radius: must be greater than 0 m, but is -1", {.shape = Circle{-1}}),
        add(kFloat ? "position: x must be from -100000 to 100000 m, but is 200000"
                   : "position: x must be from -1e+13 to 1e+13 m, but is 2e+13",
            {.position = {far, 0}}),
        add("position: y must be from", {.position = {0, kNan}}),
        add("rotation: must be the {cosine, sine} of an angle, but is {90, 0}: use "
            "Rot::fromAngle(radians); 90 degrees are 1.5708 radians",
            {.rotation = {90, 0}}),
        add("density: must be from 1e-09 to 1e+09 kg/m^2, but is 0: BodyType::Static makes",
            {.density = 0}),
        add(kFloat ? "mass: must be from 1e-18 to 1e+18 kg, but is 0: BodyType::Static makes"
                   : "mass: must be from 1e-100 to 1e+100 kg, but is 0: BodyType::Static makes",
            {.mass = MassDef{.mass = 0}}),
        add("shape.corners[2]: lies on the line from corner 0 to corner 1, as far as numbers "
            "resolve: "
            "a triangle needs an area",
            {.shape = Polygon{{{0, 0}, {1, 1}, {2, 2}}}}),
        add("velocity: must be at most 1e+07 m/s long, but is {8e+06, 8e+06}, of length 113137",
            {.velocity = {Real(8e6), Real(8e6)}}),
        add("velocity: must be finite, but is {0, inf}", {.velocity = {0, kInf}}),
        add("angularVelocity: must be from -1e+07 to 1e+07 rad/s, but is 2e+07",
            {.angularVelocity = Real(2e7)}),
        add("flags: must not have bit 31, which is reserved", {.flags = 1u << 31}),
        add("flags: must not have bits 25 and 26: kNoSensors is of queries and",
            {.flags = 1u << 25}),
        add("required: must have a category with kMatchAny or kMatchAll, but is 0",
            {.flags = kMatchAny}),
        add("required: has no effect without a match mode: add kMatchNone, kMatchAny, kMatchAll or "
            "kMatchEqual "
            "to flags",
            {.required = 1}),
        add("velocity: must be zero for a static body: make it Kinematic",
            {.velocity = {1, 0}, .type = BodyType::Static}),
        add("angularVelocity: must be zero for a static body: make it Kinematic",
            {.angularVelocity = 1, .type = BodyType::Static}),
        add("mass: must be from", {.mass = MassDef{}}),
        add("mass.inertia: must be from", {.mass = MassDef{.mass = 1, .inertia = -1}}),
        add("mass: must not be set for a body with a plane, which has no mass",
            {.shape = Plane{}, .mass = MassDef{.mass = 1}, .type = BodyType::Static}),
        add("shape.corners[2]: is the same point as corner 1: leave it out, or use convexHull()",
            {.shape = Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}}),
        add("shape.corners: must be from 3 to 1024 points, but there are 2",
            {.shape = Polygon{{{0, 0}, {1, 0}}}}),
        add("shape.parts: must be from 1 to 65535 primitives, but there are 0",
            {.shape = Compound{}}),
        add("shape.heights: must be from 2 to 65536 numbers, but there are 1",
            {.shape = Heightmap{{}, 1, {0}}, .type = BodyType::Static}),
        add("type: must be Static or Kinematic: a plane has no mass", {.shape = Plane{}}),
        add("type: must be Static or Kinematic: a plane has no mass",
            {.shape = Compound{{Circle{1}, Plane{}}}}),
        add("type: must be Static or Kinematic: a heightmap is ground; for a body that moves "
            "freely, give a Compound of its segments",
            {.shape = Heightmap{{}, 1, {0, 0}}}),
        add("shape.to: must differ from `from`, but both are {1, 2}",
            {.shape = Segment{{1, 2}, {1, 2}}}),
        add("shape.points: must be from 3 to 65535, but there are 2",
            {.shape = Chain{.points = {{0, 0}, {1, 0}}, .closed = true}}),
        add("shape.points[2]: must differ from `points[1]`, but both are {1, 0}",
            {.shape = Chain{.points = {{0, 0}, {1, 0}, {1, 0}}}}),
        add("shape.normal: must be a unit vector, but is {0, 2}, of length 2: use normalize()",
            {.shape = Plane{{0, 2}}, .type = BodyType::Static}),
        add(kFloat
                ? "shape: must lie within 100000 m of the origin of its frame, but reaches to "
                  "200000"
                : "shape: must lie within 1e+13 m of the origin of its frame, but reaches to 2e+13",
            {.shape = Circle{far}}),
    });
}

TEST(Sentences, OfAJoint) {
    const auto add = [](const char* sentence, auto change) {
        return Mistake{sentence, [=](Beginning& s) { s.world.add(change(s)); }};
    };
    expectSentences({
        add("ends.a: is not set: give the id", [](Beginning&) { return RevoluteJoint{}; }),
        add("ends.b: is not set: give the id",
            [](Beginning& s) { return FixedJoint{.ends = {.a = s.box}}; }),
        add("body: is not set: give the id", [](Beginning&) { return MouseJoint{}; }),
        add("ends.breakForce: must be greater than 0 N, but is -5: the default, kUnbreakable,",
            [](Beginning& s) {
                return FixedJoint{.ends = {.a = s.box, .b = s.ball, .breakForce = -5}};
            }),
        add("limits.lower: must be from -10000 to 10000 rad, but is -36000",
            [](Beginning& s) {
                return RevoluteJoint{.ends = s.ends(), .limits = Range{-36000, 90}};
            }),
        add("ratio: is 0, so the gear would not turn: give the speed of b per speed of a",
            [](Beginning& s) { return GearJoint{.ends = s.ends(), .ratio = 0}; }),
        add("ends.collide: is true, so the joint would do nothing",
            [](Beginning& s) {
                return FilterJoint{.ends = {.a = s.box, .b = s.ball, .collide = true}};
            }),
        add("limits.upper: must be at least limits.lower, which is 1 rad, but is 0",
            [](Beginning& s) {
                return RevoluteJoint{.ends = s.ends(), .limits = Range{1, 0}};
            }),
        add("motorTorque: must be finite and at least 0 N m, but is inf",
            [](Beginning& s) { return RevoluteJoint{.ends = s.ends(), .motorTorque = kInf}; }),
        add("axis: must be a unit vector, but is {1, 1}, of length 1.41421",
            [](Beginning& s) {
                return PrismaticJoint{.ends = s.ends(), .axis = {1, 1}};
            }),
        add("hertz: is 0 and there are no limits, so the joint would do nothing: set hertz for a "
            "spring, equal limits for a rod",
            [](Beginning& s) { return DistanceJoint{.ends = s.ends()}; }),
        add("force: and torque are 0, so the joint would do nothing: set the largest force, the "
            "largest torque, or both",
            [](Beginning& s) { return MotorJoint{.ends = s.ends()}; }),
        add("force: is 0, so the joint would do nothing: set the largest force",
            [](Beginning& s) { return MouseJoint{.body = s.box}; }),
    });
}

TEST(Sentences, OfAJointIdAreThoseOfABodyId) {
    Beginning scene;
    World other;
    const BodyId a = other.add({});
    const BodyId b = other.add({.position = {3, 0}});
    const JointId foreign = other.add(RevoluteJoint{.ends = {a, b}});
    const JointId gone = scene.world.add(RevoluteJoint{.ends = scene.ends()});
    scene.world.remove(gone);
    scene.world.add(RevoluteJoint{.ends = scene.ends()}); // in the same slot
    const auto sentence = [&](JointId id) {
        try {
            scene.world.remove(id);
        } catch (const BadDefinition& bad) {
            return std::string(bad.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(sentence({}), "joint: the null id JointId{} names no joint");
    EXPECT_EQ(sentence(foreign), "joint: joint 0 of generation 1 belongs to another World");
    EXPECT_EQ(sentence(gone), "joint: joint 0 of generation 1 is not in this World: it was "
                              "removed, broke, or never added");
}

TEST(Sentences, OfACallWithSeveralBodiesNameTheIdThatIsNone) {
    Beginning scene;
    World other;
    const BodyId foreign = other.add({});
    const BodyId gone = scene.world.add({});
    scene.world.remove(gone);
    const std::string ofForeign = "body 0 of generation 1 belongs to another World";
    const std::string ofGone =
        "body 4 of generation 1 is not in this World: it was removed, or never added";
    const auto expect = [&](const std::string& sentence, auto call) {
        SCOPED_TRACE(sentence);
        const std::uint64_t before = scene.world.stateHash();
        try {
            call();
            ADD_FAILURE() << "accepted";
        } catch (const BadBodyId& bad) {
            EXPECT_EQ(std::string(bad.what()), sentence);
        }
        EXPECT_EQ(scene.world.stateHash(), before);
    };
    const auto expectEnds = [&](const JointEnds& ends, const std::string& text) {
        const support::EveryKind<JointDef> kinds{RevoluteJoint{.ends = ends},
                                                 FixedJoint{.ends = ends},
                                                 DistanceJoint{.ends = ends, .hertz = 1},
                                                 PrismaticJoint{.ends = ends},
                                                 MotorJoint{.ends = ends, .force = 1},
                                                 MouseJoint{.body = gone, .force = 1},
                                                 WheelJoint{.ends = ends},
                                                 PulleyJoint{.ends = ends},
                                                 GearJoint{.ends = ends},
                                                 FilterJoint{.ends = ends}};
        for (const JointDef& def : kinds.list) {
            const bool one = std::holds_alternative<MouseJoint>(def);
            expect(one ? "body: " + ofGone : text, [&] { scene.world.add(def); });
        }
    };
    expectEnds({.a = gone, .b = scene.box}, "ends.a: " + ofGone);
    expectEnds({.a = scene.box, .b = gone}, "ends.b: " + ofGone);
    expectEnds({.a = foreign, .b = scene.box}, "ends.a: " + ofForeign);
    expectEnds({.a = scene.box, .b = foreign}, "ends.b: " + ofForeign);
    expect("into: " + ofGone, [&] { scene.world.weld(gone, scene.box); });
    expect("part: " + ofForeign, [&] { scene.world.weld(scene.box, foreign); });
    expect("part: the null id BodyId{} names no body", [&] { scene.world.weld(scene.box, {}); });
    expect(ofGone, [&] { scene.world.remove(gone); }); // one id: no name
}

TEST(Sentences, OfOtherCalls) {
    expectSentences({
        {"part: must be below 1, the number of parts of the body, but is 5",
         [](Beginning& s) { s.world.unweld(s.box, 5); }},
        {"part: is the only part of the body", [](Beginning& s) { s.world.unweld(s.box, 0); }},
        {"part: must not be the body that it is welded to",
         [](Beginning& s) { s.world.weld(s.box, s.box); }},
        {"part: is a plane, which has no mass: weld it to a static or kinematic body",
         [](Beginning& s) { s.world.weld(s.box, s.ground); }},
        {"shape: is a plane, which has no mass: weld it to a static or kinematic body",
         [](Beginning& s) { s.world.weld(s.box, Plane{}, {}, 1); }},
        {"region: must not be NaN, but reaches from {nan, 0} to {1, 1}",
         [](Beginning& s) {
             s.world.setRegion(Aabb{{kNan, 0}, {1, 1}});
         }},
        {"region: must have lower <= upper on both axes, but reaches from {1, 0} to {0, 1}",
         [](Beginning& s) {
             s.world.setRegion(Aabb{{1, 0}, {0, 1}});
         }},
        {"dt: must be from 1e-07 to 1 s, but is 16: it is in seconds; divide a longer time into "
         "several steps",
         [](Beginning& s) { s.world.step(16); }},
        {"dt: must be from 1e-07 to 1 s, but is 0: 1/60 divides integers, which gives 0; write "
         "1.0f / 60",
         [](Beginning& s) { s.world.step(1 / 60); }},
        {"dt: must be from 1e-07 to 1 s, but is 0: 1/60 divides integers",
         [](Beginning& s) {
             s.world[s.box].moveTo({0, 5}, 1 / 60);
         }},
        {"velocity: must be zero for a static body: make it Kinematic",
         [](Beginning& s) {
             s.world[s.wall].setVelocity({1, 0});
         }},
        {"angularVelocity: must be zero for a static body: make it Kinematic",
         [](Beginning& s) { s.world[s.wall].setAngularVelocity(1); }},
        {"force: must be finite, but is {nan, 0}",
         [](Beginning& s) {
             s.world[s.box].applyForce({kNan, 0});
         }},
        {"velocity after the impulse: must be at most 1e+07 m/s long",
         [](Beginning& s) {
             s.world[s.box].applyImpulse({Real(8e6), Real(8e6)}); // 1 kg
         }},
        {"velocity: must be at most 1e+07 m/s long",
         [](Beginning& s) {
             s.world[s.box].setVelocity({Real(8e6), Real(8e6)});
         }},
        {"position: is too far to be reached in dt = 1e-07 s: it takes 1e+09 m/s, but a body has "
         "at most 1e+07 m/s",
         [](Beginning& s) {
             s.world[s.box].moveTo({100, 5}, Real(1e-7));
         }},
        {"position: and rotation must be the present ones for a static body: make it Kinematic",
         [](Beginning& s) {
             s.world[s.wall].moveTo({1, 0}, 1);
         }},
        {"rotation: is too far to be reached in dt = 1e-07 s: it takes",
         [](Beginning& s) {
             s.world[s.box].moveTo({0, 5}, Rot{-1, 0}, Real(1e-7));
         }},
    });
}

TEST(Sentences, OfFlagsThatUnlockAPlaneNameTheFlags) {
    Beginning scene;
    scene.world[scene.ground].setFlags(kLockMove | kLockRotate);
    scene.world[scene.ground].setType(BodyType::Dynamic); // held by its locks
    try {
        scene.world[scene.ground].setFlags(0);
        ADD_FAILURE() << "accepted";
    } catch (const BadDefinition& bad) {
        EXPECT_EQ(std::string(bad.what()),
                  "flags: must have kLockMove and kLockRotate: a plane has no mass");
    }
}

// Bodies at the limit of speed keep it: what is accepted is not frozen by the next step.
TEST(Sentences, ASpeedThatIsAcceptedIsNotFrozen) {
    World world;
    const Real most = Real(0.7071) * kMaxSpeed;
    const BodyId ball = world.add({.velocity = {most, most}});
    world.step(kMinTimeStep);
    EXPECT_TRUE(world.frozenBodies().empty());
    world[ball].setVelocity({0, -kMaxSpeed});
    world.step(kMinTimeStep);
    EXPECT_TRUE(world.frozenBodies().empty());
}

TEST(Sentences, OfAFilter) {
    const CollisionFilter two{kMatchAny | kMatchAll, 1};
    const CollisionFilter none{0, 1};
    const CollisionFilter sensor{kMatchAny | kSensor, 1};
    const std::pair<CollisionFilter, const char*> refused[] = {
        {two, "which.flags: must have one of kMatchNone, kMatchAny, kMatchAll and "
              "kMatchEqual at most"},
        {none, "which.required: has no effect without a match mode: add kMatchNone, kMatchAny, "
               "kMatchAll or "
               "kMatchEqual to which.flags"},
        {sensor, "which.flags: must have a match mode alone: a filter does not compare locks"},
        {{2, 0},
         "which.flags: must have a match mode alone: put the categories to find into "
         "which.required, as {kMatchAny, categories}"},
        {{kMatchAny | 2, 4}, "which.flags: must have a match mode alone: put the categories"},
        {{kMatchAny, 0},
         "which.required: must name the categories to find: with kMatchAny or "
         "kMatchAll, 0 finds nothing"},
        {{kMatchAll, 0}, "which.required: must name the categories to find"},
    };
    std::vector<Mistake> mistakes;
    for (const auto& mistake : refused) {
        const CollisionFilter which = mistake.first;
        const std::string sentence = mistake.second;
        const auto add = [&](std::function<void(Beginning&)> make) {
            mistakes.push_back({sentence, std::move(make)});
        };
        add([=](Beginning& s) { rayCast(s.world, {}, {1, 0}, which); });
        add([=](Beginning& s) { rayCastAll(s.world, {}, {1, 0}, which); });
        add([=](Beginning& s) {
            visitRay(
                s.world, {}, {1, 0}, [](const QueryHit&) { return true; }, which);
        });
        add([=](Beginning& s) { shapeCast(s.world, Circle{1}, {}, {1, 0}, which); });
        add([=](Beginning& s) { overlap(s.world, Aabb{}, which); });
        add([=](Beginning& s) { overlap(s.world, Circle{1}, {}, which); });
        add([=](Beginning& s) {
            visitOverlaps(
                s.world, Circle{1}, {}, [](BodyId) { return true; }, which);
        });
        add([=](Beginning& s) { closestPoint(s.world, {}, 1, which); });
        add([=](Beginning& s) { s.world.applyForceToAll({1, 0}, which); });
        add([=](Beginning& s) { s.world.applyTorqueToAll(1, which); });
        add([=](Beginning& s) {
            s.world.addField({std::make_shared<Gravity>(Vec2{0, 1}), which});
        });
        add([=](Beginning& s) {
            s.world.setFields({{std::make_shared<Gravity>(Vec2{0, 1}), which}});
        });
    }
    expectSentences(mistakes);
}

TEST(Sentences, OfAQuery) {
    const Real far = 2 * kMaxQueryCoordinate;
    expectSentences({
        {"from: x must be from ",
         [=](Beginning& s) {
             rayCast(s.world, {far, 0}, {});
         }},
        {"to: y must be from ",
         [=](Beginning& s) {
             rayCastAll(s.world, {}, {0, -far});
         }},
        {"to: must differ from `from`, but both are {1, 2}: overlap() with a Point",
         [](Beginning& s) {
             rayCast(s.world, {1, 2}, {1, 2});
         }},
        {"to: y must be from ",
         [](Beginning& s) {
             visitRay(s.world, {}, {0, kNan}, [](const QueryHit&) { return true; });
         }},
        {"start: x must be from ",
         [=](Beginning& s) {
             shapeCast(s.world, Circle{1}, {{far, 0}, {}}, {1, 0});
         }},
        {"displacement: leads too far: x must be from ",
         [=](Beginning& s) {
             shapeCast(s.world, Circle{1}, {}, {far, 0});
         }},
        {"displacement: must be finite, but is {nan, 0}",
         [](Beginning& s) {
             shapeCast(s.world, Circle{1}, {}, {kNan, 0});
         }},
        {"radius: must be greater than 0 m, but is 0",
         [](Beginning& s) {
             shapeCast(s.world, Circle{0}, {}, {1, 0});
         }},
        {"box: x must be from ",
         [=](Beginning& s) {
             overlap(s.world, Aabb{{-far, 0}, {}});
         }},
        {"box: must have lower <= upper on both axes, but reaches from {1, 0} to {0, 0}",
         [](Beginning& s) {
             overlap(s.world, Aabb{{1, 0}, {}});
         }},
        {"at: y must be from ",
         [=](Beginning& s) {
             overlap(s.world, Circle{1}, {{0, far}, {}});
         }},
        {"at: must be the {cosine, sine} of an angle",
         [](Beginning& s) {
             overlap(s.world, Circle{1}, {{}, {2, 0}});
         }},
        {"shape: reaches too far: x must be from ",
         [=](Beginning& s) { overlap(s.world, Circle{far}, {}); }},
        {"point: x must be from ",
         [=](Beginning& s) {
             closestPoint(s.world, {far, 0}, 1);
         }},
        {"maxDistance: must be at least 0 m, or infinite for the whole World, but is -1",
         [](Beginning& s) { closestPoint(s.world, {}, -1); }},
        {"visit: must not be empty",
         [](Beginning& s) {
             visitRay(s.world, {}, {1, 0}, {});
         }},
        {"visit: must not be empty",
         [](Beginning& s) { visitOverlaps(s.world, Circle{1}, {}, {}); }},
    });
}

// Queries answer right up to their largest coordinate, in each length unit.
TEST(Query, AnswersRightAtItsLargestCoordinate) {
    for (const Real unit : {Real(1e-6), Real(1), Real(1e6)}) {
        SCOPED_TRACE(unit);
        World world({.lengthUnit = unit});
        const BodyDef round{.shape = Circle{unit}, .type = BodyType::Static};
        const BodyDef sided{
            .shape = Box{2 * unit, 2 * unit}, .position = {4 * unit, 0}, .type = BodyType::Static};
        ASSERT_FALSE(check(round, unit));
        const BodyId ball = world.add(round);
        const BodyId box = world.add(sided);
        const Real far = kMaxQueryCoordinate * unit;
        EXPECT_EQ(rayCastAll(world, {-far, 0}, {far, 0}).size(), 2u);
        EXPECT_EQ(rayCastAll(world, {0, far}, {0, -far}).size(), 1u);
        EXPECT_EQ(rayCast(world, {4 * unit, 0}, {far, far})->body, box);
        EXPECT_FALSE(rayCast(world, {-4 * unit, 0}, {-far, far}));
        EXPECT_TRUE(shapeCast(world, Circle{unit}, {{-9 * unit, 0}, {}}, {far, 0}));
        EXPECT_TRUE(shapeCast(world, Box{unit, unit}, {{-9 * unit, 0}, {}}, {far, 0}));
        EXPECT_EQ(overlap(world, Aabb{{-far, -far}, {far, far}}).size(), 2u);
        EXPECT_TRUE(closestPoint(world, {far, far}, kInf));
        EXPECT_EQ(closestPoint(world, {-9 * unit, 0}, kInf)->body, ball);
        EXPECT_FALSE(closestPoint(world, {-9 * unit, 0}, unit));
    }
}

TEST(Query, AtAnInfiniteDistanceFindsTheClosestBodyOfTheWholeWorld) {
    Beginning scene;
    const auto near = closestPoint(scene.world, {1000, 5}, kInf);
    ASSERT_TRUE(near);
    EXPECT_EQ(near->body, scene.ground);
    scene.world.remove(scene.ground);
    EXPECT_EQ(closestPoint(scene.world, {1000, 5}, kInf)->body, scene.ball);
    EXPECT_FALSE(closestPoint(World{}, {}, kInf));
}

} // namespace
} // namespace kodo
