// SPDX-License-Identifier: MIT
// Scenes with motors or permanent motion, and the two smallest worlds.
#include <scenes/nets.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::Material;
using scenes::Vec2;

constexpr std::uint16_t kWall = 1;
constexpr std::uint16_t kBall = 2;
constexpr std::uint16_t kShard = 4;

/// A ball, box or polygon of the same size.
BodyDef drop(Dice& dice, std::size_t kind, double radius) {
    BodyDef body;
    if (kind % 3 == 0) {
        body.parts = {scenes::Circle{radius}};
    } else if (kind % 3 == 1) {
        body.parts = {scenes::Box{1.6 * radius, 1.6 * radius}};
    } else {
        body.parts = {shard(dice, radius)};
    }
    body.rotation = scenes::turnedBy(dice.between(-1, 1));
    return body;
}

/// Rows of sloping roofs, 10 m apart.
std::vector<BodyDef> roofs(double width) {
    std::vector<BodyDef> list;
    for (int row = 0; row < 3; ++row) {
        for (double x = -width / 2 + 5; x < width / 2; x += 10) {
            BodyDef roof = wall(7, 0.4, {x, 10.0 * row});
            roof.rotation = scenes::turnedBy(row % 2 == 0 ? 0.15 : -0.15);
            list.push_back(roof);
        }
    }
    return list;
}

/// Ten static boxes around a room of 12 by 9 m.
std::vector<BodyDef> tenWalls(Material material) {
    std::vector<BodyDef> walls;
    for (const double y : {-0.5, 9.5}) {
        for (const double x : {2.0, 6.0, 10.0}) {
            walls.push_back(wall(4, 1, {x, y}, material));
        }
    }
    for (const double x : {-0.5, 12.5}) {
        for (const double y : {2.0, 6.5}) {
            walls.push_back(wall(1, y == 2.0 ? 4 : 5, {x, y}, material));
        }
    }
    return walls;
}

/// 20 columns and 15 rows of blocks in a room of 41 by 42 m.
std::vector<BodyDef> breakoutRoom(Material material) {
    std::vector<BodyDef> room{wall(43, 1, {20.5, -0.5}, material),
                              wall(43, 1, {20.5, 42.5}, material),
                              wall(1, 42, {-0.5, 21}, material), wall(1, 42, {41.5, 21}, material)};
    for (int i = 0; i < 300; ++i) {
        room.push_back(wall(1.6, 0.8, {1.5 + 2 * (i % 20), 20 + 1.2 * (i / 20)}, material));
    }
    for (BodyDef& body : room) {
        body.category = kWall;
    }
    return room;
}

} // namespace

Scene tumbler(int size, std::uint64_t) {
    const double width = 20 * stretch(size, 2000);
    Scene scene;
    scene.def = {"tumbler", scenes::kDown, {}};
    BodyDef drum;
    drum.locked = true;
    drum.spin = 0.43633231299858238; // 25 degrees per second
    const double side = width / 2 + 0.5;
    drum.parts = {scenes::Box{width + 2, 1, {0, -side}}, scenes::Box{width + 2, 1, {0, side}},
                  scenes::Box{1, width, {-side, 0}}, scenes::Box{1, width, {side, 0}}};
    scene.def.bodies.push_back(drum);
    const int columns = static_cast<int>(0.9 * width / 0.4);
    const int rows = (size + columns - 1) / columns;
    for (int i = 0; i < size; ++i) {
        const Vec2 place{0.4 * (i % columns - 0.5 * (columns - 1)),
                         0.4 * (i / columns - 0.5 * (rows - 1))};
        scene.def.bodies.push_back(scenes::box(0.25, 0.25, place));
    }
    scene.region = Region{{-width / 2, -width / 2}, {width / 2, width / 2}, 0};
    scene.error = meanDepth();
    return scene;
}

