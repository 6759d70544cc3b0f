// SPDX-License-Identifier: MIT
// Bodies with more contacts than colours.
#include <kodo/world.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace kodo {
namespace {

using support::kDt;

/// A plank over discs on the ground.
struct Plank {
    World world{{.gravity = support::kEarth}};
    std::vector<BodyId> discs;
    BodyId plank;

    Plank(int count, Real density) {
        constexpr Real kRadius = Real(0.1);
        constexpr Real kApart = Real(0.25);
        support::addFloor(world);
        for (int i = 0; i < count; ++i) {
            discs.push_back(world.add(
                {.shape = Circle{kRadius}, .position = {static_cast<Real>(i) * kApart, kRadius}}));
        }
        const Real length = static_cast<Real>(count) * kApart;
        plank = world.add({.shape = Box{length, Real(0.2)},
                           .position = {(length - kApart) / 2, Real(0.3)},
                           .density = density,
                           .flags = kNeverSleep});
    }
};

// The contacts carry the weight of the plank, whatever its mass. Nothing moves sideways or turns.
TEST(SharedBody, APlankRestsOnManyDiscs) {
    for (const int count : {40, 100, 400}) {
        for (const Real density : {Real(0.01), Real(1), Real(100)}) {
            SCOPED_TRACE(testing::Message() << count << " discs, density " << density);
            Plank scene(count, density);
            for (int step = 0; step < 240; ++step) {
                scene.world.step(kDt);
            }
            Real carried = 0;
            for (const CollisionRecord& record : scene.world.collisions(scene.plank)) {
                carried += record.totalImpulse;
            }
            const auto plank = scene.world[scene.plank];
            const Real weight = plank.mass() * length(support::kEarth) * kDt;
            EXPECT_NEAR(carried / weight, 1, 0.01);
            EXPECT_NEAR(plank.position().y, 0.3, 0.002);
            EXPECT_NEAR(plank.rotation().s, 0, 1e-4);
            EXPECT_NEAR(length(plank.velocity()), 0, 0.01); // a light plank rolls on the discs
        }
    }
}

// Without external forces the momentum of a wheel and of the discs that hit it stays, and friction
// of many contacts adds no energy.
TEST(SharedBody, KeepsMomentumAndGainsNoEnergy) {
    constexpr int kDiscs = 240;
    World world;
    const BodyId wheel = world.add({.shape = Circle{10}, .angularVelocity = 1});
    for (int i = 0; i < kDiscs; ++i) {
        const Rot at = Rot::fromAngle(2 * std::numbers::pi_v<Real> * static_cast<Real>(i) / kDiscs);
        const Vec2 out{at.c, at.s};
        world.add({.shape = Circle{Real(0.1)},
                   .position = Real(10.15) * out,
                   .velocity = Real(-1 - i % 3) * out});
    }
    const auto measure = [&] {
        struct {
            Vec2 momentum;
            Real spin = 0, energy = 0, size = 0;
        } sum;
        for (const BodyId id : world.bodies()) {
            const auto body = world[id];
            const Vec2 p = body.mass() * body.velocity();
            sum.momentum += p;
            sum.size += length(p);
            sum.spin += cross(body.position(), p) + body.inertia() * body.angularVelocity();
            sum.energy += (dot(p, body.velocity()) +
                           body.inertia() * body.angularVelocity() * body.angularVelocity()) /
                          2;
        }
        return sum;
    };
    const auto before = measure();
    Real energy = before.energy;
    const Real rounding = sizeof(Real) == 4 ? Real(1e-4) : Real(1e-9);
    const Real arms = Real(1e-5); // they are fixed within a step
    for (int step = 0; step < 120; ++step) {
        world.step(kDt);
        const auto now = measure();
        ASSERT_LE(length(now.momentum - before.momentum), rounding * before.size) << step;
        ASSERT_LE(std::abs(now.spin - before.spin), (rounding + arms) * std::abs(before.spin));
        ASSERT_LE(now.energy, energy * (1 + rounding)) << step;
        energy = now.energy;
    }
    EXPECT_LT(world[wheel].angularVelocity(), Real(0.999)); // the discs were touched
}

} // namespace
} // namespace kodo
