// SPDX-License-Identifier: MIT
// F1: seams of flush ground. What lands beside one is not turned aside, and its blow is told.
#include <kodo/world.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

using support::draws;
using support::RandomNumbers;

enum class Ground { Tiles, MovingTiles, PartsOfABody };
constexpr int kRates[] = {30, 60, 120, 240}; // Hz

/// Tiles of 1 m with their surface at height 0, from -4 to 4 m. Those that move stand still.
void addTiles(World& world, Ground ground, const Material& material) {
    Compound parts;
    for (int i = -4; i < 4; ++i) {
        const Vec2 center{static_cast<Real>(i) + Real(0.5), Real(-0.5)};
        parts.parts.emplace_back(Box{1, 1, center});
        if (ground != Ground::PartsOfABody) {
            world.add({.shape = Box{1, 1},
                       .position = center,
                       .material = material,
                       .type = ground == Ground::Tiles ? BodyType::Static : BodyType::Kinematic});
        }
    }
    if (ground == Ground::PartsOfABody) {
        world.add({.shape = parts, .material = material, .type = BodyType::Static});
    }
}

/// m/s, the largest speed to a side of a body that falls straight down, without friction.
Real asideOf(const BodyDef& def, Ground ground, const StepSettings& settings, int rate) {
    World world({.gravity = support::kEarth, .settings = settings});
    addTiles(world, ground, def.material);
    const BodyId body = world.add(def);
    Real most = 0;
    for (int step = 0; step < rate; ++step) {
        world.step(1 / static_cast<Real>(rate));
        most = std::max(most, std::abs(world[body].velocity().x));
    }
    return most;
}

// Closed form: every normal points straight up, so nothing moves to a side. Regression: a contact
// with the corner of the tile beside was hidden only within a slop of the surface, so that a body
// which began the step with a gap of 10 mm was braked by both, and left at 1.4 m/s. The solver of
// the thesis found the corner where it predicted the body, in the ground: 11 m/s.
// Faces and their normals are exact here; the bound is the rounding of the arms at 15 m/s.
TEST(Seam, TurnsNothingAsideThatLandsBesideIt) {
    for (const StepSettings& settings : {balanced(), accurate(), fast(), thesis2006()}) {
        for (const int rate : kRates) {
            for (const Ground ground : {Ground::Tiles, Ground::MovingTiles, Ground::PartsOfABody}) {
                for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
                    RandomNumbers random(3);
                    for (int i = 0; i < std::max(draws(36), 4); ++i) {
                        BodyDef def;
                        def.shape = i % 3 == 0   ? Shape(Circle{Real(0.5)})
                                    : i % 3 == 1 ? Shape(Capsule{{-1, 0}, {1, 0}, Real(0.5)})
                                                 : Shape(Circle{Real(0.2)});
                        const Real end = i % 3 == 1 ? 1 : 0; // of a capsule, beside the seam
                        def.position = {end + random.between(-0.3, 0.3), random.between(1, 2)};
                        def.velocity = {0, -random.between(0, 10)};
                        def.material = support::slippery(restitution);
                        def.flags = kLockRotate;
                        ASSERT_LT(asideOf(def, ground, settings, rate), Real(1e-5))
                            << "draw " << i << ", solver " << settings.solver.index() << ", "
                            << rate << " Hz, ground " << static_cast<int>(ground)
                            << ", restitution " << restitution << ", x " << def.position.x;
                    }
                }
            }
        }
    }
}

