// SPDX-License-Identifier: MIT
// Joints of a Point, which has no inertia.
#include <kodo/kodo.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

using support::kSolvers;
using support::settingsOf;

/// Kinetic energy (J) of two bodies.
Real energyOf(const World& world, BodyId one, BodyId other) {
    Real sum = 0;
    for (const BodyId id : {one, other}) {
        const BodyView body = world[id];
        sum += (body.mass() * lengthSquared(body.velocity()) +
                body.inertia() * body.angularVelocity() * body.angularVelocity()) /
               2;
    }
    return sum;
}

template <typename Joint>
void expectNoEnergy(const StepSettings& settings, Real spin, Joint joint) {
    World world({.settings = settings});
    const BodyId box = world.add({.shape = Box{1, 1}, .position = {0, Real(-1.25)}});
    const BodyId point = world.add(
        {.shape = Point{}, .position = {Real(3.25), Real(-1.25)}, .angularVelocity = spin});
    joint.ends = {.a = box, .b = point, .anchorA = {Real(1.6), 0}, .anchorB = {Real(-1.65), 0}};
    world.add(joint);
    for (int step = 0; step < 30; ++step) {
        world.step(Real(1) / 60);
        ASSERT_LT(energyOf(world, box, point), Real(1e-6)) << spin << " rad/s, step " << step;
    }
}

// Its spin holds neither energy nor angular momentum, so none may come out of it.
TEST(ParticleJoint, TakesNothingFromTheSpinOfAPoint) {
    for (const auto solver : kSolvers) {
        for (const Real spin : {Real(4), Real(-40), Real(4e3)}) {
            expectNoEnergy(settingsOf(solver), spin, RevoluteJoint{});
            expectNoEnergy(settingsOf(solver), spin, FixedJoint{});
            expectNoEnergy(settingsOf(solver), spin, PrismaticJoint{});
            expectNoEnergy(settingsOf(solver), spin, DistanceJoint{.limits = Range{0, Real(0.5)}});
        }
    }
}

} // namespace
} // namespace kodo
