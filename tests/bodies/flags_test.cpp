// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

struct Row {
    std::uint16_t required;
    Flags present;
    bool any;
    bool all;
    bool equal;
};

// R9: every relation of two sets of flags. "Any" and "all" of no flags fail.
constexpr Row kTable[] = {
    {0b0000, 0b0000, false, false, true},  // both empty
    {0b0000, 0b0001, false, false, false}, // nothing required
    {0b0001, 0b0000, false, false, false}, // nothing present
    {0b0001, 0b0010, false, false, false}, // disjoint
    {0b0011, 0b0110, true, false, false},  // overlapping
    {0b0011, 0b0111, true, true, false},   // required within present
    {0b0111, 0b0011, true, false, false},  // present within required
    {0b0101, 0b0101, true, true, true},    // equal
    {0xffff, 0xffff, true, true, true},    // equal, all of them
};

TEST(CollisionFilter, FollowsTheTruthTable) {
    for (const Row& row : kTable) {
        SCOPED_TRACE(testing::Message() << row.required << " against " << row.present);
        EXPECT_TRUE(accepts({0, row.required}, row.present));
        EXPECT_EQ(accepts({kMatchAny, row.required}, row.present), row.any);
        EXPECT_EQ(accepts({kMatchAll, row.required}, row.present), row.all);
        EXPECT_EQ(accepts({kMatchEqual, row.required}, row.present), row.equal);
    }
}

TEST(CollisionFilter, UsesOnlyUserFlags) {
    for (const Row& row : kTable) {
        const Flags dressed = row.present | kLockMove | kLockRotate | kColliding | kMatchAny;
        EXPECT_EQ(accepts({kMatchAny | kLockMove, row.required}, dressed), row.any);
        EXPECT_EQ(accepts({kMatchEqual | kColliding, row.required}, dressed), row.equal);
    }
}

// R9: both bodies must accept, unlike in the thesis, so their order never matters.
TEST(CollisionFilter, RequiresBothBodiesToAccept) {
    const CollisionFilter ball{0b01 | kMatchAny, 0b10};
    const CollisionFilter block{0b10, 0};
    const CollisionFilter ghost{0b10 | kMatchAny, 0b100};
    EXPECT_TRUE(shouldCollide(ball, block));
    EXPECT_TRUE(shouldCollide(block, ball));
    EXPECT_FALSE(shouldCollide(ball, ghost));
    EXPECT_FALSE(shouldCollide(ghost, ball));
}

TEST(CollisionFilter, IsSymmetricForAllModesAndFlags) {
    constexpr Flags kModes[] = {0, kMatchAny, kMatchAll, kMatchEqual};
    for (const Flags modeA : kModes) {
        for (const Flags modeB : kModes) {
            for (unsigned bits = 0; bits < 4096; ++bits) {
                const CollisionFilter a{modeA | (bits & 7), std::uint16_t(bits >> 3 & 7)};
                const CollisionFilter b{modeB | (bits >> 6 & 7), std::uint16_t(bits >> 9)};
                ASSERT_EQ(shouldCollide(a, b), shouldCollide(b, a));
                ASSERT_EQ(shouldCollide(a, b), accepts(a, b.flags) && accepts(b, a.flags));
            }
        }
    }
}

// R8: the inverse of ENABLED in the thesis.
TEST(CollisionFilter, DisabledCollidesWithNothing) {
    EXPECT_FALSE(shouldCollide({kDisabled, 0}, {}));
    EXPECT_FALSE(shouldCollide({}, {kDisabled, 0}));
    EXPECT_TRUE(shouldCollide({}, {}));
}

TEST(CollisionFilter, EngineFlagsDoNotOverlapUserFlags) {
    constexpr Flags kEngine = kLockMove | kLockRotate | kDisabled | kColliding | kMatchModes;
    EXPECT_EQ(kEngine & kUserFlags, 0u);
}

} // namespace
} // namespace kodo
