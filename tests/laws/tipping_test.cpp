// SPDX-License-Identifier: MIT
// Bodies that stand almost balanced on one corner [Thesis06, 5.2.1, fig. 5.3].
#include <support/scenes.hpp>
#include <support/solver.hpp>
#include <support/tipping.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace kodo {
namespace {

struct Fall {
    support::Solver solver;
    int rate; // Hz
    double off;
    Real place; // m, of the body on the floor
    // Variants that are the same fall:
    Real mirror = 1; // -1: to the other side
    Real boost = 0;  // m/s, of body and floor
};

/// Simulated time (s) over the exact one, of a convex shape whose corner at `corner` is on the
/// floor.
double timeShare(const Fall& fall, std::vector<Vec2> corners, Vec2 corner) {
    if (fall.mirror < 0) {
        std::reverse(corners.begin(), corners.end());
        for (Vec2& each : corners) {
            each.x = -each.x;
        }
        corner.x = -corner.x;
    }
    World world({.gravity = {0, -10}, .settings = support::settingsOf(fall.solver)});
    const BodyId floor = support::addFloor(world, withFriction(2));
    if (fall.boost != 0) {
        world[floor].setType(BodyType::Kinematic);
        world[floor].setVelocity({fall.boost, 0});
    }
    const double mirror = static_cast<double>(fall.mirror);
    const double balance =
        std::atan2(-static_cast<double>(corner.x), -static_cast<double>(corner.y));
    BodyDef def;
    def.shape = Polygon{std::move(corners)};
    def.material = withFriction(2);
    def.rotation = Rot::fromAngle(static_cast<Real>(balance + mirror * fall.off));
    def.position = {fall.place, -(def.rotation * corner).y};
    def.velocity = {fall.boost, 0};
    const BodyRef body = world[world.add(def)];
    const double r = static_cast<double>(length(corner));
    const double m = static_cast<double>(body.mass());
    const double exact =
        support::fallTime(fall.off, 10 * r * m / (static_cast<double>(body.inertia()) + m * r * r));
    for (int step = 1; step < 20 * fall.rate; ++step) {
        world.step(1 / static_cast<Real>(fall.rate));
        const double turned = std::atan2(static_cast<double>(body.rotation().s),
                                         static_cast<double>(body.rotation().c)) -
                              balance;
        if (mirror * turned > support::kFallen) {
            return (step - 0.5) / fall.rate / exact;
        }
    }
    return 20 / exact;
}

/// Three shapes of unlike height.
void expectPendulum(const Fall& fall) {
    // The share of 0.75 steps in a fall of a second, the shortest one, comes on top.
    const double tolerance = 0.05 + 0.75 / fall.rate;
    SCOPED_TRACE(std::to_string(static_cast<int>(fall.solver)) + " solver, " +
                 std::to_string(fall.rate) + " Hz, off by " + std::to_string(fall.off) +
                 " rad, at " + std::to_string(fall.place) + " m, mirror " +
                 std::to_string(fall.mirror) + ", boost " + std::to_string(fall.boost));
    const auto box = [](Real x, Real y) {
        return std::vector<Vec2>{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    };
    EXPECT_NEAR(timeShare(fall, box(Real(0.2), Real(0.5)), {Real(-0.2), Real(-0.5)}), 1, tolerance);
    EXPECT_NEAR(timeShare(fall, box(1, 1), {-1, -1}), 1, tolerance);
    EXPECT_NEAR(timeShare(fall, {{0, -1}, {1, Real(0.5)}, {-1, Real(0.5)}}, {0, -1}), 1, tolerance);
}

template <typename Visit>
void forEachFall(Visit visit) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 120, 240}) {
            for (const double off : {0.03, 0.01, 0.001, 0.0003}) {
                visit(Fall{solver, rate, off, 0});
            }
        }
    }
}

// An arm that stays what it was some slops of motion ago would make the start too slow: a body
// that is off by a thousandth of a radian has a lever of half a millimetre.
TEST(Tipping, TakesTheTimeOfAPendulumUpsideDown) {
    forEachFall([](Fall fall) {
        for (const Real place : {Real(0), Real(-60)}) {
            fall.place = place;
            expectPendulum(fall);
        }
    });
}

TEST(Tipping, TakesTheSameTimeMirroredAndOnAMovingFloor) {
    forEachFall([](Fall fall) {
        for (const Real boost : {Real(0), Real(-3), Real(0.5)}) {
            fall.boost = boost;
            fall.mirror = -1;
            expectPendulum(fall);
            fall.mirror = 1;
            if (boost != 0) {
                expectPendulum(fall);
            }
        }
    });
}

} // namespace
} // namespace kodo
