// SPDX-License-Identifier: MIT
// Continuous collision chosen for each body.
#include "support/solver.hpp"
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kodo {
namespace {

using support::kSolvers;
using support::Solver;

constexpr ContinuousMode kModes[] = {ContinuousMode::Never, ContinuousMode::Static,
                                     ContinuousMode::All};

WorldDef inSpace(Solver solver) {
    return {.settings = {.solver = support::settingsOf(solver).solver, .leaveOut = Feature::Sleep}};
}

/// A disc that flies to the right, and what it flies at.
struct Shot {
    World world;
    BodyId disc;
    BodyId target;

    /// The target is thin, at x = 5 m, and has a type and a mode; a dynamic one is heavy.
    Shot(Solver solver, Real speed, BodyType type, ContinuousMode ofDisc, ContinuousMode ofTarget)
        : world(inSpace(solver)) {
        BodyDef plate{.shape = Box{Real(0.02), 40},
                      .position = {5, 0},
                      .density = 1000,
                      .continuousMode = ofTarget,
                      .type = type};
        target = world.add(plate);
        BodyDef ball = support::ballDef({0, 0}, Real(0.1), support::slippery(1));
        ball.velocity = {speed, 0};
        ball.continuousMode = ofDisc;
        disc = world.add(ball);
    }
    /// True if the disc is beyond the place of the target after its way there and back.
    bool passes() {
        const Real speed = world[disc].velocity().x;
        for (int step = 0; step < 4 + static_cast<int>(10 / (speed * support::kDt)); ++step) {
            world.step(support::kDt);
        }
        return world[disc].position().x > world[target].position().x;
    }
};

/// Speed (m/s) at which a step leads from clearly before a plate at 5 m to clearly behind it, and
/// not to a place within the way of a contact that is ready.
Real tunnelling(support::RandomNumbers& random) {
    const Real steps = std::floor(random.between(1, 3));
    return 5 / (steps + random.between(0.3, 0.6)) / support::kDt;
}

bool checks(ContinuousMode a, ContinuousMode b, BodyType target) {
    const ContinuousMode lower = std::min(a, b);
    return lower == ContinuousMode::All ||
           (lower == ContinuousMode::Static && target != BodyType::Dynamic);
}

// The rule of a pair: the lower mode of both counts, and Static means a body that nothing moves.
// What is not checked tunnels at speeds at which what is checked bounces.
TEST(ContinuousModes, APairIsCheckedAsTheLowerModeOfBothSays) {
    support::RandomNumbers random(41);
    for (const Solver solver : kSolvers) {
        for (int round = 0; round < 4; ++round) {
            const Real speed = tunnelling(random);
            for (const BodyType type : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
                for (const ContinuousMode ofDisc : kModes) {
                    for (const ContinuousMode ofTarget : kModes) {
                        Shot shot(solver, speed, type, ofDisc, ofTarget);
                        EXPECT_EQ(shot.passes(), !checks(ofDisc, ofTarget, type))
                            << speed << " m/s, type " << int(type) << ", disc " << int(ofDisc)
                            << ", target " << int(ofTarget);
                    }
                }
            }
        }
    }
}

// A body with both motion locks is one that nothing moves, and a frozen or static one as well.
TEST(ContinuousModes, StaticStopsAtBodiesWithBothMotionLocks) {
    for (const Flags locks : {Flags{0}, kLockMove | kLockRotate}) {
        Shot shot(Solver::Soft, 400, BodyType::Dynamic, ContinuousMode::Static,
                  ContinuousMode::All);
        shot.world[shot.target].setFlags(locks);
        EXPECT_EQ(shot.passes(), locks == 0);
    }
}

// The setter acts from the next step on, and the other way round.
TEST(ContinuousModes, MayChangeBetweenSteps) {
    for (const Solver solver : kSolvers) {
        for (const bool checked : {true, false}) {
            const auto [before, after] =
                checked ? std::pair(ContinuousMode::Never, ContinuousMode::All)
                        : std::pair(ContinuousMode::All, ContinuousMode::Never);
            Shot shot(solver, 120, BodyType::Static, before, ContinuousMode::All);
            shot.world.step(support::kDt);
            shot.world[shot.disc].setContinuousMode(after);
            EXPECT_EQ(shot.world[shot.disc].continuousMode(), after);
            EXPECT_EQ(shot.passes(), !checked);
        }
    }
}

// A sensor notices what passes it within a step only if the pair is checked.
TEST(ContinuousModes, ASensorNoticesWhatPassesItOnlyIfThePairIsChecked) {
    for (const Solver solver : kSolvers) {
        for (const ContinuousMode mode : kModes) {
            World world(inSpace(solver));
            world.add({.shape = Box{Real(0.02), 4},
                       .position = {5, 0},
                       .type = BodyType::Static,
                       .flags = kSensor});
            BodyDef ball = support::ballDef({0, 0}, Real(0.1));
            ball.velocity = {400, 0};
            ball.continuousMode = mode;
            world.add(ball);
            std::size_t begins = 0;
            for (int step = 0; step < 4; ++step) {
                world.step(support::kDt);
                begins += world.begunCollisions().size();
            }
            EXPECT_EQ(begins, mode == ContinuousMode::Never ? 0u : 1u) << int(mode);
        }
    }
}

/// Fast discs and boxes in a closed box.
World swarm(Solver solver, ContinuousMode mode) {
    World world(inSpace(solver));
    for (const auto& [x, y] :
         {std::pair(-6, 0), std::pair(6, 0), std::pair(0, -6), std::pair(0, 6)}) {
        const bool upright = y == 0;
        world.add({.shape = Box{Real(upright ? 1 : 13), Real(upright ? 13 : 1)},
                   .position = {Real(x), Real(y)},
                   .material = support::slippery(1),
                   .type = BodyType::Static});
    }
    support::RandomNumbers random(5);
    for (int i = 0; i < 40; ++i) {
        BodyDef def = i % 2 == 0 ? support::ballDef({}, Real(0.2), support::slippery(1))
                                 : support::boxDef({}, Real(0.4), Real(0.3), support::slippery(1));
        def.position = {Real(i % 7) * Real(1.4) - Real(4.2), Real(i / 7) * Real(1.5) - Real(4)};
        def.velocity = Real(60) * random.rotation().xAxis();
        def.continuousMode = mode;
        world.add(def);
    }
    return world;
}

// Modes that are set and reset leave no trace but for the loads that a setter makes the engine look
// at: nothing is loaded here.
TEST(ContinuousModes, AllIsTheDefaultAndChangesNoBit) {
    EXPECT_EQ(BodyDef{}.continuousMode, ContinuousMode::All);
    for (const Solver solver : kSolvers) {
        World world = swarm(solver, ContinuousMode::All);
        World other = swarm(solver, ContinuousMode::Never);
        const std::vector<BodyId> ids = world.bodies();
        const std::vector<BodyId> others = other.bodies();
        for (const BodyId id : others) {
            other[id].setContinuousMode(ContinuousMode::All);
        }
        for (int step = 0; step < 60; ++step) {
            world.step(support::kDt);
            other.step(support::kDt);
            for (std::size_t i = 0; i < ids.size(); ++i) {
                const BodyView a = world[ids[i]];
                const BodyView b = other[others[i]];
                ASSERT_EQ(a.position(), b.position()) << "step " << step;
                ASSERT_EQ(a.velocity(), b.velocity()) << "step " << step;
            }
        }
        EXPECT_EQ(world.stateHash(), other.stateHash());
    }
}

// With Never on all bodies, a World moves as without continuous collision.
TEST(ContinuousModes, NeverOnAllBodiesIsTheSameAsLeavingTheFeatureOut) {
    for (const Solver solver : kSolvers) {
        World never = swarm(solver, ContinuousMode::Never);
        World out = swarm(solver, ContinuousMode::All);
        StepSettings settings = out.settings();
        settings.leaveOut |= Feature::ContinuousCollision;
        out.setSettings(settings);
        const std::vector<BodyId> ids = never.bodies();
        const std::vector<BodyId> others = out.bodies();
        std::size_t touches = 0;
        for (int step = 0; step < 60; ++step) {
            never.step(support::kDt);
            out.step(support::kDt);
            touches += never.collisions().size();
            for (std::size_t i = 0; i < ids.size(); ++i) {
                ASSERT_EQ(never[ids[i]].position(), out[others[i]].position()) << "step " << step;
                ASSERT_EQ(never[ids[i]].velocity(), out[others[i]].velocity()) << "step " << step;
            }
        }
        EXPECT_GT(touches, 100u);
    }
}

// With Static, walls hold all of a swarm, whatever passes through whatever.
TEST(ContinuousModes, StaticKeepsASwarmWithinItsWalls) {
    for (const Solver solver : kSolvers) {
        World world = swarm(solver, ContinuousMode::Static);
        for (int step = 0; step < 300; ++step) {
            world.step(support::kDt);
        }
        for (const BodyId id : world.bodies()) {
            const Vec2 place = world[id].position();
            EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 6) << id.index;
        }
    }
}

// Snapshots, copies and the hash hold the mode.
TEST(ContinuousModes, GoOnAfterASnapshotWithTheSameBits) {
    for (const Solver solver : kSolvers) {
        World world = swarm(solver, ContinuousMode::Static);
        support::run(world, 20);
        World read = fromBytes(toBytes(world));
        World copy = world;
        EXPECT_EQ(read.stateHash(), world.stateHash());
        for (World* one : {&world, &read, &copy}) {
            support::run(*one, 60);
        }
        EXPECT_EQ(read.stateHash(), world.stateHash());
        EXPECT_EQ(copy.stateHash(), world.stateHash());
        EXPECT_EQ(toBytes(read), toBytes(world));
        const BodyId last = world.bodies().back();
        EXPECT_EQ(std::as_const(read)[last].continuousMode(), ContinuousMode::Static);
        world[last].setContinuousMode(ContinuousMode::All);
        EXPECT_NE(world.stateHash(), read.stateHash());
    }
}

// StepStats tells what continuous collision did.
TEST(ContinuousModes, StepStatsCountsPairsAndStops) {
    for (const ContinuousMode mode : kModes) {
        Shot shot(Solver::Soft, 400, BodyType::Static, mode, ContinuousMode::All);
        shot.world.step(support::kDt);
        const std::size_t expected = mode == ContinuousMode::Never ? 0 : 1;
        EXPECT_EQ(stepStats(shot.world).continuousPairs, expected);
        EXPECT_EQ(stepStats(shot.world).continuousStops, expected);
        EXPECT_EQ(stepStats(shot.world).pairs, 1u);
        const World read = fromBytes(toBytes(shot.world));
        EXPECT_EQ(stepStats(read).continuousStops, expected);
    }
}

TEST(ContinuousModes, AnotherNumberIsRefused) {
    World world;
    BodyDef def;
    def.continuousMode = static_cast<ContinuousMode>(3);
    ASSERT_TRUE(check(def));
    EXPECT_EQ(check(def)->field, "continuousMode");
    const BodyId body = world.add({});
    EXPECT_THROW(world[body].setContinuousMode(static_cast<ContinuousMode>(3)), BadDefinition);
    EXPECT_EQ(world[body].continuousMode(), ContinuousMode::All);
}

} // namespace
} // namespace kodo
