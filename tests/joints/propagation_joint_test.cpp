// SPDX-License-Identifier: MIT
// Joints under the solver of the thesis, whose errors are removed by displacements.
#include <joints/rig.hpp>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace kodo {
namespace {

using joints::energyOf;

StepSettings awake(StepSettings settings) {
    settings.leaveOut = Feature::Sleep;
    return settings;
}

/// A square net of discs that hangs on its upper corners.
struct SquareNet {
    World world;

    SquareNet(int side, const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        std::vector<BodyId> discs;
        for (int i = 0; i < side * side; ++i) {
            const int column = i % side;
            const bool corner = i < side && (column == 0 || column == side - 1);
            discs.push_back(world.add({.shape = Circle{Real(0.2)},
                                       .position = {Real(0.5) * static_cast<Real>(column),
                                                    Real(-0.5) * static_cast<Real>(i / side)},
                                       .type = corner ? BodyType::Static : BodyType::Dynamic}));
            if (column > 0) {
                tie(discs[discs.size() - 2], discs.back(), {Real(0.25), 0});
            }
            if (i >= side) {
                tie(discs[discs.size() - 1 - static_cast<std::size_t>(side)], discs.back(),
                    {0, Real(-0.25)});
            }
        }
    }
    void tie(BodyId a, BodyId b, Vec2 half) {
        world.add(RevoluteJoint{.ends = {.a = a, .b = b, .anchorA = half, .anchorB = -half}});
    }
};

// B12: a net that sags from its corners gains no energy and calms down. With errors removed by
// velocities it gained 1e8 J: 6 x 6 at 30 Hz, 20 x 20 at 60 Hz.
TEST(PropagationJoint, ANetGainsNoEnergy) {
    struct Case {
        int side;
        Real rate;
        int seconds;
    };
    for (const Case& of : support::variants<Case>(
             {{6, 30, 20}, {6, 60, 20}, {6, 240, 5}, {20, 30, 10}, {20, 60, 10}})) {
        SCOPED_TRACE(std::to_string(of.side) + " at " + std::to_string(of.rate) + " Hz");
        SquareNet net(of.side, awake(thesis2006()));
        const double start = energyOf(net.world);
        double most = start;
        for (int step = 0; step < of.seconds * static_cast<int>(of.rate); ++step) {
            net.world.step(1 / of.rate);
            most = std::max(most, energyOf(net.world));
        }
        EXPECT_LT(most - start, 0.01);
        EXPECT_LT(support::totalsOf(net.world).kinetic, 10);
    }
}

/// 21 balls of 0.1 kg on pins of 0.2 m.
struct BallChain {
    World world;
    std::vector<BodyId> balls;
    std::vector<JointEnds> ends;

    BallChain(const StepSettings& settings, Vec2 first, Real endMass = 1)
        : world({.gravity = support::kEarth, .settings = settings}) {
        for (int i = 0; i < 21; ++i) {
            BodyDef def =
                support::ballDef(first + Vec2{Real(0.2) * static_cast<Real>(i), 0}, Real(0.08));
            def.density = i == 20 ? 5 * endMass : Real(5);
            balls.push_back(world.add(def));
            if (i > 0) {
                ends.push_back({.a = balls[balls.size() - 2],
                                .b = balls.back(),
                                .anchorA = {Real(0.1), 0},
                                .anchorB = {Real(-0.1), 0}});
                world.add(RevoluteJoint{.ends = ends.back()});
            }
        }
    }
    /// m, largest gap of a joint in ten seconds at this rate, with a force (N) on the first ball.
    Real opens(Real rate, Vec2 pull) {
        Real widest = 0;
        for (int step = 0; step < static_cast<int>(10 * rate); ++step) {
            world[balls[0]].applyForce(pull);
            world.step(1 / rate);
            for (const JointEnds& end : ends) {
                widest = std::max(widest, length(joints::gapOf(world, end)));
            }
        }
        return widest;
    }
};

// B2: chains that touch something are not solved directly. Before, gaps of 17 m at 30 Hz, and of
// 0.6 m over the peg at 60 Hz.
TEST(PropagationJoint, AChainThatTouchesSomethingStaysTogether) {
    for (const Real rate : support::variants({Real(60), Real(30), Real(240)})) {
        SCOPED_TRACE(rate);
        BallChain pulled(awake(thesis2006()), {0, Real(0.08)});
        pulled.world.add({.shape = Plane{}, .type = BodyType::Static});
        EXPECT_LT(pulled.opens(rate, {-20, 0}), 0.01);

        BallChain hung(awake(thesis2006()), {-2, Real(2.88)});
        hung.world.add({.shape = Plane{}, .type = BodyType::Static});
        hung.world.add(
            {.shape = Circle{Real(0.3)}, .position = {0, Real(2.5)}, .type = BodyType::Static});
        EXPECT_LT(hung.opens(rate, {}), 0.08);
    }
}

// At 60 Hz ten passes do not carry so large a force through a light chain: gaps of metres.
TEST(PropagationJoint, AChainWithAHeavyEndStaysTogetherAtSmallSteps) {
    BallChain pulled(awake(thesis2006()), {0, Real(0.08)}, 100);
    pulled.world.add({.shape = Plane{}, .type = BodyType::Static});
    EXPECT_LT(pulled.opens(240, {-150, 0}), 0.01);
}

constexpr Real kRates[]{30, 60, 120, 240}; // Hz

/// A car of 1 m on two wheels, on a slope.
struct Car {
    World world{{.gravity = support::kEarth, .settings = thesis2006()}};
    BodyId chassis;

