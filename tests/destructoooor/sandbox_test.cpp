// SPDX-License-Identifier: MIT
#include <catalogue/parts.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <dials.hpp>
#include <filesystem>
#include <fstream>
#include <sandbox.hpp>
#include <set>
#include <string>

namespace {

using namespace destructoooor;

std::size_t indexOf(std::string_view name) {
    const std::span<const Scene> all = catalogue();
    const auto found = std::ranges::find(all, name, &Scene::name);
    EXPECT_NE(found, all.end()) << name;
    return static_cast<std::size_t>(found - all.begin());
}

Sandbox sandboxOf(std::string_view name) {
    Sandbox sandbox;
    sandbox.open(indexOf(name));
    return sandbox;
}

void run(Sandbox& sandbox, int steps) {
    for (int i = 0; i < steps; ++i) {
        sandbox.step();
    }
}

/// Mass (kg) and momentum (kg m/s) of the dynamic bodies.
struct Sums {
    Real mass = 0;
    Vec2 momentum{};
    std::size_t bodies = 0;
};
Sums sumsOf(const kodo::World& world) {
    Sums sums;
    for (const BodyId id : world.bodies()) {
        if (world[id].type() == kodo::BodyType::Dynamic) {
            sums.mass += world[id].mass();
            sums.momentum += world[id].mass() * world[id].velocity();
            ++sums.bodies;
        }
    }
    return sums;
}

class EveryScene : public testing::TestWithParam<std::size_t> {};

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    std::string name;
    for (const char letter : std::string(catalogue()[info.param].name)) {
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
            name += letter;
        }
    }
    return name;
}

TEST_P(EveryScene, IsAsExpected) {
    Sandbox sandbox;
    sandbox.open(GetParam());
    const int steps = static_cast<int>(std::lround(sandbox.scene().seconds / kStepSeconds));
    run(sandbox, steps);
    ASSERT_TRUE(sandbox.verdict().has_value());
    EXPECT_TRUE(*sandbox.verdict())
        << sandbox.scene().question << " " << sandbox.scene().expectation;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryScene, testing::Range(std::size_t{0}, catalogue().size()),
                         nameOf);

TEST(Catalogue, HasSixtyScenesWithAQuestionEach) {
    EXPECT_GE(catalogue().size(), 60u);
    std::set<std::string_view> names;
    for (const Scene& scene : catalogue()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_EQ(scene.question.back(), '?') << scene.name;
        EXPECT_EQ(scene.expectation.back(), '.') << scene.name;
    }
}

// A tour tells what is seen: each stop, at its time, without a touch.
TEST(Tours, EachStopIsAsExpected) {
    ASSERT_EQ(tours().size(), 2u);
    for (std::size_t tour = 0; tour < tours().size(); ++tour) {
        EXPECT_GE(tours()[tour].stops.size(), 5u);
        for (std::size_t stop = 0; stop < tours()[tour].stops.size(); ++stop) {
            Sandbox sandbox;
            sandbox.visit(tour, stop);
            EXPECT_EQ(sandbox.scene().name, sandbox.stop()->scene);
            EXPECT_EQ(sandbox.settings(), sandbox.stop()->settings);
            run(sandbox, static_cast<int>(std::lround(sandbox.judgedAfter() / kStepSeconds)));
            ASSERT_TRUE(sandbox.verdict().has_value());
            EXPECT_TRUE(*sandbox.verdict()) << tours()[tour].name << ", stop " << stop + 1 << ": "
                                            << sandbox.measures().last().overlap << " mm";
        }
    }
}

/// Deepest overlap (mm) and visits of contacts where a stop is judged.
std::pair<Real, Real> measuredAt(std::size_t tour, std::size_t stop) {
    Sandbox sandbox;
    sandbox.visit(tour, stop);
    run(sandbox, static_cast<int>(std::lround(sandbox.judgedAfter() / kStepSeconds)));
    const Sample last = sandbox.measures().last();
    return {last.overlap, last.visits};
}

