// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

// From 0.1 mm to 100 km, bodies rest within 1 % of their size if length unit and gravity scale with
// it.
TEST(Size, BodiesOfAnySizeFallAsleepOnTheFloor) {
    for (const double size : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5}) {
        SCOPED_TRACE(size);
        const auto s = static_cast<Real>(size);
        World world({.gravity = {0, -10 * s}, .lengthUnit = s});
        world.add(
            {.shape = Box{20 * s, s}, .position = {0, Real(-0.5) * s}, .type = BodyType::Static});
        const BodyId box = world.add(support::boxDef({0, s}, s, s));
        const BodyId ball = world.add(support::ballDef({3 * s, s}, s / 2));
        support::run(world, 300);
        for (const BodyId id : {box, ball}) {
            EXPECT_TRUE(support::near(world[id].position().y, size / 2, size / 100));
            EXPECT_LT(length(world[id].velocity()), s / 100);
            EXPECT_NE(world[id].flags() & kAsleep, 0u);
        }
    }
}

// Bodies from 1/100 to 100 length units rest on the floor of one World.
TEST(Size, SmallAndLargeLieOnOneFloor) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    std::vector<std::pair<BodyId, Real>> boxes;
    Real x = -400;
    for (const Real size : {Real(0.01), Real(0.1), Real(1), Real(10), Real(100)}) {
        boxes.emplace_back(world.add(support::boxDef({x, size}, size, size)), size);
        x += 150;
    }
    support::run(world, 600);
    for (const auto& [box, size] : boxes) {
        SCOPED_TRACE(size);
        // The slop is a share of the unit, so a small body may overlap the floor by that much.
        EXPECT_TRUE(
            support::near(world[box].position().y, size / 2, size / 100 + world.tolerances().slop));
        EXPECT_LT(length(world[box].velocity()), Real(0.01) + size / 100);
    }
}

} // namespace
} // namespace kodo
