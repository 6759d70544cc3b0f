// SPDX-License-Identifier: MIT
#include <kodo/kodo.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

struct Row {
    Flags required;
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
    {0xffff, 0xffff, true, true, true},    // equal, all of the low ones
    {category(47), kUserFlags, true, true, false},
    {category(16) | 1, 1, true, false, false},
    {kUserFlags, kUserFlags, true, true, true}, // equal, all of them
};

TEST(CollisionFilter, FollowsTheTruthTable) {
    for (const Row& row : kTable) {
        SCOPED_TRACE(testing::Message() << row.required << " against " << row.present);
        EXPECT_TRUE(accepts({0, row.required}, row.present));
        EXPECT_EQ(accepts({kMatchAny, row.required}, row.present), row.any);
        EXPECT_EQ(accepts({kMatchNone, row.required}, row.present), !row.any);
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
    constexpr Flags kModes[] = {0, kMatchNone, kMatchAny, kMatchAll, kMatchEqual};
    for (const Flags modeA : kModes) {
        for (const Flags modeB : kModes) {
            for (unsigned bits = 0; bits < 4096; ++bits) {
                const CollisionFilter a{modeA | (bits & 7), bits >> 3 & 7};
                const CollisionFilter b{modeB | (bits >> 6 & 7), bits >> 9};
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

TEST(CollisionFilter, Has48CategoriesByNumber) {
    Flags all = 0;
    for (unsigned number = 0; number < 48; ++number) {
        EXPECT_EQ(all & category(number), 0u) << number;
        all |= category(number);
    }
    EXPECT_EQ(all, kUserFlags);
    EXPECT_THROW(category(48), BadDefinition); // would be another one's bit
    EXPECT_THROW(category(static_cast<unsigned>(-1)), BadDefinition);
}

// Groups come before the modes, as in Box2D.
TEST(CollisionFilter, GroupsComeBeforeModes) {
    for (const std::int32_t group : {1, 2147483647}) {
        const CollisionFilter deaf{kMatchAny, 2, group}; // has no category, and wants one
        EXPECT_TRUE(shouldCollide(deaf, deaf));
        EXPECT_FALSE(shouldCollide(deaf, {kMatchAny, 2, group - 1}));
        EXPECT_FALSE(shouldCollide(deaf, {kMatchAny, 2, -group}));
        EXPECT_FALSE(shouldCollide({0, 0, -group}, {0, 0, -group}));
        EXPECT_TRUE(shouldCollide({0, 0, -group}, {0, 0, group}));
        EXPECT_TRUE(shouldCollide({0, 0, -group}, {}));
        EXPECT_FALSE(shouldCollide({kDisabled, 0, group}, {0, 0, group}));
    }
}

/// A floor without a filter, and a ball on its way to it.
struct Fall {
    explicit Fall(CollisionFilter filter, std::int32_t floorGroup = 0) {
        world.add({.shape = Box{10, 1},
                   .position = {0, Real(-0.5)},
                   .type = BodyType::Static,
                   .group = floorGroup});
        ball = world.add({.position = {0, 1},
                          .flags = filter.flags,
                          .required = filter.required,
                          .group = filter.group});
    }
    bool lands() {
        for (int i = 0; i < 90; ++i) {
            world.step(Real(1) / 60);
        }
        return world[ball].position().y > 0;
    }
    World world{{.gravity = {0, -10}}};
    BodyId ball;
};

TEST(CollisionFilter, AFloorWithoutACategoryHoldsWhatNamesExceptions) {
    EXPECT_TRUE(Fall({kMatchNone, 1}).lands());
    EXPECT_FALSE(Fall({kMatchAny, kUserFlags}).lands());
    EXPECT_TRUE(Fall({kMatchAny, 1, 7}, 7).lands());
    EXPECT_FALSE(Fall({0, 0, -7}, -7).lands());
    EXPECT_TRUE(Fall({0, 0, -7}, -8).lands());
}

// Of a floor that names no category.
TEST(CollisionFilter, TheDefaultCategoryIsThatOfBodiesWithoutOne) {
    EXPECT_TRUE(Fall({kMatchAny, 2 | kDefaultCategory}).lands());
    EXPECT_TRUE(Fall({kMatchAll, kDefaultCategory}).lands());
    EXPECT_TRUE(Fall({kMatchEqual, kDefaultCategory}).lands());
    EXPECT_TRUE(Fall({kMatchEqual, 0}).lands());
    EXPECT_FALSE(Fall({kMatchNone, kDefaultCategory}).lands());
    for (const Flags mode : {kMatchAny, kMatchAll, kMatchEqual}) { // the floor has category 2
        Fall fall({mode, kDefaultCategory});
        fall.world[fall.world.bodies().front()].setFlags(2);
        EXPECT_FALSE(fall.lands());
    }
    World world;
    const BodyId plain = world.add({});
    const BodyId named = world.add({.position = {9, 0}, .flags = category(20)});
    EXPECT_EQ(overlap(world, Aabb{{-1, -1}, {20, 1}}, {kMatchAny, kDefaultCategory}),
              std::vector<BodyId>{plain});
    world.applyForceToAll({6, 0}, {kMatchNone, kDefaultCategory});
    world.step(Real(1) / 60);
    EXPECT_EQ(world[plain].velocity(), Vec2{});
    EXPECT_GT(world[named].velocity().x, 0);
    EXPECT_THROW(world[plain].setFlags(kDefaultCategory), BadDefinition);
    EXPECT_THROW(world.add({.flags = kDefaultCategory}), BadDefinition);
}

TEST(CollisionFilter, SettersStartAndEndContacts) {
    Fall fall({}, -3);
    ASSERT_TRUE(fall.lands());
    fall.world[fall.ball].setGroup(-3);
    EXPECT_FALSE(fall.lands());
    fall.world[fall.ball].setPosition({0, 1});
    fall.world[fall.ball].setVelocity({});
    fall.world[fall.ball].setGroup(0);
    EXPECT_TRUE(fall.lands());
    EXPECT_THROW(fall.world[fall.ball].setRequired(kSensor), BadDefinition);
}

TEST(CollisionFilter, IsStateInAllItsBits) {
    const CollisionFilter filters[] = {{kMatchNone | category(47), category(40), -9},
                                       {kMatchNone | category(46), category(40), -9},
                                       {kMatchNone | category(47), category(41), -9},
                                       {kMatchNone | category(47), category(40), 9},
                                       {kMatchNone, 0, 0}};
    std::vector<std::uint64_t> hashes;
    for (const CollisionFilter& filter : filters) {
        Fall fall(filter);
        World restored = fromBytes(toBytes(fall.world));
        const BodyView body = restored[fall.ball];
        EXPECT_EQ(body.flags(), filter.flags);
        EXPECT_EQ(body.required(), filter.required);
        EXPECT_EQ(body.group(), filter.group);
        const BodyId clone = restored.clone(fall.ball, {3, 3});
        EXPECT_EQ(restored[clone].group(), filter.group);
        hashes.push_back(restored.stateHash());
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes.back()), 1);
    }
}

TEST(CollisionFilter, QueriesTakeGroups) {
    Fall fall({kMatchNone, category(20), 5});
    EXPECT_EQ(overlap(fall.world, Aabb{{-20, -20}, {20, 20}}).size(), 2u);
    EXPECT_EQ(overlap(fall.world, Aabb{{-20, -20}, {20, 20}}, {0, 0, -5}).size(), 2u);
    fall.world[fall.ball].setGroup(-5);
    EXPECT_EQ(overlap(fall.world, Aabb{{-20, -20}, {20, 20}}, {0, 0, -5}).size(), 1u);
    fall.world[fall.ball].setGroup(5);
    const std::vector<BodyId> own =
        overlap(fall.world, Aabb{{-20, -20}, {20, 20}}, {kMatchAny, category(20), 5});
    EXPECT_EQ(own, std::vector{fall.ball});
    fall.world.applyForceToAll({1, 0}, {kMatchAny, category(20), 5});
    fall.world.step(Real(1) / 60);
    EXPECT_GT(fall.world[fall.ball].velocity().x, 0);
}

} // namespace
} // namespace kodo
