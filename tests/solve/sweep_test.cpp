// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo {
namespace {

// What flies in a row does not meet within a step, by its motion alone; but once the first is
// stopped by the wall, the next is stopped by the first, and so on. One by one they pass neither
// each other nor the wall, at up to a hundred widths a step.
TEST(Sweep, WhatFollowsAStoppedBodyStopsBehindIt) {
    for (const Real speed : {Real(20), Real(60), Real(300), Real(1200)}) {
        SCOPED_TRACE(speed);
        World world;
        world.add({.shape = Box{Real(0.2), 10}, .position = {5, 0}, .flags = kLocked});
        std::vector<BodyId> row;
        for (int i = 0; i < 6; ++i) {
            BodyDef def =
                support::boxDef({4 - Real(0.4) * static_cast<Real>(i), 0}, Real(0.2), Real(0.2));
            def.velocity = {speed, 0};
            row.push_back(world.add(def));
        }
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
            Real ahead = 5;
            for (const BodyId body : row) {
                const Real x = world[body].position().x;
                ASSERT_LT(x, ahead) << "step " << step;
                ahead = x;
            }
        }
    }
}

/// Boxes in a square drum that turns, `width` (m) inside.
struct Drum {
    World world{{.gravity = support::kEarth}};
    BodyId wall;
    std::vector<BodyId> boxes;

    Drum(Real width, Real spin, int rows) {
        const Real side = (width + 1) / 2;
        BodyDef def{.shape = Compound{{Box{.width = width + 2, .height = 1, .center = {0, -side}},
                                       Box{.width = width + 2, .height = 1, .center = {0, side}},
                                       Box{.width = 1, .height = width, .center = {-side, 0}},
                                       Box{.width = 1, .height = width, .center = {side, 0}}}},
                    .flags = kLocked};
        def.angularVelocity = spin;
        wall = world.add(def);
        for (int i = 0; i < rows * rows; ++i) {
            const auto at = [&](int place) {
                return Real(0.4) * (static_cast<Real>(place) - static_cast<Real>(rows - 1) / 2);
            };
            boxes.push_back(
                world.add(support::boxDef({at(i % rows), at(i / rows)}, Real(0.25), Real(0.25))));
        }
    }

    /// m; the farthest that the middle of a box is out of the drum, below 0 inside.
    Real farthestOut(Real width) const {
        Real farthest = -width;
        for (const BodyId box : boxes) {
            const Vec2 p = unrotate(world[wall].rotation(), world[box].position());
            farthest = std::max({farthest, std::abs(p.x) - width / 2, std::abs(p.y) - width / 2});
        }
        return farthest;
    }
};

// A wall that moves cannot be stopped; what is stopped between it and others that fall on it must
// not be run over, a little in each step, until it is out. Here the walls go 0.2 m a step at the
// corners of the drum, which is nearly a box, and throw all that is in it about.
TEST(Sweep, NobodyIsRunOverByTheWallsOfATurningDrum) {
    constexpr Real kWidth = 10;
    Drum drum(kWidth, Real(1.75), 22);
    for (int step = 0; step < 400; ++step) {
        drum.world.step(support::kDt);
        ASSERT_LT(drum.farthestOut(kWidth), 0) << "step " << step;
    }
}

