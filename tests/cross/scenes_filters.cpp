// SPDX-License-Identifier: MIT
// Flags, filters, sensors and records by part.
#include <scenes/impacts.hpp>

#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Vec2;

const char* const kSlop = "Box2D's slop is 5 mm";

/// Body 1 is a shelf that only category 2 stands on; bodies 2 and 3 fall on it.
CrossScene masks() {
    CrossScene scene{"MasksLetOneBallPassTheShelf",
                     "Two balls fall on a shelf that stops one",
                     "Ball 2 accepts ground and shelf, ball 3 the ground alone: it falls through "
                     "the shelf. They do not collide with each other either.",
                     "",
                     {"masks", scenes::kDown, {scenes::ground(20)}}};
    scenes::BodyDef shelf = scenes::box(4, 0.4, {0, 1.8});
    shelf.locked = true;
    scene.def.bodies.push_back(shelf);
    scene.def.bodies.push_back(scenes::ball(0.4, {-0.3, 4}));
    scene.def.bodies.push_back(scenes::ball(0.4, {0.3, 4}));
    const std::uint16_t categories[] = {1, 2, 4, 8};
    const std::uint16_t masks[] = {0, 0, 3, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        scene.def.bodies[i].category = categories[i];
        scene.def.bodies[i].mask = masks[i];
    }
    scene.drawn = {2, 3};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        double wrong = 0;
        for (int i = 0; i < 180; ++i) {
            engine.step(kDt);
            wrong += engine.touching(2, 3) || engine.touching(1, 3) ? 1 : 0;
        }
        return {engine.state(2).position.y, engine.state(3).position.y, meanForce(engine, 1, 2),
                meanForce(engine, 0, 3), wrong};
    };
    const double weight = 10 * massOf(scene.def.bodies[2]).mass;
    figure(scene, "height of the ball on the shelf", "m").exact(2.4, 0.01, kSlop);
    figure(scene, "height of the other ball", "m").exact(0.4, 0.01, kSlop);
    figure(scene, "force on the shelf", "N").exact(weight, 0.01, "0.2 % of the weight");
    figure(scene, "force on the ground", "N").exact(weight, 0.01, "0.2 % of the weight");
    figure(scene, "steps with a filtered touch", "").exact(0, 0, "a count");
    return scene;
}

CrossScene sensor() {
    CrossScene scene{"SensorSeesABallThatItDoesNotStop",
                     "A ball flies through a sensor",
                     "A ball of 0.4 m at 3 m/s passes a sensor of 1 m: it touches for 1.8 / 3 = "
                     "0.6 s from 0.367 s on, and keeps its velocity.",
                     "",
                     {"sensor", {}, {}}};
    scene.def.bodies = {scenes::box(1, 2, {0, 0}), scenes::ball(0.4, {-2, 0})};
    scene.def.bodies[0].locked = true;
    scene.def.bodies[0].sensor = true;
    scene.def.bodies[1].velocity = {3, 0};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        double begin = -1;
        double end = -1;
        double impulse = 0;
        for (int i = 1; i <= 120; ++i) {
            engine.step(kDt);
            const bool touches = engine.touching(0, 1);
            begin = touches && begin < 0 ? i * kDt : begin;
            end = touches ? i * kDt : end;
            impulse += engine.impulse(0, 1);
        }
        return {begin, end, impulse, engine.state(1).velocity.x};
    };
    const char* const step = "two steps: sensors look at the start of a step";
    figure(scene, "begin", "s").exact(1.1 / 3, 2 * kDt, step);
    figure(scene, "end", "s").exact(2.9 / 3, 2 * kDt, step);
    figure(scene, "impulse", "N s").exact(0, 0, "a sensor has none");
    figure(scene, "velocity after", "m/s").exact(3, 1e-6, "rounding");
    return scene;
}

