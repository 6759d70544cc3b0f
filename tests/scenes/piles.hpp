// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

namespace scenes {

/// A stack of unit boxes on the ground: bodies 1 to `count`, from below.
inline SceneDef stack(int count) {
    SceneDef scene{"stack", kDown, {ground(20)}};
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(box(1, 1, {0, 0.5 + i}));
    }
    return scene;
}

/// A pyramid of unit boxes with gaps of 0.1 m in a row; order from below and from the left.
inline SceneDef pyramid(int rows) {
    SceneDef scene{"pyramid", kDown, {ground(60)}};
    for (int row = 0; row < rows; ++row) {
        for (int i = row; i < rows; ++i) {
            const double x = 1.1 * (i - 0.5 * (row + rows - 1));
            scene.bodies.push_back(box(1, 1, {x, 0.5 + row}));
        }
    }
    return scene;
}

/// Body 2 rests on body 1 and has `ratio` times its density. Both are unit boxes.
inline SceneDef heavyOnLight(double ratio) {
    SceneDef scene = stack(2);
    scene.name = "heavy box on light box";
    scene.bodies[2].density = ratio;
    return scene;
}

/// Bodies 1 to `count`: dominoes of 0.2 by 1 m, 0.6 m apart. The first one is tipping over.
inline SceneDef dominoRow(int count) {
    SceneDef scene{"domino row", kDown, {ground(40, {0.5, 0})}};
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(box(0.2, 1, {0.6 * i, 0.5}, {0.5, 0}));
    }
    // Velocity of the centre for a rotation about the bottom edge, 0.5 m below.
    scene.bodies[1].velocity = {1, 0};
    scene.bodies[1].spin = -2;
    return scene;
}

/// Polygons with 3 to 8 corners, random in shape and position, falling between two walls.
inline SceneDef pile(int count) {
    SceneDef scene{"pile", kDown, {ground(20)}};
    for (const double x : {-4.0, 4.0}) {
        scene.bodies.push_back(box(1, 20, {x, 10}));
        scene.bodies.back().locked = true;
    }
    Dice dice(1);
    for (int i = 0; i < count; ++i) {
        BodyDef def;
        const std::size_t corners = 3 + dice.below(6);
        const double width = dice.between(0.5, 1);
        def.parts = {randomPolygon(dice, corners, width, dice.between(0.5, 1))};
        const double x = -2.4 + 1.2 * (i % 5) + dice.between(-0.1, 0.1);
        def.position = {x, 1 + 1.2 * (i / 5)};
        def.rotation = turnedBy(dice.between(-1, 1));
        def.material = {dice.between(0.2, 0.8), 0};
        scene.bodies.push_back(def);
    }
    return scene;
}

} // namespace scenes