// What the texts of the stops promise of each other.
TEST(Tours, FromStopToStopTheOverlapGoes) {
    const auto [two, fewVisits] = measuredAt(0, 1);
    const auto [ten, someVisits] = measuredAt(0, 2);
    const auto [sixty, manyVisits] = measuredAt(0, 3);
    const auto [present, presentVisits] = measuredAt(0, 4);
    EXPECT_LT(ten, two / 5);
    EXPECT_LT(sixty, ten / 5);
    EXPECT_LT(present, sixty);
    EXPECT_LT(fewVisits, someVisits);
    EXPECT_NEAR(manyVisits / someVisits, 4, 0.5);
    EXPECT_NEAR(manyVisits / presentVisits, 12, 1);
    EXPECT_LT(measuredAt(1, 1).first, measuredAt(1, 0).first / 100);
    EXPECT_LT(measuredAt(1, 3).first, measuredAt(1, 2).first / 100);
}

TEST(Tours, AStopStartsAgainAndASceneLeavesTheTour) {
    Sandbox sandbox;
    sandbox.visit(1, 1);
    ASSERT_NE(sandbox.twin(), nullptr);
    run(sandbox, 60);
    EXPECT_GT(sandbox.difference(), 0.5); // m: the tower beside it falls
    sandbox.drop(Thing::Ball, {0, 14}, 1);
    sandbox.restart();
    EXPECT_EQ(sandbox.tick(), 0u);
    EXPECT_EQ(sandbox.place()->stop, 1u);
    EXPECT_EQ(sandbox.settings(), sandbox.stop()->settings);
    sandbox.open(3);
    EXPECT_EQ(sandbox.stop(), nullptr);
    EXPECT_EQ(sandbox.settings(), catalogue()[3].settings);
    sandbox.restart();
    EXPECT_EQ(sandbox.sceneIndex(), 3u);
}

/// Maximum overlap (m) during two seconds, after one second of settling.
Real maxOverlapOf(std::string_view scene, int collision, int rest, int shock) {
    Sandbox sandbox = sandboxOf(scene);
    kodo::StepSettings settings = kodo::thesis2006();
    settings.propagation().impactPasses = collision;
    settings.propagation().contactPasses = rest;
    settings.propagation().shockPasses = shock;
    settings.leaveOut = kodo::Feature::Sleep;
    sandbox.setSettings(settings);
    Real maxOverlap = 0;
    for (int step = 0; step < 180; ++step) {
        sandbox.step();
        maxOverlap = step < 60 ? 0 : std::max(maxOverlap, deepestOverlap(sandbox.world()));
    }
    return maxOverlap;
}

// A2: shock propagation greatly improves stability even with few iterations.
TEST(Sandbox, ShockPropagationStabilisesATowerWithFewIterations) {
    const Real without = maxOverlapOf("Tower", 5, 2, 0);
    const Real with = maxOverlapOf("Tower", 5, 2, 1);
    EXPECT_LT(with, without / 4);
}

// A2: overlap grows with the height of stacks; more collision and rest iterations reduce it.
TEST(Sandbox, MoreIterationsReduceOverlap) {
    const Real few = maxOverlapOf("Few iterations", 2, 2, 0);
    const Real some = maxOverlapOf("Few iterations", 10, 10, 0);
    const Real many = maxOverlapOf("Few iterations", 40, 60, 0);
    EXPECT_LT(some, few);
    EXPECT_LT(many, some / 2);
}

TEST(Measures, TheRegistryHasTheTimesOfAllStagesAndTheirSum) {
    Sandbox sandbox;
    run(sandbox, 10);
    const Sample last = sandbox.measures().last();
    float sum = 0;
    for (std::size_t i = 0; i < kodo::kStepStageNames.size(); ++i) {
        sum += valueOf(last, kMeasures.size() + i);
    }
    EXPECT_GT(sum, 0);
    EXPECT_FLOAT_EQ(valueOf(last, 0), sum);
}