// A wall that goes half of its size a step or more does not run over what rests: that is pushed
// along like what is awake, in the very step in which it is reached, and keeps ahead of the wall;
// what the wall does not reach rests on.
TEST(Sweep, AFastWallPushesWhatRestsAlong) {
    for (const Real speed : {Real(6), Real(30), Real(60), Real(120), Real(1000)}) {
        for (const Real start : {Real(-1.1), Real(-1.5), Real(-2.3)}) {
            SCOPED_TRACE(testing::Message() << speed << " m/s from " << start << " m");
            World world({.gravity = support::kEarth});
            support::addFloor(world);
            const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
            const BodyId next = world.add(support::boxDef({1, Real(0.5)}, 1, 1)); // touches it
            const BodyId far = world.add(support::boxDef({-20, Real(0.5)}, 1, 1));
            const BodyId wall =
                world.add({.shape = Box{1, 3}, .position = {start, Real(1.6)}, .flags = kLocked});
            support::run(world, 100);
            ASSERT_NE(world[box].flags() & kResting, 0u);
            world[wall].setVelocity({speed, 0});
            for (int step = 0; step < 20; ++step) {
                world.step(support::kDt);
                const Real face = world[wall].position().x + Real(0.5);
                ASSERT_GT(world[box].position().x - Real(0.5), face - Real(0.1)) << step;
                ASSERT_GT(world[next].position().x - Real(0.5), face - Real(0.1)) << step;
            }
            EXPECT_NE(world[far].flags() & kResting, 0u);
        }
    }
}

// A fast wall does not carry along what bounces off it, before the blow that sends it away, by a
// whole step's way, if need be into another wall. The blow gives w = 2 V - v.
TEST(Sweep, WhatBouncesOffAMovingWallIsNotCarriedByIt) {
    constexpr Real kWall = 10;  // m/s
    constexpr Real kBall = -12; // m/s
    World world;
    const Material bouncing = support::slippery(1);
    world.add({.shape = Box{1, 10},
               .position = {Real(-0.85), 0}, // its face is at -0.35 m
               .velocity = {kWall, 0},
               .material = bouncing,
               .flags = kLocked});
    BodyDef def = support::ballDef({0, 0}, Real(0.3), bouncing);
    def.velocity = {kBall, 0};
    const BodyId ball = world.add(def);
    world.step(support::kDt / 2);
    EXPECT_LE(world[ball].position().x, 0);
    EXPECT_EQ(world[ball].velocity().x, kBall);
    world.step(support::kDt / 2);
    EXPECT_TRUE(support::near(world[ball].velocity().x, 2 * kWall - kBall, Real(1e-4)));
}

/// Two discs without restitution, which come towards each other along x.
struct HeadOn {
    World world;
    BodyId left;
    BodyId right;

    /// `way` is how far they go towards each other in a step, in radii of the smaller.
    HeadOn(Real radiusA, Real radiusB, Real start, Real way) {
        const Real speed = way * std::min(radiusA, radiusB) / (2 * support::kDt);
        BodyDef def = support::ballDef({-radiusA - start / 2, 0}, radiusA);
        def.velocity = {speed, 0};
        left = world.add(def);
        def = support::ballDef({radiusB + start / 2, 0}, radiusB);
        def.velocity = {-speed, 0};
        right = world.add(def);
    }
    Real gap() const {
        return world[right].position().x - world[right].bounds().extent().x / 2 -
               (world[left].position().x + world[left].bounds().extent().x / 2);
    }
};

// Loose bodies may go into each other by less than the smaller one's inner radius within a step, so
// that its middle stays outside; whoever would go farther is stopped. Either way they part to the
// sides that they came from, and momentum is kept, however fast they are.
TEST(Sweep, LooseBodiesPartToTheSidesTheyCameFrom) {
    support::RandomNumbers random(81);
    Real deepestOfAll = 0; // in radii
    for (int i = 0; i < 300; ++i) {
        const Real way = random.between(0.1, i % 2 == 0 ? 1 : 30);
        const Real radiusA = random.between(0.1, 1);
        const Real radiusB = random.between(0.1, 1);
        SCOPED_TRACE(testing::Message()
                     << way << " radii a step, radii " << radiusA << " and " << radiusB << " m");
        HeadOn pair(radiusA, radiusB, random.between(0.05, 1), way);
        const auto momentum = [&] {
            return pair.world[pair.left].mass() * pair.world[pair.left].velocity().x +
                   pair.world[pair.right].mass() * pair.world[pair.right].velocity().x;
        };
        const Real before = momentum();
        const Real push = pair.world[pair.left].mass() * pair.world[pair.left].velocity().x;
        Real deepest = 0;
        for (int step = 0; step < 120; ++step) {
            pair.world.step(support::kDt);
            deepest = std::max(deepest, -pair.gap());
            ASSERT_LT(pair.world[pair.left].position().x, pair.world[pair.right].position().x);
        }
        EXPECT_LT(deepest, std::min(radiusA, radiusB));
        deepestOfAll = std::max(deepestOfAll, deepest / std::min(radiusA, radiusB));
        EXPECT_GT(pair.gap(), -pair.world.tolerances().slop);
        // By roundings of the push, of which there are some in each of 600 substeps.
        const Real rounding = 600 * std::numeric_limits<Real>::epsilon();
        EXPECT_NEAR(momentum(), before, std::max(push, Real(1)) * rounding);
    }
    EXPECT_GT(deepestOfAll, Real(0.5)) << "nobody went as far as a sweep lets them";
}

