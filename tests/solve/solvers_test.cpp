// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <solve/solver_scenes.hpp>

#include <algorithm>

namespace {

using namespace kodo;
using strategies::kStep;
using strategies::Outcome;
using strategies::propagation;
using strategies::standing;

/// Sleep off, since it would hide what a solver cannot hold.
StepSettings awake(StepSettings settings) {
    settings.leaveOut |= Feature::Sleep;
    return settings;
}

// W5, A2: the purpose of shock propagation in the thesis.
TEST(Solvers, ShockPropagationHoldsATallStackWith4PassesThatFallsWithout) {
    const strategies::Trial trial = standing(scenes::stack(20), 10, 0.05);
    const Outcome with = run(trial, awake(propagation(4, 4)));
    const Outcome without = run(trial, awake(propagation(4, 0)));
    EXPECT_TRUE(with.yes);
    EXPECT_LT(with.moved, Real(0.005));
    EXPECT_LT(with.depth, Real(0.002));
    EXPECT_FALSE(without.yes);
    EXPECT_GT(without.moved, 1); // boxes have come down
}

TEST(Solvers, ShockPropagationHoldsAThousandTimesHeavierBoxOnALightOne) {
    const strategies::Trial trial = standing(scenes::heavyOnLight(1000), 10, 0.05);
    const Outcome with = run(trial, awake(propagation(4, 4)));
    EXPECT_TRUE(with.yes);
    EXPECT_LT(with.depth, Real(0.002));
    EXPECT_FALSE(run(trial, awake(propagation(4, 0))).yes);
    EXPECT_FALSE(run(trial, awake(propagation(40, 0))).yes);
}

// About as many visits of contacts and less overlap: 10 + 10 passes against 20.
TEST(Solvers, ShockPassesReduceOverlapMoreThanAsManyPlainPasses) {
    const strategies::Trial trial = standing(scenes::pyramid(12), 5, 0.1);
    const Outcome with = run(trial, awake(propagation(10, 10)));
    const Outcome without = run(trial, awake(propagation(20, 0)));
    EXPECT_TRUE(with.yes);
    EXPECT_LT(with.visitsPerStep, without.visitsPerStep);
    EXPECT_LT(with.depth, without.depth / 5);
    EXPECT_LT(with.moved, without.moved / 5);
}

// O3 with this solver: a stack that stands falls asleep, and then costs nothing.
TEST(Solvers, AStackUnderShockPropagationFallsAsleep) {
    const strategies::Trial trial = standing(scenes::stack(20), 3, 0.05);
    scenes::KodoScene scene = inKodo(trial.scene, propagation(4, 4));
    for (int i = 0; i < 180; ++i) {
        scene.world.step(kStep);
    }
    EXPECT_NE(scene.world[scene.ids[20]].flags() & kAsleep, 0u);
    EXPECT_EQ(stepStats(scene.world).contacts, 0u);
}

// W5: the thesis sorts all contacts by height, so several stacks cost more than their sum
// (4.2.2.2).
TEST(Solvers, SeparateStacksCostShockPropagationNothingExtra) {
    const auto visits = [](int stacks) {
        scenes::SceneDef scene = scenes::stack(0);
        scene.bodies[0] = scenes::ground(400);
        for (int k = 0; k < stacks; ++k) {
            for (int i = 0; i < 10; ++i) {
                scene.bodies.push_back(scenes::box(1, 1, {3.0 * k - 40, 0.5 + i}));
            }
        }
        scenes::KodoScene world = inKodo(scene, awake(propagation(4, 4)));
        world.world.step(kStep);
        return stepStats(world.world).contacts;
    };
    EXPECT_GT(visits(1), 0u);
    EXPECT_EQ(visits(20), 20 * visits(1));
}

/// Mean displacement of all boxes of a symmetric pyramid (m): to the right, and in absolute value.
struct Drift {
    double toTheRight = 0;
    double toAnySide = 0;
};

Drift driftOf(const StepSettings& settings) {
    const scenes::SceneDef def = scenes::pyramid(10);
    scenes::KodoScene scene = inKodo(def, awake(settings));
    for (int i = 0; i < 300; ++i) {
        scene.world.step(kStep);
    }
    Drift displacement;
    for (std::size_t i = 1; i < scene.ids.size(); ++i) {
        const double way =
            static_cast<double>(scene.world[scene.ids[i]].position().x) - def.bodies[i].position.x;
        displacement.toTheRight += way / 55;
        displacement.toAnySide += std::abs(way) / 55;
    }
    return displacement;
}

// W6: stride order has no bias to one side. A third of the mean absolute displacement is far more
// than the mean of 55 random ones.
TEST(Solvers, ASymmetricPyramidDriftsToNeitherSide) {
    for (const StepSettings& settings : {propagation(4, 4), propagation(10, 10)}) {
        const Drift displacement = driftOf(settings);
        EXPECT_LT(displacement.toAnySide, 0.05);
        EXPECT_LT(std::abs(displacement.toTheRight), 0.33 * displacement.toAnySide + 0.0005);
    }
}

// The promises of the table that tests/solve/solver_table prints.
TEST(Solvers, SoftSolverHoldsEveryScene) {
    for (const strategies::Trial& trial : strategies::trials()) {
        EXPECT_TRUE(run(trial, awake({})).yes) << trial.scene.name;
    }
}

TEST(Solvers, ShockPropagationHoldsEverySceneWithoutLeaningBodies) {
    for (const strategies::Trial& trial : strategies::trials()) {
        // Leaning bodies need the load from above, which does not act on frozen bodies.
        if (trial.scene.name != "card house" && trial.scene.name != "arch" &&
            trial.scene.name != "circle pile") {
            const Outcome outcome = run(trial, awake(propagation(10, 10)));
            EXPECT_TRUE(outcome.yes) << trial.scene.name;
            EXPECT_LT(outcome.depth, Real(0.005)) << trial.scene.name;
        }
    }
}

// Contacts as stiff as the substeps permit: a new pile comes to rest instead of creeping apart.
TEST(Solvers, AStiffPyramidComesToRestWithFewSubstepsOrMany) {
    for (const int substeps : {2, 3, 8}) {
        SCOPED_TRACE(substeps);
        StepSettings settings;
        settings.soft().substeps = substeps;
        settings.soft().contactHertz = 1000;
        scenes::KodoScene scene = inKodo(scenes::pyramid(16), awake(settings));
        for (int i = 0; i < 600; ++i) {
            scene.world.step(kStep);
        }
        Real fastest = 0;
        for (const BodyId id : scene.ids) {
            fastest = std::max(fastest, length(scene.world[id].velocity()));
        }
        EXPECT_LT(fastest, Real(0.01));
    }
}

} // namespace