Scene breakout(int size, std::uint64_t seed) {
    Dice dice(seed);
    Scene scene;
    scene.def = {"breakout", scenes::kDown, breakoutRoom({0.6, 1})};
    std::vector<std::size_t> balls;
    for (int i = 0; i < 8; ++i) {
        BodyDef ball = scenes::ball(0.3, {3.0 + 5 * i, 5}, {0, 1});
        ball.weightless = true;
        ball.velocity = 25.0 * (scenes::turnedBy(dice.between(-0.4, 0.4)) * Vec2{0, 1});
        ball.category = kBall;
        ball.mask = kWall | kBall;
        balls.push_back(scene.def.bodies.size());
        scene.def.bodies.push_back(ball);
    }
    const std::size_t firstShard = scene.def.bodies.size();
    for (int i = 0; i < size; ++i) {
        BodyDef body;
        body.parts = {shard(dice, dice.between(0.10, 0.18))};
        body.position = {0.5 + dice.between(0, 40), 1 + 40.0 * i / size};
        body.category = kShard;
        body.mask = kWall | kShard;
        scene.def.bodies.push_back(body);
    }
    scene.every = 10;
    scene.act = [=](Stage& stage, int) { // shards re-enter at the top
        for (int i = 0; i < size; ++i) {
            const std::size_t body = firstShard + static_cast<std::size_t>(i);
            const Vec2 at = stage.engine().state(body).position;
            if (at.y < 1) {
                stage.engine().place(body, {at.x, 41.5});
            }
        }
    };
    scene.region = Region{{0, 0}, {41, 42}};
    scene.error = speedLost(balls, 25);
    return scene;
}

Scene rain(int size, std::uint64_t seed) {
    constexpr int kEvery = 4;  // steps between two rows of drops
    constexpr int kLife = 200; // steps
    const int row = std::max(1, size * kEvery / kLife);
    const double width = 2.0 * row;
    Scene scene;
    scene.def = {"rain", scenes::kDown, roofs(width)};
    scene.every = kEvery;
    scene.warmUp = kLife;
    scene.actIsTimed = true;
    const auto oldest = std::make_shared<std::size_t>(scene.def.bodies.size());
    const auto dice = std::make_shared<Dice>(seed);
    scene.act = [=](Stage& stage, int) {
        for (int i = 0; i < row; ++i) {
            BodyDef body = drop(*dice, dice->below(3), 0.25);
            body.position = {1 + 2.0 * i - width / 2 + dice->between(-0.5, 0.5), 35};
            body.velocity = {0, -5};
            stage.add(body);
        }
        while (stage.placeOfNext() - *oldest > static_cast<std::size_t>(row * (kLife / kEvery))) {
            stage.remove((*oldest)++);
        }
    };
    scene.error = meanDepth();
    return scene;
}

Scene joints(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"joints", scenes::kDown, {}};
    BodyDef knot = scenes::ball(0.4, {});
    knot.category = kBall;
    knot.mask = kWall; // which does not exist here
    scenes::addNet(scene.def, size, knot, {});
    for (int column = std::max(0, size / 2 - 3); column <= std::min(size - 1, size / 2 + 3);
         ++column) {
        scene.def.bodies[static_cast<std::size_t>(column)].locked = true;
    }
    scene.error = widestJoint(scene.def);
    return scene;
}

Scene spinner(int size, std::uint64_t seed) {
    Dice dice(seed);
    const double radius = 20 * stretch(size, 1000);
    Scene scene;
    scene.def = {"spinner", scenes::kDown, ringOfWalls(radius)};
    const std::size_t bar = scene.def.bodies.size();
    scene.def.bodies.push_back(scenes::box(1.5 * radius, 0.5, {}));
    scene.def.joints = {{0, bar, {}, 2, 1e6}};
    const double pitch = 0.85;
    const int columns = static_cast<int>(1.3 * radius / pitch);
    for (int i = 0; i < size; ++i) { // half of them above the bar, half below
        const int row = i / (2 * columns);
        const double side = i / columns % 2 == 0 ? 1 : -1;
        BodyDef body = drop(dice, static_cast<std::size_t>(i), 0.35);
        body.position = {pitch * (i % columns - 0.5 * (columns - 1)), side * (0.8 + pitch * row)};
        scene.def.bodies.push_back(body);
    }
    scene.region = Region{{-radius - 1, -radius - 1}, {radius + 1, radius + 1}};
    scene.error = meanDepth();
    return scene;
}

Scene empty(int, std::uint64_t) {
    Scene scene;
    scene.def = {"empty", scenes::kDown, {}};
    scene.warmUp = 10;
    return scene;
}

Scene smallRoom(int, std::uint64_t) {
    const Material material{0, 1};
    Scene scene;
    scene.def = {"smallroom", {}, tenWalls(material)};
    BodyDef ball = scenes::ball(0.3, {4, 3}, material);
    ball.velocity = 10.0 * (scenes::turnedBy(0.3) * Vec2{1, 0});
    scene.def.bodies.push_back(ball);
    scene.warmUp = 10;
    scene.region = Region{{0, 0}, {12, 9}};
    scene.error = speedLost({10}, 10);
    return scene;
}

} // namespace bench
