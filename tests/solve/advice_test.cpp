// SPDX-License-Identifier: MIT
// Each sentence of advice in engine/docs/tuning.md. The page names these tests; docs/advice.py
// holds both together.
#include <scenes/impacts.hpp>
#include <scenes/nets.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>
#include <solve/solver_scenes.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kodo::advice {
namespace {

using strategies::KodoScene;
using support::kDt;

StepSettings soft(int substeps, Real contactHertz) {
    StepSettings settings;
    settings.soft().substeps = substeps;
    settings.soft().contactHertz = contactHertz;
    return settings;
}

KodoScene awake(const scenes::SceneDef& def, StepSettings settings) {
    settings.leaveOut |= Feature::Sleep;
    return inKodo(def, settings);
}

void run(KodoScene& scene, double seconds) {
    support::run(scene.world, static_cast<int>(std::lround(60 * seconds)));
}

/// Mean overlap (mm) of the contacts of a pile, as the mean of a second.
double overlap(const scenes::SceneDef& def, const StepSettings& settings, double seconds = 5) {
    KodoScene scene = awake(def, settings);
    run(scene, seconds);
    double sum = 0;
    double count = 0;
    for (int i = 0; i < 60; ++i) {
        scene.world.step(kDt);
        for (const CollisionRecord& record : scene.world.collisions()) {
            if (record.phase != TouchPhase::End) {
                sum += std::max(0.0, -static_cast<double>(record.separation));
                ++count;
            }
        }
    }
    return 1000 * sum / count;
}

double pyramid(const StepSettings& settings) {
    return overlap(scenes::pyramid(16), settings);
}

/// How far (mm) the top of a stack of twenty sinks.
double sinking(const StepSettings& settings) {
    KodoScene scene = awake(scenes::stack(20), settings);
    run(scene, 10);
    return 1000 * (19.5 - static_cast<double>(scene.world[scene.ids[20]].position().y));
}

/// Share by which a box on ten light ones, a thousand times as heavy, compresses them.
double compression(const StepSettings& settings, double ratio = 1000) {
    scenes::SceneDef def = scenes::stack(11);
    def.bodies[11].density = ratio;
    KodoScene scene = awake(def, settings);
    run(scene, 10);
    return (10.5 - static_cast<double>(scene.world[scene.ids[11]].position().y)) / 10;
}

/// Largest error of a contact force in a stack of ten, of which the top one is ten times as heavy.
double forceError(const StepSettings& settings) {
    scenes::SceneDef def = scenes::stack(10);
    def.bodies[10].density = 10;
    KodoScene scene = awake(def, settings);
    run(scene, 10);
    double worst = 0;
    for (std::size_t k = 1; k <= 10; ++k) {
        const auto* record = support::recordOf(scene.world, scene.ids[k - 1], scene.ids[k]);
        const double force = record == nullptr ? 0 : 60 * static_cast<double>(record->totalImpulse);
        worst = std::max(worst, std::abs(force / (10 * (20 - static_cast<double>(k))) - 1));
    }
    return worst;
}

/// Error of the way that a box slides to rest, as a share of it.
double slideError(const StepSettings& settings) {
    KodoScene scene = awake(scenes::slidingBox(0.3), settings);
    run(scene, 5);
    return static_cast<double>(scene.world[scene.ids[1]].position().x) / (25.0 / 6) - 1;
}

/// Largest error of the energy of a bar that swings from level for so long, as a share of it.
double swingError(const StepSettings& settings, double seconds = 60) {
    World world({.gravity = support::kEarth, .settings = settings});
    const BodyId post = world.add({.shape = Circle{Real(0.1)}, .type = BodyType::Static});
    const BodyId bar =
        world.add({.shape = Box{1, Real(0.1)}, .position = {Real(0.5), 0}, .flags = kNeverSleep});
    world.add(RevoluteJoint{.ends = {.a = post, .b = bar, .anchorB = {Real(-0.5), 0}}});
    const auto half = static_cast<double>(5 * world[bar].mass());
    double worst = 0;
    for (int i = 0; i < 60 * seconds; ++i) {
        world.step(kDt);
        const auto height = static_cast<double>(world[bar].position().y);
        const auto kinetic = static_cast<double>(support::totalsOf(world).kinetic);
        worst = std::max(worst, std::abs(kinetic + 2 * half * height) / half);
    }
    return worst;
}

/// Widest gap (mm) of a net of 20 x 20 balls that hangs from the middle of its upper edge.
double netGap(const StepSettings& settings) {
    scenes::SceneDef def{"net", scenes::kDown, {}};
    scenes::BodyDef knot = scenes::ball(0.4, {});
    knot.category = 1; // no knot collides with another
    knot.mask = 2;
    scenes::addNet(def, 20, knot, {});
    for (std::size_t column = 7; column <= 13; ++column) {
        def.bodies[column].locked = true;
    }
    KodoScene scene = awake(def, settings);
    run(scene, 10);
    Real widest = 0;
    for (const JointId id : scene.world.joints()) {
        const JointEnds ends = std::get<RevoluteJoint>(scene.world.joint(id)).ends;
        const Vec2 gap = scene.world[ends.b].transform() * ends.anchorB -
                         scene.world[ends.a].transform() * ends.anchorA;
        widest = std::max(widest, length(gap));
    }
    return 1000 * static_cast<double>(widest);
}

/// Speed of the last of so many touching balls in the step in which a ball hits the first one at
/// 5 m/s. They were added from the last one on, against the way of the impact.
double passedOn(const StepSettings& settings, int count, Real restitution = 1) {
    World world({.settings = settings});
    std::vector<BodyId> balls;
    for (int i = count; i >= 0; --i) {
        const Real x = i == 0 ? Real(-1) : static_cast<Real>(i - 1) * Real(0.5);
        balls.push_back(
            world.add(support::ballDef({x, 0}, Real(0.25), support::slippery(restitution))));
    }
    world[balls.back()].setVelocity({5, 0});
    for (int i = 0; i < 60 && world[balls.back()].velocity().x > Real(4.99); ++i) {
        world.step(kDt);
    }
    return static_cast<double>(world[balls[0]].velocity().x);
}

/// Of two boxes that start in overlap: their largest speed (m/s) apart, and the time (s) until 5 mm
/// are left.
struct Separation {
    double fastest = 0;
    double seconds = 0;
};
Separation separation(const StepSettings& settings) {
    World world({.settings = settings});
    const BodyId a = world.add(support::boxDef({0, 0}, 1, 1));
    const BodyId b = world.add(support::boxDef({Real(0.6), 0}, 1, 1));
    Separation result;
    const auto apart = [&] { return world[b].position().x - world[a].position().x; };
    for (int i = 0; i < 1200 && apart() < Real(0.995); ++i) {
        const Real before = apart();
        world.step(kDt);
        result.seconds += 1.0 / 60;
        result.fastest = std::max(result.fastest, 60 * static_cast<double>(apart() - before));
    }
    return result;
}

/// Steps until a box that was laid on the ground sleeps.
int stepsToSleep(int sleepSteps) {
    StepSettings settings;
    settings.sleepSteps = sleepSteps;
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    int steps = 0;
    for (; steps < 1000 && !world[box].isAsleep(); ++steps) {
        world.step(kDt);
    }
    return steps;
}

/// Visits of contacts by the solver in half a second of a pyramid, of which its time follows.
double visits(const StepSettings& settings) {
    KodoScene scene = awake(scenes::pyramid(16), settings);
    double sum = 0;
    for (int i = 0; i < 30; ++i) {
        scene.world.step(kDt);
        sum += static_cast<double>(stepStats(scene.world).contacts);
    }
    return sum;
}

StepSettings shock(int passes) {
    return {.solver = PropagationSettings{.contactPasses = 4, .shockPasses = passes}};
}

// --- What to take

TEST(Advice, BalancedHoldsPilesWaysAndForcesToItsFigures) {
    EXPECT_NEAR(overlap(scenes::pyramid(30), balanced()), 0.6, 0.1);
    EXPECT_NEAR(slideError(balanced()), -0.002, 3e-4);
    EXPECT_LT(forceError(balanced()), 2e-6);
    EXPECT_NEAR(sinking(balanced()), 34, 3);
    EXPECT_NEAR(compression(balanced()), 0.0106, 0.001);
}

TEST(Advice, FastOverlapsFiveTimesAsMuchAndKeepsForces) {
    const double loss = pyramid(fast()) / pyramid(balanced());
    EXPECT_GT(loss, 4.5);
    EXPECT_LT(loss, 7);
    EXPECT_LT(forceError(fast()), 2e-5);
}

TEST(Advice, FastLosesStacksSwingsWaysAndLoads) {
    EXPECT_NEAR(sinking(fast()), 192, 20);
    EXPECT_NEAR(slideError(fast()), -0.005, 0.001);
    EXPECT_NEAR(swingError(fast()), 0.0143, 0.002);
    EXPECT_NEAR(compression(fast()), 0.015, 0.002);
}

TEST(Advice, FastVisitsFewerContactsThanBalancedAndAccurateMore) {
    const double some = visits(balanced());
    EXPECT_NEAR(visits(fast()) / some, 0.4, 0.05) << "two of five substeps";
    EXPECT_NEAR(visits(accurate()) / some, 3.2, 0.3) << "sixteen";
}

TEST(Advice, EightSubstepsAt96HertzLeaveTwoFifthsOfTheOverlap) {
    EXPECT_NEAR(pyramid(soft(8, 96)) / pyramid(balanced()), 0.4, 0.05);
    EXPECT_NEAR(sinking(soft(8, 96)), 13, 1.5);
}

TEST(Advice, AccurateLeavesATenthOfTheOverlapAndOfASinkingStack) {
    EXPECT_NEAR(pyramid(accurate()) / pyramid(balanced()), 0.1, 0.02);
    EXPECT_NEAR(sinking(accurate()), 3.3, 0.4);
    EXPECT_NEAR(compression(accurate()), 0.0042, 0.0005);
    EXPECT_LT(compression(accurate(), 300), 0.013);
    EXPECT_NEAR(swingError(accurate()), 0.0018, 3e-4);
    EXPECT_NEAR(slideError(accurate()), -6.4e-4, 2e-4);
}

/// Share of its speed with which a ball returns, without restitution, that falls 3 m on one that
/// stands on the ground.
double returned(const StepSettings& settings, Real ratio) {
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    world.add(support::ballDef({0, Real(0.5)}, Real(0.5)));
    BodyDef def = support::ballDef({0, Real(4.5)}, Real(0.5));
    def.density = ratio;
    const BodyId falling = world.add(def);
    Real fall = 0;
    Real rise = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(kDt);
        fall = std::max(fall, -world[falling].velocity().y);
        rise = std::max(rise, world[falling].velocity().y);
    }
    return static_cast<double>(rise / fall);
}

