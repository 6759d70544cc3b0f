// SPDX-License-Identifier: MIT
// Springs of revolute, prismatic, fixed and wheel joints; the winch; limits of several turns.
#include <support/draws.hpp>
#include <support/solver.hpp>
#include <support/swings.hpp>

#include <joints/rig.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace kodo {
namespace {

using joints::kG;
using joints::kPi;
using joints::Rig;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;
using support::settingsOf;

StepSettings awake(support::Solver solver) {
    StepSettings settings = settingsOf(solver);
    settings.leaveOut = Feature::Sleep;
    return settings;
}

/// Period (s) of a number of a joint about its rest, over ten seconds.
template <typename Read>
double periodOf(World& world, Read read) {
    support::Swings swings(1.0 / 60);
    for (int step = 0; step < 600; ++step) {
        swings.see(static_cast<double>(read()));
        world.step(kDt);
    }
    return swings.count() > 0 ? swings.period() : 0;
}

// F1: `hertz` is the frequency about the anchor: of a door of any width on an immovable frame. The
// rest angle may be several turns away.
TEST(JointSpring, ADoorSwingsAtItsFrequency) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double width : {0.5, 2.0}) {
            for (const double target : {0.0, 1.0, -9.0}) {
                Rig rig({}, awake(solver));
                const Real half = static_cast<Real>(width / 2);
                const BodyId door = rig.world.add(support::boxDef({half, 0}, 2 * half, Real(0.1)));
                const JointId hinge = rig.world.add(
                    RevoluteJoint{.ends = {.a = rig.post, .b = door, .anchorB = {-half, 0}},
                                  .target = static_cast<Real>(target),
                                  .hertz = Real(0.5)});
                rig.world[door].setAngularVelocity(Real(0.5));
                rig.world[door].setVelocity({0, Real(0.5) * half});
                const double period = periodOf(rig.world, [&] {
                    return rig.world.jointState(hinge).angle - static_cast<Real>(target);
                });
                // At 9 rad it turns by up to 0.5 rad in a step, and a substep is of second order.
                EXPECT_TRUE(nearShare(period, 2.0, std::abs(target) > 1 ? 0.015 : 0.005))
                    << width << ", " << target;
            }
        }
    }
}

// F1: under a torque T the spring turns by T / (I omega^2), whatever its damping is.
TEST(JointSpring, ADoorTurnsByItsTorqueOverItsStiffness) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig({}, awake(solver));
        const BodyId door = rig.world.add(support::boxDef({0, 0}, 1, 1));
        const JointId hinge = rig.world.add(
            RevoluteJoint{.ends = {.a = rig.post, .b = door}, .hertz = 1, .damping = 1});
        const Real torque = Real(0.3) * rig.world[door].inertia();
        for (int step = 0; step < 300; ++step) {
            rig.world[door].applyTorque(torque);
            rig.world.step(kDt);
        }
        EXPECT_TRUE(nearShare(rig.world.jointState(hinge).angle, 0.3 / (4 * kPi * kPi), 1e-3));
        EXPECT_TRUE(nearShare(rig.world.jointTorque(hinge), -static_cast<double>(torque), 1e-3));
    }
}

// F1: a slider and a wheel swing at their frequency, also of a free pair, with momentum kept.
TEST(JointSpring, ASliderAndAWheelSwingAtTheirFrequency) {
    for (const support::Solver solver : support::kSolvers) {
        for (const bool wheel : {false, true}) {
            World world({.settings = awake(solver)});
            const BodyId a = world.add(support::boxDef({0, 0}, 1, 1));
            const BodyId b = world.add(support::ballDef({2, 0}, Real(0.25)));
            const JointEnds ends{.a = a, .b = b, .anchorA = {2, 0}};
            const JointId joint =
                wheel ? world.add(WheelJoint{.ends = ends, .axis = {1, 0}, .hertz = 1})
                      : world.add(PrismaticJoint{.ends = ends, .hertz = 1});
            world[b].setVelocity({1, 0});
            const support::Totals before = support::totalsOf(world);
            EXPECT_TRUE(nearShare(
                periodOf(world, [&] { return world.jointState(joint).translation; }), 1.0, 0.003));
            const support::Totals after = support::totalsOf(world);
            EXPECT_TRUE(near(after.momentum.x, before.momentum.x, 1e-4L));
            EXPECT_TRUE(near(after.spin, before.spin, 1e-4L));
        }
    }
}