TEST(Measures, TheGapOfAJointIsThatBetweenItsAnchors) {
    kodo::World world;
    const BodyId wall = world.add({.shape = kodo::Box{1, 1}, .type = kodo::BodyType::Static});
    const BodyId door = world.add({.shape = kodo::Box{1, 1}, .position = {1, 0}});
    world.add(kodo::RevoluteJoint{
        .ends = {.a = wall, .b = door, .anchorA = {0.5_r, 0}, .anchorB = {-0.5_r, 0}}});
    Measures measures;
    measures.sample(world, 10);
    EXPECT_EQ(measures.last().gap, 0);
    world[door].setPosition({1.25_r, 0});
    measures.sample(world, 10);
    EXPECT_FLOAT_EQ(measures.last().gap, 250); // mm
}

// Two boxes lie side by side; only the one under a heavy box pays for finer substeps.
TEST(Measures, PartsOfASubstepAreThoseOfTheIslandThatNeedsTheMost) {
    kodo::World world({.gravity = {0, -10}});
    world.add({.shape = kodo::Box{40, 1}, .position = {0, -0.5_r}, .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Box{1, 1}, .position = {-5, 0.5_r}});
    world.add({.shape = kodo::Box{1, 1}, .position = {5, 0.5_r}});
    Measures measures;
    world.step(1 / 60_r);
    measures.sample(world, 10);
    EXPECT_EQ(measures.last().parts, 1);
    EXPECT_EQ(measures.last().refined, 0);
    world.add({.shape = kodo::Box{1, 1}, .position = {5, 1.5_r}, .density = 1000});
    for (int i = 0; i < 10; ++i) {
        world.step(1 / 60_r);
    }
    measures.sample(world, 10);
    EXPECT_EQ(measures.last().parts, 4);
    EXPECT_EQ(measures.last().refined, 2);
}

// The first thing that is seen: it makes one stay.
TEST(Sandbox, StartsWithTheDefaultSolver) {
    EXPECT_EQ(Sandbox().settings(), kodo::balanced());
}

TEST(Sandbox, DropsEveryThingIntoEveryScene) {
    for (std::size_t scene = 0; scene < catalogue().size(); ++scene) {
        Sandbox sandbox;
        sandbox.open(scene);
        const std::size_t before = sumsOf(sandbox.world()).bodies;
        for (std::size_t what = 0; what < kThingNames.size(); ++what) {
            sandbox.drop(static_cast<Thing>(what), {2 * Real(what) - 6, 14}, 1);
        }
        EXPECT_EQ(sumsOf(sandbox.world()).bodies, before + kThingNames.size());
        run(sandbox, 20);
        EXPECT_GT(sandbox.measures().last().fastest, 0) << sandbox.scene().name;
    }
}

TEST(Sandbox, RewindsToTheSameBitsAndGoesOnAlike) {
    for (const std::string_view name : {"Pit", "Walker", "Galton's board", "Breaking up"}) {
        Sandbox sandbox = sandboxOf(name);
        run(sandbox, 100);
        const std::uint64_t middle = sandbox.world().stateHash();
        run(sandbox, 77);
        const std::uint64_t end = sandbox.world().stateHash();
        sandbox.rewind(100);
        EXPECT_EQ(sandbox.world().stateHash(), middle) << name;
        EXPECT_EQ(sandbox.lastTick(), 177u) << name;
        sandbox.rewind(177);
        EXPECT_EQ(sandbox.world().stateHash(), end) << name;
        sandbox.rewind(100);
        run(sandbox, 77);
        EXPECT_EQ(sandbox.world().stateHash(), end) << name;
    }
}