CrossScene upright() {
    CrossScene scene{"LockedRotationLandsOnItsCorner", "A box that cannot turn lands on its corner",
                     "It neither tips nor turns: it rests on its corner. The impulse of the "
                     "landing is m v = 4.472 N s.",
                     "", scenes::boxOnItsCorner()};
    scene.def.bodies[1].upright = true;
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        run(engine, 2);
        const State end = engine.state(1);
        return {hit.time,       hit.impulse,    end.angle,
                end.position.x, end.position.y, meanForce(engine, 0, 1)};
    };
    const double angle = std::atan2(4, 3);
    const double height = 1 - 1 + std::sqrt(0.5) * std::sin(angle + kPi / 4);
    figure(scene, "first hit", "s").exact(std::sqrt(0.2), 2 * kDt, "two steps");
    figure(scene, "impulse of three steps", "N s")
        .exact(std::sqrt(20.0), 0.6, "up to three and a half steps of gravity, 0.58 N s");
    figure(scene, "angle", "rad").exact(angle, 1e-6, "rounding");
    figure(scene, "place", "m").exact(0, 1e-5, "rounding");
    figure(scene, "height", "m").exact(height, 0.01, "slop, and corners rounded by 4 mm in Box2D");
    figure(scene, "force on the ground", "N").exact(10, 0.01, "0.1 % of the weight");
    return scene;
}

CrossScene weightless() {
    CrossScene scene{"WeightlessBodyStaysUntilItIsHit",
                     "A ball falls on a body without weight",
                     "Body 0 has no weight and stays at its place. An equal ball falls 1 m on it "
                     "with e = 1 and hands its velocity over.",
                     "One step of gravity more acts in Box2D before the bounce.",
                     {"weightless", scenes::kDown, {}}};
    scene.def.bodies = {scenes::ball(0.5, {0, 0}, {0, 1}), scenes::ball(0.5, {0, 2}, {0, 1})};
    scene.def.bodies[0].weightless = true;
    scene.drawn = {0, 1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 0.4);
        const double before = engine.state(0).position.y;
        const Hit hit = runToHit(engine, 0, 1, 2);
        const double v = engine.state(0).velocity.y;
        run(engine, 0.5);
        return {before, 0.4 + hit.time, hit.impulse, v, engine.state(0).velocity.y};
    };
    const double mass = massOf(scene.def.bodies[0]).mass;
    const double v = std::sqrt(20.0);
    const char* const gravity = "a step and a half of gravity before the impact, 0.25 m/s";
    figure(scene, "place before the hit", "m").exact(0, 0, "nothing acts on it");
    figure(scene, "first hit", "s").exact(std::sqrt(0.2), 2 * kDt, "two steps");
    figure(scene, "impulse", "N s").exact(mass * v, mass * 0.25, gravity);
    figure(scene, "body after", "m/s").exact(-v, 0.25, gravity);
    figure(scene, "body 0.5 s later", "m/s").exact(-v, 0.25, gravity);
    return scene;
}

/// Impulses on the legs, parts 0 and 1 of body 1, in one second.
std::vector<double> legs(Engine& engine) {
    run(engine, 9);
    double left = 0;
    double right = 0;
    double top = 0;
    for (int i = 0; i < 60; ++i) {
        engine.step(kDt);
        for (const Touch& one : engine.touches()) {
            if (one.a == 0 && one.b == 1) {
                (one.partB == 0 ? left : one.partB == 1 ? right : top) += one.impulse;
            }
        }
    }
    return {left, right, top, left + right, engine.state(1).angle};
}

CrossScene table() {
    CrossScene scene{"RecordsByPartShareTheWeightByLevers",
                     "A table on two feet of unlike distance",
                     "Records name the part. The feet stand 0.5 m left and 1.5 m right of the "
                     "centre of the top; by levers the forces share the weight.",
                     "",
                     {"table", scenes::kDown, {scenes::ground(20)}}};
    scenes::BodyDef table;
    table.parts = {scenes::Circle{0.2, {-0.5, 0.2}}, scenes::Circle{0.2, {1.5, 0.2}},
                   scenes::Box{4, 0.4, {0, 0.6}}};
    scene.def.bodies.push_back(table);
    scene.drawn = {1};
    scene.measure = legs;
    const Mass mass = massOf(table);
    const double weight = 10 * mass.mass;
    const double right = weight * (mass.center.x + 0.5) / 2;
    const char* const force = "0.5 % of the weight, as mean of a second";
    figure(scene, "force on the left foot", "N").exact(weight - right, 0.005 * weight, force);
    figure(scene, "force on the right foot", "N").exact(right, 0.005 * weight, force);
    figure(scene, "force on the top", "N").exact(0, 0, "it touches nothing");
    figure(scene, "force on both", "N").exact(weight, 0.001 * weight, "0.1 % of the weight");
    figure(scene, "tilt", "rad").exact(0, 0.003, "a slop over 2 m");
    return scene;
}

} // namespace

std::vector<CrossScene> filterScenes() {
    return {masks(), sensor(), upright(), weightless(), table()};
}

} // namespace crosscheck
