// SPDX-License-Identifier: MIT
// Bounds on the time without damage, without bending the ball's path.
#include <apart/core/bot.hpp>
#include <apart/core/progress.hpp>
#include <support/near.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

TEST(ProgressClock, PassesItsStagesAndReleasesBlocksOneByOne) {
    ProgressClock clock;
    std::vector<std::uint32_t> due;
    for (std::uint32_t tick = 1; tick <= kFailTicks + 3 * kFailEvery; ++tick) {
        if (clock.tick()) {
            due.push_back(tick);
        }
        const Patience wanted = tick < kGlowTicks    ? Patience::Calm
                                : tick < kShakeTicks ? Patience::Glowing
                                : tick < kFailTicks  ? Patience::Shaking
                                                     : Patience::Failing;
        ASSERT_EQ(clock.patience(), wanted) << tick;
    }
    EXPECT_EQ(due, (std::vector<std::uint32_t>{kFailTicks, kFailTicks + kFailEvery,
                                               kFailTicks + 2 * kFailEvery,
                                               kFailTicks + 3 * kFailEvery}));
    clock.progress();
    EXPECT_EQ(clock.patience(), Patience::Calm);
}

TEST(ProgressClock, RunsFasterInAHurryAndSkipsNoStage) {
    for (const std::uint32_t head : {0u, 1u}) { // ticks before the hurry
        ProgressClock clock;
        std::vector<std::uint32_t> due;
        for (std::uint32_t tick = 1; tick <= kFailTicks; ++tick) {
            if (clock.tick(tick <= head ? 1 : kLastHurry)) {
                due.push_back(tick);
            }
        }
        ASSERT_GE(due.size(), 3u);
        EXPECT_EQ(due[0], (kFailTicks - head + kLastHurry - 1) / kLastHurry + head);
        EXPECT_EQ(due[1] - due[0], kFailEvery / kLastHurry);
        EXPECT_EQ(due[2] - due[1], kFailEvery / kLastHurry);
    }
}

/// Ticks without damage until mounts give way by themselves.
std::uint32_t ticksUntilFatigue(const std::string& row) {
    Game game(levelOf(row), 1);
    for (std::uint32_t tick = 1; tick <= kFailTicks + 1; ++tick) {
        GameTestAccess::shoot(game, {8, 9}, {0, 12}); // resets the ball, so that it hits nothing
        game.tick({});
        if (eventOf<LetGo>(game) != nullptr) {
            return tick;
        }
    }
    return 0;
}

TEST(Mounts, OfTheLastBlocksFailSooner) {
    EXPECT_EQ(ticksUntilFatigue("gggg...........\n"), kFailTicks);
    EXPECT_EQ(ticksUntilFatigue("ggg............\n"), kFailTicks / kLastHurry);
}

/// Paddle contacts until the clock detects a repeating sequence of `loop` contacts; 0: never.
int meetingsUntilSeen(int loop, int most) {
    ProgressClock clock;
    for (int i = 0; i < most; ++i) {
        const auto step = static_cast<Real>(i % loop);
        const Vec2 heading = kodo::Rot::fromAngle(Real(-1.2) - Real(0.1) * step).xAxis();
        if (clock.metPaddle({2 * step - 5, 2}, heading, 2 * step - 5)) {
            return i + 1;
        }
    }
    return 0;
}

TEST(ProgressClock, DetectsALoopInItsThirdRound) {
    for (const int loop : {1, 2, 4, 6}) {
        EXPECT_EQ(meetingsUntilSeen(loop, 100), 2 * loop + 1) << loop;
    }
}

TEST(ProgressClock, AdvancesByAStageWhenItDetectsALoop) {
    ProgressClock clock;
    for (int i = 0; i < 3; ++i) {
        clock.metPaddle({1, 2}, {0, -1}, 1);
    }
    EXPECT_EQ(clock.patience(), Patience::Glowing);
    clock.metPaddle({1, 2}, {0, -1}, 1);
    EXPECT_EQ(clock.patience(), Patience::Shaking);
    EXPECT_FALSE(clock.metPaddle({1, 2}, {0, -1}, 1)); // the next stage needs the warning time
    clock.progress();
    EXPECT_FALSE(clock.metPaddle({1, 2}, {0, -1}, 1)); // and the contacts are cleared
}

TEST(ProgressClock, DetectsNoLoopInVaryingPaths) {
    ProgressClock clock;
    for (int i = 0; i < 30; ++i) {
        const auto x = static_cast<Real>(i) * Real(0.6) - 9;
        EXPECT_FALSE(clock.metPaddle({x, 2}, {0, -1}, x));
    }
}

TEST(Mounts, FailFromBelowAfterALongTimeWithoutDamage) {
    Game game(levelOf("g..............\nb..............\n....b..........\n"), 1);
    GameTestAccess::shoot(game, {8, 9}, {0, 12});
    EXPECT_EQ(game.state().nextToFall()->key, 2u * kColumns + 4);
    std::vector<std::uint32_t> fell;
    for (std::uint32_t tick = 1; tick <= kFailTicks + 3 * kFailEvery + 240; ++tick) {
        GameTestAccess::shoot(game, {8, 9}, {0, 12}); // resets the ball, so that it hits nothing
        game.tick({});
        if (const LetGo* off = eventOf<LetGo>(game)) {
            EXPECT_EQ(off->why, LetGo::Why::Fatigue);
            EXPECT_TRUE(fell.empty() || off->key < fell.back()); // lowest first
            fell.push_back(off->key);
        }
    }
    EXPECT_EQ(fell.size(), 3u);
    EXPECT_EQ(game.blocksLeft(), 0); // blocks count when they have left the field
    EXPECT_EQ(game.result(), Result::Won);
}

