// SPDX-License-Identifier: MIT
// Parts that are caught, and blocks that split into balls.
#include <support/near.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

// A5: a part that is caught is welded to the paddle.
TEST(WeldedPart, IsAPartOfThePaddleAndAddsItsMass) {
    Game game = dropped("W");
    ASSERT_EQ(game.parts().size(), 1u);
    const Real partMass = game.world()[game.parts()[0].body].mass();
    const Real before = game.world()[game.paddle()].mass();
    const Real top = game.world()[game.paddle()].bounds().upper.y;

    const auto welded = playUntil<Welded>(game, towards(kCatchX), 240);

    ASSERT_TRUE(welded);
    EXPECT_NE(eventOf<Caught>(game), nullptr);
    const kodo::BodyView paddle = game.world()[game.paddle()];
    EXPECT_EQ(paddle.partCount(), 2u);
    EXPECT_EQ(game.welds().size(), 1u);
    EXPECT_EQ(game.score(), 0) << "nothing scores before the first serve";
    EXPECT_TRUE(near(paddle.mass(), before + partMass, 1e-4));
    EXPECT_EQ(welded->mass, paddle.mass());
    EXPECT_GT(paddle.bounds().upper.y, top + Real(0.3));
    EXPECT_EQ(game.parts().size(), 0u);
}

TEST(WeldedPart, MovesWithThePaddleAndBouncesTheBall) {
    Game game = dropped("W");
    ASSERT_TRUE(playUntil<Welded>(game, towards(kCatchX), 240));
    const Vec2 center = game.world()[game.paddle()].center();
    for (int tick = 0; tick < 60; ++tick) {
        game.tick(towards(kCatchX + 3));
    }
    EXPECT_TRUE(near(game.world()[game.paddle()].center(), center + Vec2{3, 0}, 0.01));
    const Real top = game.world()[game.paddle()].bounds().upper.y;
    GameTestAccess::shoot(game, {3, top + 2}, {0, -12});
    const auto struck = playUntil<Struck>(game, towards(kCatchX + 3), 60);
    ASSERT_TRUE(struck);
    EXPECT_EQ(struck->what, Role::Paddle);
    EXPECT_GT(length(game.world()[game.balls()[0].body].velocity()), 11); // lossless like the dome
}

TEST(WeldedPart, ComesOffWhenImpactsHaveUsedUpItsWeldStrength) {
    Game game = dropped("W");
    ASSERT_TRUE(playUntil<Welded>(game, towards(kCatchX), 240));
    const Real heavy = game.world()[game.paddle()].mass();
    const Real top = game.world()[game.paddle()].bounds().upper.y;
    const auto impact = [&] {
        GameTestAccess::shoot(game, {0, top + 1}, {0, -12});
        return playUntil<Struck>(game, towards(kCatchX), 60);
    };
    ASSERT_TRUE(impact());
    EXPECT_TRUE(near(game.welds()[0].strengthLeft, kWeldStrength - 24, 3)); // about 2 m v
    GameTestAccess::welds(game)[0].strengthLeft = 1;
    ASSERT_TRUE(impact());
    const KnockedOff* off = eventOf<KnockedOff>(game);
    ASSERT_NE(off, nullptr);
    EXPECT_EQ(off->parts, 0);
    EXPECT_EQ(game.welds().size(), 0u);
    EXPECT_EQ(game.world()[game.paddle()].partCount(), 1u);
    const Real lost = game.world()[off->shard].mass();
    EXPECT_TRUE(near(game.world()[game.paddle()].mass(), heavy - lost, 1e-4));
}