// What is locked does not give way, so only half of that is let into it.
TEST(Sweep, NobodyGoesFarIntoWhatIsLocked) {
    constexpr Real kRadius = Real(0.5);
    const Real kNearly = 8 * std::numeric_limits<Real>::epsilon(); // m, of places about 1 m
    support::RandomNumbers random(82);
    for (int i = 0; i < 300; ++i) {
        const Real way = random.between(0.01, i % 2 == 0 ? 0.6 : 20); // m a step
        SCOPED_TRACE(testing::Message() << way << " m a step");
        World world;
        world.add({.shape = Box{1, 10}, .position = {Real(0.5), 0}, .flags = kLocked});
        BodyDef def = support::ballDef({-kRadius - random.between(0.05, 1), 0}, kRadius);
        def.velocity = {way / support::kDt, 0};
        const BodyId ball = world.add(def);
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
            const Real depth = world[ball].position().x + kRadius;
            ASSERT_LE(depth, kRadius / 2 + kNearly) << "step " << step;
        }
    }
}

/// Something thin in the way of a box, and how it came into the World.
enum class Thin { Locked, Part, Later };

void expectStopped(Thin thin, Real way, Real start) {
    constexpr Real kThickness = Real(0.02); // m
    constexpr Real kSide = Real(0.4);       // of the box
    World world;
    const Box slab{kThickness, 6};
    BodyDef def{.shape = slab, .flags = kLocked};
    if (thin == Thin::Part) {
        def.shape = Compound{{slab, Box{.width = 4, .height = 4, .center = {0, 9}}}};
    }
    if (thin != Thin::Later) {
        world.add(def);
    }
    BodyDef thrown = support::boxDef({start - (kSide + kThickness) / 2, 0}, kSide, kSide);
    thrown.velocity = {way / support::kDt, 0};
    const BodyId box = world.add(thrown);
    world.step(support::kDt);
    if (thin == Thin::Later) {
        world.add(def);
    }
    for (int step = 0; step < 100; ++step) {
        world.step(support::kDt);
        const Real depth = world[box].position().x + (kSide + kThickness) / 2;
        // half of the thinner one's inner radius, which is half of the thickness
        ASSERT_LT(depth, kThickness / 4 + world.tolerances().slop) << "step " << step;
    }
}

// Where nothing bounces, who is too slow for the thinnest of all bodies is not looked at: that may
// be a locked one, which takes no part in a step, a part of a larger one, or one that came later.
TEST(Sweep, SeesWhatIsThinWhoeverItBelongsTo) {
    for (const Thin thin : {Thin::Locked, Thin::Part, Thin::Later}) {
        for (const Real way : {Real(0.03), Real(0.045), Real(0.1), Real(0.4)}) { // m a step
            for (const Real start : {Real(-1), Real(-1.01), Real(-1.02), Real(-1.03)}) {
                SCOPED_TRACE(testing::Message() << static_cast<int>(thin) << ", " << way
                                                << " m a step from " << start << " m");
                expectStopped(thin, way, start);
            }
        }
    }
}

} // namespace
} // namespace kodo
