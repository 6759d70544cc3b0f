// SPDX-License-Identifier: MIT
// Water: what floats, what sinks, what splashes, and what runs out. Blocks that must be kept.
#include <apart/core/tuning.hpp>
#include <apart/core/water.hpp>

#include <game/game_access.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

/// A lake between x = -4 m and 4 m, from y = 8 m to 11 m, on a bed of brick, with `more` tables.
std::string lake(const std::string& more) {
    return R"(format = 1
title = "t"
idea = "i"
[legend.w]
stuff = "wood"
hold = "standing"
[legend.s]
stuff = "stone"
hold = "standing"
[legend.b]
stuff = "brick"
[legend.x]
stuff = "steel"
hold = "standing"
[[block]]
kind = "b"
shape = "beam"
x = 0
y = 7600
width = 8000
height = 800
[[water]]
x = 0
y = 11000
width = 8000
depth = 3000
density = 800
dam = "b"
)" + more;
}

// 1.6 m by 0.8 m of wood displace half their area in this water.
const std::string kRaft = "[[block]]\nkind = \"w\"\nx = 0\ny = 11000\n";
const std::string kStone = "[[block]]\nkind = \"s\"\nx = 2000\ny = 12500\n";

kodo::BodyView bodyOf(const Game& game, std::size_t index) {
    return game.world()[game.blocks()[index].body];
}

TEST(Water, WetPartIsExactAtAllSides) {
    const kodo::Aabb water{{-2, 0}, {2, 3}};
    const kodo::ConvexShape box = kodo::convexShapeOf(kodo::Box{2, 1}, {});
    EXPECT_NEAR(wetPart(box, {{0, 3}, {}}, water).area, 1, 1e-5); // half below the surface
    EXPECT_NEAR(wetPart(box, {{0, 3}, {}}, water).centroid.y, 2.75, 1e-5);
    EXPECT_NEAR(wetPart(box, {{2, 1}, {}}, water).area, 1, 1e-5); // half beyond a side
    EXPECT_NEAR(wetPart(box, {{2, 1}, {}}, water).centroid.x, 1.5, 1e-5);
    EXPECT_NEAR(wetPart(box, {{0, 0}, {}}, water).area, 1, 1e-5); // half below the bottom
    EXPECT_EQ(wetPart(box, {{0, 5}, {}}, water).area, 0);
    EXPECT_EQ(wetPart(box, {{4, 1}, {}}, water).area, 0);
    const kodo::ConvexShape disc = kodo::convexShapeOf(kodo::Circle{Real(0.5)}, {});
    const double whole = std::numbers::pi / 4;
    EXPECT_NEAR(wetPart(disc, {{0, 1}, {}}, water).area, whole, 1e-5);
    EXPECT_NEAR(wetPart(disc, {{0, 3}, {}}, water).area, whole / 2, 1e-5);
    const Real exact = submerged(disc, {{0, Real(3.2)}, {}}, {0, 3}, {0, 1}).area;
    EXPECT_NEAR(wetPart(disc, {{0, Real(3.2)}, {}}, water).area, exact, 0.01 * whole);
}

TEST(Water, ABlockFloatsWhereItDisplacesItsMassAndSleeps) {
    Game game(levelFrom(lake(kRaft)), 1);
    playOn(game, 10 * kTicksPerSecond);
    EXPECT_NEAR(bodyOf(game, 1).position().y, 11, 0.002);
    EXPECT_TRUE(bodyOf(game, 1).isAsleep());
    Game high(levelFrom(lake("[[block]]\nkind = \"w\"\nx = 0\ny = 11300\n")), 1);
    playOn(high, 10 * kTicksPerSecond);
    EXPECT_NEAR(bodyOf(high, 1).position().y, 11, 0.01);
}

TEST(Water, ALoadedRaftFloatsWhereItDisplacesBoth) {
    // 0.512 kg of wood carry 0.256 kg of it: 0.768 / (0.8 1.6) = 0.6 m deep
    Game game(levelFrom(lake("[[block]]\nkind = \"w\"\nx = 0\ny = 10800\n"
                             "[[block]]\nkind = \"w\"\nshape = \"square\"\nx = 0\ny = 11600\n")),
              1);
    playOn(game, 10 * kTicksPerSecond);
    EXPECT_NEAR(bodyOf(game, 1).position().y, 10.8, 0.003);
    EXPECT_TRUE(bodyOf(game, 1).isAsleep());
}

TEST(Water, StoneOfItsDensityIsSlowedAndSplashes) {
    Game game(levelFrom(lake(kStone)), 1);
    const auto splash = playUntil<Splashed>(game, {}, 120);
    ASSERT_TRUE(splash);
    EXPECT_NEAR(splash->point.y, 11, 1e-5);
    EXPECT_LT(splash->speed, -4); // after a fall of 1.5 m
    EXPECT_NEAR(splash->mass, 0.8 * 1.28, 1e-4);
    const Real speed = -bodyOf(game, 1).velocity().y;
    playOn(game, kTicksPerSecond);
    EXPECT_LT(-bodyOf(game, 1).velocity().y, speed / 2);
}

