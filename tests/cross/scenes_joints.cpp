// SPDX-License-Identifier: MIT
// Joints: period, motor, spring, and a pair that moves as one body.
#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::SceneDef;
using scenes::Vec2;

/// A scene with body 0, a small static disc at the origin, as an anchor.
SceneDef onAHook(const char* name) {
    SceneDef scene{name, scenes::kDown, {scenes::ball(0.1, {0, 0})}};
    scene.bodies[0].locked = true;
    return scene;
}

std::vector<double> swing(Engine& engine) {
    engine.join({.kind = Link::Kind::RevoluteJoint, .a = 0, .b = 1, .point = {0, 0}});
    std::vector<double> passes;
    double before = engine.state(1).angle;
    double stretch = 0;
    double widest = 0;
    for (int i = 1; i <= 900; ++i) {
        engine.step(kDt);
        const State now = engine.state(1);
        if (before < 0 && now.angle >= 0) {
            passes.push_back((i - now.angle / (now.angle - before)) * kDt);
        }
        before = now.angle;
        stretch = std::max(stretch, std::abs(sizeOf(now.position) - 0.5));
        widest = i > 720 ? std::max(widest, std::abs(now.angle)) : 0;
    }
    return {(passes.at(5) - passes.at(0)) / 5, stretch, widest};
}

CrossScene pendulum() {
    CrossScene scene{"PendulumHasTheExactPeriod", "A rod swings from a pin",
                     "The period for an amplitude of 0.2 rad is 2 pi sqrt((m l^2 + I) / (m g l)) / "
                     "agm(1, cos(0.1)).",
                     "The position correction of Box2D 2.4.1 ignores velocities and loses energy.",
                     onAHook("pendulum")};
    const scenes::Rot turn = scenes::turnedBy(0.1003); // tan(0.1)
    scenes::BodyDef rod = scenes::box(0.1, 1, turn * Vec2{0, -0.5});
    rod.rotation = turn;
    scene.def.bodies.push_back(rod);
    scene.drawn = {1};
    scene.measure = swing;
    const double arithmetic = (1 + std::cos(0.1)) / 2; // one iteration of the mean suffices: 1e-7
    const double period = 2 * kPi * std::sqrt((0.25 + 1.01 / 12) / 5) /
                          std::sqrt(arithmetic * std::sqrt(std::cos(0.1)));
    figure(scene, "period", "s")
        .exact(period, 0.002 * period, "0.2 %: crossings are interpolated between steps of 1 %");
    figure(scene, "stretch of the arm", "m").exact(0, 0.002, "2 mm: half a slop");
    figure(scene, "swing after 15 s", "rad").kodoExact(0.2, 0.006, "97 % of the swing is kept");
    return scene;
}

CrossScene motorWheel() {
    CrossScene scene{"MotorAcceleratesAWheelByItsTorqueUpToItsSpeed",
                     "A motor of 0.5 N m drives a wheel to 6 rad/s",
                     "omega = T t / I, then 6 rad/s.", "", onAHook("motor wheel")};
    scene.def.bodies.push_back(scenes::ball(0.5, {0, 0}));
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        Link pin{.kind = Link::Kind::RevoluteJoint, .a = 0, .b = 1};
        pin.motorSpeed = 6;
        pin.motorTorque = 0.5;
        engine.join(pin);
        run(engine, 0.5);
        const double ramp = engine.state(1).spin;
        run(engine, 2);
        const State end = engine.state(1);
        return {ramp, end.spin, end.position.x, end.position.y};
    };
    const double inertia = massOf(scene.def.bodies[1]).inertia;
    const char* const rounding = "rounding: the torque acts from the first step on";
    figure(scene, "spin after 0.5 s", "rad/s").exact(0.25 / inertia, 1e-3, rounding);
    figure(scene, "spin at the end", "rad/s").exact(6, 1e-4, rounding);
    figure(scene, "axle x", "m").exact(0, 1e-3, "1 mm of sag");
    figure(scene, "axle y", "m").exact(0, 1e-3, "1 mm of sag");
    return scene;
}

