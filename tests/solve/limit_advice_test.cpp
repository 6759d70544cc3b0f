// SPDX-License-Identifier: MIT
// The limits of piles and loads that engine/docs/tuning.md publishes, and what to do about each.
// docs/advice.py holds both together.
#include <support/scenes.hpp>

#include <gtest/gtest.h>
#include <solve/solver_scenes.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::limit_advice {
namespace {

using strategies::KodoScene;

KodoScene awake(const scenes::SceneDef& def, StepSettings settings) {
    settings.leaveOut |= Feature::Sleep;
    return inKodo(def, settings);
}

/// Share by which a box of `ratio` times the density compresses `count` light ones in ten seconds;
/// 1 if it has fallen down.
double compression(int count, double ratio, const StepSettings& settings, int rate = 60) {
    scenes::SceneDef def = scenes::stack(count + 1);
    def.bodies.back().density = ratio;
    KodoScene scene = awake(def, settings);
    support::run(scene.world, 10 * rate, 1 / static_cast<Real>(rate));
    const auto height = static_cast<double>(scene.world[scene.ids.back()].position().y);
    return std::min(1.0, (count + 0.5 - height) / count);
}

/// Height (m) of the underside of a box of 1 kg that has lain for ten seconds on a plank of 2 m x
/// 0.1 m on the floor; the ratio of their masses.
double onAPlank(double ratio, const StepSettings& settings, int rate = 60) {
    scenes::SceneDef def{
        "plank",
        scenes::kDown,
        {scenes::ground(20), scenes::box(2, 0.1, {0, 0.05}), scenes::box(1, 1, {0, 0.6})}};
    def.bodies[1].density = 5;
    def.bodies[2].density = ratio;
    KodoScene scene = awake(def, settings);
    support::run(scene.world, 10 * rate, 1 / static_cast<Real>(rate));
    return static_cast<double>(scene.world[scene.ids[2]].position().y) - 0.5;
}

/// Deepest place (m, below its rest) and last height of a box of 1 kg that falls on a plate of 5 g.
struct Landing {
    double deepest = 0;
    double highestAfter = 0;
};
Landing onAPlate(double height, int rate = 60) {
    scenes::SceneDef def{"plate",
                         scenes::kDown,
                         {scenes::ground(20), scenes::box(1, 0.05, {0, 0.025}),
                          scenes::box(1, 1, {0, 0.55 + height})}};
    def.bodies[1].density = 0.1;
    KodoScene scene = awake(def, {});
    Landing result;
    bool landed = false;
    for (int i = 0; i < 3 * rate; ++i) {
        scene.world.step(1 / static_cast<Real>(rate));
        const double above = static_cast<double>(scene.world[scene.ids[2]].position().y) - 0.55;
        landed = landed || above < 0.002;
        result.deepest = std::max(result.deepest, -above);
        result.highestAfter = landed ? std::max(result.highestAfter, above) : 0;
    }
    return result;
}

/// Farthest way (m) of a body of a wall in running bond, of so many rows of bricks of 1 m x 0.5 m.
double wallMoves(int rows, const StepSettings& settings) {
    scenes::SceneDef def{"wall", scenes::kDown, {scenes::ground(40)}};
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < 8 - row % 2; ++i) {
            def.bodies.push_back(scenes::box(1, 0.5, {i - 4 + 0.5 * (row % 2), 0.25 + 0.5 * row}));
        }
    }
    KodoScene scene = awake(def, settings);
    support::run(scene.world, 600);
    return static_cast<double>(strategies::farthestMove(scene, def));
}

// --- Stack high

TEST(LimitAdvice, TheThesisHoldsAStackAtAnyMassRatio) {
    for (const double ratio : {1.0, 1000.0, 1e6}) {
        EXPECT_LT(std::abs(compression(3, ratio, thesis2006())), 1e-4) << ratio;
    }
    KodoScene scene = inKodo(scenes::heavyOnLight(1e6), thesis2006());
    support::run(scene.world, 300);
    EXPECT_TRUE(scene.world[scene.ids[2]].isAsleep());
}

TEST(LimitAdvice, TheSoftSolverHoldsWallsThatTheThesisDoesNot) {
    for (const int rows : {8, 12}) {
        EXPECT_LT(wallMoves(rows, balanced()), 0.02) << rows;
        EXPECT_GT(wallMoves(rows, thesis2006()), 0.2) << rows;
    }
}

TEST(LimitAdvice, RecordsOfTheThesisHoldTheLoadsWithoutShockPasses) {
    const auto onGround = [](int shockPasses) {
        KodoScene scene = awake(scenes::stack(5), strategies::propagation(10, shockPasses));
        support::run(scene.world, 60);
        double sum = 0;
        for (int i = 0; i < 60; ++i) {
            scene.world.step(support::kDt);
            const auto* record = support::recordOf(scene.world, scene.ids[0], scene.ids[1]);
            sum += record == nullptr ? 0 : static_cast<double>(record->totalImpulse);
        }
        return sum / 50; // N s in a second, of 50 N
    };
    EXPECT_NEAR(onGround(0), 1, 0.01);
    EXPECT_NEAR(onGround(4), 0.5, 0.1);
}

TEST(LimitAdvice, AColumnPartsSlowlyWhereGravityEnds) {
    for (const int count : {1, 2, 5, 10}) {
        for (const double ratio : {1.0, 100.0, 300.0, 1000.0}) {
            scenes::SceneDef def = scenes::stack(count + 1);
            def.bodies.back().density = ratio;
            KodoScene scene = awake(def, {});
            support::run(scene.world, 300);
            scene.world.setFields({});
            support::run(scene.world, 60); // in the first steps light boxes vibrate
            Real fastest = 0;
            for (int i = 0; i < 60; ++i) {
                scene.world.step(support::kDt);
                fastest = std::max(fastest, strategies::fastest(scene));
            }
            EXPECT_LT(fastest, Real(0.45)) << count << ", " << ratio;
            EXPECT_LT(strategies::farthestMove(scene, def), 1) << count << ", " << ratio;
        }
    }
}