// The same for a ball that comes from a side, to any place: it keeps its speed. Normals that differ
// by less than 0.0045 rad count as those of one surface, and both act: up to 2 mm beside the seam
// that share of a blow may go to the side.
TEST(Seam, TakesNoSpeedFromABallThatLandsAcrossIt) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : kRates) {
            RandomNumbers random(5);
            for (int i = 0; i < std::max(draws(60), 6); ++i) {
                World world({.settings = support::settingsOf(solver)});
                addTiles(world, Ground::Tiles, support::slippery());
                const Real speed = random.between(-3, 3);
                const BodyId ball = world.add({.shape = Circle{Real(0.5)},
                                               .position = {random.between(-0.5, 0.5), 1},
                                               .velocity = {speed, -random.between(3, 12)},
                                               .material = support::slippery()});
                for (int step = 0; step < rate / 2; ++step) {
                    const Vec2 before = world[ball].velocity();
                    world.step(1 / static_cast<Real>(rate));
                    const Vec2 blow = world[ball].velocity() - before;
                    ASSERT_LE(std::abs(blow.x), Real(0.0045) * std::abs(blow.y) + Real(1e-5))
                        << "draw " << i << ", solver " << static_cast<int>(solver) << ", " << rate
                        << " Hz";
                }
            }
        }
    }
}

// A tile that stands out by ten slops has a real corner. A ball that comes down on it beside the
// seam meets it before the lower tile, at a normal n, and leaves at v_x = (1 + e) v n_x n_y. The
// soft solver stops what has restitution at its touch: the tolerance is the half slop by which it
// stops short. The solver of the thesis takes the normal of the pose ahead, so it only has to
// strike it.
TEST(Seam, OfATileThatStandsOutIsStruck) {
    constexpr Real kHigh = Real(0.05); // m
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : kRates) {
            for (const Real x : {Real(-0.05), Real(-0.1), Real(-0.15)}) {
                for (int place = 0; place < 7; ++place) {
                    const bool soft = solver == support::Solver::Soft;
                    const Material material = support::slippery(soft ? Real(0.5) : Real(0));
                    World world({.settings = support::settingsOf(solver)});
                    world.add({.shape = Box{1, 1, {Real(-0.5), Real(-0.5)}},
                               .material = material,
                               .type = BodyType::Static});
                    world.add({.shape = Box{1, 1, {Real(0.5), kHigh - Real(0.5)}},
                               .material = material,
                               .type = BodyType::Static});
                    const BodyId ball =
                        world.add({.shape = Circle{Real(0.5)},
                                   .position = {x, 1 + Real(0.0137) * static_cast<Real>(place)},
                                   .velocity = {0, -6},
                                   .material = material});
                    Real farthest = 0; // m/s
                    for (int step = 0; step < rate / 4; ++step) {
                        world.step(1 / static_cast<Real>(rate));
                        farthest = std::min(farthest, world[ball].velocity().x);
                    }
                    const Real nx = x / Real(0.5);
                    const Real right =
                        (soft ? Real(1.5) : Real(1)) * 6 * nx * std::sqrt(1 - nx * nx);
                    EXPECT_NEAR(farthest / right, 1, soft ? Real(0.02) : Real(0.6))
                        << "solver " << static_cast<int>(solver) << ", " << rate << " Hz, x " << x
                        << ", place " << place;
                }
            }
        }
    }
}

/// A capsule, a plank or a crate, tilted, that is thrown down at the tiles.
BodyDef thrown(RandomNumbers& random, int kind) {
    BodyDef def;
    def.shape = kind == 0   ? Shape(Capsule{{Real(-0.4), 0}, {Real(0.4), 0}, Real(0.2)})
                : kind == 1 ? Shape(Box{1, Real(0.4)})
                            : Shape(Box{1, 1});
    def.position = {random.between(-1, 1), 2};
    def.rotation = Rot::fromAngle(random.between(-0.3, 0.3));
    def.velocity = {0, -random.between(3, 20)};
    def.material = support::slippery();
    return def;
}

/// m/s: the change of the velocity of a body in a step, and what its hits tell of it.
struct Blow {
    Real change;
    Real told;
};

Blow blowOf(World& world, BodyId body, int rate) {
    const Vec2 before = world[body].velocity();
    world.step(1 / static_cast<Real>(rate));
    Blow blow{length(world[body].velocity() - before), 0};
    for (const CollisionRecord& hit : world.hits(0)) {
        blow.told += hit.totalImpulse / world[body].mass();
    }
    return blow;
}