CrossScene spring() {
    CrossScene scene{"SpringHoldsItsLoadByHookesLaw", "A ball hangs on a damped spring of 1 Hz",
                     "Rest at g / (2 pi)^2 = 0.253 m below the rest length.", "",
                     onAHook("spring")};
    scene.def.bodies.push_back(scenes::ball(0.3, {0, -2}));
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        Link spring{.kind = Link::Kind::DistanceJoint, .a = 0, .b = 1};
        spring.pointB = {0, -2};
        spring.hertz = 1;
        spring.damping = 0.2;
        engine.join(spring);
        double lowest = 0;
        for (int i = 0; i < 60; ++i) {
            engine.step(kDt);
            lowest = std::min(lowest, engine.state(1).position.y);
        }
        run(engine, 9);
        const State end = engine.state(1);
        return {lowest, end.position.y, end.velocity.y, end.position.x};
    };
    const double sag = 10 / (4 * kPi * kPi);
    const double overshoot = std::exp(-0.2 * kPi / std::sqrt(1 - 0.04)); // of a damped oscillation
    figure(scene, "lowest", "m")
        .exact(-2 - sag * (1 + overshoot), 0.1 * sag,
               "a tenth of the amplitude: an implicit spring has extra damping of a share w h");
    figure(scene, "place at rest", "m").exact(-2 - sag, 1e-4, "rounding");
    figure(scene, "speed at rest", "m/s").exact(0, 1e-4, "rounding");
    figure(scene, "sideways", "m").exact(0, 1e-6, "rounding");
    return scene;
}

std::vector<double> fallJoined(Engine& engine) {
    engine.join({.kind = Link::Kind::FixedJoint, .a = 1, .b = 2, .point = {-0.75, 2.25}});
    double bend = 0;
    double apart = 0;
    double first = -1;
    for (int i = 1; i <= 300; ++i) {
        engine.step(kDt);
        const State low = engine.state(1);
        const State high = engine.state(2);
        first = first < 0 && engine.impulse(0, 1) > 0 ? i * kDt : first;
        bend = std::max(bend, std::abs(high.angle - low.angle));
        const scenes::Rot turn{std::cos(low.angle), std::sin(low.angle)};
        apart = std::max(apart, sizeOf(high.position - low.position - turn * Vec2{-0.75, 0.75}));
    }
    const State low = engine.state(1);
    const State high = engine.state(2);
    return {first,
            bend,
            apart,
            low.position.y,
            high.position.y - low.position.y,
            high.angle - low.angle};
}

CrossScene fixedPair() {
    CrossScene scene{"TwoBoxesWithAFixedJointFallAsOneBody",
                     "Two boxes with a fixed joint fall",
                     "They behave as one body: at the first touch, and at rest on the lower box.",
                     "Soft joints yield in the impact.",
                     {"weld", scenes::kDown, {scenes::ground(20)}}};
    scene.def.bodies.push_back(scenes::box(2, 0.5, {0, 2}));
    scene.def.bodies.push_back(scenes::box(0.5, 1, {-0.75, 2.75}));
    scene.drawn = {1, 2};
    scene.measure = fallJoined;
    figure(scene, "first hit", "s").exact(std::sqrt(0.35), 2 * kDt, "two steps");
    figure(scene, "most bend", "rad").kodoExact(0, 0.01, "yields by 1 cm over 1 m in the impact");
    figure(scene, "most gap", "m")
        .kodoExact(0, 0.01, "yields by 1 cm in the impact")
        .thesis(0.02, "one substep a step: half the stiffness");
    figure(scene, "height of the lower at rest", "m").exact(0.25, 0.01, "Box2D's slop is 5 mm");
    figure(scene, "height of the upper over it", "m").exact(0.75, 2e-3, "2 mm at rest");
    figure(scene, "bend at rest", "rad").exact(0, 2e-3, "2 mrad at rest");
    return scene;
}

} // namespace

std::vector<CrossScene> jointScenes() {
    return {pendulum(), motorWheel(), spring(), fixedPair()};
}

} // namespace crosscheck