TEST(Water, RunsOutThroughABrokenDamAndTakesTheRaftAlong) {
    Game game(levelFrom(lake(kRaft)), 1);
    playOn(game, 60);
    GameTestAccess::shoot(game, {1, 6}, {0, 20});
    ASSERT_TRUE(playUntil<Breached>(game, {}, 30));
    EXPECT_TRUE(game.waters()[0].open);
    const std::uint64_t hash = game.stateHash();
    Game copy = game;
    playOn(game, 4 * kTicksPerSecond);
    playOn(copy, 4 * kTicksPerSecond);
    EXPECT_EQ(copy.stateHash(), game.stateHash());
    EXPECT_NE(game.stateHash(), hash);
    EXPECT_TRUE(game.waters()[0].isEmpty());
    EXPECT_EQ(game.result(), Result::Won); // the raft has left its place
}

TEST(Water, StaysWithoutADam) {
    const std::string text = lake(kRaft);
    std::string closed = text;
    closed.erase(closed.find("dam = \"b\"\n"), 10);
    Game game(levelFrom(closed), 1);
    GameTestAccess::shoot(game, {1, 6}, {0, 20});
    ASSERT_TRUE(playUntil<Broke>(game, {}, 30));
    playOn(game, 120);
    EXPECT_FALSE(game.waters()[0].open);
    EXPECT_NE(digestOf(levelFrom(closed)), digestOf(levelFrom(text)));
}

// Each part of a disc is slowed by its own speed, so its spin falls as its speed does: by 1/e in
// density / drag. The drag is explicit: 240 steps of a second are 0.3 % below the exponential.
TEST(Water, ADiscLosesItsSpinAsItsSpeed) {
    kodo::World world; // without gravity; the water lifts nothing
    const Pool::Fluid still{0, kWaterDrag, {}};
    world.addField({std::make_shared<Pool>(still, kodo::Aabb{{-9, -9}, {9, 9}})});
    const kodo::BodyId disc = world.add(
        {.shape = kodo::Circle{Real(0.5)}, .velocity = {2, 0}, .angularVelocity = 4, .density = 1});
    for (int step = 0; step < 240; ++step) {
        world.step(Real(1) / 240);
    }
    const Real left = std::exp(-kWaterDrag); // of both after a second
    EXPECT_NEAR(world[disc].velocity().x / 2, left, Real(0.01) * left);
    EXPECT_NEAR(world[disc].angularVelocity() / 4, left, Real(0.01) * left);
}

TEST(Water, BallsFlyThroughIt) {
    const Level wet = levelFrom(lake(kRaft));
    Level dry = wet;
    dry.waters.clear();
    const auto placeAfter = [](const Level& level) {
        Game game(level, 1);
        Input launch;
        launch.launch = true;
        game.tick(launch);
        const kodo::BodyId ball = GameTestAccess::shoot(game, {-6, 10}, {12, 0});
        playOn(game, 20);
        return game.world()[ball].position();
    };
    EXPECT_EQ(placeAfter(wet), placeAfter(dry));
}

TEST(Water, IsRefusedByLineIfInvalid) {
    const auto problem = [](const std::string& before, const std::string& after) {
        std::string text = lake(kRaft);
        text.replace(text.find(before), before.size(), after);
        const Read<Level> level = parseLevel(text, "test", "test.toml");
        const auto* found = std::get_if<FileProblem>(&level);
        return found == nullptr ? std::string("none") : found->text();
    };
    EXPECT_EQ(problem("dam = \"b\"", "dam = \"x\""),
              "test.toml:28: water.dam must be the letter of a block in the legend that can break");
    EXPECT_EQ(problem("depth = 3000\n", ""), "test.toml:22: the key depth is missing");
    EXPECT_EQ(problem("density = 800", "density = 0"),
              "test.toml:27: density must be a whole number from 1 to 10000");
    EXPECT_EQ(problem("dam =", "damm ="), "test.toml:28: unknown key water.damm");
    EXPECT_EQ(problem("title", "keep = \"roof\"\ntitle"),
              "test.toml:2: there is no block named roof");
}

TEST(Kept, ABlockOfSteelStandsUntilItFalls) {
    const std::string idol = "[[block]]\nkind = \"x\"\nname = \"idol\"\nx = 6000\ny = 9000\n"
                             "[[ledge]]\nx = 6000\ny = 8400\nwidth = 2000\n";
    std::string text = lake(kRaft + idol);
    text.replace(text.find("title"), 5, "keep = \"idol\"\ntitle");
    Game game(levelFrom(text), 1);
    EXPECT_EQ(game.level().keepName, "idol");
    playOn(game, 60);
    EXPECT_TRUE(game.state().keeps());
    GameTestAccess::world(game)[game.blocks()[2].body].setVelocity({8, 0});
    playOn(game, 120);
    EXPECT_FALSE(game.state().keeps());
    EXPECT_FALSE(Game(levelFrom(lake(kRaft)), 1).state().keeps()) << "a level without one";
    text.replace(text.find("keep = \"idol\""), 13, "keep = \"roof\"");
    EXPECT_TRUE(std::holds_alternative<FileProblem>(parseLevel(text, "test", "test.toml")));
}

} // namespace
