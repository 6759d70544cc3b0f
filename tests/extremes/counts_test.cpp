// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <set>

namespace kodo {
namespace {

constexpr std::size_t kSixteenBits = 65536;

// More bodies and contacts than 16 bits can count: 270 rows of 270 balls that touch their
// neighbours. Every pair is found once, under its own ids.
TEST(Counts, BodiesAndContactsMayExceedSixteenBits) {
    constexpr std::size_t kRow = 270;
    constexpr std::size_t kPairs = 2 * kRow * (kRow - 1);
    static_assert(kRow * kRow > kSixteenBits && kPairs > 2 * kSixteenBits);
    World world;
    std::vector<BodyId> ids;
    for (std::size_t i = 0; i < kRow * kRow; ++i) {
        const Vec2 place{static_cast<Real>(i % kRow), static_cast<Real>(i / kRow)};
        ids.push_back(world.add(support::ballDef(place, Real(0.5))));
    }
    world[ids.back()].setVelocity({-1, 0}); // the last ball hits the one before
    world.step(support::kDt);
    ASSERT_EQ(world.collisions().size(), kPairs);
    std::set<std::pair<BodyId, BodyId>> pairs;
    for (const CollisionRecord& record : world.collisions()) {
        const std::uint32_t apart = record.b.index - record.a.index;
        ASSERT_TRUE(apart == 1 || apart == kRow);
        ASSERT_TRUE(pairs.emplace(record.a, record.b).second);
    }
    const CollisionRecord* hit = support::recordOf(world, ids.back(), ids[ids.size() - 2]);
    ASSERT_NE(hit, nullptr);
    EXPECT_GT(hit->maxImpulse, 0);
    EXPECT_LT(world[ids[ids.size() - 2]].velocity().x, 0);
    EXPECT_EQ(world[ids[ids.size() - 2 - kSixteenBits]].velocity(), Vec2{});
}

// The largest heightmap has as many cells as there are part indices, and its last cell has an index
// of its own.
TEST(Counts, TheLargestHeightmapIsSolidToItsLastCell) {
    World world({.gravity = support::kEarth});
    Heightmap map{{-1000, 0}, Real(2000) / kMaxHeights, std::vector<Real>(kMaxHeights, 0)};
    map.heights.back() = map.heights[kMaxHeights - 2];
    const BodyId ground = world.add({.shape = map, .type = BodyType::Static});
    const Real last = -1000 + map.spacing * (static_cast<Real>(kMaxHeights) - Real(1.5));
    const BodyId ball = world.add(support::ballDef({last, Real(0.1)}, Real(0.01)));
    support::run(world, 15); // it falls for 8 steps
    EXPECT_GT(world[ball].position().y, 0);
    const CollisionRecord* record = support::recordOf(world, ground, ball);
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->partA, kMaxHeights - 2);
    map.heights.push_back(0);
    EXPECT_THROW(world.add({.shape = map, .type = BodyType::Static}), BadDefinition);
}

// One part more than 16-bit part indices allow is refused, by add() and by weld().
TEST(Counts, MorePartsThanSixteenBitsAreRefused) {
    World world;
    Compound compound{std::vector<Primitive>(kMaxParts + 1, Circle{Real(0.1)})};
    const auto problem = check(BodyDef{.shape = compound});
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(problem->field, "shape.parts");
    EXPECT_THROW(world.add({.shape = compound}), BadDefinition);
    compound.parts.pop_back();
    const BodyId full = world.add({.shape = compound});
    const BodyId one = world.add(support::ballDef({3, 0}, Real(0.1)));
    const std::uint64_t before = world.stateHash();
    EXPECT_THROW(world.weld(full, one), BadDefinition);
    EXPECT_THROW(world.weld(one, full), BadDefinition);
    EXPECT_THROW(world.weld(full, Circle{1}, {}, 1), BadDefinition);
    EXPECT_EQ(world.stateHash(), before);
    EXPECT_EQ(world[full].partCount(), kMaxParts);
    EXPECT_NO_THROW(world.unweld(full, 65534));
    EXPECT_NO_THROW(world.weld(full, one));
}

// R1: after more than 2^16 reuses of a slot, a stale id is still invalid.
TEST(Counts, ABodyIdNeverAliasesAfter16BitsOfReuses) {
    World world;
    const BodyId first = world.add(support::ballDef({}, 1));
    BodyId last = first;
    for (std::size_t life = 0; life <= kSixteenBits; ++life) {
        world.remove(last);
        last = world.add(support::ballDef({}, 1));
        ASSERT_EQ(last.index, first.index);
        ASSERT_FALSE(world.contains(first));
    }
    EXPECT_THROW(world[first], BadBodyId);
    EXPECT_TRUE(world.contains(last));
}

TEST(Counts, AJointIdNeverAliasesAfter16BitsOfReuses) {
    World world;
    const BodyId a = world.add(support::ballDef({}, 1));
    const BodyId b = world.add(support::ballDef({3, 0}, 1));
    const JointId first = world.add(DistanceJoint{.ends = {a, b}, .limits = Range{0, 9}});
    JointId last = first;
    for (std::size_t life = 0; life <= kSixteenBits; ++life) {
        world.remove(last);
        last = world.add(DistanceJoint{.ends = {a, b}, .limits = Range{0, 9}});
        ASSERT_EQ(last.index, first.index);
        ASSERT_FALSE(world.contains(first));
    }
    EXPECT_THROW(world.joint(first), BadDefinition);
    EXPECT_TRUE(world.contains(last));
}

} // namespace
} // namespace kodo
