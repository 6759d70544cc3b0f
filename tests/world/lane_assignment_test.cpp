// SPDX-License-Identifier: MIT
// Results depend on the colours of contacts alone, not on their lanes.
#include <support/scenes.hpp>

#include "world/world_impl.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace kodo {
namespace {

/// A pile with all that a lane stores: rolling resistance, restitution, static friction above the
/// kinetic one, a chain, a heavy body on light ones, more contacts of a body than colours, and
/// bodies that fall asleep beside it.
World pile(const StepSettings& settings) {
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    Material material = withFriction(Real(0.5));
    material.staticFriction = Real(0.7);
    material.rollingResistance = Real(0.05);
    for (int i = 0; i < 60; ++i) {
        BodyDef def = support::boxDef({Real(0.5) * static_cast<Real>(i % 10),
                                       Real(0.4) + Real(0.5) * static_cast<Real>(i / 10)},
                                      Real(0.4), Real(0.4));
        if (i % 3 == 0) {
            def.shape = Circle{Real(0.2)};
        }
        def.material = material;
        def.material.restitution = i % 7 == 0 ? Real(0.5) : Real(0);
        world.add(def);
    }
    world.add(support::boxDef({2, 6}, 2, 2)); // heavy
    BodyId before = world.add(support::boxDef({-3, 5}, Real(0.3), Real(0.1)));
    for (int i = 1; i < 8; ++i) {
        const Real x = -3 + Real(0.3) * static_cast<Real>(i);
        const BodyId next = world.add(support::boxDef({x, 5}, Real(0.3), Real(0.1)));
        world.add(RevoluteJoint{
            .ends = {
                .a = before, .b = next, .anchorA = {Real(0.15), 0}, .anchorB = {Real(-0.15), 0}}});
        before = next;
    }
    world.add(support::boxDef({30, Real(0.5)}, 20, Real(0.4))); // a plank with 60 boxes
    for (int i = 0; i < 60; ++i) {
        world.add(support::boxDef({Real(20.5) + Real(0.32) * static_cast<Real>(i), 1}, Real(0.3),
                                  Real(0.3)));
    }
    world.add(support::boxDef({-9, Real(0.5)}, 1, 1)); // sleeps first
    return world;
}

void expectSameBits(const StepSettings& settings, int steps) {
    World keeps = pile(settings);
    World assigns = pile(settings);
    std::size_t asleep = 0;
    for (int step = 0; step < steps; ++step) {
        for (World* world : {&keeps, &assigns}) {
            if (step % 20 == 19) { // one after the other is removed
                const std::vector<BodyId> all = world->bodies();
                world->remove(all[1 + static_cast<std::size_t>(step) % (all.size() - 1)]);
            }
            world->step(support::kDt);
        }
        assigns.impl().contactData().lanes().rebuildSoon();
        ASSERT_EQ(assigns.stateHash(), keeps.stateHash()) << "step " << step;
        asleep = std::max(asleep, keeps.bodyCount() - stepStats(keeps).bodies);
    }
    EXPECT_GT(asleep, 0u);
}

TEST(LaneAssignment, ChangesNoBitOfTheSoftSolver) {
    expectSameBits({}, 400);
}

TEST(LaneAssignment, ChangesNoBitOfPropagation) {
    expectSameBits(thesis2006(), 200);
}

} // namespace
} // namespace kodo
