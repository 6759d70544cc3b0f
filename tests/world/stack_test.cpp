// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::addStack;
using support::boxDef;
using support::near;
using support::run;
using support::withoutSleep;

// W4: ten boxes stand for 60 s without sleep. Each contact may overlap by the slop.
TEST(Stack, OfTenBoxesStandsForAMinute) {
    World world(withoutSleep());
    addFloor(world);
    const std::vector<BodyId> boxes = addStack(world, 10);
    run(world, 3600);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const BodyView box = world[boxes[i]];
        const Real height = static_cast<Real>(i) + Real(0.5);
        const Real sink = static_cast<Real>(i + 1) * world.tolerances().slop;
        EXPECT_TRUE(near(box.position().x, 0, Real(1e-3))) << i;
        EXPECT_LE(box.position().y, height + Real(1e-3)) << i;
        EXPECT_GE(box.position().y, height - sink) << i;
        EXPECT_LT(length(box.velocity()), Real(1e-3)) << i;
        EXPECT_TRUE(near(box.rotation().s, 0, Real(1e-3))) << i;
    }
}

// With sleep, the stack falls asleep in place.
TEST(Stack, FallsAsleepInPlace) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const std::vector<BodyId> boxes = addStack(world, 10);
    run(world, 600);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_NE(world[boxes[i]].flags() & kAsleep, 0u) << i;
        EXPECT_TRUE(near(world[boxes[i]].position().y, static_cast<Real>(i) + Real(0.5),
                         static_cast<Real>(i + 1) * world.tolerances().slop));
    }
}

// In a symmetric pyramid of 10 rows, no box moves sideways by more than 1 cm.
TEST(Stack, APyramidStands) {
    World world(withoutSleep());
    addFloor(world);
    std::vector<std::pair<BodyId, Vec2>> boxes;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            const Vec2 place{Real(1.1) * (static_cast<Real>(i) + static_cast<Real>(row) / 2),
                             static_cast<Real>(row) + Real(0.5)};
            boxes.emplace_back(world.add(boxDef(place, 1, 1)), place);
        }
    }
    run(world, 900);
    for (const auto& [id, place] : boxes) {
        EXPECT_TRUE(near(world[id].position().x, place.x, Real(0.01)));
        EXPECT_TRUE(near(world[id].position().y, place.y, 10 * world.tolerances().slop));
    }
}

} // namespace
} // namespace kodo
