// SPDX-License-Identifier: MIT
// Joints with anchors far outside of small bodies. An accumulated impulse acts along the arm of the
// substep before, and must not rotate such a body.
#include <joints/rig.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kodo {
namespace {

using joints::energyOf;

struct NamedSettings {
    std::string name;
    StepSettings settings;
    int substeps;
};

std::vector<NamedSettings> solvers() {
    return {{"soft", {}, SoftSettings{}.substeps},
            {"thesis2006", thesis2006(), PropagationSettings{}.substeps}};
}

enum class Kind { Revolute, Fixed, Prismatic };

JointDef jointOf(Kind kind, const JointEnds& ends) {
    switch (kind) {
    case Kind::Fixed:
        return FixedJoint{.ends = ends};
    case Kind::Prismatic:
        return PrismaticJoint{.ends = ends, .axis = {0, 1}};
    default:
        return RevoluteJoint{.ends = ends};
    }
}

/// A box of 1 m at `kSpin` rad/s and a body of `size` m that can only rotate, joined at `arm` m
/// from both centres.
struct Axle {
    static constexpr Real kSpin = 6;
    World world;
    BodyId box;
    BodyId small;

    Axle(Kind kind, const StepSettings& settings, Real size, Real arm)
        : world({.settings = settings}),
          box(world.add({.shape = Box{1, 1}, .angularVelocity = kSpin})),
          small(
              world.add({.shape = Box{size, size}, .position = {2 * arm, 0}, .flags = kLockMove})) {
        world.add(jointOf(kind, {box, small, {arm, 0}, {-arm, 0}}));
    }
    double energy() const { // J
        const auto half = [](Real inertia, Real square) {
            return static_cast<double>(inertia * square) / 2;
        };
        const BodyView a = std::as_const(world)[box];
        const BodyView b = std::as_const(world)[small];
        return half(a.mass(), lengthSquared(a.velocity())) +
               half(a.inertia(), a.angularVelocity() * a.angularVelocity()) +
               half(b.inertia(), b.angularVelocity() * b.angularVelocity());
    }
};

// F1: a small body on a fixed axle, joined on a long arm to one that turns, gains no energy and
// loses little. The first substep has no centripetal impulse yet, so anchors leave their arcs by
// q^2 / 2 of the arm, with q as the rotation in a substep, which takes up to 2 q of the energy to
// close. Two steps in, the velocities fit the joint.
TEST(LongArm, ASmallBodyThatOnlyTurnsKeepsTheEnergy) {
    for (const NamedSettings& solver : solvers()) {
        for (const Kind kind : {Kind::Revolute, Kind::Fixed, Kind::Prismatic}) {
            for (const int rate : {30, 60, 240}) {
                for (const Real size : {Real(0.05), Real(0.1), Real(0.3)}) {
                    for (const Real arm : {Real(0.6), Real(1.5)}) {
                        SCOPED_TRACE(testing::Message()
                                     << solver.name << ", joint " << static_cast<int>(kind) << ", "
                                     << rate << " Hz, box of " << size << " m, arms of " << arm
                                     << " m");
                        Axle axle(kind, solver.settings, size, arm);
                        const double rotation =
                            static_cast<double>(Axle::kSpin) / (rate * solver.substeps);
                        const double most = (1 + 2 * rotation) * axle.energy();
                        support::run(axle.world, 2, 1 / static_cast<Real>(rate));
                        const double least = 0.7 * axle.energy();
                        for (int step = 0; step < 2 * rate; ++step) {
                            axle.world.step(1 / static_cast<Real>(rate));
                            ASSERT_LT(axle.energy(), most) << "step " << step;
                            ASSERT_GT(axle.energy(), least) << "step " << step;
                        }
                    }
                }
            }
        }
    }
}

// F1: the limits of a revolute joint stop a box and a splinter whose anchor is 4 m away.
// Regression: the energy grew by a factor of 59 in one step, since the impulse of a limit alone
// rotated the splinter. Later impacts on the limits are not elastic.
TEST(LongArm, LimitsOfARevoluteJointAddNoEnergy) {
    for (const NamedSettings& solver : solvers()) {
        for (const int rate : {30, 60, 240}) {
            for (const Real size : {Real(0.05), Real(0.1), Real(0.4)}) {
                SCOPED_TRACE(testing::Message()
                             << solver.name << ", " << rate << " Hz, splinter of " << size << " m");
                World world({.settings = solver.settings});
                const BodyId box = world.add({.shape = Box{1, 1},
                                              .position = {-3.25f, 0},
                                              .velocity = {-4.5f, 2.5f},
                                              .angularVelocity = 2.9f});
                const BodyId splinter =
                    world.add({.shape = Box{size, size / 3}, .velocity = {-2, -3.5f}});
                world.add(
                    RevoluteJoint{.ends = {box, splinter, {-0.636f, -1.468f}, {-3.886f, -1.468f}},
                                  .limits = Range{-0.7f, 1.3f}});
                const double start = energyOf(world);
                double angle = 0; // rad, largest
                for (int step = 0; step < 3 * rate; ++step) {
                    world.step(1 / static_cast<Real>(rate));
                    ASSERT_LT(static_cast<double>(support::totalsOf(world).kinetic), 1.02 * start)
                        << "step " << step;
                    const Rot turned = world[splinter].rotation() * world[box].rotation().inverse();
                    angle = std::max(angle, std::abs(static_cast<double>(turned.angle())));
                }
                EXPECT_GT(angle, 0.6) << "no limit was reached";
            }
        }
    }
}

/// Two small boxes on a static post, each hinged `arm` m from its centre, with limits of 0.7 rad.
/// The outer one has `load` times the mass of the inner one; both turn at `spin` rad/s.
struct LimitedArms {
    World world;
    std::vector<JointId> pins;