TEST(Sandbox, RewindsOverChangesByHand) {
    Sandbox sandbox = sandboxOf("Tower");
    run(sandbox, 40);
    sandbox.drop(Thing::Ball, {3, 9}, 1);
    sandbox.change([](kodo::World& world) { explode(world, {0, 2}, 5, 10); });
    run(sandbox, 25);
    sandbox.setGravity(3);
    run(sandbox, 30);
    const std::uint64_t end = sandbox.world().stateHash();
    sandbox.rewind(50);
    EXPECT_EQ(sandbox.tick(), 50u);
    sandbox.rewind(95);
    EXPECT_EQ(sandbox.world().stateHash(), end);
    // A step from an earlier tick begins another branch.
    sandbox.rewind(50);
    sandbox.step();
    EXPECT_EQ(sandbox.lastTick(), 51u);
}

TEST(Sandbox, ATouchedSceneIsNotJudged) {
    Sandbox sandbox = sandboxOf("Slope");
    sandbox.drop(Thing::Box, {0, 13}, 1);
    run(sandbox, 200);
    EXPECT_FALSE(sandbox.verdict().has_value());
}

TEST(Sandbox, TheMouseHoldsAndThrows) {
    Sandbox sandbox = sandboxOf("Tower");
    sandbox.setGravity(0);
    sandbox.drop(Thing::Box, {5, 6}, 1);
    const BodyId box = sandbox.world().bodies().back();
    sandbox.grab({5.2_r, 6});
    for (int i = 0; i < 60; ++i) {
        sandbox.pull({5.2_r + 0.05_r * Real(i), 6});
        sandbox.step();
    }
    EXPECT_NEAR(sandbox.world()[box].velocity().x, 3, 0.5); // m/s: 0.05 m in 1/60 s
    sandbox.letGo();
    EXPECT_TRUE(sandbox.world().joints().empty());
    EXPECT_GT(sandbox.world()[box].velocity().x, 2);
}

TEST(Sandbox, ComparesTwoSettingsFromTheSameStart) {
    Sandbox sandbox = sandboxOf("Pit");
    sandbox.compareWith(sandbox.settings());
    run(sandbox, 60);
    EXPECT_EQ(sandbox.difference(), 0);
    sandbox.compareWith(kodo::fast());
    run(sandbox, 60);
    EXPECT_GT(sandbox.difference(), 0);
    EXPECT_EQ(sandbox.twin()->settings(), kodo::fast());
}

TEST(Sandbox, SavesAndLoadsTheWorld) {
    const std::string file = testing::TempDir() + "sandbox_test.kodo";
    Sandbox sandbox = sandboxOf("Bridge");
    run(sandbox, 30);
    sandbox.save(file);
    const std::uint64_t hash = sandbox.world().stateHash();
    run(sandbox, 30);
    sandbox.load(file);
    EXPECT_EQ(sandbox.world().stateHash(), hash);
    std::filesystem::resize_file(file, 100);
    EXPECT_THROW(sandbox.load(file), std::runtime_error);
    EXPECT_THROW(sandbox.load(file + ".missing"), std::runtime_error);
    EXPECT_EQ(sandbox.world().stateHash(), hash);
    EXPECT_THROW(sandbox.save("/no/such/folder/file"), std::runtime_error);
    std::filesystem::remove(file);
}

/// Boxes in a row on the ground, up to x = 109 m.
kodo::World rowOf(int boxes) {
    kodo::World world({.gravity = {0, -10}});
    world.add({.shape = kodo::Box{300, 2}, .position = {0, -1}, .type = kodo::BodyType::Static});
    for (int i = 0; i < boxes; ++i) {
        world.add({.shape = kodo::Box{1, 1}, .position = {1.1_r * Real(i), 0.5_r}});
    }
    return world;
}

TEST(Sandbox, ALoadedSceneKeepsAndShowsBodiesFarFromTheOrigin) {
    const std::vector<std::byte> bytes = kodo::toBytes(rowOf(100));
    Sandbox sandbox;
    sandbox.take(bytes);
    run(sandbox, 10);
    EXPECT_EQ(sumsOf(sandbox.world()).bodies, 100u);
    EXPECT_LT(sandbox.view().lower.x, -0.5);
    EXPECT_GT(sandbox.view().upper.x, 109.4);
    sandbox.restart();
    run(sandbox, 10);
    EXPECT_EQ(sumsOf(sandbox.world()).bodies, 100u);
}

