// SPDX-License-Identifier: MIT
// Friction on flat ground and on slopes.
#include <scenes/slides.hpp>

#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

/// Distance (m), speed (m/s) and spin (rad/s) of body 1 after a time in seconds.
std::vector<double> travel(Engine& engine, double seconds) {
    const scenes::Vec2 start = engine.state(1).position;
    run(engine, seconds);
    const State end = engine.state(1);
    return {sizeOf(end.position - start), sizeOf(end.velocity), end.spin};
}

std::vector<double> stop(Engine& engine) {
    double stopped = -1;
    for (int i = 1; i <= 120; ++i) {
        engine.step(kDt);
        if (stopped < 0 && engine.state(1).velocity.x < 1e-3) {
            stopped = i * kDt;
        }
    }
    const State end = engine.state(1);
    return {stopped, end.position.x, end.position.x, end.position.y, std::abs(end.angle)};
}

void addStop(CrossScene& scene, double friction) {
    const double time = 5 / (10 * friction);
    const double way = 25 / (20 * friction);
    figure(scene, "stands from", "s").exact(time, 1.5 * kDt, "a step and half of one");
    figure(scene, "distance", "m")
        .kodoExact(way, 0.015, "Euler errs by v h / 2: 8 mm with five substeps")
        .thesis(0.06, "one substep a step: Euler errs by v dt / 2 = 42 mm");
    figure(scene, "distance, both", "m").agree(0.06, "Euler in Box2D errs by v dt / 2 = 42 mm");
    figure(scene, "height at rest", "m").exact(0.25, 0.01, "Box2D's slop is 5 mm");
    figure(scene, "tilt at rest", "rad").exact(0, 2e-3, "2 mm over the width of 1 m");
}

CrossScene slidingBox() {
    CrossScene scene{"BoxStopsAtTheExactDistanceAndTime", "A box slides to a stop",
                     "mu = 0.5: distance v^2 / (2 mu g) = 2.5 m, time v / (mu g) = 1 s.",
                     "An Euler step without half-step term errs by v dt / 2.",
                     scenes::slidingBox(0.5)};
    scene.drawn = {1};
    scene.measure = stop;
    addStop(scene, 0.5);
    return scene;
}

CrossScene unlikeFrictions() {
    CrossScene scene{
        "UnlikeFrictionsTakeTheGeometricMean", "A box of friction 0.9 slides on ground of 0.4",
        "The geometric mean is 0.6: distance 2.083 m, time 0.833 s.",
        "An Euler step without half-step term errs by v dt / 2.", scenes::slidingBox(0.4)};
    scene.def.bodies[1].material.friction = 0.9;
    scene.drawn = {1};
    scene.measure = stop;
    addStop(scene, 0.6);
    return scene;
}

/// Body 1 lies on the ground with friction 0.1, body 2 on it with friction 1: body 2 slides at 3
/// m/s and drags body 1 along.
CrossScene stackOfUnlikeFrictions() {
    CrossScene scene{"BoxDragsTheBoxBelowByUnlikeFrictions",
                     "A box slides on a sliding plank, with unlike frictions",
                     "Friction 0.4 between box and plank, 0.1 between plank and ground. The box "
                     "brakes by 4 m/s^2. The plank, of twice the mass, gains (0.4 - 0.3) 10 / 2 = "
                     "0.5 m/s^2. They meet at 1/3 m/s after 2/3 s, then brake by 1 m/s^2.",
                     "An Euler step without half-step term errs by v dt / 2.",
                     {"plank", scenes::kDown, {scenes::ground(40, {0.025, 0})}}};
    scene.def.bodies.push_back(scenes::box(6, 0.5, {0, 0.25}, {0.4, 0}));
    scene.def.bodies.push_back(scenes::box(1.5, 1, {-2, 1}, {0.4, 0}));
    scene.def.bodies[2].velocity = {3, 0};
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 0.5);
        const double box = engine.state(2).velocity.x;
        const double plank = engine.state(1).velocity.x;
        run(engine, 2);
        return {box, plank, engine.state(2).position.x + 2, engine.state(1).position.x};
    };
    const char* const landing = "the box settles in the first step: one step of friction, 0.07";
    figure(scene, "box after 0.5 s", "m/s").exact(1, 0.07, landing);
    figure(scene, "plank after 0.5 s", "m/s").exact(0.25, 0.03, landing).withShock(-1, kStatic);
    const double together = 1.0 / 18; // m, from 1/3 m/s at 1 m/s^2
    const char* const euler = "v dt / 2 = 25 mm and one step of friction";
    figure(scene, "way of the box", "m").exact(3 * 2.0 / 3 - 2 * 4.0 / 9 + together, 0.06, euler);
    figure(scene, "way of the plank", "m")
        .exact(0.25 * 4.0 / 9 + together, 0.03, euler)
        .withShock(-1, kStatic);
    return scene;
}