    LimitedArms(const StepSettings& settings, Real arm, Real load, Real spin)
        : world({.settings = settings}) {
        BodyId before = world.add({.shape = Box{1, 1}, .type = BodyType::Static});
        for (const int link : {1, 2}) {
            const BodyId box = world.add({.shape = Box{0.2f, 0.2f},
                                          .position = {static_cast<Real>(link) * arm, 0},
                                          .velocity = {0, static_cast<Real>(link) * arm * spin},
                                          .angularVelocity = spin,
                                          .density = link == 1 ? Real(1) : load,
                                          .flags = kDisabled});
            pins.push_back(
                world.add(RevoluteJoint{.ends = {.a = before, .b = box, .anchorB = {-arm, 0}},
                                        .limits = Range{-0.7f, 0.7f}}));
            before = box;
        }
    }
};

// F1: two links that are much longer than they are wide swing from limit to limit for 5 s and gain
// no energy. Regression: the limit of the second pin saw the first box spin about its own centre,
// and the energy grew by a factor of 1e9. With heavier outer links, energy may still grow.
TEST(LongArm, LimitsOfTwoLinksInARowAddNoEnergy) {
    const auto judge = [](const NamedSettings& solver, int rate, Real arm, Real load) {
        for (const Real spin : {Real(2), Real(-5)}) {
            SCOPED_TRACE(testing::Message() << solver.name << ", " << rate << " Hz, arms of " << arm
                                            << " m, load " << load << ", spin " << spin);
            LimitedArms arms(solver.settings, arm, load, spin);
            const auto energy = [&] {
                return static_cast<double>(support::totalsOf(arms.world).kinetic);
            };
            const double start = energy();
            Real angle = 0; // rad, largest of the inner pin
            for (int step = 0; step < 5 * rate; ++step) {
                arms.world.step(1 / static_cast<Real>(rate));
                ASSERT_LT(energy(), 1.03 * start) << "step " << step;
                angle = std::max(angle, std::abs(arms.world.jointState(arms.pins[0]).angle));
            }
            EXPECT_GT(angle, Real(0.69)) << "no limit was reached";
        }
    };
    const std::vector<NamedSettings> both = solvers();
    for (const int rate : {30, 60, 120, 240}) {
        for (const Real arm : {Real(0.3), Real(1), Real(2)}) {
            for (const Real load : {Real(0.01), Real(0.1), Real(1)}) {
                judge(both.front(), rate, arm, 10 * load);
                judge(both.back(), rate, arm, load);
            }
        }
    }
}

// F1: a body that can only turn, on a slider whose motor cannot move it, stays at rest.
// Regression: with the angle held nothing moves along the axis, and the impulse was 0 / 0.
TEST(LongArm, ASliderCannotMoveABodyThatOnlyTurns) {
    for (const NamedSettings& solver : solvers()) {
        for (const int rate : {30, 60, 240}) {
            for (const Vec2 place : {Vec2{0, 0}, Vec2{-3.25f, 800}}) {
                for (const Vec2 arm : {Vec2{1.125f, 0.75f}, Vec2{-4, -4.25f}, Vec2{-1.125f, 4}}) {
                    SCOPED_TRACE(testing::Message() << solver.name << ", " << rate << " Hz, arm "
                                                    << arm.x << ", " << arm.y << " at " << place.y);
                    World world({.gravity = support::kEarth, .settings = solver.settings});
                    const BodyId turning =
                        world.add({.shape = Box{1, 1}, .position = place, .flags = kLockMove});
                    const BodyId wall = world.add({.shape = Circle{0.5f},
                                                   .position = place + Vec2{-8, -2},
                                                   .type = BodyType::Static});
                    world.add(PrismaticJoint{.ends = {turning, wall, arm, arm + Vec2{8, 2}},
                                             .axis = {1, 0},
                                             .limits = Range{-1, 1},
                                             .motorSpeed = 0.5f,
                                             .motorForce = 2});
                    for (int step = 0; step < rate; ++step) {
                        world.step(1 / static_cast<Real>(rate));
                        ASSERT_EQ(world[turning].flags() & kFrozen, 0u) << "step " << step;
                        ASSERT_LT(std::abs(world[turning].angularVelocity()), Real(0.02));
                    }
                    EXPECT_LT(std::abs(world[turning].rotation().angle()), Real(0.01));
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
