// SPDX-License-Identifier: MIT
// A boss is one body whose blocks break off.
#include <support/near.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

// Two arms and a core. One block below the left arm is attached to that arm only.
const std::string kGrid = "g..............\n" + emptyRows(3) + ".....aacaa.....\n.....a.........\n";

Game withBoss(const std::string& drift = "") {
    return Game(levelOf(kGrid, 12000, drift,
                        "[legend.a]\nstuff = \"brick\"\nhold = \"boss\"\n"
                        "[legend.c]\nstuff = \"stone\"\nhold = \"boss\"\ncore = true\n"),
                1);
}

std::size_t indexOf(const Game& game, int row, int column) {
    for (std::size_t i = 0; i < game.blocks().size(); ++i) {
        if (game.blocks()[i].key == static_cast<std::uint32_t>(row * kColumns + column)) {
            return i;
        }
    }
    throw std::runtime_error("no such block");
}

Vec2 placeOf(const Game& game, const Block& block) {
    const kodo::BodyView body = game.world()[block.body];
    return body.position() + body.rotation() * block.local;
}

/// Shoots a ball from below at the middle of a block.
void shootAt(Game& game, int row, int column, Real speed) {
    const Vec2 place = placeOf(game, game.blocks()[indexOf(game, row, column)]);
    GameTestAccess::shoot(game, place - Vec2{0, kCellHeight / 2 + kBallRadius + Real(0.2)},
                          {0, speed});
}

int countBoss(const Game& game) {
    int count = 0;
    for (const Block& block : game.blocks()) {
        count += block.support == Support::Boss ? 1 : 0;
    }
    return count;
}

TEST(Boss, IsOneBodyWithAllItsBlocksAtTheirGridPositions) {
    const Game game = withBoss();
    ASSERT_TRUE(game.boss());
    EXPECT_EQ(game.world()[*game.boss()].partCount(), 6u);
    EXPECT_EQ(countBoss(game), 6);
    for (const Block& block : game.blocks()) {
        const Cell cell{static_cast<std::uint8_t>(block.key / kColumns),
                        static_cast<std::uint8_t>(block.key % kColumns), 0};
        EXPECT_TRUE(near(placeOf(game, block), centerOf(cell), 1e-5));
    }
}

TEST(Boss, DriftsToBothSidesWithinItsLimits) {
    Game game = withBoss("boss = { drift = 2000, speed = 3000 }\n");
    Real left = 0;
    Real right = 0;
    const Real home = game.world()[*game.boss()].position().x;
    for (int tick = 0; tick < 480; ++tick) {
        game.tick({});
        const Real x = game.world()[*game.boss()].position().x - home;
        left = std::min(left, x);
        right = std::max(right, x);
    }
    EXPECT_TRUE(near(left, -2, 0.03)); // reverses at the first tick beyond; 25 mm per tick
    EXPECT_TRUE(near(right, 2, 0.03));
}

TEST(Boss, LosesABlockBrokenOffByAnImpact) {
    Game game = withBoss();
    shootAt(game, 4, 9, 12);
    const auto off = playUntil<LetGo>(game, {}, 30);
    ASSERT_TRUE(off);
    EXPECT_EQ(off->why, LetGo::Why::BrokeOff);
    EXPECT_EQ(countBoss(game), 5);
    EXPECT_EQ(game.world()[*game.boss()].partCount(), 5u);
    const Block& block = game.blocks()[indexOf(game, 4, 9)];
    EXPECT_EQ(block.support, Support::Loose);
    EXPECT_EQ(block.part, 0u);
    EXPECT_GT(game.world()[block.body].velocity().y, 0); // the impulse beyond the strength of its
                                                         // mount
    EXPECT_EQ(game.blocksLeft(), 7);                     // counts until it is gone
    for (const Block& other : game.blocks()) {
        EXPECT_EQ(game.state().findBlock(other.body, other.part),
                  &other); // part indices were renumbered
    }
}

TEST(Boss, ReleasesBlocksNotConnectedToACore) {
    Game game = withBoss();
    shootAt(game, 4, 6, 12); // the left arm's inner block supports two more
    ASSERT_TRUE(playUntil<LetGo>(game, {}, 30));
    EXPECT_EQ(countBoss(game), 3); // core and right arm
    EXPECT_EQ(game.blocks()[indexOf(game, 5, 5)].support, Support::Loose);
    EXPECT_EQ(game.blocks()[indexOf(game, 4, 5)].support, Support::Loose);
    EXPECT_EQ(eventOf<BossDown>(game), nullptr);
}

TEST(Boss, FallsApartWithItsLastCore) {
    Game game = withBoss();
    shootAt(game, 4, 7, 20); // 40 N s against a strength of 30
    ASSERT_TRUE(playUntil<BossDown>(game, {}, 30));
    EXPECT_NE(eventOf<Broke>(game), nullptr);
    EXPECT_FALSE(game.boss());
    EXPECT_EQ(countBoss(game), 0);
    EXPECT_GT(game.shards().size(), 1u);
}

// Regression: a boss whose core was its last block ended without a BossDown event.
TEST(Boss, IsDownWhenItsLastBlockIsACore) {
    const std::string core = "[legend.c]\nstuff = \"stone\"\nhold = \"boss\"\ncore = true\n";
    const Level level =
        levelOf("g..............\n" + emptyRows(3) + ".......c.......\n", 12000, "", core);
    Game broken(level, 1);
    const Vec2 place = placeOf(broken, broken.blocks()[indexOf(broken, 4, 7)]);
    shootAt(broken, 4, 7, 20);
    const auto down = playUntil<BossDown>(broken, {}, 30);
    ASSERT_TRUE(down);
    EXPECT_NE(eventOf<Broke>(broken), nullptr);
    EXPECT_TRUE(near(down->point, place, 1e-5));

    Game fallen(level, 1);
    GameTestAccess::shoot(fallen, {-9, 9}, {12, 0});
    for (std::uint32_t tick = 0; tick < kFailTicks / kLastHurry; ++tick) {
        ASSERT_EQ(eventOf<BossDown>(fallen), nullptr);
        GameTestAccess::idle(fallen);
    }
    EXPECT_NE(eventOf<BossDown>(fallen), nullptr);
    EXPECT_FALSE(fallen.boss());
}

TEST(Boss, IsClearedWhenAllItsBlocksHaveFallen) {
    Game game = withBoss();
    shootAt(game, 4, 7, 20);
    ASSERT_TRUE(playUntil<BossDown>(game, {}, 30));
    for (int tick = 0; tick < 600; ++tick) {
        GameTestAccess::shoot(game, {-9, 9}, {12, 0}); // away from the blocks
        game.tick(towards(-9));
    }
    EXPECT_EQ(game.blocksLeft(), 1); // the glass
    EXPECT_EQ(game.blocks().size(), 1u);
}

TEST(Boss, ConservesMassAndMomentumOfADetachedBlock) {
    Game game = withBoss("boss = { drift = 2000, speed = 3000 }\n");
    for (int tick = 0; tick < 10; ++tick) {
        game.tick({});
    }
    const Real before = game.world()[*game.boss()].mass();
    const std::size_t index = indexOf(game, 5, 5);
    GameTestAccess::letGo(game, index);
    const kodo::BodyView off = game.world()[game.blocks()[index].body];
    EXPECT_TRUE(near(game.world()[*game.boss()].mass() + off.mass(), before, Real(1e-5) * before));
    EXPECT_TRUE(near(off.velocity(), Vec2{3, 0}, 1e-4)); // keeps the velocity of the boss
}

} // namespace