// A5: a part that is caught sticks, and fires after a second.
TEST(LaunchPart, SticksForExactlyOneSecondAndThenFlies) {
    Game game = dropped("L");
    ASSERT_TRUE(playUntil<Stuck>(game, towards(kCatchX), 240));
    const std::uint32_t stuck = game.ticks();
    const kodo::BodyId part = game.parts()[0].body;
    const Vec2 offset = game.world()[part].position() - game.world()[game.paddle()].position();
    for (int tick = 0; tick < 119; ++tick) {
        game.tick(towards(2)); // moves with the paddle
        EXPECT_EQ(eventOf<Launched>(game), nullptr);
        const Vec2 now = game.world()[part].position() - game.world()[game.paddle()].position();
        EXPECT_TRUE(near(now, offset, 1e-3));
    }
    game.tick(towards(2));
    EXPECT_NE(eventOf<Launched>(game), nullptr);
    EXPECT_EQ(game.ticks() - stuck, kStickTicks);
    EXPECT_TRUE(near(game.world()[part].velocity(), Vec2{0, kLaunchSpeed}, 1e-3));
}

TEST(LaunchPart, DestroysTheBlocksAboveAndLeavesTheField) {
    Game game = dropped("L");
    const std::int32_t before = game.blocksLeft();
    ASSERT_TRUE(playUntil<Launched>(game, towards(kCatchX), 500));
    const Real x = game.world()[game.parts()[0].body].center().x;
    const auto spent = playUntil<Spent>(game, towards(kCatchX), 300);
    ASSERT_TRUE(spent);
    EXPECT_FALSE(spent->onSteel);
    EXPECT_GT(spent->point.y, kFieldHeight);
    EXPECT_TRUE(near(spent->point.x, x, 0.1)); // straight up
    EXPECT_LE(game.blocksLeft(), before - 2);  // glass and brick
    EXPECT_GE(game.blocksLeft(), before - 4);  // only blocks above it
}

TEST(LaunchPart, FallsOffWhenTheLifeIsLost) {
    Game game = dropped("L");
    ASSERT_TRUE(playUntil<Stuck>(game, towards(kCatchX), 240));
    GameTestAccess::shoot(game, {8, 1}, {0, -12});
    ASSERT_TRUE(playUntil<LifeLost>(game, towards(kCatchX), 60));
    ASSERT_EQ(game.parts().size(), 1u);
    EXPECT_EQ(game.parts()[0].state, PartState::Loose);
}

// A6: a block becomes further balls.
TEST(SplitBlock, BecomesSeveralBalls) {
    Game game = dropped("S");
    EXPECT_EQ(game.balls().size(), 1u + kSplitBalls);
    Input launch = towards(kCatchX);
    launch.launch = true;
    game.tick(launch);
    for (int tick = 0; tick < 40; ++tick) {
        game.tick(towards(kCatchX));
    }
    for (const Ball& ball : game.balls()) {
        const Real speed = length(game.world()[ball.body].velocity());
        EXPECT_TRUE(near(speed, game.state().ballSpeed(), game.state().ballSpeed() / 20));
    }
}

// The ball of the serve and those of four blocks would be nine.
TEST(SplitBlock, BecomesShardsWhereThereAreTheMostBalls) {
    constexpr std::size_t kBlocks = 4;
    static_assert(1 + kBlocks * kSplitBalls == kMostBalls + 1);
    Game game(levelOf(".SSSS..........\n"), 1);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        GameTestAccess::breakBlock(game, 0, {0, 24});
    }
    EXPECT_EQ(game.balls().size(), kMostBalls);
    EXPECT_EQ(game.shards().size(), 1u);
}

TEST(SplitBlock, LosesNoLifeWhileABallIsLeft) {
    Game game = dropped("S");
    const std::size_t balls = game.balls().size();
    GameTestAccess::world(game)[game.balls()[1].body].setPosition({8, -2});
    game.tick(towards(kCatchX));
    ASSERT_NE(eventOf<BallLost>(game), nullptr);
    EXPECT_EQ(eventOf<BallLost>(game)->ballsLeft, static_cast<int>(balls) - 1);
    EXPECT_EQ(game.lives(), 3);
}

} // namespace
