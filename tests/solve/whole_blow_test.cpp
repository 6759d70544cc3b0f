// SPDX-License-Identifier: MIT
// One blow without restitution is one record, at any phase of the step.
#include "support/solver.hpp"
#include <kodo/kodo.hpp>
#include <support/near.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace kodo;
using support::nearShare;
using support::Solver;

constexpr int kPhases = 24;

struct Throw {
    Solver solver = Solver::Propagation;
    Shape shape{};
    Real radius = 0; // m, from the centre to the wall at the touch
    BodyType wall = BodyType::Static;
    Real rate = 60;    // Hz
    Real speed = 1;    // m/s, towards the wall
    Real frame = 0;    // m/s, along the wall, added to all that moves
    bool left = false; // the direction of the throw
    Vec2 place{};      // m
    int phase = 0;     // 0 to kPhases - 1
};

BodyDef bodyOf(BodyType type, const Shape& shape, Vec2 position, Vec2 velocity) {
    BodyDef def;
    def.type = type;
    def.shape = shape;
    def.position = position;
    def.velocity = velocity;
    def.material = withFriction(0);
    return def;
}

/// Impulses of a record, in units of the right value, J = v / (1/m_a + 1/m_b) [Thesis06, eq. 4.9
/// with e = 0].
struct Blow {
    Real largest;
    Real total;
};

/// The records with an impulse, without gravity.
std::vector<Blow> blowsOf(const Throw& t) {
    World world{{.gravity = {}, .settings = settingsOf(t.solver)}};
    const Real side = t.left ? Real(-1) : Real(1);
    const Vec2 along{0, t.wall == BodyType::Static ? Real(0) : t.frame};
    const BodyId wall = world.add(bodyOf(t.wall, Box{2, 8}, t.place, along));
    const Real way = t.speed / t.rate * (1 + static_cast<Real>(t.phase) / kPhases);
    const Vec2 start = t.place - Vec2{side * (1 + t.radius + way), 0};
    const BodyId body =
        world.add(bodyOf(BodyType::Dynamic, t.shape, start, along + Vec2{side * t.speed, 0}));
    const Real give = t.wall == BodyType::Dynamic ? 1 / world[wall].mass() : Real(0);
    const Real whole = t.speed / (1 / world[body].mass() + give);
    std::vector<Blow> blows;
    for (int i = 0; i < 6; ++i) {
        world.step(1 / t.rate);
        for (const CollisionRecord& record : world.collisions()) {
            if (record.maxImpulse > Real(1e-4) * whole) {
                blows.push_back({record.maxImpulse / whole, record.totalImpulse / whole});
            }
        }
    }
    return blows;
}

// Regression: the thesis's solver braked a body to arrive at the end of the step, and stopped it
// with the next one, so that the first record held any share of the blow from 0 to 1.
TEST(WholeBlow, IsOneRecordAtAnyPhaseOfTheStep) {
    const std::pair<Shape, Real> kShapes[] = {{Circle{Real(0.5)}, Real(0.5)},
                                              {Box{1, 1}, Real(0.5)},
                                              {Capsule{{-1, 0}, {1, 0}, Real(0.25)}, Real(1.25)},
                                              {Polygon{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}, 1}};
    const auto check = [&](Throw t) {
        for (const auto& [shape, radius] : kShapes) {
            t.shape = shape;
            t.radius = radius;
            const std::vector<Blow> blows = blowsOf(t);
            Real sum = 0;
            for (const Blow& blow : blows) {
                sum += blow.total;
            }
            EXPECT_TRUE(nearShare(sum, 1, 0.01)) << t.rate << " Hz, " << t.phase;
            // The soft solver brakes in one substep and stops in the next.
            if (t.solver == Solver::Propagation) {
                ASSERT_EQ(blows.size(), 1u) << t.rate << " Hz, " << t.speed << " m/s, " << t.phase;
                EXPECT_TRUE(nearShare(blows[0].largest, 1, 0.01)) << t.rate << " Hz, " << t.phase;
            }
        }
    };
    for (const Solver solver : support::kSolvers) {
        for (const BodyType wall : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
            for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
                for (const Real speed : {Real(1), Real(4), Real(12)}) {
                    for (int phase = 0; phase < kPhases; ++phase) {
                        check({.solver = solver,
                               .wall = wall,
                               .rate = rate,
                               .speed = speed,
                               .frame = phase % 4 == 0 ? Real(3) : Real(0),
                               .left = phase % 2 == 1,
                               .place = phase % 3 == 0 ? Vec2{40, -7} : Vec2{},
                               .phase = phase});
                    }
                }
            }
        }
    }
}

} // namespace