TEST(LimitAdvice, ABodyThatNeverSleepsKeepsItsPileAwake) {
    for (const Flags flags : {Flags{0}, kNeverSleep}) {
        World world({.gravity = support::kEarth});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 3);
        world[boxes[2]].setFlags(flags);
        support::run(world, 200);
        EXPECT_EQ(world[boxes[0]].isAsleep(), flags == Flags{0});
    }
}

// --- Put heavy on light

TEST(LimitAdvice, TenLightBoxesCarryUpTo4000TimesTheirMass) {
    for (const double ratio : {10.0, 100.0, 300.0, 1000.0, 2000.0, 3000.0, 4000.0}) {
        EXPECT_LT(compression(10, ratio, balanced()), 0.016) << ratio;
        EXPECT_LT(compression(10, ratio, accurate()), 0.0125) << ratio;
        EXPECT_LT(compression(10, ratio, thesis2006()), 1e-4) << ratio;
        EXPECT_LT(ratio < 2000 ? compression(10, ratio, fast()) : 0, 0.03) << ratio;
        EXPECT_LT(ratio < 3000 ? compression(10, ratio, balanced(), 30) : 0, 0.03) << ratio;
    }
    EXPECT_EQ(compression(10, 4000, fast()), 1) << "the advice is still needed";
}

TEST(LimitAdvice, OneLightBoxCarriesUpTo3000TimesItsMass) {
    for (const double ratio : {10.0, 100.0, 1000.0, 2000.0, 3000.0}) {
        EXPECT_LT(compression(1, ratio, balanced()), 0.02) << ratio;
        EXPECT_LT(ratio < 1000 ? compression(1, ratio, fast()) : 0, 0.03) << ratio;
    }
    EXPECT_EQ(compression(1, 4000, fast()), 1);
}

TEST(LimitAdvice, APlankCarriesUpTo3000TimesItsMassAt60HertzAndMore) {
    for (const int rate : {60, 120}) {
        for (const double ratio : {10.0, 300.0, 1000.0, 3000.0}) {
            const double height = onAPlank(ratio, balanced(), rate);
            EXPECT_GT(height, 0.08) << ratio << ", " << rate;
            EXPECT_LT(height, 0.101) << ratio << ", " << rate;
        }
    }
    EXPECT_LT(onAPlank(4000, balanced(), 30), 0.05) << "the advice is still needed";
}

TEST(LimitAdvice, ABoxThatFallsOnAPlateStaysDown) {
    for (const double height : {0.1, 0.5, 1.0}) {
        const Landing at60 = onAPlate(height);
        EXPECT_LT(at60.deepest, 0.05) << height;
        EXPECT_LT(at60.highestAfter, 0.01) << height;
        EXPECT_LT(onAPlate(height, 30).deepest, 0.16) << height;
        EXPECT_LT(onAPlate(height, 30).highestAfter, 0.01) << height;
    }
}

TEST(LimitAdvice, AHeavyBoxThatLandsOnAColumnIsCarriedAt240Hertz) {
    const auto crushed = [](double ratio, int rate) {
        scenes::SceneDef def = scenes::stack(6);
        def.bodies[6].density = ratio;
        def.bodies[6].position.y += 0.5;
        KodoScene scene = awake(def, {});
        support::run(scene.world, 4 * rate, 1 / static_cast<Real>(rate));
        return scene.world[scene.ids[6]].position().y < Real(5.3);
    };
    for (const double ratio : {2.0, 16.0}) {
        EXPECT_FALSE(crushed(ratio, 60)) << ratio;
    }
    for (const double ratio : {2.0, 16.0, 100.0, 300.0}) {
        EXPECT_FALSE(crushed(ratio, 240)) << ratio;
    }
}

TEST(LimitAdvice, AHeavyBodyThatStartsTooLowIsRaisedToItsPlaceWithoutOvershoot) {
    for (const double overlap : {0.0, 0.2, 0.3, 0.5}) {
        scenes::SceneDef def = scenes::heavyOnLight(100);
        def.bodies[1].position.y -= overlap;
        def.bodies[2].position.y -= overlap;
        KodoScene scene = awake(def, {});
        Real highest = 0;
        for (int i = 0; i < 300; ++i) {
            scene.world.step(support::kDt);
            highest = std::max(highest, scene.world[scene.ids[2]].position().y);
        }
        EXPECT_LT(highest, Real(1.52)) << overlap;
        EXPECT_GT(scene.world[scene.ids[2]].position().y, Real(1.48)) << overlap;
    }
}

TEST(LimitAdvice, APlankLiesOn200Discs) {
    scenes::SceneDef def{"plank on discs", scenes::kDown, {scenes::ground(60)}};
    for (int i = 0; i < 200; ++i) {
        def.bodies.push_back(scenes::ball(0.1, {0.21 * (i - 99.5), 0.1}));
    }
    def.bodies.push_back(scenes::box(43, 0.5, {0, 0.45}));
    for (const double density : {1.0, 100.0}) {
        def.bodies.back().density = density;
        KodoScene scene = awake(def, {});
        support::run(scene.world, 120);
        EXPECT_NEAR(scene.world[scene.ids.back()].position().y, 0.45, 0.01) << density;
    }
}

} // namespace
} // namespace kodo::limit_advice
