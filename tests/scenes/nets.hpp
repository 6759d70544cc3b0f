// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

namespace scenes {

/// Adds a square net of bodies 1 m apart. Revolute joints connect each body to its neighbours at
/// the midpoints, so the meshes form loops. `corner` is the position of the top left body. Returns
/// the index of that body; the others follow row by row.
inline std::size_t addNet(SceneDef& scene, int side, const BodyDef& knot, Vec2 corner) {
    const std::size_t first = scene.bodies.size();
    for (int i = 0; i < side * side; ++i) {
        const int column = i % side;
        const int row = i / side;
        BodyDef body = knot;
        body.position = corner + Vec2{static_cast<double>(column), -static_cast<double>(row)};
        const std::size_t place = scene.bodies.size();
        scene.bodies.push_back(body);
        if (column > 0) {
            scene.joints.push_back({place - 1, place, body.position + Vec2{-0.5, 0}});
        }
        if (row > 0) {
            const std::size_t above = place - static_cast<std::size_t>(side);
            scene.joints.push_back({above, place, body.position + Vec2{0, 0.5}});
        }
    }
    return first;
}

/// Revolute joints in all configurations: a hanging net hit by boxes, a swinging chain, a
/// motor-driven bar, and a loose net falling to the ground.
inline SceneDef nets() {
    SceneDef scene{"nets", kDown, {ground(60)}};
    const std::size_t hung = addNet(scene, 9, ball(0.4, {}), {-4, 14});
    scene.bodies[hung].locked = true;
    scene.bodies[hung + 8].locked = true;
    addNet(scene, 5, box(0.8, 0.3, {}), {8, 9});
    for (int i = 0; i < 6; ++i) {
        scene.bodies.push_back(box(0.7, 0.5, {-2.0 + 0.8 * i, 16.0 + i}));
    }
    std::size_t last = scene.bodies.size();
    BodyDef post = box(0.5, 0.5, {-16, 12});
    post.locked = true;
    scene.bodies.push_back(post);
    for (int i = 1; i <= 8; ++i) {
        const double x = -16.0 + i;
        scene.joints.push_back({last, scene.bodies.size(), {x - 0.5, 12}});
        last = scene.bodies.size();
        scene.bodies.push_back(box(0.9, 0.2, {x, 12}));
    }
    scene.joints.push_back({0, scene.bodies.size(), {4, 2}, 3, 400});
    scene.bodies.push_back(box(3.5, 0.3, {4, 2}));
    return scene;
}

} // namespace scenes
