// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

namespace scenes {

/// Body 1, a box of 1 by 0.5 m, slides on flat ground with an initial speed of 5 m/s.
inline SceneDef slidingBox(double friction) {
    SceneDef scene{"sliding box", kDown, {}};
    const Material material{friction, 0};
    scene.bodies = {ground(40, material), box(1, 0.5, {0, 0.25}, material)};
    scene.bodies[1].velocity = {5, 0};
    return scene;
}

/// Body 1, a box of 1 by 0.5 m, on a slope of 3 over 4. It sticks at friction 0.75 and above.
inline SceneDef boxOnSlope(double friction) {
    SceneDef scene{"box on a slope", kDown, {}};
    const Material material{friction, 0};
    const Rot hill = slope(3, 4);
    scene.bodies = {ground(80, material, hill), box(1, 0.5, hill * Vec2{0, 0.25}, material)};
    scene.bodies[1].rotation = hill;
    return scene;
}

/// Body 1, a ball of radius 0.5 m, rolls down a slope of 5 over 12 from rest.
inline SceneDef ballDownSlope() {
    SceneDef scene{"ball rolls down a slope", kDown, {}};
    const Material material{0.6, 0};
    const Rot hill = slope(5, 12);
    scene.bodies = {ground(80, material, hill), ball(0.5, hill * Vec2{0, 0.5}, material)};
    return scene;
}

/// A slope with ten bodies, 2 m apart: boxes of increasing friction, then balls.
inline SceneDef incline() {
    SceneDef scene{"incline", kDown, {}};
    const Rot hill = slope(3, 4);
    scene.bodies = {ground(80, {1, 0}, hill)};
    for (int i = 0; i < 10; ++i) {
        const Material material{0.1 * i, 0};
        const Vec2 place = hill * Vec2{2.0 * i - 9, 0.25};
        scene.bodies.push_back(i % 3 == 2 ? ball(0.25, place, material)
                                          : box(0.5, 0.5, place, material));
        scene.bodies.back().rotation = hill;
    }
    return scene;
}

} // namespace scenes
