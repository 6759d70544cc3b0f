// SPDX-License-Identifier: MIT
// Obstructions and hanging blocks.
#include <support/near.hpp>

#include <array>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

// An obstruction, letter o, in the middle of row 5: x = 0, y = 13.6. A distant glass block keeps
// the game running.
const std::string kOverGlass = "g..............\n" + emptyRows(4) + ".......o.......\n";
constexpr Vec2 kMiddle{0, Real(13.6)};

Game with(const std::string& lines) {
    return Game(levelWith(kOverGlass, "o", lines), 1);
}

/// Speed of the first ball.
Real speedOf(const Game& game) {
    return length(game.world()[game.balls()[0].body].velocity());
}

// A7: obstructions.
TEST(Bumper, KicksTheBallAndTheServoRestoresItsSpeed) {
    Game game = with("obstruction = \"bumper\"\nspeed = 6000");
    GameTestAccess::shoot(game, kMiddle - Vec2{0, 2}, {0, 12});
    const auto bumped = playUntil<Bumped>(game, {}, 30);
    ASSERT_TRUE(bumped);
    EXPECT_TRUE(near(bumped->normal, Vec2{0, -1}, 1e-3));
    EXPECT_TRUE(near(speedOf(game), 12 + 6, 0.05)); // lossless bounce plus the kick
    EXPECT_EQ(game.obstructions()[0].hitTick, game.ticks());
    for (int tick = 0; tick < 40; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(speedOf(game), 12, 0.2));
}

TEST(Bumper, KicksShardsToo) {
    Game game(levelWith("g..............\n" + emptyRows(1) + ".......b.......\n" + emptyRows(2) +
                            ".......o.......\n",
                        "o", "obstruction = \"bumper\"\nsize = 700"),
              1);
    GameTestAccess::breakBlock(game, 1, {0, 0});
    const auto bumped = playUntil<Bumped>(game, {}, 240);
    ASSERT_TRUE(bumped);
    EXPECT_EQ(roleOf(game.world()[bumped->body].flags()), Role::Shard);
}

TEST(Pin, DeflectsTheBallWithoutAKick) {
    Game game = with("obstruction = \"pin\"");
    GameTestAccess::shoot(game, kMiddle - Vec2{Real(0.25), 2}, {0, 12});
    const auto struck = playUntil<Struck>(game, {}, 30);
    ASSERT_TRUE(struck);
    EXPECT_EQ(struck->what, Role::Obstruction);
    // sin of the angle between path and normal = offset / sum of radii
    EXPECT_TRUE(near(struck->normal.x, Real(-0.5), 0.03));
    EXPECT_TRUE(near(speedOf(game), 12, 0.05));
    EXPECT_LT(game.balls()[0].heading.x, Real(-0.7)); // reflected at 30 degrees: sin 60
}

TEST(Motor, RotatesItsBarAtItsSpeed) {
    Game game = with("obstruction = \"motor\"\nspeed = 2000");
    const kodo::BodyId bar = game.obstructions()[0].body;
    for (int tick = 0; tick < 120; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(game.world()[bar].angularVelocity(), 2, 1e-3));
    // One second at 2 rad/s, except for the first tick of acceleration.
    EXPECT_TRUE(near(game.world()[bar].rotation().angle(), 2, 0.02));
    EXPECT_TRUE(near(game.world()[bar].position(), kMiddle, 1e-3));
}

TEST(Motor, YieldsToAnImpactAndRecovers) {
    Game game = with("obstruction = \"motor\"\nspeed = 0");
    const kodo::BodyId bar = game.obstructions()[0].body;
    GameTestAccess::shoot(game, kMiddle + Vec2{Real(1.2), -2}, {0, 12});
    ASSERT_TRUE(playUntil<Struck>(game, {}, 60));
    EXPECT_GT(game.world()[bar].angularVelocity(), 1);
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(game.world()[bar].angularVelocity(), 0, 1e-3));
}

TEST(Gate, LetsBallsPassFromBehindOnly) {
    const std::array<Vec2, 4> fronts{Vec2{0, 1}, Vec2{0, -1}, Vec2{-1, 0}, Vec2{1, 0}};
    for (std::size_t facing = 0; facing < fronts.size(); ++facing) {
        SCOPED_TRACE(kFacingNames[facing]);
        const std::string name(kFacingNames[facing]);
        for (const Real side : {Real(1), Real(-1)}) { // from the front, from behind
            Game game = with("obstruction = \"gate\"\nsize = 3000\nfacing = \"" + name + "\"");
            const Vec2 front = fronts[facing];
            const Vec2 from = kMiddle + side * Real(1.5) * front;
            const kodo::BodyId ball = GameTestAccess::shoot(game, from, -side * Real(12) * front);
            for (int tick = 0; tick < 24; ++tick) { // 2.4 m
                game.tick({});
            }
            const Real place = dot(game.world()[ball].position() - kMiddle, front);
            if (side > 0) {
                EXPECT_GT(place, 1) << "it went through the front";
            } else {
                EXPECT_TRUE(near(place, Real(0.9), 0.02)) << "it was held up on its way";
            }
        }
    }
}

