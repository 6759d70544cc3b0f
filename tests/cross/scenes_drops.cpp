// SPDX-License-Identifier: MIT
// Bodies that fall on a corner, on two parts, and through pins.
#include <scenes/impacts.hpp>

#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Vec2;

const char* const kTwoSteps = "two steps: one detects the touch, the next applies the impulse";
const char* const kSlop = "Box2D's slop is 5 mm; 1 cm for two contacts";

/// Deviation of an angle from the nearest multiple of a quarter turn.
double offSquare(double angle) {
    return std::abs(std::remainder(angle, kPi / 2));
}

/// State after the impact of a corner, when runToHit returns.
struct Landing {
    Vec2 impulse;
    Vec2 velocity;
    double spin;
};

/// Impulse J of a landing corner. If it sticks, K J = (-v_x, -(1 + e) v_y) with the effective mass
/// matrix of 1/m and the lever arm. If it slips, J lies on the edge of the friction cone. There is
/// no rotation before the impact. Gravity acts for the 2.5 steps (within half a step) until
/// runToHit returns; a body without restitution rotates about its corner meanwhile.
Landing land(const Mass& mass, Vec2 arm, double fall, double friction, double restitution) {
    const double k11 = 1 / mass.mass + arm.y * arm.y / mass.inertia;
    const double k22 = 1 / mass.mass + arm.x * arm.x / mass.inertia;
    const double k12 = -arm.x * arm.y / mass.inertia;
    const double wanted = (1 + restitution) * fall;
    const double determinant = k11 * k22 - k12 * k12;
    Vec2 impulse{-k12 * wanted / determinant, k11 * wanted / determinant};
    if (std::abs(impulse.x) > friction * impulse.y) {
        const double slope = std::copysign(friction, impulse.x);
        impulse.y = wanted / (k22 + slope * k12);
        impulse.x = slope * impulse.y;
    }
    const double after = 2.5 * kDt;
    const double pivot = mass.inertia + mass.mass * dot(arm, arm);
    const double turning = restitution > 0 ? 0 : 10 * mass.mass * arm.x / pivot;
    return {impulse,
            {impulse.x / mass.mass, impulse.y / mass.mass - fall - 10 * after},
            cross(arm, impulse) / mass.inertia + after * turning};
}

CrossScene boxOnItsCorner() {
    CrossScene scene{
        "BoxOnItsCornerTipsOverAndLiesFlat", "A box falls on its corner and lies flat",
        "The corner sticks: its impulse follows from the effective mass at the corner. "
        "The box then tips about it and lies flat.",
        "", scenes::boxOnItsCorner()};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const double spin = engine.state(1).spin;
        const double rest = runToRest(engine, 1, 1, 8);
        const State end = engine.state(1);
        return {hit.time,       hit.impulse,          spin,      rest,
                end.position.y, offSquare(end.angle), end.angle, end.position.x};
    };
    const Vec2 arm = scene.def.bodies[1].rotation * Vec2{-0.5, -0.5};
    const double spin = land(massOf(scene.def.bodies[1]), arm, std::sqrt(20.0), 0.6, 0).spin;
    figure(scene, "first hit", "s").exact(std::sqrt(0.2), 2 * kDt, kTwoSteps);
    figure(scene, "impulse of three steps", "N s")
        .agree(0.2, "a step of gravity, 0.17 N s, more or less");
    figure(scene, "spin after", "rad/s")
        .exact(spin, 0.05 * std::abs(spin), "gravity turns it for up to three steps");
    figure(scene, "at rest from", "s").agree(0.5, "rocking depends on the slip of the corner");
    figure(scene, "height at rest", "m").exact(0.5, 0.01, kSlop);
    figure(scene, "off square at rest", "rad").exact(0, 2e-3, "2 mm over the width of 1 m");
    figure(scene, "angle at rest", "rad").agree(4e-3, "the same side, within 2 mrad each");
    figure(scene, "place at rest", "m").agree(0.1, "the slip of the corner: a tenth of the width");
    return scene;
}