CrossScene slope(double share, const std::string& name) {
    const bool sticks = share > 1;
    CrossScene scene{name,
                     sticks ? "A box sticks to a slope of 1 % more friction than its tangent"
                            : "A box slips on a slope of 1 % less friction than its tangent",
                     sticks
                         ? "A slope of 3 over 4, mu = 0.7575: it stays for ten seconds."
                         : "A slope of 3 over 4, mu = 0.7425: a = g (0.6 - 0.8 mu) = 0.06 m/s^2, "
                           "so 3 m in ten seconds.",
                     "", scenes::boxOnSlope(0.75 * share)};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        std::vector<double> all = travel(engine, 10);
        all.resize(2);
        return all;
    };
    if (sticks) {
        figure(scene, "way", "m")
            .exact(0, 0.007, "sinks some millimetres until the contact carries the weight");
        figure(scene, "speed", "m/s").exact(0, 1e-3, "creep of less than 1 mm/s");
    } else {
        const char* const first = "5 %: the box settles in the first steps";
        figure(scene, "way", "m").exact(3, 0.15, first);
        figure(scene, "speed", "m/s").exact(0.6, 0.03, first);
    }
    return scene;
}

CrossScene slips() {
    CrossScene scene{"BoxSlipsWithTheExactAcceleration", "A box slips down a slope",
                     "mu = 0.3: a = g (sin - mu cos) = 3.6 m/s^2.",
                     "Euler errs by a t dt / 2 = 60 mm in two seconds.", scenes::boxOnSlope(0.3)};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const std::vector<double> all = travel(engine, 2);
        return {all[1], all[0], all[0]};
    };
    figure(scene, "speed after 2 s", "m/s").exact(7.2, 0.1, "the box settles in the first steps");
    figure(scene, "way in 2 s", "m")
        .kodoExact(7.2, 0.04, "Euler errs by a t h / 2: 12 mm; settling")
        .thesis(0.1, "one substep a step: Euler errs by a t dt / 2 = 60 mm");
    figure(scene, "way in 2 s, both", "m").agree(0.1, "Euler in Box2D: 60 mm");
    return scene;
}

CrossScene rolls() {
    CrossScene scene{"BallRollsDownASlopeWithoutSlipping", "A ball rolls down a slope",
                     "A rolling disc has a = 2/3 g sin, since friction 0.6 exceeds tan / 3.",
                     "Box2D's radius is off by its slop, which changes a by 0.34 %.",
                     scenes::ballDownSlope()};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const std::vector<double> all = travel(engine, 2);
        return {all[1], all[2], all[0], all[1], all[0]};
    };
    const double a = 2.0 / 3 * 10 * 5 / 13;
    figure(scene, "speed after 2 s", "m/s").kodoExact(2 * a, 0.002 * 2 * a, "0.2 %: overlap");
    figure(scene, "spin after 2 s", "rad/s").kodoExact(4 * a, 0.004 * 4 * a, "0.4 %: overlap");
    figure(scene, "way in 2 s", "m")
        .kodoExact(2 * a, 0.03, "Euler errs by a t h / 2: 9 mm; settling")
        .thesis(0.06, "one substep a step: Euler errs by a t dt / 2 = 43 mm");
    figure(scene, "speed, both", "m/s").agree(0.01 * 2 * a, "1 %: the slop of Box2D");
    figure(scene, "way, both", "m").agree(0.1, "Euler in Box2D: 43 mm, and its slop");
    return scene;
}

} // namespace

std::vector<CrossScene> slideScenes() {
    return {slidingBox(),
            unlikeFrictions(),
            stackOfUnlikeFrictions(),
            slope(1.01, "BoxOnASlopeSticksAboveTheTangent"),
            slope(0.99, "BoxOnASlopeSlipsBelowTheTangent"),
            slips(),
            rolls()};
}

} // namespace crosscheck
