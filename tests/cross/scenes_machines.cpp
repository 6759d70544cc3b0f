// SPDX-License-Identifier: MIT
// Loads far heavier than what carries them, figures of joints, and joints that pull, break and
// turn.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Vec2;

/// A point of two bodies that a joint holds together.
class Pin {
public:
    Pin(const scenes::SceneDef& def, std::size_t a, std::size_t b, Vec2 point)
        : a_(a), b_(b), onA_(local(def.bodies[a], point)), onB_(local(def.bodies[b], point)) {}

    /// Distance (m) between the two points.
    double gap(const Engine& engine) const {
        return sizeOf(world(engine, a_, onA_) - world(engine, b_, onB_));
    }

private:
    static Vec2 local(const scenes::BodyDef& body, Vec2 point) {
        const scenes::Rot back{body.rotation.c, -body.rotation.s};
        return back * (point - body.position) - massOf(body).center;
    }
    static Vec2 world(const Engine& engine, std::size_t body, Vec2 point) {
        const State at = engine.state(body);
        return at.position + scenes::Rot{std::cos(at.angle), std::sin(at.angle)} * point;
    }

    std::size_t a_;
    std::size_t b_;
    Vec2 onA_;
    Vec2 onB_;
};

CrossScene heavyOnLight(double ratio, const std::string& name) {
    CrossScene scene{name,
                     "A box carries one that is " + std::to_string(static_cast<int>(ratio)) +
                         " times as heavy",
                     "It stands, and the ground carries both weights.",
                     "In Box2D the heavy box sinks into the light one.",
                     {"ratio", scenes::kDown, {scenes::ground(20)}}};
    scene.def.bodies.push_back(scenes::box(1, 1, {0, 0.5}));
    scene.def.bodies.push_back(scenes::box(1, 1, {0, 1.5}));
    scene.def.bodies[2].density = ratio;
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 5);
        const double height = engine.state(2).position.y;
        const double force = meanForce(engine, 0, 1);
        return {height, sizeOf(engine.state(2).velocity), force};
    };
    const char* const sinks = "without shock passes it does not carry such a load";
    figure(scene, "height of the heavy one", "m")
        .kodoExact(1.5, ratio > 200 ? 0.02 : 0.01, "it yields softly, by millimetres")
        .withoutShock(-1, sinks);
    figure(scene, "its speed", "m/s")
        .kodoExact(0, 0.005, "it yields softly")
        .withoutShock(-1, sinks);
    figure(scene, "force of the ground", "N")
        .kodoExact(10 * (1 + ratio), 0.01 * 10 * (1 + ratio), "1 % of the weight")
        .withoutShock(-1, sinks)
        .withShock(-1, kStatic);
    return scene;
}

CrossScene ragdoll() {
    CrossScene scene{"RagdollFallsAndHangsTogether",
                     "A figure of six parts falls 2 m",
                     "Pins hold, and limits of 0.4 and 0.8 rad are kept.",
                     "Soft pins open in the impact.",
                     {"ragdoll", scenes::kDown, {scenes::ground(20)}}};
    const Vec2 base{0, 3};
    scene.def.bodies.push_back(scenes::box(0.4, 0.8, base)); // torso
    scene.def.bodies.push_back(scenes::ball(0.18, base + Vec2{0, 0.6}));
    struct Limb {
        Vec2 center;
        Vec2 pin;
    };
    const std::vector<Limb> limbs{{{-0.25, 0.1}, {-0.25, 0.35}},
                                  {{0.25, 0.1}, {0.25, 0.35}},
                                  {{-0.12, -0.7}, {-0.12, -0.4}},
                                  {{0.12, -0.7}, {0.12, -0.4}}};
    std::vector<Link> links{
        {.a = 1, .b = 2, .point = base + Vec2{0, 0.4}, .limits = Limits{-0.4, 0.4}}};
    for (const Limb& limb : limbs) {
        scene.def.bodies.push_back(scenes::box(0.14, 0.6, base + limb.center));
        links.push_back({.a = 1,
                         .b = scene.def.bodies.size() - 1,
                         .point = base + limb.pin,
                         .limits = Limits{-0.8, 0.8}});
    }
    scene.drawn = {1, 2, 3, 4, 5, 6};
    for (std::size_t body = 1; body <= 6; ++body) {
        scene.def.bodies[body].spin = 0.3; // so that it does not land on both feet at once
    }
    scene.measure = [links, def = scene.def](Engine& engine) -> std::vector<double> {
        std::vector<Pin> pins;
        for (const Link& link : links) {
            engine.join(link);
            pins.emplace_back(def, link.a, link.b, link.point);
        }
        double gap = 0;
        double over = 0;
        for (int i = 0; i < 360; ++i) {
            engine.step(kDt);
            for (std::size_t k = 0; k < pins.size(); ++k) {
                gap = std::max(gap, pins[k].gap(engine));
                const double bend = std::remainder(
                    engine.state(links[k].b).angle - engine.state(links[k].a).angle, 2 * kPi);
                over = std::max(over, std::abs(bend) - links[k].limits->upper);
            }
        }
        double rest = 0;
        double fastest = 0;
        for (std::size_t k = 0; k < pins.size(); ++k) {
            rest = std::max(rest, pins[k].gap(engine));
            fastest = std::max(fastest, sizeOf(engine.state(links[k].b).velocity));
        }
        return {gap, std::max(over, 0.0), rest, fastest};
    };
    figure(scene, "largest gap of a pin", "m")
        .kodoExact(0, 0.02, "2 cm in the impact, a seventh of a limb's width")
        .thesis(0.06, "one substep a step: half the stiffness");
    figure(scene, "most beyond a limit", "rad").exact(0, 0.03, "2 cm at the end of a limb");
    figure(scene, "largest gap at the end", "m").exact(0, 2e-3, "2 mm");
    figure(scene, "largest speed at the end", "m/s");
    return scene;
}

