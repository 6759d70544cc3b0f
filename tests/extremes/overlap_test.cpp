// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/depth.hpp>
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::kSolvers;
using support::settingsOf;
using support::Solver;

using support::maxOverlap;

/// `count` bodies with their centres at the origin, without gravity.
World crowd(int count, const Shape& shape, Solver strategy) {
    StepSettings settings = settingsOf(strategy);
    World world({.settings = settings});
    for (int i = 0; i < count; ++i) {
        world.add({.shape = shape});
    }
    return world;
}

Real fastest(const World& world) {
    Real speed = 0;
    for (const BodyId id : world.bodies()) {
        const Real own = length(world[id].velocity());
        if (!std::isfinite(own) || !isFinite(world[id].position())) {
            return std::numeric_limits<Real>::infinity();
        }
        speed = std::max(speed, own);
    }
    return speed;
}

/// m/s, largest speed of any body during these steps.
Real mostSpeedIn(World& world, int steps) {
    Real most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(support::kDt);
        most = std::max(most, fastest(world));
    }
    return most;
}

/// m/s, push speed: the largest speed that separates two bodies.
Real mostSpeed(const World& world) {
    return support::pushSpeedOf(world.settings()) * world.tolerances().unit();
}

struct Kind {
    const char* name;
    Shape shape;
};
const Kind kKinds[] = {
    {"circle", Circle{Real(0.5)}},
    {"box", Box{1, 1}},
    {"triangle", Polygon{{{Real(-0.5), Real(-0.5)}, {Real(0.5), Real(-0.5)}, {0, Real(0.5)}}}},
};

// Coinciding centres define no direction, but the bodies separate. No body is shot out: the
// outermost of twenty is at most 5 % faster than the push speed of a pair.
TEST(Overlap, AFewBodiesOnOnePointSeparate) {
    for (const Solver strategy : kSolvers) {
        for (const Kind& kind : kKinds) {
            for (const int count : {2, 20}) {
                SCOPED_TRACE(testing::Message() << kind.name << " x " << count << ", strategy "
                                                << static_cast<int>(strategy));
                World world = crowd(count, kind.shape, strategy);
                EXPECT_LT(mostSpeedIn(world, 600), Real(1.05) * mostSpeed(world));
                EXPECT_LT(maxOverlap(world), Real(0.02));
                EXPECT_TRUE(world.frozenBodies().empty());
            }
        }
    }
}

// S4: distant overlaps do not change the separation of a heap by any bit.
TEST(Overlap, SeparationDoesNotDependOnDistantOverlaps) {
    const auto heapBeside = [](int others) {
        World world(support::withoutSleep());
        support::addFloor(world);
        std::vector<BodyId> own;
        for (int i = 0; i < 5; ++i) {
            own.push_back(world.add(support::boxDef({Real(0.2) * Real(i), Real(0.6)}, 1, 1)));
        }
        for (int i = 0; i < others; ++i) {
            world.add(support::boxDef({100, 5}, 1, 1));
        }
        support::run(world, 120);
        std::vector<Vec2> states;
        for (const BodyId id : own) {
            states.push_back(world[id].position());
            states.push_back(world[id].velocity());
        }
        return states;
    };
    const std::vector<Vec2> alone = heapBeside(0);
    EXPECT_EQ(heapBeside(30), alone);
    EXPECT_EQ(heapBeside(100), alone);
}

// Coinciding circles get directions from their ranks in the crowd. So they separate in all
// directions, and not along one line.
TEST(Overlap, CirclesOnOnePointSeparateInAllDirections) {
    World world = crowd(20, Circle{Real(0.5)}, Solver::Soft);
    support::run(world, 600);
    Real wide = 0;
    Real high = 0;
    for (const BodyId id : world.bodies()) {
        wide = std::max(wide, std::abs(world[id].position().x));
        high = std::max(high, std::abs(world[id].position().y));
    }
    EXPECT_GT(wide, 2);
    EXPECT_GT(high, 2);
}

// 60 bodies separate within 17 s. Those behind a body add to its speed: the fastest of 57 to 63
// boxes reached 1.2 times the push speed. Momentum is conserved to the rounding of 1770 contacts in
// every substep.
TEST(Overlap, SixtyBodiesOnOnePointSeparateWithinTwentySeconds) {
    for (const Kind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        World world = crowd(60, kind.shape, Solver::Soft);
        EXPECT_LT(mostSpeedIn(world, 1200), Real(1.3) * mostSpeed(world));
        EXPECT_LT(maxOverlap(world), Real(0.02));
        EXPECT_TRUE(support::near(support::totalsOf(world).momentum, Vec2{},
                                  support::byPrecision(0.01, 1e-9)));
        EXPECT_EQ(world.bodyCount(), 60u);
    }
}

