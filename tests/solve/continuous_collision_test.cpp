// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo {
namespace {

// Bodies that fly in a row at one speed do not collide with each other by their own motion. Once
// the wall stops the first one, it stops the next one, and so on. None passes another or the wall,
// at up to a hundred widths per step.
TEST(ContinuousCollision, BodiesBehindAStoppedBodyStopBehindIt) {
    for (const Real speed : {Real(20), Real(60), Real(300), Real(1200)}) {
        SCOPED_TRACE(speed);
        World world;
        world.add({.shape = Box{Real(0.2), 10}, .position = {5, 0}, .type = BodyType::Kinematic});
        std::vector<BodyId> row;
        for (int i = 0; i < 6; ++i) {
            BodyDef def =
                support::boxDef({4 - Real(0.4) * static_cast<Real>(i), 0}, Real(0.2), Real(0.2));
            def.velocity = {speed, 0};
            row.push_back(world.add(def));
        }
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
            Vec2 ahead{5, 0};
            for (const BodyId body : row) {
                const Vec2 place = world[body].position();
                ASSERT_LT(place.x, 5) << "step " << step;
                const bool beside = std::abs(place.y - ahead.y) > Real(0.2); // blown aside
                ASSERT_TRUE(place.x < ahead.x || beside) << "step " << step;
                ahead = place;
            }
        }
    }
}

/// Boxes in a rotating square drum with an inner width of `width` (m).
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
                    .type = BodyType::Kinematic};
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

    /// Largest distance (m) of the middle of a box outside the drum; below 0 inside.
    Real farthestOut(Real width) const {
        Real farthest = -width;
        for (const BodyId box : boxes) {
            const Vec2 p = unrotate(world[wall].rotation(), world[box].position());
            farthest = std::max({farthest, std::abs(p.x) - width / 2, std::abs(p.y) - width / 2});
        }
        return farthest;
    }
};

// A kinematic wall cannot be stopped. Boxes stopped between it and other boxes must not pass
// through it, not even slowly over many steps. Here the corners of the drum move 0.2 m per step,
// which is nearly the size of a box.
TEST(ContinuousCollision, BoxesDoNotPassTheWallsOfATurningDrum) {
    constexpr Real kWidth = 10;
    Drum drum(kWidth, Real(1.75), 22);
    for (int step = 0; step < (support::kSanitized ? 150 : 400); ++step) {
        drum.world.step(support::kDt);
        ASSERT_LT(drum.farthestOut(kWidth), 0) << "step " << step;
    }
}

// A wall that moves by half of its size per step or more does not pass through sleeping bodies. It
// pushes them along like awake ones, in the step in which it reaches them. Bodies that it does not
// reach stay asleep.
TEST(ContinuousCollision, AFastWallPushesSleepingBodiesAlong) {
    for (const Real speed : {Real(6), Real(30), Real(60), Real(120), Real(1000)}) {
        for (const Real start : {Real(-1.1), Real(-1.5), Real(-2.3)}) {
            SCOPED_TRACE(testing::Message() << speed << " m/s from " << start << " m");
            World world({.gravity = support::kEarth});
            support::addFloor(world);
            const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
            const BodyId next = world.add(support::boxDef({1, Real(0.5)}, 1, 1)); // touches it
            const BodyId far = world.add(support::boxDef({-20, Real(0.5)}, 1, 1));
            const BodyId wall = world.add(
                {.shape = Box{1, 3}, .position = {start, Real(1.6)}, .type = BodyType::Kinematic});
            support::run(world, 100);
            ASSERT_NE(world[box].flags() & kAsleep, 0u);
            world[wall].setVelocity({speed, 0});
            for (int step = 0; step < 20; ++step) {
                world.step(support::kDt);
                const Real face = world[wall].position().x + Real(0.5);
                ASSERT_GT(world[box].position().x - Real(0.5), face - Real(0.1)) << step;
                ASSERT_GT(world[next].position().x - Real(0.5), face - Real(0.1)) << step;
            }
            EXPECT_NE(world[far].flags() & kAsleep, 0u);
        }
    }
}

// A ball that meets a fast wall within a step has its impulse in this step, and no second one in
// the next. The impact gives the velocity w = 2 V - v. For the rest of the step the wall carries
// it: it lies at its face.
TEST(ContinuousCollision, ABallBouncingOffAMovingWallGetsItsImpulseWithinTheStep) {
    constexpr Real kWall = 10;  // m/s
    constexpr Real kBall = -12; // m/s
    World world;
    const Material bouncing = support::slippery(1);
    const BodyId wall = world.add({.shape = Box{1, 10},
                                   .position = {Real(-0.85), 0}, // its face is at -0.35 m
                                   .velocity = {kWall, 0},
                                   .material = bouncing,
                                   .type = BodyType::Kinematic});
    BodyDef def = support::ballDef({0, 0}, Real(0.3), bouncing);
    def.velocity = {kBall, 0};
    const BodyId ball = world.add(def);
    world.step(support::kDt / 2);
    EXPECT_TRUE(support::near(world[ball].position().x - Real(0.3),
                              world[wall].position().x + Real(0.5), Real(1e-4)));
    EXPECT_TRUE(support::near(world[ball].velocity().x, 2 * kWall - kBall, Real(1e-4)));
    world.step(support::kDt / 2);
    EXPECT_TRUE(support::near(world[ball].velocity().x, 2 * kWall - kBall, Real(1e-4)));
}

/// Two discs without restitution that approach each other along x.
struct HeadOn {
    World world;
    BodyId left;
    BodyId right;

