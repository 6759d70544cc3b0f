// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/solver.hpp>

#include <joints/rig.hpp>

#include <cmath>

namespace kodo {
namespace {

using joints::Rig;
using support::settingsOf;

constexpr double kTooth = 0.5; // rad

/// A disc of radius 1 m on a pin with a ratchet.
struct Wheel : Rig {
    BodyId wheel;
    JointId pin;
    Real dt; // s

    Wheel(support::Solver solver, double rate, double tooth, Vec2 place = {})
        : Rig({}, settingsOf(solver)), dt(static_cast<Real>(1 / rate)) {
        world[post].setPosition(place);
        wheel = world.add({.shape = Circle{1}, .position = place});
        pin = world.add(RevoluteJoint{.ends = {.a = post, .b = wheel},
                                      .limits = Range{-1000, 1000},
                                      .ratchet = static_cast<Real>(tooth)});
    }
    double angle() const { return static_cast<double>(world.jointState(pin).angle); }
    double spin() const { return static_cast<double>(world[wheel].angularVelocity()); }
    Range limits() const { return *std::get<RevoluteJoint>(world.joint(pin)).limits; }
    void turn(double torque, double seconds) { // N m
        for (int step = 0; step < static_cast<int>(seconds / static_cast<double>(dt)); ++step) {
            world[wheel].applyTorque(static_cast<Real>(torque));
            world.step(dt);
        }
    }
};

// F1: under a torque T a wheel turns by T t^2 / 2 I, as without a ratchet. Then the opposite one,
// ten times as strong, turns it back to the last tooth, where it rests.
TEST(Ratchet, HoldsTheLastTooth) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double rate : {30.0, 60.0, 240.0}) {
            for (const double way : {1.0, -1.0}) {
                for (const Vec2 place : {Vec2{}, Vec2{700, -300}}) {
                    SCOPED_TRACE(testing::Message() << rate << " Hz, " << way);
                    Wheel rig(solver, rate, way * kTooth, place);
                    rig.turn(way * 2, 2);
                    const double inertia = static_cast<double>(rig.world[rig.wheel].inertia());
                    const double turned = 2 * 2.0 * 2 / 2 / inertia;
                    EXPECT_NEAR(way * rig.angle(), turned, 0.04 * turned); // a step of 30 Hz
                    const double last = std::floor(way * rig.angle() / kTooth) * kTooth;
                    ASSERT_GE(last, 2 * kTooth);
                    rig.world[rig.wheel].setAngularVelocity(0);
                    rig.turn(-20 * way, 2);
                    EXPECT_NEAR(way * rig.angle(), last, 0.01);
                    EXPECT_NEAR(rig.spin(), 0, 1e-3);
                    const Real held = way > 0 ? rig.limits().lower : -rig.limits().upper;
                    EXPECT_NEAR(held, last, 1e-4);
                }
            }
        }
    }
}

// The other limit ends the way; the teeth never pass it.
TEST(Ratchet, StopsAtTheEndOfItsRange) {
    for (const support::Solver solver : support::kSolvers) {
        Wheel rig(solver, 60, kTooth);
        rig.world.changeJoint<RevoluteJoint>(rig.pin, [](RevoluteJoint& joint) {
            joint.limits = Range{0, Real(1.75)};
        });
        rig.turn(20, 2);
        EXPECT_NEAR(rig.angle(), 1.75, 0.01);
        EXPECT_EQ(rig.limits().lower, Real(1.5));
        rig.turn(-20, 2);
        EXPECT_NEAR(rig.angle(), 1.5, 0.01);
    }
}

// Between two free discs it acts on both: their angular momentum stays.
TEST(Ratchet, ConservesAngularMomentum) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.settings = settingsOf(solver)});
        const BodyId disc = world.add({.shape = Circle{1}});
        const BodyId other = world.add({.shape = Circle{Real(0.5)}, .angularVelocity = -3});
        world.add(RevoluteJoint{
            .ends = {.a = disc, .b = other}, .limits = Range{0, 1000}, .ratchet = Real(kTooth)});
        const double before = 3 * static_cast<double>(world[other].inertia());
        support::run(world, 60);
        const double both = static_cast<double>(world[disc].inertia() + world[other].inertia());
        for (const BodyId id : {disc, other}) { // stopped at once, and turned on as one
            EXPECT_NEAR(world[id].angularVelocity(), -before / both, 0.01 * before / both);
        }
    }
}

TEST(Ratchet, CountsOnAfterItWasSavedAndLoaded) {
    Wheel rig(support::Solver::Soft, 60, kTooth);
    rig.turn(2, 2);
    World loaded = fromBytes(toBytes(rig.world));
    for (World* const world : {&rig.world, &loaded}) {
        for (int step = 0; step < 120; ++step) {
            (*world)[rig.wheel].applyTorque(-20);
            world->step(rig.dt);
        }
    }
    EXPECT_EQ(loaded.jointState(rig.pin).angle, rig.world.jointState(rig.pin).angle);
}

TEST(Ratchet, NeedsARange) {
    const JointEnds ends{.a = {.index = 0, .generation = 1}, .b = {.index = 1, .generation = 1}};
    const auto problem = check(RevoluteJoint{.ends = ends, .ratchet = 1});
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->field, "ratchet");
    EXPECT_TRUE(check(RevoluteJoint{.ends = ends, .limits = Range{0, 1}, .ratchet = Real(2e4)}));
    EXPECT_TRUE(check(RevoluteJoint{.ends = ends, .limits = Range{0, 1}, .ratchet = Real(1e-7)}));
    EXPECT_FALSE(check(RevoluteJoint{.ends = ends, .limits = Range{0, 1}, .ratchet = -1}));
}

} // namespace
} // namespace kodo