TEST(Sandbox, ABodyFarOutsideOfWhatWasThereIsRemoved) {
    Sandbox sandbox;
    sandbox.take(kodo::toBytes(rowOf(2)));
    sandbox.drop(Thing::Ball, {0, 75}, 1);
    sandbox.drop(Thing::Ball, {0, 90}, 1);
    sandbox.step();
    EXPECT_EQ(sumsOf(sandbox.world()).bodies, 3u);
}

TEST(Dials, EachOneChangesWhatItNames) {
    for (const Dial& dial : dials()) {
        Sandbox sandbox = sandboxOf(dial.name == "contactPasses" || dial.name == "shockPasses"
                                        ? "Shock propagation on"
                                        : "Tower");
        ASSERT_TRUE(dial.shown(sandbox)) << dial.name;
        const double wanted = dial.words.empty() ? snapped(dial, (dial.low + 3 * dial.high) / 4)
                              : dial.value(sandbox) > 0 ? 0
                                                        : 1;
        dial.set(sandbox, wanted);
        EXPECT_NEAR(dial.value(sandbox), wanted, 1e-6) << dial.name;
        run(sandbox, 3);
        EXPECT_FALSE(dial.what.empty()) << dial.name;
    }
}

TEST(Dials, ThoseOfTheOtherSolverAreHidden) {
    const auto shown = [](const Sandbox& sandbox, std::string_view name) {
        return std::ranges::find(dials(), name, &Dial::name)->shown(sandbox);
    };
    Sandbox sandbox = sandboxOf("Tower");
    EXPECT_TRUE(shown(sandbox, "contactHertz"));
    EXPECT_FALSE(shown(sandbox, "shockPasses"));
    sandbox.setSettings(kodo::thesis2006());
    EXPECT_FALSE(shown(sandbox, "contactHertz"));
    EXPECT_TRUE(shown(sandbox, "shockPasses"));
}

TEST(Dials, SettingsAreWrittenAsCode) {
    EXPECT_NE(codeOf(kodo::balanced()).find(".substeps = 5"), std::string::npos);
    EXPECT_NE(codeOf(kodo::thesis2006()).find(".shockPasses = 4"), std::string::npos);
}

TEST(Hands, ACutKeepsMassAndMomentum) {
    kodo::World world;
    const Vec2 velocity{3, -1};
    world.add({.shape = kodo::Box{4, 2}, .velocity = velocity, .angularVelocity = 2});
    world.add({.shape = kodo::Circle{1, {}}, .position = {5, 0}, .velocity = velocity});
    world.add({.shape = kodo::Capsule{{-1, 0}, {1, 0}, 0.4_r},
               .position = {10, 0},
               .velocity = velocity,
               .angularVelocity = -1});
    const Sums before = sumsOf(world);
    EXPECT_EQ(cut(world, {-5, -0.3_r}, {15, 0.4_r}), 3);
    const Sums after = sumsOf(world);
    EXPECT_EQ(after.bodies, 6u);
    // Arcs become chords of 1/16 of a turn: 2.6 % of a circle's area.
    EXPECT_NEAR(after.mass, before.mass, 0.02_r * before.mass);
    EXPECT_NEAR(after.momentum.x / after.mass, velocity.x, 0.02);
    EXPECT_NEAR(after.momentum.y / after.mass, velocity.y, 0.02);
}