// F1: the spring of a slider rests at its target; under a weight it gives by g / omega^2.
TEST(JointSpring, ASliderGivesByItsWeightFromItsTarget) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig(support::kEarth, awake(solver));
        const BodyId load = rig.addBob({0, 1});
        const JointId slider = rig.world.add(PrismaticJoint{.ends = {.a = rig.post, .b = load},
                                                            .axis = {0, 1},
                                                            .target = 1,
                                                            .hertz = 2,
                                                            .damping = 1});
        run(rig.world, 300);
        const double give = kG / (16 * kPi * kPi);
        EXPECT_TRUE(near(rig.world.jointState(slider).translation, 1 - give, 1e-3 * give));
    }
}

// F1: a soft fixed joint swings at its frequency along the axes, across them, and in rotation.
TEST(JointSpring, ASoftFixedJointSwingsAtItsFrequency) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int way : {0, 1, 2}) {
            Rig rig({}, awake(solver));
            const BodyId load = rig.addBob({0, 0});
            const JointId joint =
                rig.world.add(FixedJoint{.ends = {.a = rig.post, .b = load}, .hertz = 1});
            if (way == 2) {
                rig.world[load].setAngularVelocity(1);
            } else {
                rig.world[load].setVelocity(way == 0 ? Vec2{1, 0} : Vec2{Real(0.6), Real(0.8)});
            }
            const double period = periodOf(rig.world, [&] {
                const JointState state = rig.world.jointState(joint);
                return way == 2 ? state.angle : state.anchorB.x;
            });
            EXPECT_TRUE(nearShare(period, 1.0, 0.003)) << way;
        }
    }
}

/// J; largest kinetic energy in a number of steps.
double peakEnergy(World& world, int steps) {
    double most = 0;
    for (int step = 0; step < steps; ++step) {
        world.step(kDt);
        most = std::max(most, static_cast<double>(support::totalsOf(world).kinetic));
    }
    return most;
}

// F1: no spring gains energy in half a minute, however stiff it is; the peaks of the last cycles
// are at most those of the first. Levers, a long arm, and three bodies in a row.
TEST(JointSpring, GainsNoEnergyAtAnyStiffness) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double hertz : {0.5, 5.0, 60.0, 2000.0}) {
            for (const int kind : {0, 1, 2, 3}) {
                World world({.settings = awake(solver)});
                BodyId last = world.add(support::boxDef({0, 0}, 1, 1));
                const auto stiff = static_cast<Real>(hertz);
                for (int i = 1; i < 4; ++i) {
                    const BodyId next = world.add(
                        support::boxDef({Real(1.5) * static_cast<Real>(i), 0}, 1, Real(0.3)));
                    const JointEnds ends{
                        last, next, {Real(0.75), Real(0.2)}, {Real(-0.75), Real(0.2)}};
                    switch (kind) {
                    case 0:
                        world.add(RevoluteJoint{.ends = ends, .hertz = stiff});
                        break;
                    case 1:
                        world.add(PrismaticJoint{.ends = ends, .hertz = stiff});
                        break;
                    case 2:
                        world.add(FixedJoint{.ends = ends, .hertz = stiff});
                        break;
                    default:
                        world.add(WheelJoint{.ends = ends, .hertz = stiff});
                    }
                    last = next;
                }
                world[last].setVelocity({Real(0.3), Real(0.5)});
                world[last].setAngularVelocity(1);
                const auto start = static_cast<double>(support::totalsOf(world).kinetic);
                const support::Totals before = support::totalsOf(world);
                EXPECT_LT(peakEnergy(world, 1800), 1.02 * start) << kind << " " << hertz;
                const support::Totals after = support::totalsOf(world);
                EXPECT_TRUE(near(after.momentum.x, before.momentum.x, 1e-4L));
                EXPECT_TRUE(near(after.momentum.y, before.momentum.y, 1e-4L));
                EXPECT_TRUE(near(after.spin, before.spin, 2e-3L)) << kind << " " << hertz;
            }
        }
    }
}