// 1000 coinciding bodies have half a million contacts. No number becomes NaN, no body is shot out,
// and separation begins. As with 60, those behind a body add to its speed: 1.26 times, in
// double 1.54. The test makes few steps, since each is expensive. In double, which takes twice as
// long for the same code, fewer bodies do.
TEST(Overlap, AThousandBodiesOnOnePointSeparateSlowly) {
    constexpr int kCount = support::kSanitized || sizeof(Real) == 8 ? 300 : 1000;
    for (const Kind& kind : {kKinds[0], kKinds[1]}) {
        SCOPED_TRACE(kind.name);
        World world = crowd(kCount, kind.shape, Solver::Soft);
        EXPECT_LT(mostSpeedIn(world, 12), Real(1.6) * mostSpeed(world));
        Real farthest = 0;
        for (const BodyId id : world.bodies()) {
            farthest = std::max(farthest, length(world[id].position()));
        }
        EXPECT_GT(farthest, Real(0.01)); // m; all began at 0
        EXPECT_EQ(world.bodyCount(), std::size_t{kCount});
    }
}

/// Two unit boxes with an overlap of `deep` (m); the right one has three times the mass.
struct Parting {
    World world;
    BodyId light;
    BodyId heavy;
    Real depth;

    Parting(Real deep, Solver strategy) : world({.settings = settingsOf(strategy)}), depth(deep) {
        BodyDef def = support::boxDef({}, 1, 1);
        light = world.add(def);
        def.position = {1 - deep, 0};
        def.density = 3;
        heavy = world.add(def);
        support::run(world, 60);
    }
    /// m, displacement of the common centre of mass.
    Real displacement() const {
        return (world[light].position().x + 3 * (world[heavy].position().x - 1 + depth)) / 4;
    }
    Real apart() const { return length(world[heavy].velocity() - world[light].velocity()); }
};

// S4, F4: relax passes remove the velocity that separates an overlap. Boxes with an overlap of 2 cm
// separate and stop, within 1/50 of the push speed of 3 m/s. Their common centre stays. An overlap
// of up to the slop, 4 mm, may remain.
TEST(Overlap, SeparationAddsNoEnergy) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        const Parting boxes(Real(0.02), strategy);
        EXPECT_LT(boxes.apart(), support::pushSpeedOf(boxes.world.settings()) / 50);
        EXPECT_TRUE(support::near(boxes.displacement(), 0, Real(1e-5)));
        EXPECT_LT(maxOverlap(boxes.world), boxes.world.tolerances().slop);
    }
}

// S4: the same from 20 cm, deeper than contacts ever get by themselves: overlap relaxation adds
// passes.
TEST(Overlap, SeparationFromADeepOverlapAddsNoEnergy) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        const Parting boxes(Real(0.2), strategy);
        EXPECT_LT(boxes.apart(), support::pushSpeedOf(boxes.world.settings()) / 50);
        EXPECT_TRUE(support::near(boxes.displacement(), 0, Real(1e-5)));
        EXPECT_LT(maxOverlap(boxes.world), boxes.world.tolerances().slop);
    }
}

// S4: other contacts do not matter. Beside sleeping or awake boxes with up to 760 contacts, the
// pair separates as it does alone.
TEST(Overlap, ALargePileDoesNotAffectTheSeparationOfADeepPair) {
    for (const int rows : {0, 5, 20}) {
        SCOPED_TRACE(rows);
        World world;
        for (int i = 0; i < rows * rows; ++i) { // without gaps
            world.add(support::boxDef(
                {50 + static_cast<Real>(i % rows), static_cast<Real>(i / rows)}, 1, 1));
        }
        const BodyId left = world.add(support::boxDef({}, 1, 1));
        const BodyId right = world.add(support::boxDef({Real(0.8), 0}, 1, 1));
        support::run(world, 60);
        EXPECT_LT(length(world[right].velocity() - world[left].velocity()),
                  support::pushSpeedOf(world.settings()) / 50);
        EXPECT_GT(world[right].position().x - world[left].position().x,
                  1 - world.tolerances().slop);
    }
}

// S4: a body stays awake while its overlap is being separated, however slowly, and falls asleep
// afterwards.
TEST(Overlap, ABodyStaysAwakeDuringSeparation) {
    StepSettings settings;
    settings.soft().pushSpeed = Real(0.05); // m/s; the separation takes 100 steps
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.4)}, 1, 1));
    for (int i = 0; i < 300; ++i) {
        world.step(support::kDt);
        if (world[box].position().y < Real(0.5) - 2 * world.tolerances().slop) {
            ASSERT_EQ(world[box].flags() & kAsleep, 0u) << "step " << i;
        }
    }
    EXPECT_NE(world[box].flags() & kAsleep, 0u);
    EXPECT_GT(world[box].position().y, Real(0.5) - world.tolerances().slop);
}

