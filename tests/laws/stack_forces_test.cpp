// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::boxDef;
using support::kDt;
using support::nearShare;
using support::recordOf;

/// Mean force (N) between two bodies over `steps` steps.
double forceBetween(World& world, BodyId a, BodyId b, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(kDt);
        const CollisionRecord* record = recordOf(world, a, b);
        sum += record == nullptr ? 0 : static_cast<double>(record->totalImpulse);
    }
    return sum / (steps / 60.0);
}

// Contact k of a stack of ten carries the 10 - k boxes above it, within 1 % after 5 s. It sinks by
// at most one slop per contact and is at rest after 20 s.
TEST(StackForces, EachContactCarriesTheWeightAbove) {
    World world(support::withoutSleep());
    BodyId lower = support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 10);
    support::run(world, 300);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const double expected = 10.0 * static_cast<double>(boxes.size() - k);
        EXPECT_TRUE(nearShare(forceBetween(world, lower, boxes[k], 1), expected, 0.01)) << k;
        const Real sink = static_cast<Real>(k) + Real(0.5) - world[boxes[k]].position().y;
        EXPECT_LE(sink, static_cast<Real>(k + 1) * world.tolerances().slop) << k;
        lower = boxes[k];
    }
    support::run(world, 900);
    for (const BodyId box : boxes) {
        EXPECT_LT(length(world[box].velocity()), Real(1e-3));
    }
}

// A beam on supports at x = -2 and 2 with a load at x obeys the lever rule, within 1 %.
TEST(StackForces, ABeamSharesItsLoadByTheLeverRule) {
    for (const double x : {0.0, 0.5, 1.5}) {
        SCOPED_TRACE(x);
        World world(support::withoutSleep());
        BodyDef support = support::ballDef({-2, Real(0.5)}, Real(0.5));
        support.type = BodyType::Static;
        const BodyId left = world.add(support);
        support.position.x = 2;
        const BodyId right = world.add(support);
        BodyDef def = boxDef({0, Real(1.25)}, 6, Real(0.5)); // 3 kg
        const BodyId beam = world.add(def);
        def = boxDef({static_cast<Real>(x), 2}, 1, 1); // 1 m^2
        def.density = 4;
        world.add(def);
        support::run(world, 300);
        const double atLeft = forceBetween(world, left, beam, 1);
        const double atRight = forceBetween(world, right, beam, 1);
        EXPECT_TRUE(nearShare(atLeft, 15 + 40 * (2 - x) / 4, 0.01));
        EXPECT_TRUE(nearShare(atRight, 15 + 40 * (2 + x) / 4, 0.01));
    }
}

// With three supports the forces are indeterminate, but their sum and torque are known.
TEST(StackForces, ThreeSupportsBalanceForceAndTorque) {
    World world(support::withoutSleep());
    std::vector<BodyId> supports;
    for (const Real x : {Real(-2), Real(0), Real(2)}) {
        BodyDef support = support::ballDef({x, Real(0.5)}, Real(0.5));
        support.type = BodyType::Static;
        supports.push_back(world.add(support));
    }
    const BodyId beam = world.add(boxDef({0, Real(1.25)}, 6, Real(0.5)));
    BodyDef load = boxDef({1, 2}, 1, 1);
    load.density = 4;
    world.add(load);
    support::run(world, 600);
    double force = 0;
    double torque = 0;
    for (const BodyId id : supports) {
        const double f = forceBetween(world, id, beam, 1);
        force += f;
        torque += f * static_cast<double>(world[id].position().x);
    }
    EXPECT_TRUE(nearShare(force, 70, 0.01));
    EXPECT_TRUE(nearShare(torque, 40, 0.01));
}

} // namespace
} // namespace kodo
