// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

constexpr long double kPi = std::numbers::pi_v<long double>;

/// A rod of 1 m on a revolute joint at the origin, released at an angle (degrees) from the
/// vertical.
struct Pendulum {
    World world{{.gravity = support::kEarth}};
    BodyId rod;

    explicit Pendulum(double degrees) {
        const BodyId hook =
            world.add({.shape = Circle{Real(0.1)}, .type = BodyType::Static, .flags = kDisabled});
        const Rot turn = Rot::fromAngle(static_cast<Real>(degrees * 3.14159265358979 / 180));
        BodyDef def = support::boxDef({}, Real(0.1), 1);
        def.rotation = turn;
        def.position = turn * Vec2{0, Real(-0.5)};
        rod = world.add(def);
        world.add(RevoluteJoint{.ends = {hook, rod, {}, {0, Real(0.5)}}});
    }
    long double angle() const { return static_cast<long double>(world[rod].rotation().angle()); }
    long double spin() const { return static_cast<long double>(world[rod].angularVelocity()); }
    long double energy() const { // J, relative to the lowest position
        const BodyView body = world[rod];
        const long double lowest = -0.5L;
        const auto v = static_cast<long double>(length(body.velocity()));
        return static_cast<long double>(body.mass()) *
                   (10 * (static_cast<long double>(body.center().y) - lowest) + v * v / 2) +
               static_cast<long double>(body.inertia()) * spin() * spin() / 2;
    }
};