TEST(Advice, AccurateLosesReboundsWithoutRestitutionAndTheThesisHasNone) {
    EXPECT_NEAR(returned(balanced(), 1), 0.16, 0.03);
    EXPECT_NEAR(returned(accurate(), 1), 0.23, 0.03);
    for (const Real ratio : {Real(0.1), Real(0.5), Real(1), Real(4), Real(10)}) {
        EXPECT_LT(returned(balanced(), ratio), 0.18) << ratio;
        EXPECT_LT(returned(accurate(), ratio), 0.26) << ratio;
        EXPECT_LT(returned(thesis2006(), ratio), 0.01) << ratio;
    }
}

TEST(Advice, ShockPassesHoldAColumnAndLoseWhatLeansAndTheLoads) {
    const StepSettings shocked = shock(4);
    EXPECT_LT(std::abs(sinking(shocked)), 0.01);
    EXPECT_LT(std::abs(compression(shocked)), 1e-5);
    const auto stands = [&](const scenes::SceneDef& def, const StepSettings& settings) {
        StepSettings still = settings;
        still.leaveOut |= Feature::Sleep;
        return run(strategies::standing(def, 10, 0.1), still).yes;
    };
    EXPECT_TRUE(stands(strategies::cardHouse(), balanced()));
    EXPECT_FALSE(stands(strategies::cardHouse(), shocked));
    EXPECT_TRUE(stands(strategies::arch(), balanced()));
    EXPECT_FALSE(stands(strategies::arch(), shocked));
    EXPECT_GT(forceError(shocked), 0.5) << "impulses are not the loads";
}