// Newton's second law: the impulses of the hits of a step add up to m dv, if nothing else acts.
// Normals differ by less than 0.3 rad, so the sum of their lengths is not below that of the
// vectors but by rounding. Blows below 0.3 m/s are left out: rests of others are among them.
// Regression: the solver of the thesis told 13 of 2,975 blows of capsules at 30 Hz in no record. A
// tile that the body did not reach had taken them, and hidden those beneath it.
TEST(Seam, HitsTellEveryBlowOnTiles) {
    for (const int rate : kRates) {
        for (int kind = 0; kind < 3; ++kind) {
            RandomNumbers random(1);
            int blows = 0;
            for (int i = 0; i < std::max(draws(500), 50); ++i) {
                World world({.settings = thesis2006()});
                addTiles(world, Ground::Tiles, support::slippery());
                const BodyId body = world.add(thrown(random, kind));
                for (int step = 0; step < rate; ++step) {
                    const auto [change, told] = blowOf(world, body, rate);
                    if (change > Real(0.3)) {
                        ++blows;
                        ASSERT_GT(told, Real(0.999) * change)
                            << "draw " << i << ", kind " << kind << ", " << rate << " Hz, step "
                            << step;
                    }
                }
            }
            EXPECT_GT(blows, draws(300));
        }
    }
}

/// Flush ground of 8 m: tiles of `width` (m), or with 0 a floor that a ramp of 0.02 rad joins.
void addFlushGround(World& world, Real width, const Material& material) {
    const auto add = [&](const Shape& shape) {
        world.add({.shape = shape, .material = material, .type = BodyType::Static});
    };
    if (width == 0) {
        add(Box{4, 1, {-2, Real(-0.5)}});
        add(Polygon{{{0, 0}, {4, 0}, {4, Real(0.08)}}});
    }
    for (Real x = -4; width > 0 && x < 4; x += width) {
        add(Box{width, Real(0.5), {x + width / 2, Real(-0.25)}});
    }
}

/// A ball, a rounded box or a triangle that spins and is thrown down at the ground.
BodyDef spinning(RandomNumbers& random, const Material& material) {
    const Shape shapes[] = {
        Circle{Real(0.5)}, Box{Real(0.7), Real(0.7), {}, {}, Real(0.15)},
        Polygon{{{Real(-0.5), Real(-0.4)}, {Real(0.5), Real(-0.4)}, {0, Real(0.5)}}}};
    BodyDef def{.shape = shapes[random.below(3)], .material = material};
    def.position = {random.between(-1, 0), 2};
    def.rotation = random.rotation();
    def.velocity = {random.between(-1, 4), -random.between(2, 9)};
    def.angularVelocity = random.between(-6, 6);
    return def;
}

// The same. Regression: a contact without a touch at the start of the step, which was replaced by
// the rising face of its ground, took an impulse and was told in no record: 1.4 to 3 % of blows at
// the ramp, 0.5 % on tiles of 0.15 m.
TEST(Seam, HitsTellEveryBlowOnNarrowTilesAndAtARamp) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : kRates) {
            RandomNumbers random(1);
            int blows = 0;
            for (int i = 0; i < std::max(draws(600), 60); ++i) {
                const Material material = withFriction(0, Real(random.below(3)) / 2);
                World world({.settings = support::settingsOf(solver)});
                addFlushGround(world, i % 2 == 0 ? 0 : random.between(0.08, 0.3), material);
                const BodyId body = world.add(spinning(random, material));
                for (int step = 0; step < rate && world[body].position().x < 2; ++step) {
                    const auto [change, told] = blowOf(world, body, rate);
                    if (change > Real(0.3)) {
                        ++blows;
                        ASSERT_GT(told, Real(0.999) * change)
                            << "draw " << i << ", " << rate << " Hz, step " << step << ", solver "
                            << static_cast<int>(solver);
                    }
                }
            }
            EXPECT_GT(blows, draws(500));
        }
    }
}

