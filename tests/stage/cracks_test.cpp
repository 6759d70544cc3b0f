// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/effects/cracks.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

kodo::ConvexShape blockOutline() {
    return kodo::convexShapeOf(kodo::Box{1.6f, 0.8f}, {});
}

Real lengthOf(const std::vector<CrackLine>& lines) {
    Real sum = 0;
    for (const CrackLine& line : lines) {
        sum += length(line.to - line.from);
    }
    return sum;
}

TEST(Cracks, StayInsideTheBlockForAnyPointOfImpact) {
    const kodo::ConvexShape outline = blockOutline();
    Dice dice(7);
    for (std::uint32_t trial = 0; trial < 500; ++trial) {
        const Vec2 point{dice.between(-0.85f, 0.85f), dice.between(-0.45f, 0.45f)};
        for (const CrackLine& line : growCracks(outline, point, dice.between(0, 1), trial)) {
            // 1e-4 m: rounding of points on the edge
            EXPECT_LE(std::abs(line.to.x), 0.8f + 1e-4f) << trial;
            EXPECT_LE(std::abs(line.to.y), 0.4f + 1e-4f) << trial;
        }
    }
}

TEST(Cracks, BeginAtThePointOfTheImpact) {
    const Vec2 point{0.3f, -0.4f};
    const std::vector<CrackLine> lines = growCracks(blockOutline(), point, 0.5f, 1);
    ASSERT_FALSE(lines.empty());
    EXPECT_LT(length(lines[0].from - point), 1e-6f); // the centre of the shape is rounded
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
    Cracks cracks;
    EXPECT_TRUE(cracks.of(7).empty());
    cracks.add(7, blockOutline(), {0, -0.4f}, 0.3f);
    const std::size_t first = cracks.of(7).size();
    EXPECT_GT(first, 0u);
    EXPECT_TRUE(cracks.of(8).empty());
    cracks.add(7, blockOutline(), {0.5f, -0.4f}, 0.6f);
    EXPECT_GT(cracks.of(7).size(), first);
    cracks.forget(7);
    EXPECT_TRUE(cracks.of(7).empty());
}

// Blocks of a boss lie anywhere in the frame of its body. A block keeps its cracks when it comes
// off.
TEST(Cracks, AreRelativeToTheCentreOfTheirBlock) {
    const kodo::ConvexShape aside = kodo::convexShapeOf(kodo::Box{1.6f, 0.8f}, {-5, 3});
    ASSERT_EQ(aside.middle, (Vec2{5, -3}));
    const auto there = growCracks(aside, aside.middle + Vec2{0.3f, -0.4f}, 0.5f, 1);
    const auto here = growCracks(blockOutline(), {0.3f, -0.4f}, 0.5f, 1);
    ASSERT_EQ(there.size(), here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_LT(length(there[i].to - here[i].to), 1e-4f); // rounding of positions of a few metres
    }
}

} // namespace
} // namespace apart