    Car(bool sprung, Real slope) {
        const Rot turn = Rot::fromAngle(slope);
        const auto add = [&](const Shape& shape, Vec2 at, BodyType type = BodyType::Dynamic) {
            return world.add(
                {.shape = shape, .position = turn * at, .rotation = turn, .type = type});
        };
        add(Box{20, 1}, {0, Real(-0.5)}, BodyType::Static);
        chassis = add(Box{2, Real(0.5)}, {0, Real(0.9)});
        for (const Real x : {Real(-0.7), Real(0.7)}) {
            const JointEnds axle{.a = chassis,
                                 .b = add(Circle{Real(0.4)}, {x, Real(0.4)}),
                                 .anchorA = {x, Real(-0.5)}};
            if (sprung) {
                world.add(WheelJoint{.ends = axle, .hertz = 4, .damping = 1, .motorTorque = 100});
            } else {
                world.add(RevoluteJoint{.ends = axle, .motorTorque = 100});
            }
        }
    }
};

// Ten passes from zero left it creeping at up to 6 mm/s on flat ground, 10 on a slope.
TEST(PropagationJoint, ACarWithBrakesRestsAndSleeps) {
    for (const Real rate : kRates) {
        for (const Real slope : {Real(0), Real(0.1)}) {
            for (const bool sprung : {false, true}) {
                SCOPED_TRACE(std::to_string(rate) + " Hz, slope " + std::to_string(slope));
                Car car(sprung, slope);
                for (int step = 0; step < static_cast<int>(3 * rate); ++step) {
                    car.world.step(1 / rate);
                }
                EXPECT_TRUE(car.world[car.chassis].isAsleep());
                const Real sag = sprung ? Real(0.025) : Real(0.001); // m, of the springs
                EXPECT_LT(length(car.world[car.chassis].position() -
                                 Rot::fromAngle(slope) * Vec2{0, Real(0.9)}),
                          sag);
            }
        }
    }
}

// No force has a torque about the pin, so the spin stays. At 30 rad/s and 30 Hz the door lost a
// third of its energy in the first step, two thirds in ten.
TEST(PropagationJoint, ADoorThatTurnsByARadianInAStepKeepsItsEnergy) {
    for (const Real rate : kRates) {
        for (const Real turn : {Real(0.1), Real(0.5), Real(1)}) { // rad a step
            SCOPED_TRACE(std::to_string(rate) + " Hz, " + std::to_string(turn));
            const Real spin = turn * rate;
            joints::Rig rig({}, awake(thesis2006()));
            const BodyId door = rig.world.add({.shape = Box{1, Real(0.1)},
                                               .position = {Real(0.5), 0},
                                               .velocity = {0, spin / 2},
                                               .angularVelocity = spin});
            rig.world.add(
                RevoluteJoint{.ends = {.a = rig.post, .b = door, .anchorB = {Real(-0.5), 0}}});
            const auto energy = [&] {
                return static_cast<double>(support::totalsOf(rig.world).kinetic);
            };
            const double start = energy();
            for (int step = 0; step < 100; ++step) {
                rig.world.step(1 / rate);
                ASSERT_NEAR(energy() / start, 1, 1e-3) << step;
            }
        }
    }
}

// The prediction knows no joints: it took the body down by g h^2, 11 mm at 30 Hz, and the motor
// then lifted it by as much into the ceiling.
TEST(PropagationJoint, ABoxThatAMotorLiftsToTheCeilingRests) {
    for (const Real rate : kRates) {
        SCOPED_TRACE(rate);
        World world({.gravity = support::kEarth, .settings = thesis2006()});
        const BodyId ceiling =
            world.add({.shape = Box{4, 1}, .position = {0, 3}, .type = BodyType::Static});
        const BodyId lift = world.add({.shape = Box{1, 1}, .position = {0, 1}});
        world.add(PrismaticJoint{.ends = {.a = ceiling, .b = lift, .collide = true},
                                 .axis = {0, 1},
                                 .motorSpeed = 1,
                                 .motorForce = 30});
        for (int step = 0; step < static_cast<int>(4 * rate); ++step) {
            world.step(1 / rate);
            ASSERT_LT(world[lift].position().y, Real(2.002)) << step; // half a slop
        }
        EXPECT_TRUE(world[lift].isAsleep());
    }
}

// H7: a joint of the ground made all contacts of the ground those of jointed bodies.
TEST(PropagationJoint, WhatHangsFromTheGroundLeavesAPileOnItAlone) {
    std::vector<Vec2> places;
    for (const bool hangs : {false, true}) {
        World world({.gravity = support::kEarth, .settings = awake(thesis2006())});
        const BodyId ground = world.add(
            {.shape = Box{4000, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Static});
        std::vector<BodyId> pile;
        for (int i = 0; i < 15; ++i) {
            pile.push_back(world.add(support::ballDef(
                {Real(0.4) * static_cast<Real>(i % 3), 1 + static_cast<Real>(i / 3)}, Real(0.5))));
        }
        if (hangs) {
            const BodyId box = world.add({.position = {1000, 3}});
            world.add(RevoluteJoint{.ends = {.a = ground, .b = box, .anchorA = {1001, 4}}});
        }
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
        }
        for (std::size_t i = 0; i < pile.size(); ++i) {
            const Vec2 place = world[pile[i]].position();
            if (hangs) {
                EXPECT_EQ(place, places[i]) << i;
            }
            places.push_back(place);
        }
    }
}

} // namespace
} // namespace kodo