CrossScene lifted() {
    CrossScene scene{
        "MouseJointHoldsAWeightByHookesLaw",
        "Mouse joints pull two boxes up; one has half the force that it needs",
        "The sag is g / (2 pi f)^2 with f = 2 Hz. The weak pull of m g / 2 leaves half of "
        "the weight on the ground.",
        "",
        {"mouse", scenes::kDown, {scenes::ground(20)}}};
    scene.def.bodies.push_back(scenes::box(1, 1, {-2, 0.5}));
    scene.def.bodies.push_back(scenes::box(1, 1, {2, 0.5}));
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const auto pull = [&](std::size_t body, double x, double force) {
            engine.join({.kind = Link::Kind::MouseJoint,
                         .a = 0,
                         .b = body,
                         .point = {x, 0.5},
                         .pointB = {x, 2},
                         .motorTorque = force,
                         .hertz = 2,
                         .damping = 1});
        };
        pull(1, -2, 1000);
        pull(2, 2, 5);
        run(engine, 5);
        const double height = engine.state(1).position.y;
        return {height, engine.state(2).position.y, meanForce(engine, 0, 2)};
    };
    figure(scene, "height of the left box", "m").exact(2 - 10 / (16 * kPi * kPi), 1e-3, "1 mm");
    figure(scene, "height of the right box", "m").exact(0.5, 1e-3, "1 mm").box2d(0.006, "its slop");
    figure(scene, "force under the right box", "N").exact(5, 0.05, "1 %");
    return scene;
}

CrossScene breaking() {
    CrossScene scene{"JointBreaksUnderTwiceItsLoad",
                     "Joints of 15 N hold 10 N, and break under 20 N",
                     "The light load hangs; the heavy one falls freely, g t^2 / 2.",
                     "",
                     {"breaking", scenes::kDown, {scenes::box(6, 0.2, {0, 0})}}};
    scene.def.bodies[0].locked = true;
    scene.def.bodies.push_back(scenes::box(1, 1, {-2, -1}));
    scene.def.bodies.push_back(scenes::box(1, 1, {2, -1}));
    scene.def.bodies[2].density = 2;
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        for (const std::size_t body : {1u, 2u}) {
            engine.join(
                {.a = 0, .b = body, .point = {body == 1 ? -2.0 : 2.0, 0}, .breakForce = 15});
        }
        run(engine, 1);
        return {engine.isBroken(0) ? 1.0 : 0.0, engine.isBroken(1) ? 1.0 : 0.0,
                engine.state(1).position.y, engine.state(2).position.y, engine.state(2).velocity.y};
    };
    figure(scene, "10 N: broken", "").exact(0, 0, "1 is yes, 0 is no");
    figure(scene, "20 N: broken", "").exact(1, 0, "1 is yes, 0 is no");
    figure(scene, "place of the light load", "m").exact(-1, 1e-3, "1 mm");
    figure(scene, "place of the heavy one after 1 s", "m")
        .exact(-6, 10 * 1.5 * kDt, "held for a step: v dt")
        .box2d(10 * 2.5 * kDt, "held for a step, and Euler");
    figure(scene, "its speed", "m/s").exact(-10, 10 * 1.5 * kDt, "held for a step: g dt");
    return scene;
}

CrossScene rollers() {
    CrossScene scene{
        "TurningRollersSpinABallInPlace",
        "A ball lies on two kinematic rollers that turn at 4 rad/s",
        "Equal radii: the ball turns at 4 rad/s in the other sense, and stays in its place.",
        "",
        {"rollers", scenes::kDown, {}}};
    for (const double x : {-0.6, 0.6}) {
        scene.def.bodies.push_back(scenes::ball(0.5, {x, 0}));
        scene.def.bodies.back().locked = true;
        scene.def.bodies.back().spin = -4;
    }
    scene.def.bodies.push_back(scenes::ball(0.5, {0, 0.8}));
    scene.drawn = {0, 1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 5);
        const State ball = engine.state(2);
        return {ball.spin, ball.position.x, ball.position.y, sizeOf(ball.velocity)};
    };
    figure(scene, "spin", "rad/s").exact(4, 1e-3, "it rolls");
    figure(scene, "x", "m").exact(0, 1e-3, "1 mm").box2d(0.01, "its slop");
    figure(scene, "height", "m")
        .exact(0.8, 2e-3, "2 mm: the slop on a slope")
        .box2d(0.01, "its slop");
    figure(scene, "speed", "m/s").exact(0, 1e-3, "it stays");
    return scene;
}

} // namespace

std::vector<CrossScene> machineScenes() {
    return {heavyOnLight(100, "LightBoxCarriesOne100TimesAsHeavy"),
            heavyOnLight(1000, "LightBoxCarriesOne1000TimesAsHeavy"),
            ragdoll(),
            lifted(),
            breaking(),
            rollers()};
}

} // namespace crosscheck