    /// `way`: approach per step, in radii of the smaller disc.
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

// Within a step, dynamic bodies may overlap by less than the core radius of the smaller one, so its
// middle stays outside; beyond that they are stopped. In both cases they separate to the sides they
// came from, and momentum is conserved, at any speed.
TEST(ContinuousCollision, DynamicBodiesSeparateToTheSidesTheyCameFrom) {
    support::RandomNumbers random(81);
    Real maxOverlapOfAll = 0; // in radii
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
        Real maxOverlap = 0;
        for (int step = 0; step < 120; ++step) {
            pair.world.step(support::kDt);
            maxOverlap = std::max(maxOverlap, -pair.gap());
            ASSERT_LT(pair.world[pair.left].position().x, pair.world[pair.right].position().x);
        }
        EXPECT_LT(maxOverlap, std::min(radiusA, radiusB));
        maxOverlapOfAll = std::max(maxOverlapOfAll, maxOverlap / std::min(radiusA, radiusB));
        EXPECT_GT(pair.gap(), -pair.world.tolerances().slop);
        // Rounding of the momentum of one disc, several times in each of 600 substeps.
        const Real rounding = 600 * std::numeric_limits<Real>::epsilon();
        EXPECT_NEAR(momentum(), before, std::max(push, Real(1)) * rounding);
    }
    EXPECT_GT(maxOverlapOfAll, Real(0.5)) << "no pair overlapped as far as is permitted";
}

// A locked body does not yield, so half of the core radius is permitted.
TEST(ContinuousCollision, ABallEntersAKinematicWallByAtMostHalfItsRadius) {
    constexpr Real kRadius = Real(0.5);
    const Real kNearly = 8 * std::numeric_limits<Real>::epsilon(); // m, at coordinates of about 1 m
    support::RandomNumbers random(82);
    for (int i = 0; i < 300; ++i) {
        const Real way = random.between(0.01, i % 2 == 0 ? 0.6 : 20); // m a step
        SCOPED_TRACE(testing::Message() << way << " m a step");
        World world;
        world.add({.shape = Box{1, 10}, .position = {Real(0.5), 0}, .type = BodyType::Kinematic});
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

/// A thin obstacle of a box: a kinematic body, a part of a larger one, or a body added later.
enum class Thin { Locked, Part, Later };

void expectStopped(Thin thin, Real way, Real start) {
    constexpr Real kThickness = Real(0.02); // m
    constexpr Real kSide = Real(0.4);       // of the box
    World world;
    const Box slab{kThickness, 6};
    BodyDef def{.shape = slab, .type = BodyType::Kinematic};
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
        // half of the core radius of the obstacle, which is half of its thickness
        ASSERT_LT(depth, kThickness / 4 + world.tolerances().slop) << "step " << step;
    }
}

// Without restitution, bodies slower than the thinnest body requires are not tested. That body may
// be a kinematic one without motion, a part of a larger body, or one added later.
TEST(ContinuousCollision, AThinObstacleOfAnyOriginStopsABox) {
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

/// Lowest height (m) of the middle of a rod that would turn away from a floor at height 0 just
/// before its corner touches it, while a heavier ball strikes its back.
Real lowestOfStruckRod(support::RandomNumbers& random, const StepSettings& settings, Real rate,
                       Real restitution, Real side, Real place) {
    constexpr Real kLength = Real(0.284); // m
    constexpr Real kThickness = Real(0.0946);
    constexpr Real kRadius = Real(0.12); // of the ball
    const Material material{Real(0.5), Real(0.5), restitution, 0};
    World world({.gravity = support::kEarth, .settings = settings});
    world.add({.shape = Box{40, 2},
               .position = {place, -1},
               .material = material,
               .type = BodyType::Static});
    const Rot rotation = Rot::fromAngle(side * random.between(-0.3, 0.3));
    const Vec2 corner{rotation.s > 0 ? -kLength / 2 : kLength / 2, -kThickness / 2};
    BodyDef rod{.shape = Box{kLength, kThickness}, .rotation = rotation, .material = material};
    rod.position = {place, random.between(0.0005, 0.0035) - (rotation * corner).y};
    rod.angularVelocity = side * random.between(-40, 40);
    rod.velocity = {0, -(rotation * corner).x * rod.angularVelocity - random.between(0, 1.5)};
    const Real x = side * random.between(-0.12, 0.12);
    const Real back = (kThickness / 2 + kRadius) / rotation.c + x * rotation.s / rotation.c;
    BodyDef ball{.shape = Circle{kRadius}, .material = material, .density = 2};
    ball.position = {place + x, rod.position.y + back + Real(0.012)};
    ball.velocity = {0, -random.between(2, 12)};
    const BodyId body = world.add(rod);
    world.add(ball);
    Real lowest = 1;
    for (int step = 0; step < static_cast<int>(rate / 2); ++step) {
        world.step(1 / rate);
        lowest = std::min(lowest, world[body].center().y);
    }
    return lowest;
}

// Narrow sees that the corner passes the floor, and takes its manifold away. A third body that
// strikes the rod in this step changes that: continuous collision then stops it at the floor. At 30
// Hz without restitution, 7 of 500 touch the floor first and are turned into it by a radian.
TEST(ContinuousCollision, ARodThatAThirdBodyStrikesDoesNotEnterTheGroundThatItWouldPass) {
    for (const StepSettings& settings : {balanced(), accurate()}) {
        for (const Real restitution : {Real(0), Real(0.18), Real(0.5)}) {
            for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
                support::RandomNumbers random(7);
                for (int i = 0; i < support::draws(200) && (rate > 30 || restitution > 0); ++i) {
                    const Real side = i % 2 == 0 ? Real(1) : Real(-1);
                    const Real place = i % 3 == 0 ? Real(100) : Real(0);
                    EXPECT_GT(lowestOfStruckRod(random, settings, rate, restitution, side, place),
                              Real(0.01))
                        << rate << " Hz, restitution " << restitution << ", " << i;
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
