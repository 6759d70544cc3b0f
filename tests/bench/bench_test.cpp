// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench_report.hpp"

namespace bench {

/// Names a recipe in messages of failing tests.
void PrintTo(const Recipe& recipe, std::ostream* out) {
    *out << recipe.name;
}

namespace {

RunOptions shortRun(const Recipe& recipe, const std::string& engine) {
    RunOptions options;
    options.scene = recipe.name;
    options.engine = engine;
    options.size = std::min(recipe.size, 12);
    options.steps = 3;
    return options;
}

class EveryScene : public testing::TestWithParam<Recipe> {};

// Box2D stores masses in float, like the float build of Kodo: 1e-5 is a hundred roundings.
void expectTheSameInEveryEngine(const Recipe& recipe) {
    const Result box2d = run(shortRun(recipe, "box2d"));
    for (const std::string& engine : builtEngines()) {
        const Result other = run(shortRun(recipe, engine));
        EXPECT_EQ(other.bodies, box2d.bodies) << engine;
        EXPECT_EQ(other.locked, box2d.locked) << engine;
        EXPECT_NEAR(other.mass, box2d.mass, 1e-5 * box2d.mass) << engine;
        EXPECT_EQ(other.escaped, box2d.escaped) << engine;
    }
}

TEST_P(EveryScene, HasTheSameBodiesAndMassInEveryEngine) {
    expectTheSameInEveryEngine(GetParam());
}

TEST(Scenes, OfTheSandboxHaveTheSameBodiesAndMassInEveryEngine) {
    int played = 0;
    for (const Recipe& recipe : sandboxRecipes()) {
        try {
            recipe.make(recipe.size, 1);
        } catch (const WrongUse&) {
            continue; // it has what the benchmark has not
        }
        SCOPED_TRACE(recipe.name);
        expectTheSameInEveryEngine(recipe);
        ++played;
    }
    EXPECT_GE(played, 35);
    RunOptions other;
    other.scene = "Wind";
    EXPECT_THROW(run(other), WrongUse);
}

TEST_P(EveryScene, EndsInTheSameStateWhenRunAgain) {
    for (const std::string& engine : builtEngines()) {
        const RunOptions options = shortRun(GetParam(), engine);
        EXPECT_EQ(run(options).stateHash, run(options).stateHash) << engine;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(recipes().begin(), recipes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

// Results for these scenes in other engines are comparable only with these exact sizes.
TEST(Scenes, HaveTheirDocumentedSizes) {
    const auto made = [](const char* name, int size) {
        return recipeOf(name).make(size, 1).def.bodies;
    };
    EXPECT_EQ(made("pyramid", 100).size(), 1u + 5050u);
    EXPECT_EQ(recipeOf("pyramid").steps, 300);
    for (const char* name : {"stack", "circles", "debris", "tumbler", "massratio"}) {
        EXPECT_EQ(recipeOf(name).steps, 600) << name;
    }
    const auto circles = made("circles", 5000);
    EXPECT_EQ(circles.size(), 3u + 5000u);
    EXPECT_NEAR(circles[2].position.x - circles[1].position.x, 60 + 1, 1e-12); // walls are 1 m
                                                                               // thick
    EXPECT_EQ(std::get<scenes::Circle>(circles[3].parts[0]).radius, 0.25);
    const auto debris = made("debris", 2000);
    EXPECT_NEAR(debris[2].position.x - debris[1].position.x, 50 + 1, 1e-12);
    EXPECT_EQ(std::count_if(debris.begin(), debris.end(),
                            [](const scenes::BodyDef& body) { return body.parts.size() == 2; }),
              2000 / 5);
    const auto tumbler = made("tumbler", 2000);
    EXPECT_NEAR(tumbler[0].spin, 25 * std::numbers::pi / 180, 1e-12);
    EXPECT_EQ(std::get<scenes::Box>(tumbler[0].parts[2]).height, 20); // between the other two
    EXPECT_EQ(std::get<scenes::Box>(tumbler[1].parts[0]).width, 0.25);
    const auto breakout = made("breakout", 200);
    EXPECT_EQ(breakout.size(), 4u + 300u + 8u + 200u);
    const scenes::BodyDef& ball = breakout[304];
    EXPECT_NEAR(std::sqrt(dot(ball.velocity, ball.velocity)), 25, 1e-12);
    EXPECT_TRUE(ball.weightless);
    EXPECT_EQ(ball.material.friction, 0);
    EXPECT_EQ(recipeOf("breakout").steps, 1200);
    const auto massRatio = made("massratio", 1000);
    EXPECT_EQ(massRatio.size(), 1u + 11u);
    EXPECT_EQ(massRatio[11].density, 1000 * massRatio[10].density);
}

BodyState at(double x, double y, scenes::Rot rotation = {}) {
    return {{x, y}, rotation, {}, 0};
}

// Plain geometry in long double with a double result: 1e-12 is far above the rounding.
TEST(Ruler, MeasuresKnownOverlaps) {
    const scenes::Part unit = scenes::Box{1, 1};
    const scenes::Part disc = scenes::Circle{0.5};
    const scenes::Part triangle = scenes::Polygon{{{-1, -1}, {1, -1}, {0, 1}}};
    EXPECT_NEAR(overlapOf(unit, at(0, 0), unit, at(0.9, 0.3)), 0.1, 1e-12);
    EXPECT_NEAR(overlapOf(unit, at(0, 0), unit, at(1.5, 0)), -0.5, 1e-12);
    EXPECT_NEAR(overlapOf(disc, at(0, 0), disc, at(0.6, 0.6)), 1 - 0.6 * std::numbers::sqrt2,
                1e-12);
    EXPECT_NEAR(overlapOf(unit, at(0, 0), disc, at(0, 0.75)), 0.25, 1e-12);
    EXPECT_NEAR(overlapOf(disc, at(0.8, 0.8), unit, at(0, 0)), 0.5 - 0.3 * std::numbers::sqrt2,
                1e-12);
    EXPECT_NEAR(overlapOf(unit, at(0, 0), disc, at(0, 0.25)), 0.75, 1e-12); // centre inside
    EXPECT_NEAR(overlapOf(triangle, at(0, 0), unit, at(0, 1.25)), 0.25, 1e-12);
    // A quarter turn and an eighth: the corner of the rotated box reaches sqrt(2) / 2 down.
    const scenes::Rot turned = scenes::slope(1, 1);
    EXPECT_NEAR(overlapOf(unit, at(0, 0), unit, at(0, 1.1, turned)), std::numbers::sqrt2 / 2 - 0.6,
                1e-12);
}

/// Bodies at their definition.
std::vector<Placed> placed(const scenes::SceneDef& scene) {
    std::vector<Placed> list;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const scenes::BodyDef& body = scene.bodies[i];
        list.push_back({i, &body, {body.position, body.rotation, body.velocity, body.spin}});
    }
    return list;
}

TEST(Ruler, TakesTheMeanOverThePairsThatOverlap) {
    scenes::SceneDef scene;
    scene.bodies = {scenes::ground(20), scenes::box(1, 1, {0, 0.49}), scenes::box(1, 1, {0, 1.46}),
                    scenes::box(1, 1, {5, 3})};
    const Depths depths = depthsOf(placed(scene), {});
    EXPECT_EQ(depths.pairs, 2u);
    EXPECT_NEAR(depths.max, 0.03, 1e-12);
    EXPECT_NEAR(depths.mean, 0.02, 1e-12);
}

TEST(Ruler, IgnoresPairsThatCannotCollide) {
    scenes::SceneDef scene;
    scene.bodies = {scenes::box(1, 1, {0, 0}),  scenes::box(1, 1, {0.5, 0}),
                    scenes::box(1, 1, {10, 0}), scenes::box(1, 1, {10.5, 0}),
                    scenes::box(1, 1, {20, 0}), scenes::box(1, 1, {20.5, 0})};
    EXPECT_EQ(depthsOf(placed(scene), {}).pairs, 3u);
    scene.bodies[0].locked = scene.bodies[1].locked = true;
    scene.bodies[2].category = 1;
    scene.bodies[3].category = 2;
    scene.bodies[3].mask = 2;
    scene.joints = {{5, 4, {20.25, 0}}};
    EXPECT_EQ(depthsOf(placed(scene), jointedPairs(scene)).pairs, 0u);
}

TEST(Ruler, CountsStandingAndEscapedBodies) {
    scenes::SceneDef scene;
    scene.bodies = {scenes::ground(20), scenes::ball(0.5, {0, 1}), scenes::ball(0.5, {2, 1}),
                    scenes::ball(0.5, {4, 1})};
    std::vector<Placed> bodies = placed(scene);
    bodies[1].state.position = {0.2, 0.1};
    bodies[2].state.position = {2.3, 1};
    bodies[3].state.position = {4, -0.5};
    const Drift displacement = driftOf(bodies);
    EXPECT_EQ(displacement.stood, 1u);
    EXPECT_NEAR(displacement.sideways, 0.3, 1e-12);
    EXPECT_NEAR(displacement.down, 1.5, 1e-12);
    bodies[1].state.position.y = std::nan("");
    EXPECT_EQ(escapedFrom({{-5, 0}, {5, 5}}, bodies), 2u);
    // In the frame of body 2, rotated by a quarter turn, the third body is 1.7 m right and 1.5 m
    // up. The first body has no finite position.
    bodies[2].state.rotation = {0, -1};
    EXPECT_EQ(escapedFrom({{-1, -1}, {1.6, 1.8}, 2}, bodies), 1u);
    EXPECT_EQ(escapedFrom({{-1, -1}, {1.4, 1.8}, 2}, bodies), 2u);
}

// m v^2 / 2 + I w^2 / 2 with m = pi r^2, I = m r^2 / 2: 2 pi + pi for r = 1, v = 2, w = 2.
TEST(Ruler, AddsUpKineticEnergy) {
    scenes::SceneDef scene;
    scene.bodies = {scenes::ball(1, {0, 0}), scenes::ground(10)};
    scene.bodies[0].velocity = {2, 0};
    scene.bodies[0].spin = 2;
    scene.bodies[1].velocity = {5, 0}; // kinematic: not part of the energy
    EXPECT_NEAR(kineticEnergy(placed(scene)), 3 * std::numbers::pi, 1e-12);
}

TEST(Runs, MeasureTheLongestStepIfTheSceneOrAnOptionSaysSo) {
    RunOptions options;
    options.scene = "stack";
    options.steps = 10;
    EXPECT_FALSE(run(options).worstSeconds);
    options.worst = true;
    const Result result = run(options);
    ASSERT_TRUE(result.worstSeconds);
    EXPECT_GE(*result.worstSeconds, result.cpuSeconds / 10);
    EXPECT_LE(*result.worstSeconds, result.cpuSeconds);
    options.scene = "columns";
    options.size = 2;
    options.worst = false;
    EXPECT_TRUE(run(options).worstSeconds);
}

TEST(Runs, ReadTheContactsOfAStackInEveryEngine) {
    const Scene scene = recipeOf("stack").make(3, 1);
    StepOptions options;
    options.events = true;
    for (const std::string& name : builtEngines()) {
        const std::unique_ptr<Engine> engine = makeEngine(name, scene.def, options);
        for (int i = 0; i < 300; ++i) {
            engine->step(kDt);
        }
        // 3 + 2 + 1 weights of 10 N over a step; 5 % covers what still moves.
        EXPECT_NEAR(engine->readContacts(), 60 * kDt, 0.05 * 60 * kDt) << name;
        if (!name.starts_with("box2d") || name == "box2d3") { // the others have no such list
            EXPECT_EQ(engine->readEvents(), 0) << name << ": nothing begins, ends or hits";
        }
        engine->push(3, {0, 5});
        EXPECT_EQ(engine->state(3).velocity.y, 5) << name;
        engine->step(kDt);
        EXPECT_GT(engine->state(3).velocity.y, 4) << name;
    }
}

// Two boxes: b may turn by 0.25 rad to either side, and falls about the joint at its left end.
TEST(Joints, KeepTheirLimitsInEveryEngine) {
    scenes::SceneDef scene{"limits", scenes::kDown, {}};
    scene.bodies = {wall(1, 1, {0, 0}), scenes::box(1, 0.1, {1, 0})};
    scene.joints = {{0, 1, {0.5, 0}, 0, 0, scenes::AngleLimits{-0.25, 0.25}}};
    for (const std::string& name : builtEngines()) {
        const std::unique_ptr<Engine> engine = makeEngine(name, scene, {});
        for (int i = 0; i < 300; ++i) {
            engine->step(kDt);
        }
        const scenes::Rot rotation = engine->state(1).rotation;
        // Box2D 2.4.1 leaves 2 degrees of slop, 0.035 rad.
        EXPECT_NEAR(std::atan2(rotation.s, rotation.c), -0.25, 0.04) << name;
    }
}

// Box2D allows an overlap of 5 mm per contact (slop) and adds a skin of 10 mm to each polygon. With
// the skin removed, a stack of three stays within three slops of its position. Otherwise the top
// would be lifted by at least 45 mm.
TEST(Box2dInTheBench, HasItsSurfacesWhereTheNominalShapesAre) {
    RunOptions options;
    options.scene = "stack";
    options.engine = "box2d";
    options.size = 3;
    options.steps = 300;
    const Result result = run(options);
    EXPECT_GT(result.depths.pairs, 0u); // touch at the nominal surfaces
    EXPECT_LT(result.depths.max, 0.006);
    ASSERT_EQ(result.errorName, "top sinks"); // or is lifted, in mm
    EXPECT_LT(result.error, 15);
}

// Box2D 3 has neither skin nor slop: the stack sinks by its soft contacts alone.
TEST(Box2d3InTheBench, HasItsSurfacesWhereTheNominalShapesAre) {
    RunOptions options;
    options.scene = "stack";
    options.engine = "box2d3";
    options.size = 3;
    options.steps = 300;
    if (!hasBox2d3()) {
        EXPECT_THROW(run(options), WrongUse);
        return;
    }
    const Result result = run(options);
    EXPECT_GT(result.depths.pairs, 0u);
    EXPECT_LT(result.depths.max, 0.006);
    EXPECT_LT(result.error, 15);
    options.step.substeps = 8;
    options.step.set = {"contactHertz=60"};
    EXPECT_LT(run(options).error, result.error);
    for (const char* wrong : {"contactHertz", "contactHertz=-1", "contactHertz=6x", "mass=3"}) {
        options.step.set = {wrong};
        EXPECT_THROW(run(options), WrongUse) << wrong;
    }
    options.step.set = {};
    options.step.passes = 8;
    EXPECT_THROW(run(options), WrongUse);
}

// At most 120 bytes per contact in the solver passes, 232 in double: a large pile must fit into the
// caches near the core. The row is the only home of what changes from step to step.
TEST(Memory, AContactRowIsSmall) {
    RunOptions options;
    options.scene = "stack";
    options.size = 3;
    options.steps = 3;
    for (const auto& [engine, most] : {std::pair("kodo", 120u), std::pair("kodo64", 232u)}) {
        options.engine = engine;
        const Result result = run(options);
        ASSERT_TRUE(result.contactBytes);
        EXPECT_GT(result.contactBytes->row, 0u);
        EXPECT_LE(result.contactBytes->row, most);
        EXPECT_GT(result.contactBytes->all, result.contactBytes->row);
        EXPECT_GT(result.bytesPerBody, 0);
    }
}

TEST(Memory, ASnapshotAndACopyAreMeasuredOnRequest) {
    RunOptions options;
    options.scene = "stack";
    options.size = 3;
    options.steps = 3;
    options.engine = "kodo";
    EXPECT_FALSE(run(options).snapshot);
    options.snapshot = true;
    const Result result = run(options);
    ASSERT_TRUE(result.snapshot && result.copy);
    EXPECT_GT(result.snapshot->bytes, 0u);
    EXPECT_GT(result.copy->bytes, 0u);
    options.engine = "box2d"; // without a call for it
    EXPECT_THROW(run(options), WrongUse);
}

TEST(Options, AreRefusedIfTheEngineDoesNotSupportThem) {
    RunOptions options;
    options.scene = "stack";
    options.steps = 1;
    options.step.profile = "nonesuch";
    EXPECT_THROW(run(options), WrongUse);
    options.step.profile = kBalanced;
    options.step.leaveOut = {"gravity"};
    EXPECT_THROW(run(options), WrongUse);
    options.step.leaveOut = {};
    options.step.continuous = "sometimes";
    EXPECT_THROW(run(options), WrongUse);
    options.step.continuous = "all";
    for (const char* wrong :
         {"contactHertz", "contactHertz=", "contactHertz=12x", "mass=3", "contactPasses=1e300",
          "contactPasses=nan", "contactPasses=2.5", "contactHertz=inf", "contactHertz=-1"}) {
        options.step.set = {wrong};
        EXPECT_THROW(run(options), WrongUse) << wrong;
    }
    options.step.set = {"contactHertz=60", "contactHertz=30"};
    EXPECT_THROW(run(options), WrongUse);
    options.step.set = {"contactHertz=120", "impactPasses=4"};
    EXPECT_NO_THROW(run(options));
    options.step.set = {};
    options.step.substeps = 0;
    EXPECT_THROW(run(options), WrongUse);
    options.engine = "box2d"; // no substeps and no profiles
    options.step.profile = {};
    options.step.substeps = 4;
    EXPECT_THROW(run(options), WrongUse);
    options.step.substeps = {};
    EXPECT_NO_THROW(run(options));
    options.step.profile = kBalanced;
    EXPECT_THROW(run(options), WrongUse);
    options.step.profile = {};
    options.engine = "unity";
    EXPECT_THROW(run(options), WrongUse);
    options.engine = "kodo";
    options.scene = "nowhere";
    EXPECT_THROW(run(options), WrongUse);
    options.scene = "slide"; // no size
    options.size = 1;
    EXPECT_NO_THROW(run(options));
    options.size = 2;
    EXPECT_THROW(run(options), WrongUse);
}

TEST(Summaries, TakeTheMedianAndTheSpread) {
    std::vector<Result> results(5);
    const double seconds[] = {5, 1, 4, 2, 3};
    std::transform(std::begin(seconds), std::end(seconds), results.begin(), [](double time) {
        Result result;
        result.cpuSeconds = time;
        result.steps = 1;
        return result;
    });
    const Summary summary = summaryOf(results);
    EXPECT_EQ(summary.result.cpuSeconds, 3);
    EXPECT_NEAR(summary.spread, 4.0 / 3, 1e-12);
    EXPECT_EQ(summary.runs, 5);
    results[3].stateHash = 7;
    EXPECT_THROW(summaryOf(results), NotRepeatable);
}

} // namespace
} // namespace bench