// A hit names a tile that the body reaches in its step: its bounds before and after, and the way
// of its speed. Of a tile ahead that the body cannot reach, no face stands in for the ground.
TEST(Seam, HitsNameTilesThatTheBodyReaches) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 120}) {
            for (int kind = 0; kind < 2; ++kind) {
                RandomNumbers random(1);
                for (int i = 0; i < std::max(draws(300), 30); ++i) {
                    World world({.settings = support::settingsOf(solver)});
                    addTiles(world, Ground::Tiles, support::slippery());
                    const BodyId body = world.add(thrown(random, kind));
                    for (int step = 0; step < rate; ++step) {
                        const Aabb before = world[body].bounds();
                        world.step(1 / static_cast<Real>(rate));
                        const Aabb after = world[body].bounds();
                        constexpr Real kWay = Real(0.1); // m: it has no speed to a side
                        for (const CollisionRecord& hit : world.hits(Real(0.5))) {
                            const Aabb tile = world[hit.other(body)].bounds();
                            ASSERT_GT(tile.upper.x, std::min(before.lower.x, after.lower.x) - kWay)
                                << "draw " << i << ", kind " << kind << ", " << rate << " Hz";
                            ASSERT_LT(tile.lower.x, std::max(before.upper.x, after.upper.x) + kWay)
                                << "draw " << i << ", kind " << kind << ", " << rate << " Hz";
                        }
                    }
                }
            }
        }
    }
}

// A plank leans on the edge of a step, and its end lies on the floor beside a seam. What carries it
// is a corner, on which it may turn: the floor holds its end. Where the floor was hidden below the
// plank, 63 of 69 ends sank by up to 0.055 m, and some planks rocked for ever.
TEST(Seam, AFloorIsNotHiddenByAPlankThatLeansOnAStep) {
    for (const StepSettings& settings : {balanced(), accurate()}) {
        for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
            for (const Real end : {Real(0), Real(1)}) { // of the pit: flush ground, a wall
                for (const Real step : {Real(0.02), Real(0.1), Real(0.3)}) {
                    for (const Real length : {Real(1.4), Real(1.8)}) {
                        constexpr Real pit = Real(0.9);
                        World world({.gravity = support::kEarth, .settings = settings});
                        world.add({.shape = Box{pit, 3},
                                   .position = {-pit / 2, -step - Real(1.5)},
                                   .type = BodyType::Static});
                        world.add({.shape = Box{3, 3},
                                   .position = {Real(1.5), Real(-1.5)},
                                   .type = BodyType::Static});
                        world.add({.shape = Box{1, 3},
                                   .position = {-pit - Real(0.5),
                                                Real(-1.5) - (end > 0 ? Real(0) : step)},
                                   .type = BodyType::Static});
                        const Rot slope = Rot::fromAngle(std::atan2(step, pit - Real(0.012)));
                        const Real top = (slope * Vec2{0, Real(0.1)}).x; // before the wall
                        const Vec2 corner{Real(0.012) - pit - end * top, -step};
                        const BodyId plank =
                            world.add({.shape = Box{length, Real(0.1), {length / 2, Real(0.05)}},
                                       .position = corner + Vec2{0, Real(0.002)},
                                       .rotation = slope});
                        Real lowest = 0;
                        for (int i = 0; i < static_cast<int>(6 * rate); ++i) {
                            world.step(1 / rate);
                            lowest = std::min(lowest, world[plank].bounds().lower.y + step);
                        }
                        EXPECT_GT(lowest, Real(-0.01))
                            << rate << " Hz, step " << step << ", length " << length << ", " << end;
                        EXPECT_LT(std::abs(world[plank].angularVelocity()), Real(0.01));
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
