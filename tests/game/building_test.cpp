// SPDX-License-Identifier: MIT
// Buildings: blocks that stand, fall, and count.
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/lint.hpp>

#include <game/game_access.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

constexpr int kMinute = 60 * kTicksPerSecond;

/// Two columns of squares on a ledge at y = 8 m, with `more` tables.
Level columns(const std::string& more = "", const std::string& stuff = "brick") {
    return levelFrom(R"(format = 1
title = "t"
idea = "i"
[legend.b]
stuff = ")" + stuff + R"("
hold = "standing"
[legend.x]
stuff = "steel"
hold = "moving"
[legend.g]
stuff = "glass"
[[ledge]]
x = 0
y = 7800
width = 10000
[[block]]
kind = "b"
name = "column"
shape = "square"
x = 4000
y = 8400
rows = 3
row-step = [0, 800]
mirror = true
)" + more);
}

std::size_t fallen(const Game& game) {
    return static_cast<std::size_t>(
        std::count_if(game.blocks().begin(), game.blocks().end(),
                      [](const Block& block) { return block.support == Support::Fallen; }));
}

/// Throws a block with this velocity (m/s).
void toss(Game& game, std::size_t index, Vec2 velocity) {
    GameTestAccess::world(game)[game.blocks()[index].body].setVelocity(velocity);
}

