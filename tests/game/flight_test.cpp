// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/paddle.hpp>
#include <support/draws.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

TEST(FreeFlight, IsAStraightLineWhileTheServoWorks) {
    support::RandomNumbers random(3);
    const Level level = levelOf("g..............\n");
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed 3, trial " + std::to_string(trial));
        Game game(level, 1);
        const Vec2 from{random.between(-4, 4), random.between(8, 10)};
        const Vec2 heading = random.rotation().xAxis();
        const Real start = random.between(1, 16); // the servo's target is 12
        const kodo::BodyId ball = GameTestAccess::shoot(game, from, start * heading);
        for (int tick = 0; tick < 36; ++tick) {
            game.tick({});
            const Vec2 way = game.world()[ball].position() - from;
            // Each of 36 steps and scalings rounds a position of 10 m to 1e-6 m.
            ASSERT_TRUE(near(cross(heading, way), 0, 1e-4));
        }
        EXPECT_TRUE(near(length(game.world()[ball].velocity()), 12, 0.15));
    }
}

TEST(FreeFlight, GainsTheServoWorkOfTheLedger) {
    for (const Real start : {Real(4), Real(20)}) {
        Game game(levelOf("g..............\n"), 1);
        const kodo::BodyId ball = GameTestAccess::shoot(game, {0, 4}, {0, start});
        const kodo::BodyView body = game.world()[ball];
        for (int tick = 0; tick < 40; ++tick) {
            game.tick({});
        }
        const Real gained = body.mass() * (lengthSquared(body.velocity()) - start * start) / 2;
        EXPECT_TRUE(near(static_cast<Real>(game.ledger().servoWork), gained, 1e-3)); // of 130 J
    }
}

// Regression: below the field and the picture, a flat ball bounced between the walls for seconds.
TEST(Ball, IsLostAsSoonAsItIsBelowThePicture) {
    Game game(levelOf("g..............\n"), 1);
    GameTestAccess::shoot(game, {-8, Real(-0.3)}, {12, -1});
    const auto lost = playUntil<BallLost>(game, {}, 60);
    ASSERT_TRUE(lost);
    EXPECT_LT(lost->point.y, -2 * kBallRadius);         // the whole ball is below the field
    EXPECT_GT(lost->point.y, -kLostDepth - Real(0.02)); // one tick of 9 mm
}

// Regression: a ball pressed against a block by the wind crept along it for seconds.
TEST(Servo, KeepsTheSpeedOfABallThatWindPressesAgainstABlock) {
    const std::string column = ".......X.......\n";
    const Level level =
        levelOf("g..............\n" + column + column + column + column, 12000, "wind = -30000\n");
    Game game(level, 1, Mode::Pure);
    GameTestAccess::shoot(game, {kCellWidth / 2 + kBallRadius, 16}, {0, Real(-0.5)});
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    EXPECT_GT(length(game.world()[game.balls()[0].body].velocity()), 6);
}

/// Walls, blocks and paddle of a level, with one ball not controlled by servo or governor.
struct Range {
    kodo::World world;
    kodo::BodyId ball;
    kodo::BodyId paddle;
    std::vector<kodo::BodyId> solids; // without the paddle

    explicit Range(const Level& level) {
        Game game(level, 1);
        ball = GameTestAccess::shoot(game, {0, 8}, {0, 1});
        paddle = game.paddle();
        world = game.world();
        for (const Block& block : game.blocks()) {
            solids.push_back(block.body);
        }
        solids.insert(solids.end(), game.walls().begin(), game.walls().end());
    }

    bool isFree(Vec2 place) const {
        const kodo::Aabb bounds = kodo::Aabb{place, place}.grown(kBallRadius);
        const auto clear = [&](kodo::BodyId body) {
            return !overlap(world[body].bounds(), bounds);
        };
        return std::all_of(solids.begin(), solids.end(), clear) && clear(paddle);
    }
    /// True if a straight line crosses a solid body. Samples are 1 cm apart, which suffices: the
    /// centre of the ball keeps 30 cm from surfaces.
    bool leadsThrough(Vec2 from, Vec2 to) const {
        for (int i = 0; i <= 16; ++i) {
            const Vec2 place = from + (static_cast<Real>(i) / 16) * (to - from);
            for (const kodo::BodyId body : solids) {
                if (world[body].contains(place)) {
                    return true;
                }
            }
        }
        return false;
    }
};

