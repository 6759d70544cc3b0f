// SPDX-License-Identifier: MIT
// Blows: what is cleared for a hit of the paddle, and what is cleared for none.
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>

#include <array>
#include <set>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

const Input kPull{.force = Force::Pull};

/// A column of six bricks on a ledge at the right: a building.
Game column() {
    return Game(levelFrom(R"(format = 1
title = "t"
idea = "i"
[legend.b]
stuff = "brick"
hold = "standing"
[[ledge]]
x = 8000
y = 7800
width = 4000
[[block]]
kind = "b"
shape = "square"
x = 8000
y = 8400
rows = 6
row-step = [0, 800]
)"),
                1);
}

/// Four blocks in a row and a lower one, after the serve.
Game row() {
    Game game(levelOf("gggg...........\n" + emptyRows(4) + ".......s.......\n"), 1);
    game.tick({.launch = true});
    return game;
}

/// Breaks the first blocks in one tick.
void breakBlocks(Game& game, int count) {
    for (int i = 0; i < count; ++i) {
        GameTestAccess::breakBlock(game, 0, Vec2{0, 24});
    }
    game.tick({});
}

/// The paddle returns the ball.
void hitAgain(Game& game) {
    const std::int32_t hits = game.counts().hits;
    playOn(game, static_cast<int>(kHitTicks));
    GameTestAccess::shoot(game, {0, 3}, {0, -12});
    for (int i = 0; i < 60 && game.counts().hits == hits; ++i) {
        game.tick({});
    }
    EXPECT_EQ(game.counts().hits, hits + 1);
}

/// Plays with the ball away from all until a block is let go. False if none is for `most` ticks.
bool waitFor(Game& game, LetGo::Why why, const Input& input, int most) {
    for (int i = 0; i < most; ++i) {
        GameTestAccess::shoot(game, {8, 5}, {0, 12});
        game.tick(input);
        const LetGo* let = eventOf<LetGo>(game);
        if (let != nullptr && let->why == why) {
            return true;
        }
    }
    return false;
}

TEST(Blow, IsMadeByNoHollowBallUntilThePaddleFillsIt) {
    Game game = column();
    game.tick({.launch = true, .aim = std::int16_t{0}});
    breakBlocks(game, 3);
    EXPECT_EQ(game.counts().bestBlow, 0);
    for (int i = 0; i < 480 && game.counts().hits < 2; ++i) {
        game.tick({.target = i < 60 ? std::int16_t{1000} : std::int16_t{0}});
    }
    ASSERT_FALSE(game.balls()[0].hollow);
    breakBlocks(game, 2);
    EXPECT_EQ(game.counts().bestBlow, 2);
}

/// A target (mm) of the paddle by tick.
using Way = std::int16_t (*)(int tick);

std::int16_t stay(int) {
    return 0;
}
std::int16_t shortWay(int tick) {
    return tick < 60 ? 200 : 0;
}
std::int16_t longWay(int tick) {
    return tick < 60 ? 800 : 0;
}
std::int16_t tremble(int tick) {
    return tick % 2 == 0 ? 120 : -120;
}

/// Serves straight up, and plays on until the paddle has returned the ball.
Game returned(Mode mode, Way way) {
    Game game(column().state().origin.level, 1, mode);
    game.tick({.launch = true, .aim = std::int16_t{0}});
    for (int i = 0; i < 480 && game.counts().hits < 2; ++i) {
        game.tick({.target = way(i)});
    }
    EXPECT_EQ(game.counts().hits, 2);
    return game;
}

// Regression: a paddle that trembled by 8 mm until it had gone 0.6 m in all filled the ball.
TEST(Hollow, IsFilledByAPaddleThatWentAwayAndByNoTwitch) {
    for (const Mode mode : {Mode::Standard, Mode::Assisted}) {
        EXPECT_TRUE(returned(mode, stay).balls()[0].hollow);
        EXPECT_TRUE(returned(mode, shortWay).balls()[0].hollow);
        EXPECT_TRUE(returned(mode, tremble).balls()[0].hollow);
        EXPECT_FALSE(returned(mode, longWay).balls()[0].hollow);
    }
}

// Regression: a paddle at rest won gold under pure rules, where no ball is hollow.
TEST(Blow, UnderPureRulesAsksForAPaddleThatHasMovedToo) {
    const auto blowAfter = [](Way way) {
        Game game = returned(Mode::Pure, way);
        EXPECT_FALSE(game.balls()[0].hollow);
        breakBlocks(game, 2);
        return game.counts().bestBlow;
    };
    EXPECT_EQ(blowAfter(stay), 0);
    EXPECT_EQ(blowAfter(shortWay), 0);
    EXPECT_EQ(blowAfter(tremble), 0);
    EXPECT_EQ(blowAfter(longWay), 2);
    Game served(column().state().origin.level, 1, Mode::Pure);
    served.tick({.launch = true, .aim = std::int16_t{0}});
    breakBlocks(served, 3);
    EXPECT_EQ(served.counts().bestBlow, 0);
}

// Regression: launching alone won the balls that were left, and with them medals.
TEST(Score, OfAWinWithoutABlowIsThatOfItsBlocks) {
    for (const Way way : {stay, longWay}) {
        Game game = returned(Mode::Pure, way);
        breakBlocks(game, static_cast<int>(game.blocksLeft()));
        const Cleared* cleared = eventOf<Cleared>(game);
        ASSERT_NE(cleared, nullptr);
        const bool blow = way(0) > 700;
        EXPECT_EQ(cleared->lives, blow ? game.lives() * kLifePoints : 0);
        EXPECT_EQ(cleared->prize > 0, blow);
    }
}

