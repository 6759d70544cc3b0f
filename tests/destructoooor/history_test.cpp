// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <history.hpp>

namespace {

using destructoooor::History;

kodo::World worldOf(int bodies) {
    kodo::World world;
    for (int i = 0; i < bodies; ++i) {
        world.add({.position = {static_cast<kodo::Real>(2 * i), 0}});
    }
    return world;
}

/// Copies that are kept of so many records, each after a change.
std::size_t copiesOf(int bodies, int records) {
    History history;
    kodo::World world = worldOf(bodies);
    for (int i = 0; i < records; ++i) {
        world.step(kodo::Real(1) / 60);
        history.record(world, true);
    }
    EXPECT_EQ(history.before(world.stepCount()).stepCount(), world.stepCount());
    return history.size();
}

// A page has 2 GB: 400 copies of a large World would take more.
TEST(History, KeepsFewerCopiesOfLargeWorlds) {
    EXPECT_EQ(copiesOf(1, 500), 400u);
    EXPECT_EQ(copiesOf(50000, 25), 20u);
}

} // namespace