CrossScene boxOnItsCornerBounces() {
    CrossScene scene{"BoxOnItsCornerBouncesWithFriction",
                     "A box falls on its corner and bounces, e = 0.5",
                     "The corner sticks while it bounces: K J = (-v_x, -(1 + e) v_y). Free fall "
                     "follows.",
                     "", scenes::boxOnItsCorner(0.5)};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State now = engine.state(1);
        return {hit.time, hit.impulse, now.velocity.x, now.velocity.y, now.spin};
    };
    const Vec2 arm = scene.def.bodies[1].rotation * Vec2{-0.5, -0.5};
    const double fall = std::sqrt(20.0);
    const Landing exact = land(massOf(scene.def.bodies[1]), arm, fall, 0.6, 0.5);
    const char* const step = "3 %: the fall is up to one step longer or shorter";
    figure(scene, "first hit", "s").exact(std::sqrt(0.2), 2 * kDt, kTwoSteps);
    figure(scene, "impulse", "N s")
        .exact(exact.impulse.y, 0.03 * exact.impulse.y, step)
        .thesis(0.04 * exact.impulse.y, "4 %: a whole step of gravity, 0.17 of 4.5 m/s");
    figure(scene, "after, x", "m/s").exact(exact.velocity.x, 0.03 * fall, step);
    figure(scene, "after, y", "m/s").exact(exact.velocity.y, 0.03 * fall + 10 * kDt, step);
    figure(scene, "spin after", "rad/s").exact(exact.spin, 0.03 * fall, step);
    return scene;
}

CrossScene compound() {
    CrossScene scene{"CompoundOfTwoBoxesLandsAndLiesAsOneBody", "An L of two boxes falls and lies",
                     "Mass and centre of mass by the parallel axis theorem. The corner slips, so "
                     "its impulse lies on the edge of the friction cone.",
                     "The rounded corners of Box2D 2.4.1 shift the lever arm.",
                     scenes::compoundDropped()};
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const State start = engine.state(1);
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State afterHit = engine.state(1);
        const double rest = runToRest(engine, 1, 1, 8);
        const State end = engine.state(1);
        return {start.position.x, start.position.y,    hit.time, afterHit.spin,
                afterHit.spin,    afterHit.velocity.y, rest,     end.position.y,
                end.angle,        end.position.x};
    };
    const scenes::BodyDef& body = scene.def.bodies[1];
    const Vec2 center = massOf(body).center;
    const Vec2 start = body.position + body.rotation * center;
    const Vec2 corner = body.position + body.rotation * Vec2{1, -0.25};
    const double fall = std::sqrt(20 * corner.y);
    const double spin = land(massOf(body), corner - start, fall, 0.6, 0).spin;
    figure(scene, "centre of mass x", "m").exact(start.x, 1e-6, "rounding");
    figure(scene, "centre of mass y", "m").exact(start.y, 1e-6, "rounding");
    figure(scene, "first hit", "s").exact(std::sqrt(2 * corner.y / 10), 2 * kDt, kTwoSteps);
    figure(scene, "spin after", "rad/s")
        .kodoExact(spin, 0.08 * std::abs(spin), "8 %: half a step of rotation by gravity");
    figure(scene, "spin after, both", "rad/s")
        .agree(0.1 * std::abs(spin), "10 %: rounded corners of Box2D, and a step of gravity");
    figure(scene, "fall after", "m/s").agree(0.15, "one step of gravity, 0.17 m/s");
    figure(scene, "at rest from", "s").agree(0.5, "rocking depends on the slip of the corner");
    figure(scene, "height of the centre at rest", "m").exact(0.25 + center.y, 0.01, kSlop);
    figure(scene, "angle at rest", "rad").exact(0, 4e-3, "8 mm over the width of 2 m");
    figure(scene, "place at rest", "m").agree(0.1, "the slip of the corner");
    return scene;
}

std::vector<double> measurePins(Engine& engine, const scenes::SceneDef& def) {
    const double start = energy(engine, def);
    const Hit hit = runToHit(engine, 0, 3, 2);
    const State bounced = engine.state(0);
    double most = 0;
    double out = -1;
    for (int i = 0; i < 600 && out < 0; ++i) {
        engine.step(kDt);
        most = std::max(most, energy(engine, def));
        out = engine.state(0).position.y < -3 ? i * kDt : -1;
    }
    return {hit.time,           hit.impulse,  bounced.velocity.x, bounced.velocity.y,
            bounced.velocity.x, bounced.spin, most / start,       out < 0 ? 1e3 : out};
}

