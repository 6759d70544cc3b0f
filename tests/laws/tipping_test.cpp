// SPDX-License-Identifier: MIT
// Bodies that stand almost balanced on one corner [Thesis06, 5.2.1, fig. 5.3].
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <cmath>

namespace kodo {
namespace {

constexpr double kFallen = 0.5; // rad from the balance: where the time of a fall is taken

/// Time (s) in which a body on a corner that does not slip turns from `off` to kFallen (rad): a
/// pendulum upside down, angle'' = rate sin(angle), `rate` in 1/s^2.
double fallTime(double off, double rate) {
    constexpr double h = 1e-4; // s; leapfrog
    double angle = off;
    double speed = 0;
    double time = 0;
    for (; angle < kFallen; time += h) {
        angle += h / 2 * speed;
        speed += h * rate * std::sin(angle);
        angle += h / 2 * speed;
    }
    return time;
}

struct Fall {
    support::Solver solver;
    int rate; // Hz
    double off;
    Real place; // m, of the body on the floor
};

/// Simulated time (s) over the exact one, of a body whose corner at `corner` is on the floor.
double timeShare(const Fall& fall, const Shape& shape, Vec2 corner) {
    World world({.gravity = {0, -10}, .settings = support::settingsOf(fall.solver)});
    support::addFloor(world, withFriction(2));
    const double balance =
        std::atan2(-static_cast<double>(corner.x), -static_cast<double>(corner.y));
    BodyDef def;
    def.shape = shape;
    def.material = withFriction(2);
    def.rotation = Rot::fromAngle(static_cast<Real>(balance + fall.off));
    def.position = {fall.place, -(def.rotation * corner).y};
    const BodyRef body = world[world.add(def)];
    const double r = static_cast<double>(length(corner));
    const double m = static_cast<double>(body.mass());
    const double exact =
        fallTime(fall.off, 10 * r * m / (static_cast<double>(body.inertia()) + m * r * r));
    for (int step = 1; step < 20 * fall.rate; ++step) {
        world.step(1 / static_cast<Real>(fall.rate));
        const double turned = std::atan2(static_cast<double>(body.rotation().s),
                                         static_cast<double>(body.rotation().c)) -
                              balance;
        if (turned > kFallen) {
            return (step - 0.5) / fall.rate / exact;
        }
    }
    return 20 / exact;
}

// An arm that stays what it was some slops of motion ago would make the start too slow: a body
// that is off by a thousandth of a radian has a lever of half a millimetre.
TEST(Tipping, TakesTheTimeOfAPendulumUpsideDown) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 120, 240}) {
            for (const double off : {0.03, 0.01, 0.001, 0.0003}) {
                for (const Real place : {Real(0), Real(-60)}) {
                    const Fall fall{solver, rate, off, place};
                    // The share of 0.75 steps in a fall of a second, the shortest one, comes on
                    // top.
                    const double tolerance = 0.05 + 0.75 / rate;
                    SCOPED_TRACE(std::to_string(static_cast<int>(solver)) + " solver, " +
                                 std::to_string(rate) + " Hz, off by " + std::to_string(off) +
                                 " rad, at " + std::to_string(place) + " m");
                    EXPECT_NEAR(timeShare(fall, Box{Real(0.4), 1}, {Real(-0.2), Real(-0.5)}), 1,
                                tolerance);
                    EXPECT_NEAR(timeShare(fall, Box{2, 2}, {-1, -1}), 1, tolerance);
                    EXPECT_NEAR(timeShare(fall, Polygon{{{0, -1}, {1, Real(0.5)}, {-1, Real(0.5)}}},
                                          {0, -1}),
                                1, tolerance);
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
