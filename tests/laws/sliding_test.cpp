// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::nearShare;

/// A box of 1 kg on the floor, flat, so that braking hardly shifts its load.
struct Slide {
    World world;
    BodyId box;

    Slide(const Material& material, Real speed, const WorldDef& def = {.gravity = support::kEarth})
        : world(def) {
        support::addFloor(world, material);
        BodyDef body = support::boxDef({0, Real(0.1)}, 1, Real(0.2), material);
        body.density = 5;
        body.velocity = {speed, 0};
        box = world.add(body);
    }
    Real way() const { return world[box].position().x; }
    Real speed() const { return world[box].velocity().x; }
};

// It stops after a distance of v^2 / (2 mu g) and a time of v / (mu g), each within 1 %.
TEST(Sliding, StopsAtTheExactDistanceAndTime) {
    for (const double mu : {0.2, 0.5, 0.9}) {
        SCOPED_TRACE(mu);
        Slide slide(withFriction(static_cast<Real>(mu)), 5);
        const double time = 5 / (mu * 10);
        double stopped = 0;
        for (int i = 1; i < 60 * 2 * time; ++i) {
            slide.world.step(support::kDt);
            if (stopped == 0 && slide.speed() < Real(1e-3)) {
                stopped = i / 60.0;
            }
        }
        EXPECT_TRUE(nearShare(slide.way(), 25 / (20 * mu), 0.01));
        // One step of slack: the step of the stop is counted as a whole.
        EXPECT_TRUE(support::near(stopped, time, 0.01 * time + 1 / 60.0));
    }
}

// The distance does not depend on the rate, except for a first-order error in the step.
TEST(Sliding, StopsAtTheSamePlaceAtAnyRate) {
    for (const Real rate : {Real(120), Real(240), Real(480)}) {
        SCOPED_TRACE(rate);
        Slide slide(withFriction(Real(0.5)), 5);
        support::run(slide.world, static_cast<int>(2 * rate), 1 / rate);
        EXPECT_TRUE(nearShare(slide.way(), 2.5L, 0.6L / static_cast<long double>(rate)));
    }
}

// A cube, whose load shifts to its front edge while braking, stops after the same distance: v^2 /
// (2 mu g) = 2.5 m.
TEST(Sliding, ACubeStopsAtTheExactDistance) {
    World world(support::withoutSleep());
    support::addFloor(world, withFriction(Real(0.5)));
    BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1, withFriction(Real(0.5)));
    def.velocity = {5, 0};
    const BodyId box = world.add(def);
    support::run(world, 180);
    EXPECT_TRUE(support::near(world[box].position().x, 2.5L, 0.025L)); // 1 %
    EXPECT_TRUE(support::near(world[box].velocity().x, 0, support::byPrecision(1e-5, 1e-9)));
}

// R7: a resting box breaks loose at mu_s m g and then slides with mu_k, each within 1 %.
TEST(Sliding, BreaksLooseAtTheStaticFriction) {
    const Material material{Real(0.6), Real(0.3), 0, 0};
    const auto speedAfter = [&](Real share) { // the force rises for one second, then stays for one
        Slide slide(material, 0);
        for (int i = 0; i < 120; ++i) {
            const Real risen = std::min(static_cast<Real>(i) / 60, Real(1));
            slide.world[slide.box].applyForce({risen * share * 6, 0});
            slide.world.step(support::kDt);
        }
        return slide.speed();
    };
    EXPECT_LT(speedAfter(Real(0.99)), Real(1e-3));
    EXPECT_GT(speedAfter(Real(1.01)), 3); // a = F/m - mu_k g = 3.06 m/s^2
}

// R7: v - mu_k g t = 2 m/s after one second.
TEST(Sliding, SlidesOnWithTheKineticFriction) {
    Slide slide({Real(0.9), Real(0.3), 0, 0}, 5);
    support::run(slide.world, 60);
    EXPECT_TRUE(nearShare(slide.speed(), 2, 0.01));
}

// S3: friction depends neither on restitution nor on the number of substeps, unlike in the thesis.
// The distances agree within 1 %.
TEST(Sliding, DependsNeitherOnRestitutionNorOnSubsteps) {
    for (const Real e : {Real(0), Real(0.5), Real(1)}) {
        for (const int substeps : {4, 40}) {
            SCOPED_TRACE(testing::Message() << "e " << e << ", " << substeps << " substeps");
            WorldDef def{.gravity = support::kEarth};
            def.settings.soft().substeps = substeps;
            Slide slide(withFriction(Real(0.5), e), 5, def);
            support::run(slide.world, 120);
            EXPECT_TRUE(nearShare(slide.way(), 2.5L, 0.01L));
        }
    }
}

// S3: the friction of a pair is the geometric mean of both.
TEST(Sliding, FrictionOfAPairIsTheGeometricMean) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, withFriction(Real(0.9)));
    BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1, withFriction(Real(0.1)));
    def.velocity = {3, 0};
    const BodyId box = world.add(def);
    support::run(world, 30);
    EXPECT_TRUE(nearShare(world[box].velocity().x, 3 - 0.3 * 10 / 2, 0.01));
}

} // namespace
} // namespace kodo