// F1: a winch shortens its rope at its speed, and a weak one brakes the fall to g - F / m.
TEST(JointSpring, AWinchLiftsAWeightBelowItsForce) {
    for (const support::Solver solver : support::kSolvers) {
        for (const double share : {0.5, 1.5}) {
            Rig rig(support::kEarth, awake(solver));
            const BodyId load = rig.addBob({0, -8});
            const JointId winch = rig.world.add(
                DistanceJoint{.ends = {.a = rig.post, .b = load},
                              .motorSpeed = -2,
                              .motorForce = static_cast<Real>(share * rig.weightOf(load))});
            run(rig.world, 60);
            const double speed = share > 1 ? -2 : kG * (1 - share);
            EXPECT_TRUE(near(rig.world.jointState(winch).lengthSpeed, speed, 0.01));
        }
    }
}

// F1: limits of several turns stop a motor on both sides, and the angle counts the turns.
TEST(JointSpring, LimitsOfSeveralTurnsStopAMotor) {
    for (const support::Solver solver : support::kSolvers) {
        Rig rig({}, settingsOf(solver));
        const BodyId drum = rig.addBob({0, 0});
        const JointId hinge = rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = drum},
                                                          .limits = Range{-10, 20},
                                                          .motorSpeed = 8,
                                                          .motorTorque = 1});
        run(rig.world, 120);
        EXPECT_TRUE(near(rig.world.jointState(hinge).angle, 16, Real(0.2)));
        run(rig.world, 120);
        EXPECT_TRUE(near(rig.world.jointState(hinge).angle, 20, Real(0.02)));
        rig.world.changeJoint<RevoluteJoint>(hinge, [](auto& joint) { joint.motorSpeed = -8; });
        run(rig.world, 300);
        EXPECT_TRUE(near(rig.world.jointState(hinge).angle, -10, Real(0.02)));
        // Another reference keeps the place of the drum, and the turns.
        rig.world.changeJoint<RevoluteJoint>(hinge, [](auto& joint) {
            joint.reference = 1;
            joint.limits = Range{-30, 30};
        });
        EXPECT_TRUE(near(rig.world.jointState(hinge).angle, -11, Real(0.02)));
    }
}

// F1: a drum that rotates by more than half a turn in a step is counted.
TEST(JointSpring, FastTurnsAreCounted) {
    Rig rig(Vec2{});
    const BodyId drum = rig.addBob({0, 0});
    const JointId hinge = rig.world.add(
        RevoluteJoint{.ends = {.a = rig.post, .b = drum}, .limits = Range{-1000, 1000}});
    rig.world[drum].setAngularVelocity(300); // 5 rad in a step
    run(rig.world, 60);
    EXPECT_TRUE(near(rig.world.jointState(hinge).angle, 300, Real(0.1)));
}

// F1: turns are state: a copy, and a World that is read from bytes, continue with them.
TEST(JointSpring, TurnsAreInSnapshots) {
    Rig rig(Vec2{});
    const BodyId drum = rig.addBob({0, 0});
    const JointId hinge = rig.world.add(RevoluteJoint{.ends = {.a = rig.post, .b = drum},
                                                      .limits = Range{-100, 12},
                                                      .motorSpeed = 8,
                                                      .motorTorque = 1});
    run(rig.world, 60);
    World copy = rig.world;
    World read = fromBytes(toBytes(rig.world));
    for (World* world : {&rig.world, &copy, &read}) {
        run(*world, 60);
        EXPECT_TRUE(near(world->jointState(hinge).angle, 12, Real(0.02)));
        EXPECT_EQ(world->stateHash(), rig.world.stateHash());
    }
}

/// Bodies in a row, each with a spring to the one before.
struct Row {
    bool hinges; // false: sliders
    int bodies;
    double ratio; // of densities
    double hertz;
    double damping;
};

