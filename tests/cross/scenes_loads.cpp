// SPDX-License-Identifier: MIT
// Joints under load: the reaction forces of statics.
#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::SceneDef;
using scenes::Vec2;

const char* const kForce = "0.5 % of the load, as mean of one step";

SceneDef between(const char* name, std::initializer_list<Vec2> hooks) {
    SceneDef scene{name, scenes::kDown, {}};
    for (const Vec2 at : hooks) {
        scene.bodies.push_back(scenes::ball(0.1, at));
        scene.bodies.back().locked = true;
    }
    return scene;
}

CrossScene beam() {
    CrossScene scene{"BeamOnTwoHingesSharesItsLoadByLevers",
                     "A beam hangs on two ropes with a load off its middle",
                     "The beam of 4 m weighs 8 N. A box of 20 N rests on it, 1 m left of the "
                     "middle. The ropes are 4 m apart: left 4 + 20 * 3/4 = 19 N, right 9 N.",
                     "", between("beam", {{-2, 2}, {2, 2}})};
    scene.def.bodies.push_back(scenes::box(4, 0.2, {0, 0}));
    scene.def.bodies.push_back(scenes::box(1, 1, {-1, 0.6}));
    scene.def.bodies[3].density = 2;
    scene.drawn = {2, 3};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        for (std::size_t side = 0; side < 2; ++side) {
            const double x = side == 0 ? -2 : 2;
            engine.join({.kind = Link::Kind::RopeJoint,
                         .a = side,
                         .b = 2,
                         .point = {x, 2},
                         .pointB = {x, 0}});
        }
        run(engine, 10);
        return {engine.jointForce(0).y, engine.jointForce(1).y, meanForce(engine, 2, 3),
                engine.state(2).position.y, engine.state(2).angle};
    };
    figure(scene, "left rope", "N").exact(19, 0.2, kForce);
    figure(scene, "right rope", "N").exact(9, 0.2, kForce);
    figure(scene, "load on the beam", "N").exact(20, 0.1, kForce);
    figure(scene, "height of the beam", "m").exact(0, 0.005, "a slop of Box2D");
    figure(scene, "tilt of the beam", "rad").exact(0, 0.003, "a slop over 2 m");
    return scene;
}

CrossScene cantilever() {
    CrossScene scene{"FixedJointCarriesACantilever", "A fixed joint carries a beam with a load",
                     "A beam of 2 m and 4 N, fixed at its end, carries a box of 10 N at the free "
                     "end. The joint carries 14 N.",
                     "Soft joints sag under the load.", between("cantilever", {{0, 0}})};
    scene.def.bodies.push_back(scenes::box(2, 0.2, {1, 0}));
    scene.def.bodies.push_back(scenes::box(0.5, 0.5, {1.7, 0.35}));
    scene.def.bodies[2].density = 4;
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        engine.join({.kind = Link::Kind::FixedJoint, .a = 0, .b = 1, .point = {0, 0}});
        run(engine, 10);
        return {engine.jointForce(0).y, meanForce(engine, 1, 2), engine.state(1).angle,
                engine.state(1).position.y};
    };
    const char* const slides =
        "the box slides down the sagging beam and falls off within ten seconds";
    figure(scene, "force of the joint", "N").exact(14, 0.07, kForce).withoutShock(-1, slides);
    figure(scene, "load on the beam", "N").exact(10, 0.05, kForce).withoutShock(-1, slides);
    figure(scene, "tilt", "rad").exact(0, 0.02, "2 cm of sag at 1 m under load");
    figure(scene, "height of the middle", "m").exact(0, 0.02, "2 cm of sag at 1 m under load");
    return scene;
}

CrossScene chain() {
    CrossScene scene{"ChainCarriesTwentyTimesTheWeightOfALink", "A chain of five links with a load",
                     "Links of 1 N each carry a ball of 20 N. The top pin carries 25 N, the lowest "
                     "20 N.",
                     "", between("chain", {{0, 0}})};
    for (int i = 0; i < 5; ++i) {
        scene.def.bodies.push_back(scenes::box(0.2, 0.5, {0, -0.25 - 0.5 * i}));
    }
    scene.def.bodies.push_back(scenes::ball(0.4, {0, -2.5}));
    scene.def.bodies[6].density = 2 / (kPi * 0.16);
    scene.drawn = {3, 6};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        for (std::size_t i = 0; i < 6; ++i) {
            engine.join({.kind = Link::Kind::RevoluteJoint,
                         .a = i,
                         .b = i + 1,
                         .point = {0, -0.5 * static_cast<double>(i)}});
        }
        run(engine, 10);
        return {engine.jointForce(0).y, engine.jointForce(5).y, engine.state(6).position.y,
                engine.state(6).position.x};
    };
    figure(scene, "top pin", "N").exact(25, 0.125, kForce);
    figure(scene, "lowest pin", "N").exact(20, 0.1, kForce);
    figure(scene, "height of the load", "m").exact(-2.5, 0.015, "half a slop of Box2D a pin");
    figure(scene, "sideways", "m").exact(0, 1e-4, "symmetry, to rounding");
    return scene;
}

