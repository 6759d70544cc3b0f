// SPDX-License-Identifier: MIT
// Falls onto ground, and the hollow ball of the serve.
#include <game/game_access.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace apart;

/// A column of three squares on a ledge at y = 8 m, above ground at y = 4 m.
Level columnAboveGround(const std::string& stuff) {
    return levelFrom(R"(format = 1
title = "t"
idea = "i"
[legend.b]
stuff = ")" + stuff + R"("
hold = "standing"
[[ledge]]
x = 0
y = 7800
width = 10000
[[block]]
kind = "b"
shape = "square"
x = 4000
y = 8400
rows = 3
row-step = [0, 800]
[[ground]]
points = [[-11500, 3000], [11500, 3000], [11500, 4000], [-11500, 4000]]
)");
}

bool hasDropped(const Block& block) {
    return block.support == Support::Fallen;
}

TEST(Game, AHollowBallCracksButBreaksNothing) {
    Game game(columnAboveGround("glass"), 1);
    game.tick({.launch = true});
    kodo::BodyRef ball = GameTestAccess::world(game)[game.balls()[0].body];
    ball.setPosition({4, 14});
    ball.setVelocity({0, -12});
    bool cracked = false;
    for (int i = 0; i < 60; ++i) {
        game.tick({});
        for (const Event& event : game.events()) {
            cracked = cracked || std::holds_alternative<Cracked>(event);
            EXPECT_FALSE(std::holds_alternative<Broke>(event));
        }
    }
    EXPECT_TRUE(cracked);
    EXPECT_TRUE(game.balls()[0].hollow);
}

/// N s; the blow that cracks a block whose lowest point, `reach` below its centre, falls 0.5 m to
/// the ground, from 4 m/s on.
kodo::Real blowOfALanding(kodo::Real angle, kodo::Real reach) {
    Game game(columnAboveGround("stone"), 1);
    GameTestAccess::countHit(game);
    kodo::BodyRef block = GameTestAccess::world(game)[game.blocks()[0].body];
    block.setPosition({-8, kodo::Real(4.5) + reach});
    block.setRotation(kodo::Rot::fromAngle(angle));
    block.setVelocity({0, -4});
    for (int i = 0; i < 60; ++i) {
        game.tick({});
        if (const auto* cracked = eventOf<Cracked>(game)) {
            return cracked->impulse;
        }
    }
    return 0;
}

// A strength in N s means the same for a face as for a corner below the centre.
TEST(Damage, OfAFlatLandingIsThatOfACorner) {
    const kodo::Real half = kCellHeight / 2;
    const kodo::Real flat = blowOfALanding(0, half);
    const kodo::Real corner = blowOfALanding(std::numbers::pi_v<kodo::Real> / 4,
                                             half * std::numbers::sqrt2_v<kodo::Real>);
    EXPECT_GT(flat, kSlightestImpact);
    EXPECT_NEAR(corner / flat, 1, 0.02); // gravity in the substeps of the tick counts as well
}

// A beam of steel of 40 m^2 rests on two stones at walls. Its weight is no blow.
TEST(Damage, IsNotDoneByARestingLoad) {
    Game game(levelFrom(R"(format = 1
title = "t"
idea = "i"
[legend.m]
stuff = "stone"
[legend.s]
stuff = "steel"
hold = "standing"
[[block]]
kind = "m"
x = -8500
y = 6000
count = 2
step = [17000, 0]
[[block]]
kind = "s"
shape = "beam"
x = 0
y = 7400
width = 20000
height = 2000
)"),
              1);
    playOn(game, 600);
    EXPECT_EQ(game.blocksLeft(), 2);
    EXPECT_EQ(game.result(), Result::Playing);
}

/// Three blocks fall 4 m to the ground.
Game fallenToGround() {
    Game game(columnAboveGround("stone"), 1);
    playOn(game, 60);
    GameTestAccess::countHit(game);
    for (const std::size_t i : {0u, 1u, 2u}) {
        GameTestAccess::world(game)[game.blocks()[i].body].setVelocity({6, 0});
    }
    return game;
}

TEST(Rubble, StaysOnGroundWhereItHasComeToRest) {
    Game game = fallenToGround();
    playOn(game, 3 * static_cast<int>(kFallenTicks));
    EXPECT_GE(std::count_if(game.blocks().begin(), game.blocks().end(), hasDropped),
              2); // one broke as it landed
}

TEST(Collapse, IsToldAfterTheLastLandingAndOverTheHeap) {
    Game game = fallenToGround();
    std::uint32_t landed = 0; // tick of the last landing
    int landings = 0;
    for (int i = 0; i < 400; ++i) {
        game.tick({});
        for (const Event& event : game.events()) {
            if (const auto* block = std::get_if<Landed>(&event)) {
                landed = game.ticks();
                ++landings;
                EXPECT_GT(block->impulse, 0);
            }
            if (const auto* told = std::get_if<Collapsed>(&event)) {
                EXPECT_EQ(landings, 3);
                EXPECT_GE(game.ticks(), landed);
                EXPECT_LT(told->point.y, 6);
                EXPECT_GT(told->point.x, 5);
                return;
            }
        }
    }
    FAIL() << "no collapse was told";
}

} // namespace
