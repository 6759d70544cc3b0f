// SPDX-License-Identifier: MIT
#include <kodo/solve/settings.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <limits>

namespace kodo {
namespace {

TEST(StepSettings, DefaultsAndProfilesAreGood) {
    EXPECT_FALSE(check(StepSettings{}).has_value());
    EXPECT_FALSE(check(thesis2006()).has_value());
}

// Every number can be set alone, and each has its range and its name in the sentence.
TEST(StepSettings, EachNumberIsChecked) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real inf = std::numeric_limits<Real>::infinity();
    struct Bad {
        const char* field;
        std::function<void(StepSettings&)> spoil;
    };
    const Bad rows[] = {
        {"settings.substeps", [](StepSettings& s) { s.substeps = 0; }},
        {"settings.substeps", [](StepSettings& s) { s.substeps = 65; }},
        {"settings.impactPasses", [](StepSettings& s) { s.impactPasses = -1; }},
        {"settings.impactPasses", [](StepSettings& s) { s.impactPasses = 1001; }},
        {"settings.contactHertz", [](StepSettings& s) { s.contactHertz = 0; }},
        {"settings.contactHertz", [=](StepSettings& s) { s.contactHertz = nan; }},
        {"settings.contactDamping", [=](StepSettings& s) { s.contactDamping = inf; }},
        {"settings.pushSpeed", [](StepSettings& s) { s.pushSpeed = -1; }},
    };
    for (const Bad& bad : rows) {
        SCOPED_TRACE(bad.field);
        StepSettings settings;
        bad.spoil(settings);
        const auto problem = check(settings);
        ASSERT_TRUE(problem.has_value());
        EXPECT_EQ(problem->field, bad.field);
    }
}

constexpr Feature kEachFeature[] = {
    Feature::Friction, Feature::RollingResistance, Feature::Restitution, Feature::Sweep,
    Feature::Records,  Feature::Resting,           Feature::Rotation};

TEST(StepSettings, FeaturesAreLeftOutOneByOne) {
    for (const Feature out : kEachFeature) {
        StepSettings settings;
        settings.leaveOut = static_cast<std::uint8_t>(out);
        for (const Feature feature : kEachFeature) {
            EXPECT_EQ(settings.has(feature), feature != out);
        }
    }
}

WorldDef without(Feature feature) {
    WorldDef def{.gravity = support::kEarth};
    def.settings.leaveOut = static_cast<std::uint8_t>(feature);
    return def;
}

// W3: what is left out has no effect. Without friction a box slides on for ever.
TEST(LeaveOut, WithoutFrictionABoxSlidesOn) {
    World world(without(Feature::Friction));
    support::addFloor(world, withFriction(1));
    BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1, withFriction(1));
    def.velocity = {2, 0};
    const BodyId box = world.add(def);
    support::run(world, 120);
    EXPECT_EQ(world[box].velocity().x, 2);
}

TEST(LeaveOut, WithoutRestitutionNothingBounces) {
    World world(without(Feature::Restitution));
    support::addFloor(world, support::slippery(1));
    const BodyId ball = world.add(support::ballDef({0, 3}, Real(0.5), support::slippery(1)));
    Real fastest = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(support::kDt);
        fastest = std::max(fastest, world[ball].velocity().y);
    }
    EXPECT_LT(fastest, Real(0.05));
}

TEST(LeaveOut, WithoutRollingResistanceABallRollsOn) {
    World world(without(Feature::RollingResistance));
    Material material = withFriction(Real(0.8));
    material.rollingResistance = Real(0.5);
    support::addFloor(world, material);
    BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), material);
    def.velocity = {3, 0};
    def.angularVelocity = -6;
    const BodyId ball = world.add(def);
    support::run(world, 120);
    EXPECT_TRUE(support::near(world[ball].velocity().x, 3, Real(1e-3)));
}

// Without the sweep a fast ball is somewhere else before it could touch: the test that shows that
// the sweep is what stops it.
TEST(LeaveOut, WithoutTheSweepABallTunnels) {
    for (const bool sweeps : {true, false}) {
        WorldDef def = without(Feature::Sweep);
        def.gravity = {};
        def.settings.leaveOut = sweeps ? std::uint8_t{0} : def.settings.leaveOut;
        World world(def);
        support::addWall(world, 5, Real(0.02), support::slippery(1));
        BodyDef ball = support::ballDef({0, 0}, Real(0.1), support::slippery(1));
        ball.velocity = {400, 0};
        const BodyId id = world.add(ball);
        support::run(world, 2);
        EXPECT_EQ(world[id].velocity().x < 0, sweeps);
    }
}

TEST(LeaveOut, WithoutRestingNothingIsPutToRest) {
    for (const bool rests : {true, false}) {
        WorldDef def = without(Feature::Resting);
        def.settings.leaveOut = rests ? std::uint8_t{0} : def.settings.leaveOut;
        World world(def);
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        support::run(world, 300);
        EXPECT_EQ((world[box].flags() & kResting) != 0, rests);
    }
}

} // namespace
} // namespace kodo