CrossScene slider(double motor, const std::string& name) {
    const bool lifts = motor > 0;
    CrossScene scene{name, lifts ? "A slider lifts 10 N at 0.5 m/s" : "A slider rests on its limit",
                     lifts ? "The motor may use 40 N. It moves at its speed and carries the weight."
                           : "The box falls 0.5 m to the limit and stays. The limit carries 10 N.",
                     "", between("slider", {{0, 0}})};
    scene.def.bodies.push_back(scenes::box(1, 1, {0, 0}));
    scene.drawn = {1};
    scene.measure = [motor](Engine& engine) -> std::vector<double> {
        Link axis{.kind = Link::Kind::PrismaticJoint, .a = 0, .b = 1};
        axis.motorTorque = motor;
        axis.motorSpeed = 0.5;
        if (motor == 0) {
            axis.limits = {-0.5, 0.5};
        }
        engine.join(axis);
        run(engine, 2);
        const State end = engine.state(1);
        return {engine.jointForce(0).y, end.position.y, end.velocity.y, end.angle};
    };
    figure(scene, "force of the joint", "N").exact(10, 0.05, kForce);
    figure(scene, "height", "m")
        .exact(lifts ? 1 : -0.5, 0.02,
               lifts ? "reaches its speed within a step: 1 cm"
                     : "twice the slop of Box2D, and of Kodo's soft limit");
    figure(scene, "velocity", "m/s").exact(lifts ? 0.5 : 0, 1e-3, "0.2 % of the speed");
    figure(scene, "angle", "rad").exact(0, 1e-4, "symmetry, to rounding");
    return scene;
}

CrossScene angleLimit() {
    CrossScene scene{"HingeRestsOnItsLimitUnderLoad", "A rod falls to the limit of its hinge",
                     "The rod of 1 m, level at the start, falls to the limit of 1 rad and rests. "
                     "The pin carries its weight of 1 N.",
                     "", between("angle limit", {{0, 0}})};
    scene.def.bodies.push_back(scenes::box(1, 0.1, {0.5, 0}));
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        Link pin{.kind = Link::Kind::RevoluteJoint, .a = 0, .b = 1};
        pin.limits = {-1, 1};
        engine.join(pin);
        run(engine, 10);
        return {engine.state(1).angle, engine.state(1).spin, engine.jointForce(0).y,
                sizeOf(engine.state(1).position)};
    };
    figure(scene, "angle at rest", "rad").exact(-1, 0.04, "2 degrees: the angular slop of Box2D");
    figure(scene, "spin at rest", "rad/s").exact(0, 1e-3, "it rests");
    figure(scene, "force of the pin", "N").exact(1, 0.005, kForce);
    figure(scene, "arm", "m").exact(0.5, 0.002, "half a slop");
    return scene;
}

/// Body 1 swings on a rope of 2 m, let go at 60 degrees.
CrossScene ropeSwing() {
    CrossScene scene{"RopeSwingHasTheExactTension", "A ball swings on a rope of 2 m",
                     "Let go at 60 degrees. At the lowest point v^2 = 2 g L (1 - cos 60) and the "
                     "tension is m g (3 - 2 cos 60) = 2 m g.",
                     "Box2D loses energy in the rope.", between("rope swing", {{0, 0}})};
    const Vec2 start{2 * std::sqrt(0.75), -1};
    scene.def.bodies.push_back(scenes::ball(0.2, start));
    scene.def.bodies[1].density = 1 / (kPi * 0.04);
    scene.drawn = {1};
    scene.measure = [start](Engine& engine) -> std::vector<double> {
        engine.join({.kind = Link::Kind::RopeJoint, .a = 0, .b = 1, .point = {}, .pointB = start});
        double speed = 0;
        double tension = 0;
        double stretch = 0;
        for (int i = 1; i <= 90; ++i) { // past the lowest point, once
            engine.step(kDt);
            const State now = engine.state(1);
            speed = std::max(speed, sizeOf(now.velocity));
            tension = i > 10 ? std::max(tension, sizeOf(engine.jointForce(0))) : 0;
            stretch = std::max(stretch, sizeOf(now.position) - 2);
        }
        return {speed, tension, stretch};
    };
    figure(scene, "largest speed", "m/s")
        .exact(std::sqrt(20.0), 0.03 * std::sqrt(20.0), "3 %: Euler errs by one step of gravity");
    figure(scene, "largest tension", "N")
        .exact(20, 1, "5 %: twice that of the speed, less what is gained between steps");
    figure(scene, "most stretch", "m").atMost(0.01, "1 cm: two slops of Box2D");
    return scene;
}

} // namespace

std::vector<CrossScene> loadScenes() {
    return {beam(),
            cantilever(),
            chain(),
            slider(40, "SliderLiftsItsLoadAtItsSpeed"),
            slider(0, "SliderRestsOnItsLimit"),
            angleLimit(),
            ropeSwing()};
}

} // namespace crosscheck
