// SPDX-License-Identifier: MIT
// A body that flies past a corner without a touch keeps its velocity, however near it passes.
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

using support::Solver;

struct Flyer {
    const char* name;
    Shape shape;
    Real below; // m, from its centre to its lowest point
    Real angle = 0;
};

const std::vector<Flyer>& flyers() {
    static const std::vector<Flyer> all{
        {"small disc", Circle{Real(0.05)}, Real(0.05)},
        {"disc", Circle{Real(0.25)}, Real(0.25)},
        {"large disc", Circle{1}, 1},
        {"box", Box{Real(0.5), Real(0.5)}, Real(0.25)},
        {"corner", Box{Real(0.5), Real(0.5)}, Real(0.35355339), Real(0.78539816)},
        {"capsule's end", Capsule{{0, Real(-0.3)}, {0, Real(0.3)}, Real(0.1)}, Real(0.4)},
        {"capsule's side", Capsule{{Real(-0.3), 0}, {Real(0.3), 0}, Real(0.1)}, Real(0.1)}};
    return all;
}

struct Flight {
    Solver solver;
    int rate;       // Hz
    Real clearance; // m, over the upper side of the target; < 0: a hit
    Real speed;     // m/s
    Real phase;     // of a step
    // Variants that are the same flight:
    Real direction = 1;
    Vec2 place{};
    Vec2 boost{}; // m/s, of both bodies
    Real restitution = 0;
    bool freeTarget = false;
    bool kinematic = false; // the target, also at rest
};

struct Flown {
    Real change = 0;  // m/s, of the velocity of any point, roughly
    Real impulse = 0; // N s per kg
    int records = 0;

    friend bool operator==(const Flown&, const Flown&) = default;
};

Flown fly(const Flyer& flyer, const Flight& flight) {
    World world({.gravity = {}, .settings = support::settingsOf(flight.solver)});
    const Material material{.restitution = flight.restitution};
    BodyDef target = support::boxDef(flight.place, 1, 1, material);
    target.velocity = flight.boost;
    target.type = flight.freeTarget                                    ? BodyType::Dynamic
                  : flight.kinematic || length(flight.boost) > Real(0) ? BodyType::Kinematic
                                                                       : BodyType::Static;
    world.add(target);
    const Real dt = 1 / static_cast<Real>(flight.rate);
    const Real way = Real(2.5) + (2 + flight.phase) * flight.speed * dt;
    BodyDef def{.shape = flyer.shape, .material = material};
    def.position =
        flight.place + Vec2{-flight.direction * way, Real(0.5) + flyer.below + flight.clearance};
    def.rotation = Rot::fromAngle(flyer.angle);
    def.velocity = flight.boost + Vec2{flight.direction * flight.speed, 0};
    const BodyId body = world.add(def);
    Flown flown;
    for (Real gone = 0; gone < 2 * way; gone += flight.speed * dt) {
        world.step(dt);
        for (const CollisionRecord& hit : world.collisions()) {
            flown.records += hit.phase != TouchPhase::End ? 1 : 0;
            flown.impulse += hit.totalImpulse / world[body].mass();
        }
    }
    flown.change = length(world[body].velocity() - def.velocity) +
                   flyer.below * std::abs(world[body].angularVelocity());
    return flown;
}

/// m/s: an approach that is slower than 1/256 slop in 3/2 steps may be braked. With friction and
/// spin, a point of the body changes its velocity by up to three times as much.
Real allowed(const World& world, int rate) {
    return 3 * world.tolerances().slop * static_cast<Real>(rate) / 384;
}

void expectUntouched(const Flyer& flyer, const Flight& flight) {
    SCOPED_TRACE(testing::Message()
                 << flyer.name << ", " << flight.rate << " Hz, clearance " << flight.clearance
                 << ", speed " << flight.speed << ", phase " << flight.phase << ", propagation "
                 << (flight.solver == Solver::Propagation));
    const World world;
    const Flown flown = fly(flyer, flight);
    EXPECT_LE(flown.change, allowed(world, flight.rate));
    EXPECT_LE(flown.impulse, allowed(world, flight.rate));
    if (flight.clearance > world.tolerances().slop) {
        EXPECT_EQ(flown.records, 0);
    }
}

template <typename Visit>
void forEachFlight(Visit visit) {
    for (const Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 120, 240}) {
            for (const Real speed : {Real(1), Real(7), Real(50)}) {
                for (const Real phase : {Real(0), Real(0.3), Real(0.55), Real(0.8)}) {
                    visit(Flight{solver, rate, 0, speed, phase});
                }
            }
        }
    }
}

TEST(Passing, ACornerDeflectsNothingThatMissesIt) {
    for (const Flyer& flyer : flyers()) {
        forEachFlight([&](Flight flight) {
            for (const Real clearance :
                 {Real(0.0001), Real(0.0003), Real(0.002), Real(0.005), Real(0.01)}) {
                flight.clearance = clearance;
                expectUntouched(flyer, flight);
            }
        });
    }
}

// The same flight, seen otherwise.
TEST(Passing, IsTheSameMirroredFarAwayAndFromAMovingFrame) {
    for (const Flyer& flyer : flyers()) {
        forEachFlight([&](Flight flight) {
            flight.clearance = Real(0.003);
            flight.direction = -1;
            expectUntouched(flyer, flight);
            flight.place = {-200, 64};
            expectUntouched(flyer, flight);
            flight.boost = {-3, 2};
            flight.place = {};
            expectUntouched(flyer, flight);
            flight.freeTarget = true;
            flight.restitution = Real(0.5);
            expectUntouched(flyer, flight);
        });
    }
}

// A kinematic body at rest is a static one, bit for bit: in a miss, a graze and a hit.
TEST(Passing, IsTheSameAtAStaticAndAtAKinematicTarget) {
    for (const Flyer& flyer : flyers()) {
        forEachFlight([&](Flight flight) {
            for (const Real clearance : {Real(0.003), Real(-0.002), Real(-1.5) * flyer.below}) {
                for (const Real restitution : {Real(0), Real(0.5)}) {
                    flight.clearance = clearance;
                    flight.restitution = restitution;
                    flight.kinematic = false;
                    const Flown fixed = fly(flyer, flight);
                    flight.kinematic = true;
                    EXPECT_EQ(fly(flyer, flight), fixed)
                        << flyer.name << ", " << flight.rate << " Hz, clearance " << clearance
                        << ", speed " << flight.speed << ", phase " << flight.phase
                        << ", restitution " << restitution;
                }
            }
        });
    }
}

// What flies lower hits, in all of these.
TEST(Passing, ACornerStopsWhatDoesNotMissIt) {
    for (const Flyer& flyer : flyers()) {
        forEachFlight([&](Flight flight) {
            flight.clearance = Real(-1.5) * flyer.below; // its centre is below the upper side
            SCOPED_TRACE(testing::Message() << flyer.name << ", " << flight.rate << " Hz, speed "
                                            << flight.speed << ", phase " << flight.phase);
            const Flown flown = fly(flyer, flight);
            EXPECT_GT(flown.records, 0);
            EXPECT_GT(flown.impulse, Real(0.5) * flight.speed);
        });
    }
}

} // namespace
} // namespace kodo