TEST(Ground, BouncesTheBallOffItsSlope) {
    Game game(levelOf("g..............\n", 12000, "",
                      "[[ground]]\nx = -12000\ny = 0\nspacing = 6000\nheights = [6000, 0]\n"),
              1);
    const kodo::BodyId ball = GameTestAccess::shoot(game, {-9, 8}, {0, -12});
    const auto struck = playUntil<Struck>(game, {}, 60);
    ASSERT_TRUE(struck);
    EXPECT_EQ(struck->what, Role::Obstruction);
    EXPECT_TRUE(near(struck->normal, Vec2{Real(0.7071), Real(0.7071)}, 1e-3)); // 45 degrees down
    EXPECT_GT(game.world()[ball].velocity().x, 11);
}

TEST(Ground, WithAnOutlineIsSolidFromAllSides) {
    const Level level = levelOf(
        "g..............\n", 12000, "",
        "[[ground]]\npoints = [[-2000, 8000], [2000, 8000], [2000, 10000], [-2000, 10000]]\n");
    const std::array<Vec2, 4> outwards = {Vec2{0, 1}, Vec2{0, -1}, Vec2{1, 0}, Vec2{-1, 0}};
    for (const Vec2 outward : outwards) {
        Game game(level, 1);
        GameTestAccess::shoot(game, Vec2{0, 9} + Real(4) * outward, -Real(12) * outward);
        const auto struck = playUntil<Struck>(game, {}, 60);
        ASSERT_TRUE(struck);
        EXPECT_EQ(struck->what, Role::Obstruction);
        EXPECT_TRUE(near(struck->normal, outward, 1e-3));
    }
}

// A hanging block in the middle of row 5, with its pin 1.6 m above.
Game hung(const std::string& stuff) {
    return with("stuff = \"" + stuff + "\"\nstrength = 900000\nhold = \"hanging\"\narm = 1600");
}

TEST(HangingBlock, HangsStillUntilItIsHit) {
    Game game = hung("stone");
    const Block block = game.blocks()[1];
    EXPECT_EQ(block.support, Support::Hanging);
    for (int tick = 0; tick < 240; ++tick) {
        game.tick({});
    }
    EXPECT_TRUE(near(game.world()[block.body].position(), kMiddle, 0.01));
    EXPECT_TRUE(near(game.world()[block.pin].position(), kMiddle + Vec2{0, Real(1.6)}, 1e-4));
}

TEST(HangingBlock, SwingsAboutItsPinWhenItIsHit) {
    Game game = hung("stone");
    const Block block = game.blocks()[1];
    GameTestAccess::shoot(game, kMiddle - Vec2{3, 0}, {12, 0});
    ASSERT_TRUE(playUntil<Cracked>(game, {}, 60));
    Real farthest = 0;
    for (int tick = 0; tick < 60; ++tick) {
        game.tick({});
        const Vec2 place = game.world()[block.body].position();
        farthest = std::max(farthest, place.x);
        // The soft joint yields by some mm under an impact.
        EXPECT_TRUE(near(length(place - game.world()[block.pin].position()), Real(1.6), 0.02));
    }
    EXPECT_GT(farthest, Real(0.5));
}

TEST(HangingBlock, GivesItsPiecesItsVelocity) {
    for (const char* stuff : {"glass", "wood", "brick", "stone"}) {
        SCOPED_TRACE(stuff);
        Game game = hung(stuff);
        kodo::BodyRef body = GameTestAccess::world(game)[game.blocks()[1].body];
        body.setRotation(kodo::Rot::fromAngle(Real(0.3)));
        body.setVelocity({3, 1});
        body.setAngularVelocity(2);
        const Vec2 center = body.center();
        const Vec2 before = body.mass() * body.velocity();
        const Real spinBefore = body.inertia() * body.angularVelocity();
        GameTestAccess::breakBlock(game, 1, {0, 24}); // its velocity already includes the impulse
        Vec2 momentum;
        Real moment = 0;
        for (const Shard& shard : game.shards()) {
            const kodo::BodyView piece = game.world()[shard.body];
            momentum += piece.mass() * piece.velocity();
            moment += piece.mass() * cross(piece.center() - center, piece.velocity()) +
                      piece.inertia() * piece.angularVelocity();
        }
        EXPECT_TRUE(near(momentum, before, 2e-5)); // a dozen floats of about 1
        EXPECT_TRUE(near(moment, spinBefore, 2e-5));
        EXPECT_FALSE(game.world().contains(game.blocks()[0].pin));
    }
}

} // namespace