/// Largest kinetic energy (J) of a row that starts with velocities to and fro, and that at the
/// start.
std::array<double, 2> energiesOf(const StepSettings& settings, const Row& row) {
    World world({.settings = settings});
    BodyId last{};
    for (int i = 0; i < row.bodies; ++i) {
        const BodyId id = world.add({.shape = Box{1, Real(0.2)},
                                     .position = {static_cast<Real>(i), 0},
                                     .velocity = {0, static_cast<Real>(i == 0       ? 0
                                                                       : i % 2 != 0 ? 1
                                                                                    : -1)},
                                     .density = static_cast<Real>(i % 2 != 0 ? 1 : row.ratio),
                                     .type = i == 0 ? BodyType::Static : BodyType::Dynamic,
                                     .flags = kDisabled});
        const JointEnds ends{
            .a = last, .b = id, .anchorA = {Real(0.5), 0}, .anchorB = {Real(-0.5), 0}};
        if (i > 0 && row.hinges) {
            world.add(RevoluteJoint{.ends = ends,
                                    .hertz = static_cast<Real>(row.hertz),
                                    .damping = static_cast<Real>(row.damping)});
        } else if (i > 0) {
            world.add(PrismaticJoint{.ends = ends,
                                     .axis = {0, 1},
                                     .hertz = static_cast<Real>(row.hertz),
                                     .damping = static_cast<Real>(row.damping)});
        }
        last = id;
    }
    const auto energy = [&] { return static_cast<double>(support::totalsOf(world).kinetic); };
    const double start = energy();
    double most = 0;
    for (int step = 0; step < 300; ++step) {
        world.step(support::kDt);
        most = std::max(most, energy());
    }
    return {most, start};
}

// The damper of a stiff spring acted as if its bodies were free: three boxes with springs of 15 Hz
// gained 1e13 of their energy.
TEST(JointSpring, RowsOfStiffSpringsGainNoEnergy) {
    for (const StepSettings& settings : {balanced(), accurate(), thesis2006()}) {
        for (const bool hinges : {true, false}) {
            for (const int bodies : {3, 4}) {
                for (const double ratio : support::variants({1000.0, 20.0, 1.0})) {
                    for (const double hertz : {3.0, 10.0, 15.0, 20.0, 30.0, 60.0, 1000.0}) {
                        for (const double damping : {0.0, 1.0}) {
                            const Row row{hinges, bodies, ratio, hertz, damping};
                            const auto [most, start] = energiesOf(settings, row);
                            EXPECT_LT(most, 1.2 * start)
                                << (hinges ? "hinges, " : "sliders, ") << bodies
                                << " bodies, 1 : " << ratio << ", " << hertz << " Hz, damping "
                                << damping;
                        }
                    }
                }
            }
        }
    }
}

// A weight extends a spring by m g / k, whatever the step is. In the solver of the thesis it did so
// up to half a radian a step alone: 44 mm instead of 15.8 at 4 Hz and 30 Hz.
TEST(JointSpring, AWeightExtendsSlidersAndHingesByItsShare) {
    for (const StepSettings& settings : {balanced(), thesis2006()}) {
        for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
            for (const double hertz : {4.0, rate / 5}) { // 1.26 rad a step
                SCOPED_TRACE(std::to_string(hertz) + " Hz at " + std::to_string(rate));
                World world({.gravity = support::kEarth, .settings = settings});
                const BodyId post =
                    world.add({.shape = Box{1, 1}, .type = BodyType::Static, .flags = kDisabled});
                const BodyId load = world.add({.shape = Box{1, 1}, .flags = kDisabled});
                const BodyId flap = world.add(
                    {.shape = Box{1, Real(0.1)}, .position = {Real(0.5), 0}, .flags = kDisabled});
                world.add(PrismaticJoint{.ends = {.a = post, .b = load},
                                         .axis = {0, 1},
                                         .hertz = static_cast<Real>(hertz),
                                         .damping = 1});
                world.add(RevoluteJoint{.ends = {.a = post, .b = flap, .anchorB = {Real(-0.5), 0}},
                                        .hertz = static_cast<Real>(hertz),
                                        .damping = 1});
                for (int step = 0; step < static_cast<int>(4 * rate); ++step) {
                    world.step(static_cast<Real>(1 / rate));
                }
                const double omega = 2 * joints::kPi * hertz;
                const double sag = joints::kG / (omega * omega); // m
                EXPECT_NEAR(-world[load].position().y, sag, 0.002 * sag + 2e-6);
                const double inertia = 1.01 / 12 + 0.25; // m^2, about the pin, per mass
                const double turn = joints::kG * 0.5 / (inertia * omega * omega); // rad
                EXPECT_NEAR(-world[flap].rotation().angle(), turn, 0.002 * turn + 2e-6);
            }
        }
    }
}

} // namespace
} // namespace kodo