TEST(Mounts, HoldBeforeTheServe) {
    Game game(levelOf("g..............\n"), 1);
    for (std::uint32_t tick = 0; tick < 2 * kFailTicks; ++tick) {
        game.tick({});
    }
    EXPECT_EQ(game.state().patience(), Patience::Calm);
    EXPECT_EQ(game.blocksLeft(), 1);
}

TEST(LooseBlock, BreaksAndCountsAfterItsTime) {
    Game game(levelOf("g..............\n" + emptyRows(4) + ".......b.......\n.......X.......\n"),
              1);
    GameTestAccess::shoot(game, {8, 9}, {0, 12});
    GameTestAccess::letGo(game, 1);
    std::uint32_t ticks = 0;
    int left = 0;
    while (eventOf<Broke>(game) == nullptr && ticks <= kLooseTicks + 2) {
        left = game.blocksLeft(); // the mount of the other block may have failed before
        GameTestAccess::shoot(game, {8, 9}, {0, 12});
        game.tick({});
        ++ticks;
    }
    EXPECT_EQ(ticks, kLooseTicks + 1);
    EXPECT_EQ(game.blocksLeft(), left - 1);
}

TEST(LooseBlock, NeitherBreaksNorCountsAfterTheGame) {
    Game game(levelOf("g..............\n" + emptyRows(4) + ".......b.......\n.......X.......\n"),
              1);
    GameTestAccess::letGo(game, 1);
    for (int life = 0; life < 3; ++life) {
        GameTestAccess::shoot(game, {8, 1}, {0, -12});
        ASSERT_TRUE(playUntil<LifeLost>(game, {}, 60));
    }
    ASSERT_EQ(game.result(), Result::Lost);
    const std::int32_t score = game.score();
    for (std::uint32_t tick = 0; tick < kLooseTicks + 10; ++tick) {
        game.tick({});
    }
    EXPECT_EQ(game.score(), score);
    EXPECT_EQ(game.blocksLeft(), 2);
}

/// Longest time without damage for this player, in ticks.
template <typename Player>
std::uint32_t longestWait(const Level& level, std::uint32_t seed, Mode mode, std::uint32_t ticks,
                          Player player) {
    Game game(level, seed, mode);
    std::uint32_t wait = 0;
    std::uint32_t longest = 0;
    std::int32_t left = game.blocksLeft();
    while (game.result() == Result::Playing && game.ticks() < ticks) {
        game.tick(player(game));
        const bool news = game.blocksLeft() < left || eventOf<Cracked>(game) != nullptr ||
                          eventOf<LetGo>(game) != nullptr || game.serving();
        wait = news ? 0 : wait + 1;
        left = game.blocksLeft();
        longest = std::max(longest, wait);
    }
    return longest;
}

// A8: no endless play without damage.
TEST(TimeWithoutDamage, IsBoundedForEveryPlayer) {
    // A glass block behind steel, out of reach of any ball: the bound does not depend on luck.
    const Level level = levelOf("XXXXXXXXXXXXXXX\n" + std::string("......XgX......\n") +
                                "......XXX......\n" + emptyRows(2) + "...b...........\n");
    const auto perfect = [](const Game& game) { return bot(game); };
    const auto lazy = [](const Game& game) { // no aim: stays straight under the ball
        Input input = towards(game.world()[game.balls()[0].body].position().x);
        input.launch = game.serving();
        return input;
    };
    for (const Mode mode : {Mode::Standard, Mode::Pure}) {
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            EXPECT_LE(longestWait(level, seed, mode, 20000, perfect), kFailTicks + 1);
            EXPECT_LE(longestWait(level, seed, mode, 20000, lazy), kFailTicks + 1);
        }
    }
}

TEST(PureMode, ChangesNoBounce) {
    for (const Mode mode : {Mode::Standard, Mode::Pure}) {
        Game game(levelOf("ggggggggggggggg\nbbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\n"), 3, mode);
        EXPECT_EQ(game.mode(), mode);
        for (int tick = 0; tick < 4000; ++tick) {
            game.tick(bot(game));
        }
        EXPECT_GT(game.ledger().bounces, 30u);
        if (mode == Mode::Pure) {
            EXPECT_EQ(game.ledger().bentBounces, 0u);
            EXPECT_EQ(game.ledger().thrownBounces, 0u);
        }
    }
}

TEST(PureMode, KeepsAFlatBallFlat) {
    for (const Mode mode : {Mode::Standard, Mode::Pure}) {
        Game game(levelOf("g..............\n"), 1, mode);
        GameTestAccess::shoot(game, {8, 9}, {12, Real(0.5)});
        for (int tick = 0; tick < 60; ++tick) {
            game.tick({}); // hits the right wall once
        }
        const Real sine = std::abs(game.balls()[0].heading.y);
        EXPECT_EQ(sine < kFlatSine - Real(0.001), mode == Mode::Pure);
    }
}

// A flat bounce towards a breakable block is useful and stays unchanged.
TEST(SmallestTurn, IsAppliedOnlyIfNoBreakableBlockIsAhead) {
    for (const char* block : {"b", "X"}) {
        Game game(levelOf("g..............\n" + emptyRows(10) + "......." + block + ".......\n"),
                  1);
        GameTestAccess::shoot(game, {8, Real(8.8)}, {12, Real(0.2)}); // at the height of the block
        for (int tick = 0; tick < 60; ++tick) {
            game.tick({}); // hits the right wall once
        }
        const Real sine = std::abs(game.balls()[0].heading.y);
        EXPECT_EQ(sine < kFlatSine - Real(0.001), *block == 'b');
        EXPECT_EQ(game.ledger().bentBounces, *block == 'b' ? 0u : 1u);
    }
}

} // namespace
