// SPDX-License-Identifier: MIT
#include <apart/stage/cracks.hpp>
#include <apart/stage/dice.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

kodo::Convex blockOutline() {
    return kodo::convexOf(kodo::Box{1.6f, 0.8f}, {});
}

Real lengthOf(const std::vector<CrackLine>& lines) {
    Real sum = 0;
    for (const CrackLine& line : lines) {
        sum += length(line.to - line.from);
    }
    return sum;
}

TEST(Cracks, StayInsideTheBlockWhereverItWasHit) {
    const kodo::Convex outline = blockOutline();
    Dice dice(7);
    for (std::uint32_t trial = 0; trial < 500; ++trial) {
        const Vec2 point{dice.between(-0.85f, 0.85f), dice.between(-0.45f, 0.45f)};
        for (const CrackLine& line : growCracks(outline, point, dice.between(0, 1), trial)) {
            // 1e-4 m: rounding of points that lie on the edge
            EXPECT_LE(std::abs(line.to.x), 0.8f + 1e-4f) << trial;
            EXPECT_LE(std::abs(line.to.y), 0.4f + 1e-4f) << trial;
        }
    }
}

TEST(Cracks, BeginAtThePointOfTheImpact) {
    const Vec2 point{0.3f, -0.4f};
    const std::vector<CrackLine> lines = growCracks(blockOutline(), point, 0.5f, 1);
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines[0].from, point);
}

TEST(Cracks, GrowWithTheDamage) {
    const Vec2 point{0, -0.4f};
    Real small = 0;
    Real large = 0;
    for (std::uint32_t seed = 0; seed < 50; ++seed) { // on average: each crack bends at random
        small += lengthOf(growCracks(blockOutline(), point, 0.2f, seed));
        large += lengthOf(growCracks(blockOutline(), point, 0.9f, seed));
    }
    EXPECT_GT(large, 1.5f * small);
}

TEST(Cracks, AreKeptForEachBlockUntilItBreaks) {
    kodo::World world;
    const kodo::BodyId block =
        world.add({.shape = kodo::Box{1.6f, 0.8f}, .position = {3, 9}, .flags = kodo::kLocked});
    Cracks cracks;
    EXPECT_TRUE(cracks.of(block).empty());
    cracks.add(world[block], {3, 8.6f}, 0.3f);
    const std::size_t first = cracks.of(block).size();
    EXPECT_GT(first, 0u);
    cracks.add(world[block], {3.5f, 8.6f}, 0.6f);
    EXPECT_GT(cracks.of(block).size(), first);
    cracks.forget(block);
    EXPECT_TRUE(cracks.of(block).empty());
}

} // namespace
} // namespace apart
