// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

constexpr Real kStepRates[] = {60, 120, 240, 480}; // Hz

/// The error must fall at least by a factor of 2^0.9 per halving of the step, down to a floor. The
/// floor covers rounding and interpolation between two steps.
template <typename Error>
void expectFirstOrder(Error errorAt, double floor) {
    double previous = 0;
    for (const Real rate : kStepRates) {
        const double error = std::abs(errorAt(rate));
        if (rate > kStepRates[0]) {
            EXPECT_LT(error, std::max(previous * 0.536, floor)) << rate << " Hz";
        }
        previous = error;
    }
}

StepSettings sleepless() {
    StepSettings settings;
    settings.leaveOut = Feature::Sleep;
    return settings;
}

// Stopping distance of a sliding box, v^2 / (2 mu g).
TEST(ConvergenceOrder, OfTheStoppingDistance) {
    expectFirstOrder(
        [](Real rate) {
            World world({.gravity = support::kEarth, .settings = sleepless()});
            support::addFloor(world, withFriction(Real(0.5)));
            BodyDef def = support::boxDef({0, Real(0.1)}, 1, Real(0.2), withFriction(Real(0.5)));
            def.velocity = {5, 0};
            const BodyId box = world.add(def);
            support::run(world, static_cast<int>(2 * rate), 1 / rate);
            return static_cast<double>(world[box].position().x) - 2.5;
        },
        1e-4);
}

// C6: a disc that slides at 10 m/s rolls at 20/3 m/s after 10/9 s. Its rolling radius is shorter by
// half of the compression of its contact, so the stiffness has to rise with the rate.
TEST(ConvergenceOrder, OfSlidingThatBecomesRolling) {
    const auto roll = [](Real rate) {
        StepSettings settings = sleepless();
        settings.soft().contactHertz = rate;
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world, withFriction(Real(0.3)));
        BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), withFriction(Real(0.3)));
        def.velocity = {10, 0};
        const BodyId disc = world.add(def);
        support::run(world, static_cast<int>(2 * rate), 1 / rate);
        return std::pair(static_cast<double>(world[disc].velocity().x) - 20.0 / 3,
                         static_cast<double>(world[disc].position().x) - 410.0 / 27);
    };
    expectFirstOrder([&](Real rate) { return roll(rate).first; }, sizeof(Real) == 4 ? 4e-4 : 1e-12);
    expectFirstOrder([&](Real rate) { return roll(rate).second; }, sizeof(Real) == 4 ? 2e-3 : 1e-9);
}

// Speed and distance of a box slipping for 2 s down a slope of 3 over 4 with friction 0.3: a = g
// (0.6 - 0.8 mu) = 3.6 m/s^2.
TEST(ConvergenceOrder, OfSlidingDownASlope) {
    const auto slip = [](Real rate) {
        World world({.gravity = support::kEarth, .settings = sleepless()});
        const Rot tilt{Real(0.8), Real(-0.6)};
        world.add({.shape = Box{80, 2},
                   .position = -1 * tilt.yAxis(),
                   .rotation = tilt,
                   .material = withFriction(Real(0.3)),
                   .type = BodyType::Static});
        BodyDef def =
            support::boxDef(Real(0.1) * tilt.yAxis(), 1, Real(0.2), withFriction(Real(0.3)));
        def.rotation = tilt;
        const BodyId box = world.add(def);
        support::run(world, static_cast<int>(2 * rate), 1 / rate);
        return std::pair(dot(world[box].velocity(), tilt.xAxis()),
                         dot(world[box].position(), tilt.xAxis()));
    };
    // The speed is exact but for rounding: 4800 substeps accumulate to about 7 m/s in float.
    expectFirstOrder([&](Real rate) { return static_cast<double>(slip(rate).first) - 7.2; },
                     static_cast<double>(support::byPrecision(3e-4, 1e-11)));
    expectFirstOrder([&](Real rate) { return static_cast<double>(slip(rate).second) - 7.2; }, 4e-4);
}

// Final speed of a disc after the transition from sliding to rolling: 2/3 of the initial speed.
TEST(ConvergenceOrder, OfTheFinalRollingSpeed) {
    expectFirstOrder(
        [](Real rate) {
            World world({.gravity = support::kEarth, .settings = sleepless()});
            support::addFloor(world, withFriction(Real(0.3)));
            BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), withFriction(Real(0.3)));
            def.velocity = {6, 0};
            const BodyId ball = world.add(def);
            support::run(world, static_cast<int>(2 * rate), 1 / rate);
            return static_cast<double>(world[ball].velocity().x) - 4;
        },
        static_cast<double>(support::byPrecision(3e-4, 1e-4)));
}

// Second peak of a ball dropped from 5 m with e = 0.8: 5 * 0.8^4.
TEST(ConvergenceOrder, OfTheHeightOfABounce) {
    expectFirstOrder(
        [](Real rate) {
            World world({.gravity = support::kEarth, .settings = sleepless()});
            support::addFloor(world, support::slippery(Real(0.8)));
            const BodyId ball = world.add(
                support::ballDef({0, Real(5.5)}, Real(0.5), support::slippery(Real(0.8))));
            int peaks = 0;
            double height = 0;
            double before = -1;
            for (int i = 0; peaks < 2 && i < static_cast<int>(20 * rate); ++i) {
                world.step(1 / rate);
                const double v = static_cast<double>(world[ball].velocity().y);
                if (before > 0 && v <= 0) {
                    ++peaks;
                    height = static_cast<double>(world[ball].position().y) - 0.5 + v * v / 20;
                }
                before = v;
            }
            return height - 5 * 0.4096;
        },
        1e-4);
}

} // namespace
} // namespace kodo
