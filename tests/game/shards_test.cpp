// SPDX-License-Identifier: MIT
// Shards are bodies: they break, break blocks, and conserve mass and momentum.
#include <apart/core/bot.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

/// Sums over all shards, about the origin.
struct ShardSums {
    Real mass = 0;
    Vec2 momentum;
    Real moment = 0;
    Real energy = 0;
};

ShardSums sumsOf(const Game& game) {
    ShardSums sums;
    for (const Shard& shard : game.shards()) {
        const kodo::BodyView body = game.world()[shard.body];
        sums.mass += body.mass();
        sums.momentum += body.mass() * body.velocity();
        sums.moment += body.mass() * cross(body.center(), body.velocity()) +
                       body.inertia() * body.angularVelocity();
        sums.energy += (body.mass() * lengthSquared(body.velocity()) +
                        body.inertia() * body.angularVelocity() * body.angularVelocity()) /
                       2;
    }
    return sums;
}

TEST(ShardBreak, ConservesMassMomentumAngularMomentumAndEnergy) {
    constexpr std::uint64_t kShardSeed = 41;
    support::RandomNumbers random(kShardSeed);
    int breaks = 0;
    for (int trial = 0; trial < 300 && !HasFailure(); ++trial) {
        SCOPED_TRACE("seed 41, trial " + std::to_string(trial));
        const std::string stuff(1, "gwbs"[trial % 4]);
        Game game(levelOf("g..............\n" + emptyRows(4) + "......." + stuff + ".......\n"),
                  static_cast<std::uint32_t>(trial));
        GameTestAccess::breakBlock(game, 1, {0, 24});
        for (const Shard& shard : game.shards()) {
            kodo::BodyRef body = GameTestAccess::world(game)[shard.body];
            body.setVelocity(random.point(6));
            body.setAngularVelocity(random.between(-5, 5));
        }
        for (int again = 0; again < 6; ++again) {
            const ShardSums before = sumsOf(game);
            const auto index = random.below(static_cast<std::uint32_t>(game.shards().size()));
            const kodo::BodyId body = game.shards()[index].body;
            GameTestAccess::breakShard(game, index, game.world()[body].center() + random.point(1));
            breaks += game.world().contains(body) ? 0 : 1;
            const ShardSums after = sumsOf(game);
            // A few dozen floats; the angular momentum has lever arms of up to 15 m. Each merged
            // corner costs up to 1e-5 of a piece.
            EXPECT_TRUE(near(after.mass, before.mass, Real(4e-5) * before.mass));
            EXPECT_TRUE(near(after.momentum, before.momentum, 3e-4));
            EXPECT_TRUE(near(after.moment, before.moment, 4e-3));
            EXPECT_TRUE(near(after.energy, before.energy, Real(1e-4) * before.energy));
        }
    }
    EXPECT_GT(breaks, 500);
}

TEST(ShardBreak, EndsAtTheSizeFloor) {
    Game game(levelOf("g..............\n" + emptyRows(4) + ".......b.......\n"), 1);
    GameTestAccess::breakBlock(game, 1, {0, 24});
    for (int round = 0; round < 8; ++round) {
        for (std::size_t i = game.shards().size(); i-- > 0;) {
            const Vec2 center = game.world()[game.shards()[i].body].center();
            GameTestAccess::breakShard(game, i, center);
        }
    }
    const std::size_t count = game.shards().size();
    EXPECT_GT(count, 12u);
    EXPECT_LT(count, 25u); // at least a share of 0.04 each
    for (const Shard& shard : game.shards()) {
        const kodo::BodyView body = game.world()[shard.body];
        EXPECT_GE(body.area(), shardLimits().area * Real(0.999));
        const auto& polygon = std::get<kodo::Polygon>(body.part(0).primitive);
        EXPECT_GE(widthOf(polygon), shardLimits().width * Real(0.999));
    }
}

TEST(ShardBreak, HappensIfTheImpulseExceedsTheStrength) {
    Game game(levelOf("g..............\n" + emptyRows(4) + ".......b.......\n", 20000), 1);
    GameTestAccess::breakBlock(game, 1, {0, 0});
    GameTestAccess::shoot(game, {0, 11}, {0, 20});
    const auto broke = playUntil<ShardBroke>(game, {}, 60);
    ASSERT_TRUE(broke);
    EXPECT_GE(broke->pieces, 2);
    EXPECT_GT(broke->impulse, kSlightestImpact);
    EXPECT_FALSE(game.world().contains(broke->shard));
}

TEST(ChainReaction, AShardThatHitsABlockHardEnoughBreaksIt) {
    // Stone falls 8 m onto glass with a strength of 1 N s.
    Game game(levelWith("g..............\n.......s.......\n" + emptyRows(9) + "......fff......\n",
                        "f", "stuff = \"glass\"\nstrength = 1000"),
              1);
    GameTestAccess::breakBlock(game, 1, {0, 0});
    int broken = 0;
    for (int tick = 0; tick < 240; ++tick) {
        game.tick({}); // the ball rides: all damage is caused by shards
        broken += eventOf<Broke>(game) != nullptr ? 1 : 0;
    }
    EXPECT_GE(broken, 1);
    EXPECT_LT(game.blocksLeft(), 4);
}

TEST(Shards, AreCappedByRemovingOldAndSmallOnesFirst) {
    Game game(levelOf("ggggggggggggggg\nggggggggggggggg\nggggggggggggggg\n"), 1);
    GameTestAccess::breakBlock(game, 0, {0, 0});
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    Real mass = sumsOf(game).mass;
    const double removed = game.ledger().removedMass;
    const auto more = [&] {
        const std::size_t before = game.shards().size();
        GameTestAccess::breakBlock(game, game.blocks().size() - 1, {0, 0}); // far from the first
        for (std::size_t i = before; i < game.shards().size(); ++i) {
            mass += game.world()[game.shards()[i].body].mass();
        }
    };
    while (game.shards().size() <= kMostShards) {
        more();
    }
    const std::vector<Shard> before(game.shards().begin(), game.shards().end());
    std::vector<Real> worth; // mass times remaining lifetime
    for (const Shard& shard : before) {
        const std::uint32_t age = game.ticks() + 1 - shard.bornTick;
        worth.push_back(game.world()[shard.body].mass() * static_cast<Real>(kShardTicks - age));
    }
    game.tick({});
    EXPECT_EQ(game.shards().size(), kMostShards);
    Real mostOfGone = 0;
    Real leastOfKept = worth[0];
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (game.world().contains(before[i].body)) {
            leastOfKept = std::min(leastOfKept, worth[i]);
        } else {
            mostOfGone = std::max(mostOfGone, worth[i]);
        }
    }
    EXPECT_GT(mostOfGone, 0);
    EXPECT_LE(mostOfGone, leastOfKept);
    // Removed mass is booked: sums of 160 floats.
    EXPECT_NEAR(static_cast<double>(sumsOf(game).mass) + game.ledger().removedMass - removed,
                static_cast<double>(mass), 1e-3);
}

} // namespace
