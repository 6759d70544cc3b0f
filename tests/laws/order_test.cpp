// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

constexpr Real kStepRates[] = {60, 120, 240, 480}; // Hz

/// The error of a figure must fall by a factor of 2^0.9 at least whenever the step is halved, until
/// it has come down to the floor: what rounding, and reading between two steps, leave of it.
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
    settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
    return settings;
}

// The way on which friction stops a box, v^2 / (2 mu g).
TEST(Order, OfTheStoppingWay) {
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

// The speed and the way of a box that slips down a slope of 3 over 4, with friction 0.3:
// a = g (0.6 - 0.8 mu) = 3.6 m/s^2, for two seconds.
TEST(Order, OfASlipDownASlope) {
    const auto slip = [](Real rate) {
        World world({.gravity = support::kEarth, .settings = sleepless()});
        const Rot tilt{Real(0.8), Real(-0.6)};
        world.add({.shape = Box{80, 2},
                   .position = -1 * tilt.yAxis(),
                   .rotation = tilt,
                   .material = withFriction(Real(0.3)),
                   .flags = kLocked});
        BodyDef def =
            support::boxDef(Real(0.1) * tilt.yAxis(), 1, Real(0.2), withFriction(Real(0.3)));
        def.rotation = tilt;
        const BodyId box = world.add(def);
        support::run(world, static_cast<int>(2 * rate), 1 / rate);
        return std::pair(dot(world[box].velocity(), tilt.xAxis()),
                         dot(world[box].position(), tilt.xAxis()));
    };
    // The speed is exact but for rounding: in float, 4800 substeps add to a number of size 7.
    expectFirstOrder([&](Real rate) { return static_cast<double>(slip(rate).first) - 7.2; },
                     static_cast<double>(support::byPrecision(3e-4, 1e-11)));
    expectFirstOrder([&](Real rate) { return static_cast<double>(slip(rate).second) - 7.2; }, 4e-4);
}

// The speed of a disc that has slid into rolling: 2/3 of the first.
TEST(Order, OfTheSpeedThatRollingLeaves) {
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

// The second peak of a ball dropped from 5 m with e = 0.8: 5 * 0.8^4.
TEST(Order, OfTheHeightOfABounce) {
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