TEST(Hands, ACutBodyKeepsItsJoints) {
    kodo::World world({.gravity = {0, -10}});
    const BodyId plank = world.add({.shape = kodo::Box{8, 0.5_r}, .position = {0, 5}});
    ASSERT_TRUE(pinAt(world, {-3.5_r, 5}));
    ASSERT_TRUE(pinAt(world, {3.5_r, 5}));
    const auto halves = split(world, plank, {0, 5}, {1, 0});
    ASSERT_TRUE(halves.has_value());
    EXPECT_EQ(world.joints().size(), 2u);
    for (int i = 0; i < 240; ++i) {
        world.step(kStepSeconds);
    }
    // Each half hangs from its own pin.
    EXPECT_NEAR(kodo::length(world[halves->first].center() - Vec2{3.5_r, 5}), 1.5, 0.1);
    EXPECT_NEAR(kodo::length(world[halves->second].center() - Vec2{-3.5_r, 5}), 1.5, 0.1);
}

TEST(Hands, ShatterMakesUpToEightPiecesOfTheSameMass) {
    kodo::World world;
    const BodyId box = world.add({.shape = kodo::Box{2, 2}, .rotation = kodo::Rot::fromAngle(1)});
    shatter(world, box, {0.1_r, 0.2_r});
    EXPECT_EQ(sumsOf(world).bodies, 8u);
    EXPECT_NEAR(sumsOf(world).mass, 4, 0.02);
}

TEST(Hands, AnOutlineBecomesABodyOrAReason) {
    kodo::World world;
    const std::vector<Vec2> corner{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const auto drawn = destructoooor::draw(world, corner);
    ASSERT_TRUE(std::holds_alternative<BodyId>(drawn));
    EXPECT_NEAR(world[std::get<BodyId>(drawn)].mass(), 5, 1e-3);
    const std::vector<Vec2> crossing{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    const auto refused = destructoooor::draw(world, crossing);
    ASSERT_TRUE(std::holds_alternative<std::string>(refused));
    EXPECT_EQ(
        std::get<std::string>(refused),
        "Point 3 begins an edge that crosses or touches the one from point 1: an outline must "
        "not meet itself, and has no holes.");
    EXPECT_EQ(world.bodyCount(), 1u);
}

TEST(Hands, AnOutlineThatEndsWhereItBeganIsABody) {
    for (const Vec2 end : {Vec2{0, 0}, Vec2{0.04_r, -0.03_r}}) {
        kodo::World world;
        const std::vector<Vec2> path{{0, 0}, {2, 0}, {2, 0}, {2, 1}, {0, 1}, end};
        const auto drawn = destructoooor::draw(world, path);
        ASSERT_TRUE(std::holds_alternative<BodyId>(drawn)) << std::get<std::string>(drawn);
        EXPECT_NEAR(world[std::get<BodyId>(drawn)].mass(), 2, 1e-3);
    }
}

TEST(Hands, AnOutlineOfOnePlaceIsRefusedByASentence) {
    kodo::World world;
    const std::vector<Vec2> click{{1, 1}, {1, 1}};
    EXPECT_TRUE(std::get<std::string>(destructoooor::draw(world, click))
                    .starts_with("The outline must be from 3 to "));
}

TEST(Hands, TieNeedsABodyAtOneEnd) {
    kodo::World world;
    world.add({.shape = kodo::Box{1, 1}});
    EXPECT_FALSE(tie(world, {5, 5}, {7, 5}));
    EXPECT_FALSE(tie(world, {0.1_r, 0}, {-0.1_r, 0}));
    EXPECT_TRUE(tie(world, {0, 0}, {0, 4}));
    EXPECT_TRUE(tie(world, {0, 0}, {3, 4}, 2));
    EXPECT_EQ(world.joints().size(), 2u);
}

TEST(Hands, AnExplosionPushesNearbyBodiesOnly) {
    kodo::World world;
    const BodyId near = world.add({.shape = kodo::Box{1, 1}, .position = {1, 5}});
    const BodyId far = world.add({.shape = kodo::Box{1, 1}, .position = {-12, 5}});
    explode(world, {0, 5}, 4, 12);
    EXPECT_GT(world[near].velocity().x, 5);
    EXPECT_EQ(world[far].velocity(), (Vec2{}));
}

} // namespace
