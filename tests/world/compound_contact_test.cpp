// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/random_shapes.hpp>
#include <support/scenes.hpp>

#include <set>

namespace kodo {
namespace {

using Parts = std::set<std::pair<std::uint16_t, std::uint16_t>>;

Compound compoundOfAFew(support::RandomNumbers& random) {
    Compound compound;
    for (std::size_t k = 0; k < 2 + random.below(3); ++k) {
        auto shape = support::randomPrimitive(random, support::kAllKinds[random.below(3)]);
        compound.parts.push_back(moved(shape, {random.point(1.5), random.rotation()}));
    }
    return compound;
}

/// Pairs of parts of two bodies that have a record after one step.
Parts touchingParts(World& world, BodyId one, BodyId other) {
    world.step(support::kDt);
    Parts parts;
    for (const CollisionRecord& record : world.collisions()) {
        EXPECT_TRUE(record.involves(one) && record.involves(other));
        parts.emplace(record.partA, record.partB);
    }
    return parts;
}

// C1, R6: all pairs of parts that the Minkowski oracle finds in overlap have a record. Pairs
// farther apart than the speculative margin have none.
TEST(CompoundContact, ExistsForEachPairOfPartsInOverlap) {
    constexpr std::uint64_t kSeed = 211;
    support::RandomNumbers random(kSeed);
    std::size_t overlaps = 0;
    for (int i = 0; i < support::draws(2000); ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        World world;
        BodyDef def{.shape = compoundOfAFew(random), .rotation = random.rotation()};
        const BodyId a = world.add(def);
        def = {.shape = compoundOfAFew(random),
               .position = random.point(3),
               .rotation = random.rotation()};
        const BodyId b = world.add(def);
        Parts sure;
        Parts possible;
        for (std::size_t p = 0; p < world[a].partCount(); ++p) {
            for (std::size_t q = 0; q < world[b].partCount(); ++q) {
                const long double gap =
                    support::signedDistance(world[a].part(p).convex, world[a].massFrame(),
                                            world[b].part(q).convex, world[b].massFrame());
                const std::pair pair(static_cast<std::uint16_t>(p), static_cast<std::uint16_t>(q));
                if (gap < -1e-4L) {
                    sure.insert(pair);
                }
                if (gap < static_cast<long double>(world.tolerances().margin)) {
                    possible.insert(pair);
                }
            }
        }
        const Parts found = touchingParts(world, a, b);
        ASSERT_TRUE(std::includes(found.begin(), found.end(), sure.begin(), sure.end()));
        ASSERT_TRUE(std::includes(possible.begin(), possible.end(), found.begin(), found.end()));
        overlaps += sure.size();
    }
    EXPECT_GT(overlaps, static_cast<std::size_t>(support::draws(2000)));
}

// C1, F2: each part of a compound touches the same cells of a heightmap as a body of that part
// alone.
TEST(CompoundContact, WithAHeightmapAgreesWithEachPartAlone) {
    constexpr std::uint64_t kSeed = 212;
    support::RandomNumbers random(kSeed);
    std::size_t contacts = 0;
    for (int i = 0; i < support::draws(500); ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", place " << i);
        Heightmap ground{{-8, 0}, Real(0.5), {}};
        for (int k = 0; k < 33; ++k) {
            ground.heights.push_back(random.between(-0.4, 0.4));
        }
        const BodyDef land{.shape = ground, .type = BodyType::Static};
        const Compound compound = compoundOfAFew(random);
        BodyDef def{.shape = compound,
                    .position = {random.between(-2, 2), random.between(0, 2)},
                    .rotation = random.rotation()};
        Parts together;
        {
            World world;
            const BodyId floor = world.add(land);
            together = touchingParts(world, floor, world.add(def));
        }
        Parts alone;
        for (std::size_t p = 0; p < compound.parts.size(); ++p) {
            World world;
            const BodyId floor = world.add(land);
            std::visit([&](const auto& kind) { def.shape = kind; }, compound.parts[p]);
            for (const auto& [cell, part] : touchingParts(world, floor, world.add(def))) {
                alone.emplace(cell, static_cast<std::uint16_t>(p));
            }
        }
        ASSERT_EQ(together, alone);
        contacts += alone.size();
    }
    EXPECT_GT(contacts, static_cast<std::size_t>(support::draws(500)));
}

} // namespace
} // namespace kodo
