// SPDX-License-Identifier: MIT
// Blocks that break: parts become bodies of their own, and momentum is kept.
#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Box;
using scenes::Vec2;

scenes::BodyDef block() {
    scenes::BodyDef def;
    def.parts = {Box{1, 0.5, {-0.5, 0}}, Box{0.5, 0.5, {0.25, 0}}};
    return def;
}

CrossScene flight() {
    CrossScene scene{
        "BlockThatBreaksInFlightKeepsItsMomentum",
        "A turning block breaks in flight",
        "Each piece moves on with the velocity that the rigid block had at its centre: "
        "v + w x r. Momentum and angular momentum are kept.",
        "",
        {"fracture in flight", {}, {block()}}};
    scene.def.bodies[0].velocity = {1, 0.5};
    scene.def.bodies[0].spin = 3;
    scene.drawn = {0};
    const Mass whole = massOf(scene.def.bodies[0]);
    const double right = 0.25; // kg, mass of the part that breaks off
    scene.measure = [whole, right](Engine& engine) -> std::vector<double> {
        run(engine, 0.5);
        const State before = engine.state(0);
        engine.split(0, 1);
        const Vec2 arm = engine.state(1).position - before.position;
        const Vec2 expected = before.velocity + Vec2{-before.spin * arm.y, before.spin * arm.x};
        const double jump = sizeOf(engine.state(1).velocity - expected);
        run(engine, 0.5);
        const State a = engine.state(0);
        const State b = engine.state(1);
        const double left = whole.mass - right;
        const Vec2 momentum = left * a.velocity + right * b.velocity;
        const Vec2 center = (1 / whole.mass) * (left * a.position + right * b.position);
        const double ia = left * (1 + 0.25) / 12;
        const double ib = right * (0.25 + 0.25) / 12;
        const double spin = left * cross(a.position - center, a.velocity) +
                            right * cross(b.position - center, b.velocity) + ia * a.spin +
                            ib * b.spin;
        return {jump, momentum.x / whole.mass, momentum.y / whole.mass, spin, b.spin};
    };
    const char* const rounding = "rounding: nothing acts";
    figure(scene, "jump of the velocity at the break", "m/s").exact(0, 1e-5, rounding);
    figure(scene, "mean velocity x", "m/s").exact(1, 1e-4, rounding);
    figure(scene, "mean velocity y", "m/s").exact(0.5, 1e-4, rounding);
    figure(scene, "angular momentum", "kg m^2/s")
        .exact(3 * whole.inertia, 0.005 * whole.inertia, "0.2 %: pieces touch as they part");
    figure(scene, "spin of the small piece", "rad/s").exact(3, 0.1, "pieces touch as they part");
    return scene;
}

CrossScene hit() {
    CrossScene scene{
        "BlockBreaksWhereTheBallHitsIt",
        "A ball hits a block, which breaks",
        "No friction, e = 0. The impulse acts on the whole block at the lever arm: J = "
        "v / (1/m + 1/M + L^2/I). Then it breaks, and all momentum is kept.",
        "",
        {"fracture by a hit", {}, {block()}}};
    scene.def.bodies[0].material = {0, 0};
    const Mass whole = massOf(scene.def.bodies[0]);
    scenes::BodyDef ball = scenes::ball(0.2, {0.25, -1.45}, {0, 0});
    scene.def.bodies.push_back(ball);
    scene.def.bodies[1].velocity = {0, 6};
    scene.drawn = {0, 1};
    scene.measure = [whole, m = massOf(ball).mass](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State before = engine.state(0);
        engine.split(0, 1);
        const double left = whole.mass - 0.25;
        const double momentum = left * engine.state(0).velocity.y +
                                0.25 * engine.state(2).velocity.y + m * engine.state(1).velocity.y;
        return {hit.time, hit.impulse, before.velocity.y, before.spin, momentum};
    };
    const double m = massOf(ball).mass;
    const double lever = 0.25 - whole.center.x;
    const double impulse = 6 / (1 / m + 1 / whole.mass + lever * lever / whole.inertia);
    const char* const stays = "2 %: the ball stays in touch for two steps, while the block turns";
    figure(scene, "first hit", "s").exact(1.0 / 6, 2 * kDt, "two steps");
    figure(scene, "impulse", "N s").exact(impulse, 0.03 * impulse, stays);
    figure(scene, "block after", "m/s")
        .exact(impulse / whole.mass, 0.03 * impulse / whole.mass, stays);
    figure(scene, "spin after", "rad/s")
        .exact(lever * impulse / whole.inertia, 0.03 * lever * impulse / whole.inertia, stays);
    figure(scene, "momentum of all pieces", "N s").exact(6 * m, 1e-4, "rounding");
    return scene;
}

CrossScene onGround() {
    CrossScene scene{"HalfABlockOverTheEdgeFallsAfterTheBreak",
                     "A block over an edge breaks, and one half falls",
                     "A block lies on a ledge with its small part in the air. After the break the "
                     "small part falls freely and the large one stays: 1 m in 0.447 s.",
                     "",
                     {"fracture over an edge", scenes::kDown, {}}};
    scenes::BodyDef ledge = scenes::box(3, 1, {-1.5, -0.5}, {0, 0});
    ledge.locked = true;
    scene.def.bodies = {ledge, block()};
    scene.def.bodies[1].position = {0, 0.25};
    scene.def.bodies[1].material = {0, 0};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 1);
        const double whole = meanForce(engine, 0, 1);
        engine.split(1, 1);
        const double start = engine.state(2).position.y;
        run(engine, 27 * kDt);
        const double fallen = start - engine.state(2).position.y;
        const double rest = meanForce(engine, 0, 1);
        return {whole, fallen, rest, engine.state(1).position.y, sizeOf(engine.state(1).velocity)};
    };
    const double time = 27 * kDt;
    figure(scene, "force of the whole block", "N").exact(7.5, 0.01, "0.1 % of the weight");
    figure(scene, "fall of the small part", "m")
        .exact(5 * time * time, 5 * time * kDt + 0.01, "Euler errs by g t dt / 2 = 38 mm");
    figure(scene, "force of what stays", "N").exact(5, 0.05, "1 % of the weight");
    figure(scene, "height of what stays", "m").exact(0.25, 0.01, "Box2D's slop is 5 mm");
    figure(scene, "speed of what stays", "m/s").exact(0, 1e-2, "it rests");
    return scene;
}

} // namespace

std::vector<CrossScene> fractureScenes() {
    return {flight(), hit(), onGround()};
}

} // namespace crosscheck