TEST(Advice, SubstepsKeepTheEnergyOfASwing) {
    EXPECT_NEAR(swingError(balanced()), 0.006, 0.001);
    EXPECT_LT(swingError(soft(16, 60)), 0.002);
    EXPECT_NEAR(swingError(soft(1, 60)), 0.03, 0.01);
    EXPECT_NEAR(swingError(soft(10, 60)) / swingError(balanced()), 0.5, 0.05);
}

TEST(Advice, ImpactPassesOfTheThesisPassAnImpactOnThroughMoreBodiesInAStep) {
    const auto last = [](int passes, int count) {
        StepSettings settings = thesis2006();
        settings.propagation().impactPasses = passes;
        return passedOn(settings, count);
    };
    EXPECT_LT(last(4, 12), 0.5);
    EXPECT_NEAR(last(8, 12), 5, 1e-3);
    EXPECT_LT(last(16, 40), 0.5);
    EXPECT_NEAR(last(32, 40), 5, 1e-3);
    EXPECT_EQ(last(4, 1), last(64, 1)) << "one ball alone";
}

TEST(Advice, ImpactPassesPassOnMoreOfAnImpactWithoutFullRestitution) {
    const auto last = [](int passes, Real restitution) {
        StepSettings settings;
        settings.soft().impactPasses = passes;
        return passedOn(settings, 40, restitution);
    };
    EXPECT_GT(last(16, Real(0.5)), 1.2 * last(4, Real(0.5)));
    EXPECT_GT(last(64, Real(0.5)), 1.5 * last(16, Real(0.5)));
    EXPECT_NEAR(last(4, 1), 5, 1e-3) << "with it, a row needs none";
    EXPECT_EQ(passedOn(fast(), 1, Real(0.5)), passedOn(accurate(), 1, Real(0.5)))
        << "one ball alone";
    EXPECT_LT(passedOn(fast(), 40, Real(0.5)), 0.8 * passedOn(balanced(), 40, Real(0.5)));
}