/// T = 2 pi sqrt((m l^2 + I) / (m g l)) / agm(1, cos(angle / 2)), for a rod of 1 by 0.1 m.
long double exactPeriod(double degrees) {
    const long double inertia = (1 + 0.01L) / 12;
    long double a = 1;
    long double b = std::cos(static_cast<long double>(degrees) * kPi / 360);
    for (int i = 0; i < 20; ++i) { // the arithmetic-geometric mean
        const long double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return 2 * kPi * std::sqrt((0.25L + inertia) / 5) / a;
}

/// Mean of `count` periods, between upward zero crossings of the angle interpolated between steps.
long double periodOf(Pendulum& pendulum, Real rate, int count) {
    long double first = 0;
    long double last = 0;
    int passes = 0;
    long double before = pendulum.angle();
    for (int i = 1; passes <= count && i < static_cast<int>(100 * rate); ++i) {
        pendulum.world.step(1 / rate);
        const long double now = pendulum.angle();
        if (before < 0 && now >= 0 && now < 1) {
            const long double time = (i - now / (now - before)) / static_cast<long double>(rate);
            first = passes == 0 ? time : first;
            last = time;
            ++passes;
        }
        before = now;
    }
    return (last - first) / (passes - 1);
}

// The period matches the elliptic integral within 1e-4. The hardest case is a swing close to the
// upper equilibrium, where dT / T = 17 dE / E.
TEST(Pendulum, HasTheExactPeriod) {
    for (const double degrees : {10.0, 90.0, 170.0}) {
        SCOPED_TRACE(degrees);
        Pendulum pendulum(degrees);
        EXPECT_TRUE(nearShare(periodOf(pendulum, 60, 3), exactPeriod(degrees), 1e-4));
    }
}

// Energy at the turning points stays within 1e-4 for one minute at 60 Hz. Within a swing it
// oscillates by 0.7 %: forces act at the start of a substep, which shifts the energy by half a
// substep.
TEST(Pendulum, KeepsItsEnergyForAMinute) {
    for (const double degrees : {10.0, 90.0, 170.0}) {
        SCOPED_TRACE(degrees);
        Pendulum pendulum(degrees);
        const long double before = pendulum.energy();
        int turns = 0;
        for (int i = 0; i < 3600; ++i) {
            const long double spin = pendulum.spin();
            const long double energy = pendulum.energy();
            pendulum.world.step(support::kDt);
            ASSERT_TRUE(nearShare(pendulum.energy(), before, 0.007)) << "step " << i;
            if (spin * pendulum.spin() < 0) { // turning point between two steps
                const long double share = spin / (spin - pendulum.spin());
                const long double top = energy + share * (pendulum.energy() - energy);
                ASSERT_TRUE(nearShare(top, before, 1e-4)) << "step " << i;
                ++turns;
            }
        }
        EXPECT_GE(turns, 30);
    }
}

// The arm keeps its length. The error per substep is of third order in its rotation: (w h)^3 l / 6
// = 1 um for 0.02 rad at the lowest point.
TEST(Pendulum, TheArmKeepsItsLength) {
    Pendulum pendulum(90);
    for (int i = 0; i < 600; ++i) {
        pendulum.world.step(support::kDt);
        ASSERT_TRUE(near(length(pendulum.world[pendulum.rod].center()), 0.5L, Real(1e-6)));
    }
}

// The error of the period falls with the square of the step (order 1.9), down to rounding. In
// float, smaller steps accumulate more rounding.
TEST(Pendulum, TheErrorOfThePeriodFallsWithTheSquareOfTheStep) {
    constexpr auto kFloor = static_cast<long double>(byPrecision(2e-4, 1e-9));
    for (const double degrees : {90.0, 170.0}) {
        SCOPED_TRACE(degrees);
        long double previous = 0;
        for (const Real rate : {Real(60), Real(120), Real(240), Real(480)}) {
            Pendulum pendulum(degrees);
            const long double error =
                std::abs(periodOf(pendulum, rate, 3) / exactPeriod(degrees) - 1);
            if (rate > 60) {
                EXPECT_LT(error, std::max(previous * 0.268L, kFloor)) << rate;
            }
            previous = error;
        }
    }
}

/// A chain of `count` rods of 1 m on revolute joints, hanging from the origin.
struct Chain {
    World world{{.gravity = support::kEarth}};
    std::vector<BodyId> rods;
    std::vector<JointId> pins;

    Chain(int count, const std::vector<double>& degrees) {
        BodyId last =
            world.add({.shape = Circle{Real(0.1)}, .type = BodyType::Static, .flags = kDisabled});
        Vec2 end{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const double angle = i < degrees.size() ? degrees[i] * 3.14159265358979 / 180 : 0;
            const Rot turn = Rot::fromAngle(static_cast<Real>(angle));
            BodyDef def = support::boxDef(end + turn * Vec2{0, Real(-0.5)}, Real(0.1), 1);
            def.rotation = turn;
            rods.push_back(world.add(def));
            const Vec2 above = i == 0 ? Vec2{} : Vec2{0, Real(-0.5)};
            pins.push_back(
                world.add(RevoluteJoint{.ends = {last, rods.back(), above, {0, Real(0.5)}}}));
            end += turn * Vec2{0, -1};
            last = rods.back();
        }
    }
    /// The largest joint error (m).
    Real widest() const {
        Real gap = 0;
        Vec2 above{};
        for (const BodyId rod : rods) {
            const BodyView body = world[rod];
            const Vec2 half = Real(0.5) * body.rotation().yAxis();
            gap = std::max(gap, length(body.position() + half - above));
            above = body.position() - half;
        }
        return gap;
    }
};

// A chaotic double pendulum for 10 s: joint errors stay below 0.2 mm where the lower rod is
// fastest. Its energy stays within 1.5 %.
TEST(Pendulum, ADoublePendulumHoldsTogetherAndKeepsItsEnergy) {
    Chain chain(2, {120, 120});
    const auto energy = [&] {
        long double potential = 0;
        for (const BodyId rod : chain.rods) {
            potential += static_cast<long double>(chain.world[rod].mass()) * 10 *
                         (static_cast<long double>(chain.world[rod].center().y) + 2);
        }
        return potential + support::totalsOf(chain.world).kinetic;
    };
    const long double before = energy();
    for (int i = 0; i < 600; ++i) {
        chain.world.step(support::kDt);
        ASSERT_LT(chain.widest(), Real(2e-4)) << "step " << i;
        ASSERT_TRUE(nearShare(energy(), before, 0.015L)) << "step " << i;
    }
}

// In a hanging chain of ten, asleep, no joint gives way. Joint k carries the rods below it.
TEST(Pendulum, AHangingChainCarriesItsWeight) {
    Chain chain(10, {});
    support::run(chain.world, 300);
    EXPECT_NE(chain.world[chain.rods[0]].flags() & kAsleep, 0u);
    EXPECT_LT(chain.widest(), Real(1e-6));
    for (std::size_t k = 0; k < chain.pins.size(); ++k) {
        const double below = static_cast<double>(chain.pins.size() - k); // of 0.1 kg each
        const Vec2 force = chain.world.jointForce(chain.pins[k]);
        EXPECT_TRUE(nearShare(force.y, below, 1e-6)) << k;
        EXPECT_TRUE(near(force.x, 0, Real(1e-6))) << k;
    }
}

} // namespace
} // namespace kodo
