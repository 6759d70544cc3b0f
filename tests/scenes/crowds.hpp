// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

namespace scenes {

/// Four walls around a room with its lower left corner at the origin: bodies 0 to 3.
inline std::vector<BodyDef> room(double width, double height, Material material) {
    std::vector<BodyDef> walls{box(width + 2, 1, {width / 2, -0.5}, material),
                               box(width + 2, 1, {width / 2, height + 0.5}, material),
                               box(1, height, {-0.5, height / 2}, material),
                               box(1, height, {width + 0.5, height / 2}, material)};
    for (BodyDef& wall : walls) {
        wall.locked = true;
    }
    return walls;
}

/// 50 balls of radius 0.25 m in a room of 10 by 10 m, frictionless, with restitution 1. Speeds up
/// to 5 m/s per axis.
inline SceneDef elasticGas() {
    const Material material{0, 1};
    SceneDef scene{"elastic gas", {}, room(10, 10, material)};
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        BodyDef def = ball(0.25, {0.9 + 1.1 * (i % 8), 0.9 + 1.1 * (i / 8)}, material);
        def.velocity = {dice.between(-5, 5), dice.between(-5, 5)};
        scene.bodies.push_back(def);
    }
    return scene;
}

/// Six balls at 40 m/s in a room of 12 by 9 m, with one wall of static blocks and one of dynamic
/// blocks.
inline SceneDef fastBalls() {
    const Material material{0.2, 1};
    SceneDef scene{"fast balls", {}, room(12, 9, material)};
    for (int i = 0; i < 16; ++i) {
        BodyDef block = box(1, 0.5, {2 + 1.1 * (i % 8), 7 - 1.5 * (i / 8)}, {0.2, 0.5});
        block.locked = i < 8;
        scene.bodies.push_back(block);
    }
    for (int i = 0; i < 6; ++i) {
        BodyDef def = ball(0.15, {1.5 + 1.8 * i, 1.5}, material);
        def.velocity = 40.0 * (turnedBy(0.2 + 0.1 * i) * Vec2{0, 1});
        scene.bodies.push_back(def);
    }
    return scene;
}

} // namespace scenes