TEST(Hollow, ABallThatStaysAboveIsServedAgainAndCostsNoLife) {
    Game game = column();
    game.tick({.launch = true});
    const std::int32_t lives = game.counts().lives;
    for (std::uint32_t i = 0; i < kFailTicks + 10 && !game.serving(); ++i) {
        kodo::BodyRef ball = GameTestAccess::world(game)[game.balls()[0].body];
        ball.setPosition({0, 12});
        ball.setVelocity({0, 12});
        game.tick({});
    }
    EXPECT_TRUE(game.serving());
    EXPECT_EQ(game.balls().size(), 1u);
    EXPECT_TRUE(game.balls()[0].hollow);
    EXPECT_EQ(game.counts().lives, lives);
    EXPECT_EQ(game.counts().hits, 1); // the next serve is another
    playOn(game, 3);
    game.tick({.launch = true});
    EXPECT_EQ(game.counts().hits, 2);
}

TEST(Blow, EndsWithATearAndTheNextHitBeginsOne) {
    Game game = row();
    ASSERT_TRUE(waitFor(game, LetGo::Why::Torn, kPull, static_cast<int>(kFailTicks)));
    breakBlocks(game, 2);
    EXPECT_EQ(game.counts().bestBlow, 0) << "what a pull tears off brings nothing down for a hit";
    hitAgain(game);
    breakBlocks(game, 1);
    EXPECT_EQ(game.counts().bestBlow, 1);
}

TEST(Blow, EndsWithAMountThatFails) {
    Game game = row();
    ASSERT_TRUE(waitFor(game, LetGo::Why::Fatigue, {}, static_cast<int>(kFailTicks) + 1));
    breakBlocks(game, 2);
    EXPECT_EQ(game.counts().bestBlow, 0);
    hitAgain(game);
    breakBlocks(game, 1);
    EXPECT_EQ(game.counts().bestBlow, 1);
}

TEST(Blow, KeepsWhatItClearedBeforeATear) {
    Game game = row();
    breakBlocks(game, 2);
    ASSERT_TRUE(waitFor(game, LetGo::Why::Torn, kPull, static_cast<int>(kFailTicks)));
    EXPECT_EQ(game.counts().bestBlow, 2);
}

TEST(Pull, TearsNothingOffWhileTheBallIsHollow) {
    Game game = column();
    game.tick({.launch = true});
    for (std::uint32_t tick = 0; tick < kGlowTicks; ++tick) {
        GameTestAccess::idle(game);
    }
    ASSERT_EQ(game.state().patience(), Patience::Glowing);
    Game filled = game;
    EXPECT_TRUE(waitFor(filled, LetGo::Why::Torn, kPull, 240));
    for (int i = 0; i < 240; ++i) {
        kodo::BodyRef ball = GameTestAccess::world(game)[game.balls()[0].body];
        ball.setPosition({-8, 9});
        ball.setVelocity({0, 12});
        game.tick(kPull);
        ASSERT_EQ(eventOf<LetGo>(game), nullptr) << i;
        ASSERT_EQ(game.state().tornShare(), 0);
    }
}

TEST(Field, RestsBeforeTheFirstServe) {
    Game game = column();
    for (int i = 0; i < 60; ++i) {
        game.tick(kPull);
        ASSERT_EQ(game.force(), Force::None);
        ASSERT_EQ(eventOf<ForceChanged>(game), nullptr);
    }
    EXPECT_EQ(game.meter(), 1);
    game.tick({.launch = true, .force = Force::Pull});
    EXPECT_EQ(game.force(), Force::Pull);
    EXPECT_LT(game.meter(), 1);
}

// Regression: a pull or a push brought hanging blocks down before the serve, for 730 points.
TEST(Score, IsNotMadeBeforeTheFirstServe) {
    for (const char* name : {"apart", "galleon"}) {
        const Level level = std::get<Level>(loadLevel(name));
        for (const Force force : {Force::Pull, Force::Push}) {
            Game game(level, 1);
            for (int i = 0; i < 10 * kTicksPerSecond; ++i) {
                game.tick({.force = force});
            }
            EXPECT_EQ(game.score(), 0) << name;
            EXPECT_EQ(game.blocksLeft(), game.blocksAtStart()) << name;
        }
    }
    Game game = column();
    breakBlocks(game, 2);
    EXPECT_EQ(game.score(), 0);
    EXPECT_EQ(game.blocksLeft(), game.blocksAtStart() - 2);
    // Regression: a level whose blocks all fell before the serve paid for its balls.
    breakBlocks(game, static_cast<int>(game.blocksLeft()));
    playOn(game, 120);
    ASSERT_EQ(game.result(), Result::Won);
    EXPECT_EQ(game.score(), 0);
}

TEST(Bot, TheAbsentPlayerHoldsEachForceWithEachAimAndNeverMoves) {
    const Level level = column().level();
    std::set<std::pair<Force, std::optional<std::int16_t>>> held;
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        Game game(level, seed);
        for (int i = 0; i < 240; ++i) {
            const Input input = bot(game, BotKind::Absent);
            EXPECT_EQ(input.paddle, 0);
            EXPECT_FALSE(input.target);
            held.emplace(input.force, input.aim);
            game.tick(input);
        }
        EXPECT_EQ(game.world()[game.paddle()].position().x, 0);
    }
    EXPECT_EQ(held.size(), 24u);
}

} // namespace
