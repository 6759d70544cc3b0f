// SPDX-License-Identifier: MIT
// C2, C7: what a collision record says of an impact: each once, its impulse, and both its points.
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kodo {
namespace {

using support::nearShare;

struct Impact {
    int records = 0; // with an impulse
    int flagged = 0; // steps in which the ball had kColliding
    int begun = 0;
    int ended = 0;
    CollisionRecord last;
    Real leaves = 0; // m/s
};

/// Shoots a ball of 0.5 m at a wall in empty space. The distance decides the phase of the step.
Impact shoot(const StepSettings& settings, Real speed, Real restitution, Real distance) {
    World world({.settings = settings});
    support::addWall(world, 2, 1, support::slippery(restitution));
    BodyDef def =
        support::ballDef({Real(1.5) - distance, 0}, Real(0.5), support::slippery(restitution));
    def.velocity = {speed, 0};
    const BodyId ball = world.add(def);
    Impact impact;
    const int steps = 20 + static_cast<int>(distance / speed / support::kDt);
    for (int i = 0; i < steps; ++i) {
        world.step(support::kDt);
        impact.begun += static_cast<int>(world.begunCollisions().size());
        impact.ended += static_cast<int>(world.endedCollisions().size());
        impact.flagged += (world[ball].flags() & kColliding) != 0 ? 1 : 0;
        for (const CollisionRecord& record : world.hits(0)) {
            ++impact.records;
            impact.last = record;
        }
    }
    impact.leaves = -world[ball].velocity().x;
    return impact;
}

// X9: each impact has a record, with either solver.
TEST(RecordPoints, EachBlowAtAWallHasOneRecordWithItsImpulse) {
    const Real mass = std::numbers::pi_v<Real> / 4;
    for (const support::Solver solver : support::kSolvers) {
        for (const int substeps : {1, 2, 3, 4, 8}) {
            const StepSettings settings =
                support::withSubsteps(support::settingsOf(solver), substeps);
            for (const Real speed : {Real(3), Real(10), Real(30), Real(60), Real(200)}) {
                for (int phase = 0; phase < 12; ++phase) {
                    const Real e = phase % 2 == 0 ? Real(1) : Real(0.5);
                    const Real way = speed * support::kDt * static_cast<Real>(phase) / 12;
                    const Impact impact = shoot(settings, speed, e, Real(0.7) + way);
                    SCOPED_TRACE(testing::Message()
                                 << "solver " << static_cast<int>(solver) << ", " << substeps
                                 << " substeps, " << speed << " m/s, phase " << phase);
                    ASSERT_EQ(impact.records, 1);
                    EXPECT_GE(impact.flagged, 1);
                    EXPECT_EQ(impact.begun, 1);
                    EXPECT_EQ(impact.ended, 1);
                    const long double impulse = static_cast<long double>(mass * speed * (1 + e));
                    EXPECT_TRUE(nearShare(impact.last.totalImpulse, impulse, 1e-5L));
                    EXPECT_TRUE(nearShare(impact.last.maxImpulse, impulse, 1e-5L));
                    EXPECT_TRUE(nearShare(impact.last.approachSpeed, speed, 1e-5L));
                    EXPECT_TRUE(support::near(impact.last.normal, Vec2{-1, 0}, Real(1e-5)));
                    EXPECT_EQ(impact.last.pointCount, 1);
                    EXPECT_TRUE(nearShare(impact.leaves, e * speed, 1e-5L));
                }
            }
        }
    }
}

/// The hit of a box of 1 kg that falls on the floor at 5 m/s, turned by an angle (rad).
CollisionRecord drop(support::Solver solver, Real angle, Real restitution) {
    World world({.settings = support::settingsOf(solver)});
    support::addFloor(world, support::slippery(restitution));
    BodyDef def = support::boxDef({0, 1}, 1, 1, support::slippery(restitution));
    def.rotation = Rot::fromAngle(angle);
    def.velocity = {0, -5};
    world.add(def);
    for (int i = 0; i < 60; ++i) {
        world.step(support::kDt);
        for (const CollisionRecord& record : world.hits(1)) {
            if (record.totalImpulse > 1) {
                return record;
            }
        }
    }
    ADD_FAILURE() << "no hit";
    return {};
}

// On a corner below the centre of mass the box stops as when it lands flat: m v (1 + e) both times.
TEST(RecordPoints, AFlatHitHasTheImpulseOfACornerHit) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real e : {Real(0.5), Real(1)}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(solver) << ", e " << e);
            const long double exact = 5 * (1 + static_cast<long double>(e));
            const CollisionRecord flat = drop(solver, 0, e);
            const CollisionRecord corner = drop(solver, std::numbers::pi_v<Real> / 4, e);
            EXPECT_TRUE(nearShare(flat.maxImpulse, exact, 1e-4L));
            EXPECT_TRUE(nearShare(corner.maxImpulse, exact, 1e-4L));
            ASSERT_EQ(flat.pointCount, 2);
            ASSERT_EQ(corner.pointCount, 1);
            EXPECT_TRUE(nearShare(flat.maxPointImpulse(), exact / 2, 1e-4L));
            EXPECT_TRUE(nearShare(corner.maxPointImpulse(), exact, 1e-4L));
            EXPECT_EQ(corner.points[1], RecordPoint{});
        }
    }
}

// X8: a record holds all of the intersection.
TEST(RecordPoints, BothPointsOfAFlatHitAreTold) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real e : {Real(0), Real(0.5)}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(solver) << ", e " << e);
            const CollisionRecord hit = drop(solver, 0, e);
            ASSERT_EQ(hit.pointCount, 2);
            const Real left = std::min(hit.points[0].position.x, hit.points[1].position.x);
            const Real right = std::max(hit.points[0].position.x, hit.points[1].position.x);
            EXPECT_TRUE(support::near(left, -0.5, 1e-3));
            EXPECT_TRUE(support::near(right, 0.5, 1e-3));
            EXPECT_TRUE(hit.point == hit.points[0].position || hit.point == hit.points[1].position);
            Real sum = 0;
            for (const RecordPoint& point : hit.points) {
                EXPECT_TRUE(support::near(point.position.y, 0, 0.05));
                EXPECT_EQ(point.separation, hit.separation);
                sum += point.maxImpulse;
            }
            EXPECT_TRUE(nearShare(hit.maxImpulse, sum, 1e-5L));
            EXPECT_LE(hit.maxImpulse, hit.totalImpulse * (1 + 4 * support::kEpsilon));
        }
    }
}

} // namespace
} // namespace kodo
