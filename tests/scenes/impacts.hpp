// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

namespace scenes {

/// Two balls of radius 0.5 m on the x axis, with a gap of 2 m, flying towards each other.
inline SceneDef headOnBalls(double speed, double densityRatio, double restitution) {
    SceneDef scene{"head-on balls", {}, {}};
    const Material material{0.6, restitution};
    scene.bodies = {ball(0.5, {-1.5, 0}, material), ball(0.5, {1.5, 0}, material)};
    scene.bodies[0].velocity = {speed, 0};
    scene.bodies[1].velocity = {-speed, 0};
    scene.bodies[1].density = densityRatio;
    return scene;
}

/// Body 0, a ball of radius 0.25 m, flies up at 3 m/s and hits body 1 without friction. Body 1 is a
/// dynamic bar of 2 by 0.5 m, lower side at y = 0. The hit is `offset` (m) right of its centre.
inline SceneDef ballOnBoxOffCentre(double offset, double restitution) {
    SceneDef scene{"ball on box off-centre", {}, {}};
    const Material material{0, restitution};
    scene.bodies = {ball(0.25, {offset, -1.25}, material), box(2, 0.5, {0, 0.25}, material)};
    scene.bodies[0].velocity = {0, 3};
    return scene;
}

/// Body 1, a unit box rotated by 53 degrees, falls on its corner from a height of 1 m.
inline SceneDef boxOnItsCorner(double restitution = 0) {
    SceneDef scene{"box dropped on its corner", kDown, {}};
    const Material material{0.6, restitution};
    const Rot turn = slope(4, 3);
    const Vec2 corner = turn * Vec2{-0.5, -0.5};
    scene.bodies = {ground(40, material), box(1, 1, {0, 1 - corner.y}, material)};
    scene.bodies[1].rotation = turn;
    return scene;
}

/// Body 1, a ball of radius 0.5 m, falls 5 m onto the ground.
inline SceneDef bouncingBall(double restitution) {
    SceneDef scene{"bouncing ball", kDown, {}};
    const Material material{0.6, restitution};
    scene.bodies = {ground(20, material), ball(0.5, {0, 5.5}, material)};
    return scene;
}

/// Body 1, an L of two boxes (2 by 0.5 m lying, 0.5 by 1 m on its left end), falls from 0.5 m.
/// Rotated by 17 degrees, it lands on its right end first.
inline SceneDef compoundDropped() {
    SceneDef scene{"two-box compound dropped", kDown, {}};
    BodyDef angle;
    angle.parts = {Box{2, 0.5, {0, 0}}, Box{0.5, 1, {-0.75, 0.75}}};
    angle.rotation = turnedBy(-0.15);
    angle.position = {0, 1.3};
    scene.bodies = {ground(20), angle};
    return scene;
}

/// Body 0, a ball of radius 0.2 m, falls through three rows of round pins: bodies 1 to 15.
inline SceneDef ballThroughPins() {
    SceneDef scene{"ball through pins", kDown, {}};
    const Material material{0.3, 0.6};
    scene.bodies = {ball(0.2, {0.15, 3}, material)};
    for (int row = 0; row < 3; ++row) {
        for (int column = -2; column <= 2; ++column) {
            const double x = column + (row % 2 == 0 ? 0 : 0.5);
            BodyDef pin = ball(0.15, {x, -1.0 * row}, material);
            pin.locked = true;
            scene.bodies.push_back(pin);
        }
    }
    return scene;
}

/// Body 0, a bar of 4 by 0.2 m, spins at 2 rad/s about its centre and hits body 1. Body 1 is a ball
/// of radius 0.25 m at rest at (1.5, 1). Frictionless, restitution 1.
inline SceneDef spinningBarHitsBall() {
    SceneDef scene{"spinning bar hits ball", {}, {}};
    const Material material{0, 1};
    scene.bodies = {box(4, 0.2, {0, 0}, material), ball(0.25, {1.5, 1}, material)};
    scene.bodies[0].spin = 2;
    return scene;
}

} // namespace scenes