CrossScene pins() {
    CrossScene scene{
        "BallThroughPinsBouncesAndFallsOut", "A ball falls through rows of pins",
        "A ball among pins is chaotic: each bounce multiplies a difference in place by "
        "about 2 d / R = 10. Only the first bounce has a closed form, with Coulomb "
        "friction on a ball without spin.",
        "After the second bounce the least difference decides the path.",
        scenes::ballThroughPins()};
    scene.drawn = {0};
    scene.measure = [def = scene.def](Engine& engine) { return measurePins(engine, def); };
    // The centre is 0.35 m from the pin's centre, vertically above x = 0.15.
    const Vec2 normal = (1 / 0.35) * Vec2{0.15, std::sqrt(0.35 * 0.35 - 0.15 * 0.15)};
    const Vec2 tangent{-normal.y, normal.x};
    const double speed = std::sqrt(2 * 10 * (3 - 0.35 * normal.y));
    const Mass mass = massOf(scene.def.bodies[0]);
    const double impulse = 1.6 * mass.mass * speed * normal.y;
    const double stick = mass.mass * speed * tangent.y / 3; // of a disc: m_t = m / 3
    const double frictionImpulse = std::clamp(stick, -0.3 * impulse, 0.3 * impulse);
    const Vec2 after =
        Vec2{0, -speed} + (1 / mass.mass) * (impulse * normal + frictionImpulse * tangent);
    const char* const gravity = "up to three steps of gravity since the impact";
    const char* const place = "overlap of up to a step in Box2D turns the normal";
    figure(scene, "first hit", "s").exact(speed / 10, 2 * kDt, kTwoSteps);
    figure(scene, "impulse", "N s").kodoExact(impulse, 0.02 * impulse, "one step of gravity");
    figure(scene, "after the bounce, x", "m/s").kodoExact(after.x, 0.25, gravity);
    figure(scene, "after the bounce, y", "m/s").kodoExact(after.y, 0.25 + 3 * 10 * kDt, gravity);
    figure(scene, "after the bounce, x, both", "m/s").agree(0.5, place);
    figure(scene, "spin after the bounce, both", "rad/s").agree(1.5, place);
    figure(scene, "largest share of the energy", "").atMost(1.001, "no energy from nothing");
    figure(scene, "out below from", "s").atMost(10, "it must fall out");
    return scene;
}

/// A box falls flat with e = 0.5: two points are hit at once.
CrossScene flatDrop() {
    CrossScene scene{
        "BoxFallsFlatAndRisesWithoutSpin",
        "A box falls flat and bounces, e = 0.5",
        "Both corners are hit at once. The box leaves at half its speed, without spin.",
        "",
        {"flat drop", scenes::kDown, {scenes::ground(20, {0.6, 0.5})}}};
    scene.def.bodies.push_back(scenes::box(1, 0.5, {0, 1.25}, {0.6, 0.5}));
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State now = engine.state(1);
        return {hit.time, hit.impulse, now.velocity.y, now.spin};
    };
    const double fall = std::sqrt(20.0);
    figure(scene, "first hit", "s").exact(std::sqrt(0.2), 2 * kDt, kTwoSteps);
    figure(scene, "impulse", "N s")
        .exact(0.5 * 1.5 * fall, 0.5 * 2 * 10 * kDt, "up to two steps of gravity");
    figure(scene, "after, y", "m/s")
        .exact(0.5 * fall - 2.5 * 10 * kDt, 1.5 * 10 * kDt, "up to three steps of gravity");
    figure(scene, "spin after", "rad/s").exact(0, 1e-4, "symmetry, to rounding");
    return scene;
}

} // namespace

std::vector<CrossScene> dropScenes() {
    return {boxOnItsCorner(), boxOnItsCornerBounces(), compound(), flatDrop(), pins()};
}

} // namespace crosscheck