// --- The two rules, and single settings

TEST(Advice, SubstepsAloneDoNotMakeContactsStiffer) {
    const double usual = pyramid(balanced());
    EXPECT_NEAR(pyramid(soft(20, 60)) / usual, 1, 0.05);
    EXPECT_NEAR(pyramid(soft(10, 120)) / usual, 0.25, 0.03);
    EXPECT_NEAR(pyramid(soft(20, 240)) / usual, 0.0625, 0.015);
}

TEST(Advice, ContactHertzCountsUpTo021OfTheSubstepRate) {
    const auto top = [](Real hertz) {
        KodoScene scene = awake(scenes::pyramid(6), soft(5, hertz));
        run(scene, 1);
        return scene.world[scene.ids.back()].position().y;
    };
    EXPECT_EQ(top(64), top(1000));
    EXPECT_NE(top(60), top(1000));
}

TEST(Advice, AStackOfTwentyFallsWithOneSubstep) {
    EXPECT_GT(sinking(soft(1, 60)), 1000);
    EXPECT_LT(sinking(soft(2, 60)), 300);
}

TEST(Advice, ContactDampingSeparatesOverlapMoreSlowlyWithoutOvershoot) {
    const auto damped = [](Real damping) {
        StepSettings settings;
        settings.soft().contactDamping = damping;
        return separation(settings);
    };
    EXPECT_GT(damped(40).seconds, 1.5 * damped(10).seconds);
    EXPECT_LT(damped(40).fastest, damped(10).fastest);
}

TEST(Advice, PushSpeedBoundsTheSpeedOfSeparation) {
    StepSettings slow;
    slow.soft().pushSpeed = 1;
    EXPECT_LT(separation(slow).fastest, 1.05);
    EXPECT_GT(separation(balanced()).fastest, 1.5);
    EXPECT_GT(separation(slow).seconds, separation(balanced()).seconds);
    StepSettings thesis = thesis2006();
    const double usual = separation(thesis).seconds;
    thesis.propagation().pushSpeed = Real(0.3);
    EXPECT_GT(separation(thesis).seconds, 2 * usual);
}

TEST(Advice, SleepStepsDelaySleep) {
    const int soon = stepsToSleep(10);
    EXPECT_NEAR(stepsToSleep(30) - soon, 20, 1);
    EXPECT_NEAR(stepsToSleep(120) - soon, 110, 1);
}

TEST(Advice, ContactPassesConvergeFurther) {
    const auto error = [](int passes) {
        StepSettings settings = thesis2006();
        settings.propagation().contactPasses = passes;
        settings.propagation().shockPasses = 0;
        return sinking(settings);
    };
    EXPECT_LT(error(80), error(10));
}

TEST(Advice, SubstepsOfTheThesisMakeErrorsOfMotionSmaller) {
    StepSettings settings = thesis2006();
    const double slide = std::abs(slideError(settings));
    const double swing = swingError(settings);
    settings.propagation().substeps = 4;
    EXPECT_LT(std::abs(slideError(settings)), slide / 2);
    EXPECT_LT(swingError(settings), swing / 2);
}

TEST(Advice, AccurateHoldsALoadedNetByItsJointHertz) {
    EXPECT_NEAR(netGap(balanced()), 18, 2);
    EXPECT_NEAR(netGap(accurate()), 1, 0.2);
    StepSettings settings = soft(16, 192);
    EXPECT_GT(netGap(settings), 5) << "not without its jointHertz";
    settings.soft().jointHertz = 240;
    EXPECT_NEAR(netGap(settings), 1, 0.2);
}

} // namespace
} // namespace kodo::advice