/// Height of the ball relative to the paddle's widest line, or 0 if the ball is beside the paddle.
Real heightOverPaddle(const Range& range) {
    const Vec2 local = range.world[range.ball].position() - range.world[range.paddle].position();
    return std::abs(local.x) < kPaddleFoot ? local.y : 0;
}

/// True if the level has only mounted blocks, without obstructions, wells or wind.
bool isStill(const Level& level) {
    return level.obstructions.empty() && level.wells.empty() && level.wind == 0 &&
           std::all_of(level.kinds.begin(), level.kinds.end(),
                       [](const BlockKind& kind) { return kind.support == Support::Mounted; });
}

TEST(ContinuousCollision, PreventsTunnellingAtFourTimesTheTopSpeedInTenThousandShots) {
    constexpr std::uint64_t kSeed = 99;
    constexpr int kShots = support::draws(10000);
    support::RandomNumbers random(kSeed);
    std::vector<Range> ranges;
    Real top = 0;
    std::vector<std::string> names = levelNames();
    for (int number = 1; number <= 20; ++number) { // few levels have walls alone
        names.push_back("endless:99:" + std::to_string(number));
    }
    for (const std::string& name : names) {
        const Level level = std::get<Level>(loadLevel(name));
        if (!isStill(level)) {
            continue;
        }
        ranges.emplace_back(level);
        top = std::max(top, static_cast<Real>(level.ballSpeed) / 1000 * (1 + kSpeedUp));
    }
    ASSERT_GE(ranges.size(), 10u);
    for (int shot = 0; shot < kShots; ++shot) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", shot " + std::to_string(shot));
        Range& range = ranges[static_cast<std::size_t>(shot) % ranges.size()];
        Vec2 place;
        do {
            place = {random.between(-11.5, 11.5), random.between(2.6, 17.5)};
        } while (!range.isFree(place));
        kodo::BodyRef ball = range.world[range.ball];
        ball.setPosition(place);
        ball.setVelocity(4 * top * random.rotation().xAxis());
        const Real drive = kKeySpeed * random.between(-1, 1);
        for (int tick = 0; tick < 12; ++tick) {
            const Vec2 from = ball.position();
            const Real over = heightOverPaddle(range);
            kodo::BodyRef paddle = range.world[range.paddle];
            const Real next = paddle.position().x + drive * kTickSeconds;
            paddle.moveTo({std::clamp(next, Real(-10), Real(10)), kPaddleY}, kTickSeconds);
            range.world.step(kTickSeconds);
            ASSERT_FALSE(range.leadsThrough(from, ball.position()))
                << from.x << " " << from.y << " to " << ball.position().x << " "
                << ball.position().y;
            ASSERT_GE(over * heightOverPaddle(range), 0) << "through the paddle";
            ASSERT_LT(std::abs(ball.position().x), kFieldWidth / 2);
            ASSERT_LT(ball.position().y, kFieldHeight);
        }
    }
}

TEST(ContinuousCollision, KeepsTheSpeedAndMirrorsThePathAtWallsAndBlocks) {
    Game game(levelOf("XXXXXXXXXXXXXXg\n"), 1);
    const kodo::BodyId ball = GameTestAccess::shoot(game, {0, 10}, {0, 1});
    kodo::World world = game.world();
    world[ball].setVelocity({30, 40});
    for (int tick = 0; tick < 240 && world[ball].position().y > 3; ++tick) {
        world.step(kTickSeconds);
        // Lossless at every bounce: a few rounding errors of 1e-7 each.
        ASSERT_TRUE(near(length(world[ball].velocity()), 50, 50 * 1e-5));
        ASSERT_TRUE(near(std::abs(world[ball].velocity().x), 30, 0.01));
    }
}

} // namespace