// S4: a box that starts 10 cm deep in the floor is lifted out and not thrown up.
TEST(Overlap, SeparationUnderGravityDoesNotThrowABody) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = settingsOf(strategy);
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.4)}, 1, 1));
        Real highest = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(support::kDt);
            highest = std::max(highest, world[box].position().y);
        }
        EXPECT_LT(highest, Real(0.502)); // half a slop above the floor
        EXPECT_GT(world[box].position().y, Real(0.495));
        EXPECT_LT(length(world[box].velocity()), Real(1e-3));
    }
}

/// N s, largest impulse of the last step.
Real hardest(const World& world) {
    Real most = 0;
    for (const CollisionRecord& record : world.collisions()) {
        most = std::max(most, record.maxImpulse);
    }
    return most;
}

// A body wedged into a gap too small for it cannot separate: opposite contacts press on it or
// rotate it. Their impulses grow until softness removes as much per substep as the push adds. The
// body rocks. At 0.2 m it leaves two of the four boxes, and the others push it back: it must not
// pass that place by more than a quarter.
TEST(Overlap, ImpulsesOnAWedgedBodyStayBounded) {
    for (const Flags flags : {Flags{0}, kLockMove}) {
        SCOPED_TRACE(flags);
        StepSettings settings;
        settings.leaveOut = Feature::Sleep;
        World world({.settings = settings});
        BodyDef def = support::boxDef({}, 2, 1);
        def.flags = flags;
        const BodyId wedged = world.add(def);
        for (const Vec2 place : {Vec2{Real(0.8), Real(0.8)}, Vec2{Real(-0.8), Real(0.8)},
                                 Vec2{Real(0.8), Real(-0.8)}, Vec2{Real(-0.8), Real(-0.8)}}) {
            world.add({.shape = Box{1, 1}, .position = place, .type = BodyType::Static});
        }
        Real farthest = 0;
        const auto hardestOf = [&](int steps) {
            Real most = 0;
            for (int step = 0; step < steps; ++step) {
                support::run(world, 1);
                most = std::max(most, hardest(world));
                farthest = std::max(farthest, length(world[wedged].position()));
            }
            return most;
        };
        const Real early = hardestOf(2000);
        EXPECT_GT(early, 0);
        EXPECT_LT(hardestOf(20000), Real(1.01) * early);
        EXPECT_LT(farthest, Real(0.25));
    }
}

// F7: a crate deep in another one, both on the ground and without friction. What pushes them apart
// turns none of them, so no speed is left: at most 0.1 m/s, where it was up to 0.9.
TEST(Overlap, ACrateThatStartsInAnotherOneOnTheGroundLeavesItAndRests) {
    const Vec2 sizes[] = {{1, 1}, {1, 3}, {3, 1}, {Real(0.3), Real(0.3)}};
    for (const StepSettings& settings : {StepSettings{}, thesis2006()}) {
        for (const BodyType type : {BodyType::Static, BodyType::Dynamic}) {
            for (const Vec2 size : sizes) {
                for (const Real depth : {Real(0.1), Real(0.3), Real(0.5)}) {
                    for (const Real rate : {Real(30), Real(60), Real(240)}) {
                        for (const Real place : {Real(0), Real(256)}) {
                            World world({.gravity = {0, -10}, .settings = settings});
                            const Material smooth = support::slippery();
                            world.add({.shape = Box{40, 1},
                                       .position = {place, Real(-0.5)},
                                       .material = smooth,
                                       .type = BodyType::Static});
                            const Box crate{size.x, size.y};
                            const BodyId first = world.add({.shape = crate,
                                                            .position = {place, size.y / 2},
                                                            .material = smooth,
                                                            .type = type});
                            const Real x = place + size.x - depth * std::min(size.x, size.y);
                            const BodyId other = world.add(
                                {.shape = crate, .position = {x, size.y / 2}, .material = smooth});
                            support::run(world, static_cast<int>(3 * rate), 1 / rate);
                            EXPECT_LT(length(world[other].velocity()), Real(0.1))
                                << size.x << " x " << size.y << " m, depth " << depth << ", "
                                << rate << " Hz, x " << place;
                            EXPECT_GT(world[other].position().x - world[first].position().x,
                                      Real(0.98) * size.x);
                        }
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