TEST(Building, ABlockOffItsPlaceIsClearedAtOnceAndIsRubble) {
    Game game(columns(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    toss(game, 2, {6, 2});
    const auto let = playUntil<LetGo>(game, {}, 60);
    ASSERT_TRUE(let);
    EXPECT_EQ(let->why, LetGo::Why::Toppled);
    EXPECT_EQ(game.blocksLeft(), 5);
    EXPECT_EQ(game.score(), 0) << "it has not landed";
    EXPECT_EQ(fallen(game), 1u);
    playOn(game, static_cast<int>(kFallenTicks + kRubbleTicks) + 2);
    EXPECT_EQ(fallen(game), 0u); // it crumbled
    EXPECT_TRUE(game.shards().empty());
    EXPECT_EQ(game.blocksLeft(), 5); // and counted once
    EXPECT_EQ(game.score(), 100);
}

TEST(Building, TheFirstLandingOfAFallenBlockScoresItsPoints) {
    Game game(columns(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    toss(game, 2, {-4, 2}); // from the column onto the ledge
    ASSERT_TRUE(playUntil<LetGo>(game, {}, 60));
    EXPECT_EQ(game.score(), 0);
    const auto landed = playUntil<Landed>(game, {}, 120);
    ASSERT_TRUE(landed);
    EXPECT_EQ(landed->points, 100);
    EXPECT_LT(landed->point.y, 9) << "on the ledge";
    EXPECT_EQ(game.score(), 100);
    EXPECT_FALSE(playUntil<Landed>(game, {}, static_cast<int>(kFallenTicks))) << "once";
}

TEST(Building, NothingScoresBeforeTheFirstServe) {
    Game game(columns(), 1);
    playOn(game, 60);
    toss(game, 2, {6, 2});
    ASSERT_TRUE(playUntil<LetGo>(game, {}, 60));
    playOn(game, static_cast<int>(kFallenTicks) + 60);
    EXPECT_EQ(game.score(), 0);
    EXPECT_EQ(game.blocksLeft(), 5);
}

/// A brick on a sled of steel, on a ledge.
const char* const kSled = R"([[block]]
kind = "x"
x = 0
y = 8400
width = 2000
height = 800
[[block]]
kind = "b"
shape = "square"
x = 0
y = 9200
)";

/// Moves a block by so much (m).
void shift(Game& game, std::size_t index, Vec2 way) {
    kodo::BodyRef body = GameTestAccess::world(game)[game.blocks()[index].body];
    body.setPosition(body.position() + way);
}

TEST(Building, ABlockThatIsCarriedAwayUprightHasNotFallen) {
    Game game(columns(kSled), 1);
    playOn(game, 60);
    shift(game, 6, {Real(1.8), 0});
    shift(game, 7, {Real(1.8), 0});
    playOn(game, 60);
    EXPECT_EQ(fallen(game), 0u);
    shift(game, 7, {Real(-3), 0}); // off the sled
    playOn(game, 60);
    EXPECT_EQ(fallen(game), 1u);
}

TEST(Building, ABlockFallsOnceWhatCarriedItHasFallen) {
    Game game(columns(), 1);
    playOn(game, 60);
    for (const std::size_t i : {0u, 1u, 2u}) { // a column as a whole: one carries the next
        shift(game, i, {Real(1.5), 0});
    }
    playOn(game, 60);
    EXPECT_EQ(fallen(game), 3u);
}

/// Two columns, and two bricks between them.
Level columnsAndBricks() {
    return columns("[[block]]\nkind = \"b\"\nshape = \"square\"\nx = 0\ny = 8400\n"
                   "[[block]]\nkind = \"b\"\nshape = \"square\"\nx = 1500\ny = 8400\n");
}

/// Throws the highest block that stands left of -3 m.
void tossTopOfLeftColumn(Game& game) {
    std::size_t top = game.blocks().size();
    for (std::size_t i = 0; i < game.blocks().size(); ++i) {
        const Block& block = game.blocks()[i];
        const bool left = block.counts() && block.home.position.x < -3;
        if (left && (top == game.blocks().size() ||
                     block.home.position.y > game.blocks()[top].home.position.y)) {
            top = i;
        }
    }
    toss(game, top, {-8, 0});
}

TEST(Building, IsDownOnceHalfOfItsHeightIsLeftAndTheRestComesDown) {
    Game game(columnsAndBricks(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    for (const std::size_t i : {0u, 1u, 2u}) {
        toss(game, i, {8, 0});
    }
    playOn(game, 240);
    EXPECT_EQ(game.blocksLeft(), 5);
    EXPECT_FALSE(game.counts().isDown()) << "0.55 of the sum of heights is left";
    tossTopOfLeftColumn(game);
    playOn(game, 600);
    EXPECT_EQ(game.blocksLeft(), 4);
    EXPECT_FALSE(game.counts().isDown()) << "no ball is in play";
    GameTestAccess::shoot(game, {0, 16}, {0, -12});
    const auto won = playUntil<Cleared>(game, {}, 600);
    ASSERT_TRUE(won);
    EXPECT_TRUE(game.counts().isDown());
    EXPECT_EQ(game.counts().hits, 1);
    EXPECT_EQ(game.collapse().largest, 4) << "the rest is one collapse";
    EXPECT_EQ(game.score(), (1 + 2 + 3 + 1 + 4) * 100 + won->lives + won->prize)
        << "what comes down by itself is not multiplied";
}

TEST(Building, ABallLostAfterItIsDownCostsNoLife) {
    Game game(columnsAndBricks(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    for (std::size_t i = 0; i < 6; ++i) {
        toss(game, i, {i < 3 ? Real(8) : Real(-8), 0});
    }
    GameTestAccess::shoot(game, {0, 16}, {0, -12});
    for (int i = 0; i < 600 && !game.counts().isDown(); ++i) {
        game.tick({});
    }
    ASSERT_TRUE(game.counts().isDown());
    GameTestAccess::shoot(game, {9, Real(0.5)}, {0, -12}); // past the paddle
    ASSERT_TRUE(playUntil<Cleared>(game, {}, 600));
    EXPECT_EQ(game.lives(), 3);
}

/// Serves straight up, and moves the paddle so far from there and back.
Game returned(std::int16_t way) {
    Game game(columns(), 1);
    game.tick({.launch = true, .aim = std::int16_t{0}});
    for (int i = 0; i < 480 && game.counts().hits < 2; ++i) {
        game.tick({.target = i < 60 ? way : std::int16_t{0}});
    }
    return game;
}

TEST(Game, AServedBallIsHollowUntilAPaddleThatHasMovedReturnsIt) {
    const auto massOf = [](const Game& game) { return game.world()[game.balls()[0].body].mass(); };
    Game game(columns(), 1);
    game.tick({.launch = true, .aim = std::int16_t{0}});
    const Real full = kBallDensity * std::numbers::pi_v<Real> * kBallRadius * kBallRadius;
    EXPECT_NEAR(massOf(game), kHollowShare * full, Real(1e-3) * full);
    const Game still = returned(0);
    EXPECT_EQ(still.counts().hits, 2);
    EXPECT_TRUE(still.balls()[0].hollow);
    const Game moved = returned(1000);
    EXPECT_EQ(moved.counts().hits, 2);
    EXPECT_FALSE(moved.balls()[0].hollow);
    EXPECT_NEAR(massOf(moved), full, Real(1e-3) * full);
}

TEST(Building, BlocksThatFallTogetherAreOneCollapse) {
    Game game(columns(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    for (const std::size_t i : {0u, 1u, 2u}) {
        toss(game, i, {6, 0});
    }
    const auto told = playUntil<Collapsed>(game, {}, 400);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->blocks, 3);
    EXPECT_EQ(told->points, 100 + 200 + 300); // each times its number in the collapse
    playOn(game, static_cast<int>(kFallenTicks));
    EXPECT_EQ(game.score(), told->points) << "all have landed";
    EXPECT_EQ(game.collapse().largest, 3);
    EXPECT_EQ(game.collapse().blocks, 0);
}

TEST(Building, ALevelIsWonOnceAllHasFallen) {
    Game game(columns(), 1);
    playOn(game, 60);
    for (std::size_t i = 0; i < game.blocks().size(); ++i) {
        toss(game, i, {i < 3 ? kodo::Real(8) : kodo::Real(-8), 0});
    }
    ASSERT_TRUE(playUntil<Cleared>(game, {}, 300));
    EXPECT_EQ(game.result(), Result::Won);
    EXPECT_EQ(game.lives(), 3); // what falls costs none
}

TEST(Building, WhatRestsOnABlockDoesNotWearIt) {
    // 32 kg of steel press glass by 3 N s in each tick, as much as its strength.
    Game game(columns("[[block]]\nkind = \"x\"\nx = 4000\ny = 12400\nwidth = 2000\nheight = 4000\n",
                      "glass"),
              1);
    for (int i = 0; i < kMinute / 4; ++i) {
        game.tick({});
        ASSERT_EQ(eventOf<Cracked>(game), nullptr);
    }
    EXPECT_EQ(game.blocksLeft(), 6);
}

TEST(Building, AFallBreaksGlassByItsTrueImpulse) {
    Game game(columns("", "glass"), 1);
    playOn(game, 60);
    // 0.26 kg at 10 m/s: 2.6 N s and the restitution, split over the corners that touch first
    toss(game, 2, {0, 14});
    const auto broke = playUntil<Broke>(game, {}, 400);
    ASSERT_TRUE(broke);
    EXPECT_GT(broke->impulse, 0);
}

TEST(Building, ARopeBreaksByItsForce) {
    const std::string weight = R"([[block]]
kind = "x"
name = "weight"
shape = "round"
x = 0
y = 12000
[[joint]]
kind = "rope"
b = "weight"
from = [0, 16000]
to = [0, 12000]
break = )";
    // 2 kg of steel weigh 24 N.
    Game strong(columns(weight + "30000\n"), 1);
    Game weak(columns(weight + "20000\n"), 1);
    EXPECT_FALSE(playUntil<Snapped>(strong, {}, kMinute / 4));
    const auto snapped = playUntil<Snapped>(weak, {}, 60);
    ASSERT_TRUE(snapped);
    EXPECT_NEAR(snapped->point.y, 12, 0.1);
    EXPECT_EQ(strong.links().size(), 1u);
    EXPECT_TRUE(weak.links().empty());
}

TEST(Building, ARopeGoesWithTheBlockThatHoldsIt) {
    Game game(columns(R"([[block]]
kind = "g"
name = "hook"
x = 0
y = 16000
[[block]]
kind = "x"
name = "weight"
shape = "round"
x = 0
y = 12000
[[joint]]
kind = "rope"
a = "hook"
b = "weight"
from = [0, 15600]
to = [0, 12000]
)"),
              1);
    playOn(game, 60);
    GameTestAccess::breakBlock(game, 6, {0, 16}, {});
    game.tick({});
    EXPECT_TRUE(game.links().empty());
    playOn(game, 60);
    EXPECT_LT(game.world()[game.blocks().back().body].position().y, 11);
}

// Rubble that breaks by its age takes its ropes and pins along in the same tick: a picture of the
// links is drawn after any tick. Before, it was drawn with joints that no longer existed.
TEST(Building, AfterEachTickAllLinksExist) {
    for (const char* const name : {"rope_bridge", "scaffold", "mobile", "crane"}) {
        Game game{std::get<Level>(loadLevel(name)), 1};
        std::size_t most = 0;
        std::size_t least = game.links().size();
        for (int tick = 0; tick < 2400; ++tick) {
            game.tick(bot(game, BotKind::Good));
            most = std::max(most, game.links().size());
            least = std::min(least, game.links().size());
            for (const Link& link : game.links()) {
                ASSERT_TRUE(game.world().contains(link.joint)) << name << ", tick " << tick;
            }
        }
        EXPECT_LT(least, most) << name << ": no link went";
    }
}

TEST(Building, APullCatchesAFallenBlock) {
    Game game(columns(), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    GameTestAccess::letGo(game, 0);
    kodo::World& world = GameTestAccess::world(game);
    world[game.blocks()[0].body].setPosition({-1, 4});
    GameTestAccess::setMeter(game, kodo::Real(0.5));
    Input pull;
    pull.force = Force::Pull;
    const auto caught = playUntil<ShardCaught>(game, pull, 120);
    ASSERT_TRUE(caught);
    EXPECT_EQ(game.blocks().size(), 5u);
}

TEST(Building, TheFieldOfThePaddleLeavesAStandingBlockAlone) {
    Game game(columns(), 1);
    Input push;
    push.force = Force::Push;
    for (int i = 0; i < 240; ++i) {
        game.tick(push);
    }
    EXPECT_EQ(fallen(game), 0u);
    EXPECT_TRUE(game.world()[game.blocks()[2].body].isAsleep());
}

/// Measures the clock of `escapement`.
struct Clock {
    static constexpr std::size_t kBar = 4, kHook = 12, kRod = 16; // free blocks of its file

    Game game{std::get<Level>(loadLevel("escapement")), 1};
    double wheel = 0; // rad, turned by the driven wheel
    int swings = 0;   // of the pendulum, there or back

    double angle(std::size_t index) const {
        const kodo::Rot turn = game.world()[game.blocks()[index].body].rotation();
        return std::atan2(static_cast<double>(turn.s), static_cast<double>(turn.c));
    }
    void run(int seconds) {
        constexpr double kTurn = 2 * 3.14159265358979;
        double before = angle(kBar);
        bool swingsLeft = false;
        for (int i = 0; i < seconds * static_cast<int>(kTicksPerSecond); ++i) {
            game.tick({});
            const double now = angle(kBar);
            wheel += std::remainder(now - before, kTurn);
            before = now;
            const kodo::Real spin = game.world()[game.blocks()[kRod].body].angularVelocity();
            if (std::abs(spin) > kodo::Real(0.05) && (spin < 0) != swingsLeft) {
                swingsLeft = !swingsLeft;
                ++swings;
            }
        }
    }
};

// A wheel of six teeth: its anchor lets half a tooth pass at each swing, there or back, and the
// wheel keeps the pendulum swinging.
TEST(Escapement, EachSwingLetsHalfAToothPass) {
    Clock clock;
    clock.run(5); // starts
    const double wheel = clock.wheel;
    const int swings = clock.swings;
    clock.run(40);
    EXPECT_GE(clock.swings - swings, 16);
    // A tooth that bounces off the anchor may miss a swing.
    EXPECT_NEAR((clock.wheel - wheel) / (clock.swings - swings), 3.14159 / 6, 0.12);
}

TEST(Escapement, WithoutItsPendulumTheWheelRaces) {
    Clock clock;
    clock.run(5);
    const double ticking = clock.wheel;
    GameTestAccess::breakBlock(clock.game, Clock::kHook, {0, kodo::Real(10.4)}, {});
    clock.run(2); // falls
    const double loose = clock.wheel;
    clock.run(5);
    EXPECT_GT(clock.wheel - loose, 2 * ticking);
}

class EveryForm : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryForm, BreaksIntoValidPiecesOfItsMass) {
    const bool arch = static_cast<Form>(GetParam()) == Form::Voussoir;
    const std::string shape = "shape = \"" + std::string(kFormNames[GetParam()]) + "\"\n";
    const std::string size = arch ? "radius = 3000\nspan = 20000\n" : "";
    for (const std::string_view stuff : kStuffNames) {
        const Level level =
            columns("[legend.n]\nstuff = \"" + std::string(stuff) +
                    "\"\n[[block]]\nkind = \"n\"\nx = 0\ny = 12000\nturn = 20000\n" + shape + size);
        const BlockKind kind = level.kinds[level.freeBlocks.back().kind];
        const PlacedShape placed = placedShapeOf(level.freeBlocks.back());
        kodo::World world;
        const kodo::Real mass = world[world.add(blockDef(kind, placed))].mass();
        for (std::uint64_t key = 1; key <= 50; ++key) {
            double sum = 0;
            const std::vector<Piece> pieces =
                piecesOf(kind, placed.shape, extentOf(placed.shape).lower, key);
            EXPECT_GE(pieces.size(), 2u) << stuff;
            for (const Piece& piece : pieces) {
                EXPECT_FALSE(check(piece.shape));
                sum += static_cast<double>(piece.mass.mass);
            }
            EXPECT_NEAR(sum, static_cast<double>(mass), 1e-5 * sum);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, EveryForm, testing::Range(std::size_t{0}, kFormNames.size()),
                         [](const auto& form) { return std::string(kFormNames[form.param]); });

class EveryBuilding : public testing::TestWithParam<std::string> {};

/// Untouched for a minute, no standing block moves by 1 cm, and all of them sleep.
TEST_P(EveryBuilding, StandsUntouched) {
    const Level level = std::get<Level>(loadLevel(GetParam()));
    Game game(level, 1);
    const std::vector<Block> before(game.blocks().begin(), game.blocks().end());
    kodo::Real farthest = 0; // m, of any block at any time
    for (int tick = 0; tick < kMinute; ++tick) {
        game.tick({});
        ASSERT_EQ(game.blocks().size(), before.size());
        for (const Block& block : before) {
            if (block.support == Support::Standing) {
                const kodo::Vec2 now = game.world()[block.body].position();
                farthest = std::max(farthest, length(now - block.home.position));
            }
        }
    }
    EXPECT_LT(farthest, kodo::Real(0.01));
    for (const Block& block : before) {
        if (block.support == Support::Standing) {
            SCOPED_TRACE("free block " + std::to_string(block.key - keyOfFree(0)));
            EXPECT_TRUE(game.world()[block.body].isAsleep());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, EveryBuilding, testing::ValuesIn(levelNames()),
                         [](const auto& level) { return level.param; });

} // namespace
