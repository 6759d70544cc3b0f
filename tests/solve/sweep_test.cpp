// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

// What flies in a row does not meet within a step, by its motion alone; but once the first is
// stopped by the wall, the next is stopped by the first, and so on. One by one they pass neither
// each other nor the wall, at up to a hundred widths a step.
TEST(Sweep, WhatFollowsAStoppedBodyStopsBehindIt) {
    for (const Real speed : {Real(20), Real(60), Real(300), Real(1200)}) {
        SCOPED_TRACE(speed);
        World world;
        world.add({.shape = Box{Real(0.2), 10}, .position = {5, 0}, .flags = kLocked});
        std::vector<BodyId> row;
        for (int i = 0; i < 6; ++i) {
            BodyDef def =
                support::boxDef({4 - Real(0.4) * static_cast<Real>(i), 0}, Real(0.2), Real(0.2));
            def.velocity = {speed, 0};
            row.push_back(world.add(def));
        }
        for (int step = 0; step < 120; ++step) {
            world.step(support::kDt);
            Real ahead = 5;
            for (const BodyId body : row) {
                const Real x = world[body].position().x;
                ASSERT_LT(x, ahead) << "step " << step;
                ahead = x;
            }
        }
    }
}

} // namespace
} // namespace kodo
