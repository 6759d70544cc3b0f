// SPDX-License-Identifier: MIT
// Crowds in fast motion, or in deep overlap at the start.
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::SceneDef;
using scenes::Vec2;

/// A floor between two walls, around x = 0.
SceneDef yard(const char* name, double width) {
    constexpr double kHigh = 30; // m
    return {name,
            scenes::kDown,
            {scenes::ground(width + 2), wall(1, kHigh, {-(width + 1) / 2, kHigh / 2}),
             wall(1, kHigh, {(width + 1) / 2, kHigh / 2})}};
}

/// Places (m) of a square grid, the nearest to the origin first.
std::vector<Vec2> placesAround(int count, double pitch) {
    const int reach = static_cast<int>(std::sqrt(static_cast<double>(count))) + 1;
    std::vector<Vec2> places;
    for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
            places.push_back({pitch * x, pitch * y});
        }
    }
    std::stable_sort(places.begin(), places.end(),
                     [](Vec2 one, Vec2 other) { return dot(one, one) < dot(other, other); });
    places.resize(static_cast<std::size_t>(count));
    return places;
}

} // namespace

/// Every ten steps, each body gets 40 m/s in a random direction.
Scene ring(int size, std::uint64_t seed) {
    constexpr double kSpeed = 40; // m/s
    const double radius = 10 * stretch(size, 400);
    Scene scene;
    scene.def = {"ring", {}, ringOfWalls(radius)};
    const std::size_t first = scene.def.bodies.size();
    for (const Vec2 place : placesAround(size, 0.7)) {
        const bool even = scene.def.bodies.size() % 2 == 0;
        scene.def.bodies.push_back(even ? scenes::ball(0.2, place)
                                        : scenes::box(0.35, 0.35, place));
    }
    const auto dice = std::make_shared<Dice>(seed);
    scene.every = 10;
    scene.act = [=](Stage& stage, int) {
        for (std::size_t body = first; body < stage.placeOfNext(); ++body) {
            stage.engine().push(body, kSpeed * scenes::direction(dice->between(0, 1)));
        }
    };
    scene.region = Region{{-radius - 1, -radius - 1}, {radius + 1, radius + 1}};
    scene.error = {"bodies outside", "bodies", [=](const Stage& stage, const Depths&) {
                       double outside = 0;
                       for (const Placed& one : stage.bodies()) {
                           const Vec2 at = one.state.position;
                           outside += !one.def->locked && dot(at, at) > radius * radius ? 1 : 0;
                       }
                       return outside;
                   }};
    return scene;
}

/// Pieces start side by side and fly apart, the outer ones faster.
Scene shards(int size, std::uint64_t seed) {
    constexpr double kRate = 5; // m/s per metre from the middle
    Dice dice(seed);
    Scene scene;
    scene.def = yard("shards", 40);
    for (const Vec2 place : placesAround(size, 0.25)) {
        BodyDef body;
        body.parts = {shard(dice, dice.between(0.08, 0.12))};
        body.position = place + Vec2{0, 5};
        body.velocity = kRate * place;
        body.spin = dice.between(-10, 10);
        scene.def.bodies.push_back(body);
    }
    constexpr double kMargin = 0.2; // m: the origin of a polygon may lie outside of it
    scene.region = Region{{-20 - kMargin, -kMargin}, {20 + kMargin, 100}};
    scene.error = meanDepth();
    return scene;
}

Scene sparks(int size, std::uint64_t) {
    constexpr double kRate = 2; // m/s per metre from the middle
    Scene scene;
    scene.def = {"sparks", scenes::kDown, {}};
    for (const Vec2 place : placesAround(size, 0.25)) {
        scene.def.bodies.push_back(scenes::ball(0.05, place));
        scene.def.bodies.back().velocity = kRate * place;
    }
    scene.error = meanDepth();
    return scene;
}

/// The ball has the mass of 250 boxes.
Scene smash(int size, std::uint64_t) {
    constexpr int kColumns = 20;
    constexpr double kWidth = 0.5; // m, of a box
    Scene scene;
    scene.def = yard("smash", 100);
    for (int i = 0; i < size; ++i) {
        scene.def.bodies.push_back(
            scenes::box(kWidth, kWidth, {kWidth * (i % kColumns), kWidth * (0.5 + i / kColumns)}));
    }
    BodyDef ball = scenes::ball(1, {-15, 4});
    ball.density = 20;
    ball.velocity = {40, 0};
    scene.def.bodies.push_back(ball);
    scene.region = Region{{-50, 0}, {50, 100}};
    scene.error = meanDepth();
    return scene;
}

/// All boxes have the same pose at the start, so no direction of separation is better than others.
Scene crowdPoint(int size, std::uint64_t) {
    Scene scene;
    scene.def = yard("crowdpoint", 60);
    for (int i = 0; i < size; ++i) {
        scene.def.bodies.push_back(scenes::box(0.5, 0.5, {0, 3}));
    }
    scene.region = Region{{-30, 0}, {30, 100}};
    scene.error = meanDepth();
    return scene;
}

} // namespace bench
