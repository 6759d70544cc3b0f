// SPDX-License-Identifier: MIT
// Kinematic bodies that push, carry and throw.
#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Vec2;

const char* const kOnePoint = "rounding: with one contact point one pass is exact";

CrossScene paddle(double e, double speed, const std::string& name) {
    CrossScene scene{name,
                     "A wall at " + std::string(speed > 10 ? "30" : "3") +
                         " m/s hits a ball, e = " + std::string(e < 1 ? "0.5" : "1"),
                     "A kinematic body has infinite mass: the ball leaves at u (1 + e), and the "
                     "wall keeps its speed.",
                     "",
                     {"paddle", {}, {}}};
    scene.def.bodies = {scenes::box(0.4, 2, {-1, 0}, {0, e}), scenes::ball(0.2, {0, 0.1}, {0, e})};
    scene.def.bodies[0].locked = true;
    scene.def.bodies[0].velocity = {speed, 0};
    scene.drawn = {0, 1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State ball = engine.state(1);
        return {hit.time,
                hit.impulse,
                ball.velocity.x,
                ball.velocity.y,
                engine.state(0).velocity.x,
                ball.position.x - engine.state(0).position.x};
    };
    const double mass = massOf(scene.def.bodies[1]).mass;
    figure(scene, "first hit", "s").exact(0.6 / speed, 2 * kDt, "two steps");
    figure(scene, "impulse", "N s").exact(mass * speed * (1 + e), 1e-4 * speed, kOnePoint);
    figure(scene, "ball after", "m/s").exact(speed * (1 + e), 1e-4 * speed, kOnePoint);
    figure(scene, "ball after, sideways", "m/s").exact(0, 1e-6, "the wall is flat");
    figure(scene, "wall after", "m/s").exact(speed, 1e-6, "infinite mass");
    figure(scene, "ball behind the wall", "").atMost(-0.0, "the ball stays in front");
    scene.figures.back().what = "lead of the wall before the ball";
    scene.figures.back().unit = "m";
    scene.measure = [inner = scene.measure](Engine& engine) {
        std::vector<double> all = inner(engine);
        all.back() = -all.back();
        return all;
    };
    return scene;
}

CrossScene carried() {
    CrossScene scene{"MovingPlateCarriesABoxByFriction",
                     "A plate at 2 m/s moves under a box",
                     "mu = 0.5: the box reaches 2 m/s after 0.4 s and lags 0.4 m behind.",
                     "Euler in Box2D errs by v dt / 2.",
                     {"carried", scenes::kDown, {}}};
    scene.def.bodies = {scenes::box(20, 1, {0, -0.5}, {0.5, 0}),
                        scenes::box(1, 0.5, {0, 0.25}, {0.5, 0})};
    scene.def.bodies[0].locked = true;
    scene.def.bodies[0].velocity = {2, 0};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 0.2);
        const double half = engine.state(1).velocity.x;
        run(engine, 1.8);
        const State box = engine.state(1);
        return {half, box.velocity.x, engine.state(0).position.x - box.position.x, box.angle};
    };
    figure(scene, "box after 0.2 s", "m/s").exact(1, 0.1, "one step of friction, 0.083 m/s");
    figure(scene, "box after 2 s", "m/s").exact(2, 1e-3, "it sticks");
    figure(scene, "lag", "m").exact(0.4, 0.05, "v dt = 33 mm, and settling");
    figure(scene, "tilt", "rad").exact(0, 2e-3, "2 mm over the width");
    return scene;
}

CrossScene lift() {
    CrossScene scene{"LiftCarriesItsLoadAtItsSpeed",
                     "A lift raises a box at 1 m/s",
                     "The box rises with it, and its force is the weight of 10 N.",
                     "",
                     {"lift", scenes::kDown, {}}};
    scene.def.bodies = {scenes::box(3, 0.4, {0, -0.2}), scenes::box(1, 1, {0, 0.5})};
    scene.def.bodies[0].locked = true;
    scene.def.bodies[0].velocity = {0, 1};
    scene.drawn = {0, 1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 2);
        const double force = meanForce(engine, 0, 1);
        const State box = engine.state(1);
        return {force, box.velocity.y, box.position.y - engine.state(0).position.y, box.angle};
    };
    figure(scene, "force", "N").exact(10, 0.01, "0.1 % of the weight");
    figure(scene, "velocity", "m/s").exact(1, 1e-3, "it sticks");
    figure(scene, "height over the lift", "m").exact(0.7, 0.01, "Box2D's slop is 5 mm");
    figure(scene, "tilt", "rad").exact(0, 1e-3, "1 mm over the width");
    return scene;
}

CrossScene rotor() {
    CrossScene scene{"KinematicRotorThrowsABallByItsLever",
                     "A driven bar throws a ball, e = 1",
                     "The bar turns at 2 rad/s whatever it hits. The ball leaves at 2 omega L, "
                     "along the normal of the bar at the touch.",
                     "In Box2D the bar turns for up to one more step.",
                     {"rotor", {}, {}}};
    scene.def.bodies = {scenes::box(4, 0.2, {0, 0}, {0, 1}), scenes::ball(0.25, {1.5, 1}, {0, 1})};
    scene.def.bodies[0].locked = true;
    scene.def.bodies[0].spin = 2;
    scene.drawn = {0, 1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const Vec2 v = engine.state(1).velocity;
        return {hit.time, hit.impulse, sizeOf(v), std::atan2(-v.x, v.y), engine.state(0).spin};
    };
    const double distance = std::sqrt(1.5 * 1.5 + 1);
    const double angle = std::atan2(1, 1.5) - std::asin(0.35 / distance);
    const double lever = std::sqrt(distance * distance - 0.35 * 0.35);
    const double mass = massOf(scene.def.bodies[1]).mass;
    const char* const early = "1 %: Kodo applies the impulse slop / 4 before the touch";
    figure(scene, "first hit", "s").exact(angle / 2, 2 * kDt, "two steps");
    figure(scene, "impulse", "N s").kodoExact(4 * lever * mass, 0.04 * lever * mass, early);
    figure(scene, "ball after", "m/s").kodoExact(4 * lever, 0.04 * lever, early);
    figure(scene, "direction of the ball", "rad").kodoExact(angle, 0.01, early);
    figure(scene, "rotor after", "rad/s").exact(2, 1e-6, "infinite mass");
    return scene;
}

/// A box between a moving and a fixed wall is pushed along, then stopped by the fixed one.
CrossScene pusher() {
    CrossScene scene{"PusherMovesABoxWithoutRebound",
                     "A pusher at 1 m/s moves a box along",
                     "With e = 0 the box takes the speed of the pusher and stays at it, against "
                     "friction of 0.3. The force of the pusher is mu m g = 3 N.",
                     "",
                     {"pusher", scenes::kDown, {scenes::ground(40, {0.3, 0})}}};
    scene.def.bodies.push_back(scenes::box(0.4, 0.6, {-1.5, 0.5}, {0, 0}));
    scene.def.bodies.push_back(scenes::box(1, 1, {0, 0.5}, {0.3, 0}));
    scene.def.bodies[1].locked = true;
    scene.def.bodies[1].velocity = {1, 0};
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 1, 2, 3);
        run(engine, 1);
        const double force = meanForce(engine, 1, 2);
        const State box = engine.state(2);
        return {hit.time, force, box.velocity.x, box.position.x - engine.state(1).position.x,
                box.angle};
    };
    figure(scene, "first hit", "s").exact(0.8, 2 * kDt + 0.01, "two steps, and the slop at 1 m/s");
    figure(scene, "force of the pusher", "N").exact(3, 0.03, "1 % of the friction");
    figure(scene, "velocity of the box", "m/s").exact(1, 1e-3, "it stays at the pusher");
    figure(scene, "distance to the pusher", "m").exact(0.7, 0.01, "Box2D's slop is 5 mm");
    figure(scene, "tilt", "rad").exact(0, 2e-3, "2 mm over the width");
    return scene;
}

} // namespace

std::vector<CrossScene> moverScenes() {
    return {paddle(1, 3, "WallHitsABallElastic"),
            paddle(0.5, 3, "WallHitsABallHalfElastic"),
            paddle(1, 30, "FastWallHitsABallAndDoesNotPassIt"),
            carried(),
            lift(),
            rotor(),
            pusher()};
}

} // namespace crosscheck
