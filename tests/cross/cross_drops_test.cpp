// SPDX-License-Identifier: MIT
#include <scenes/impacts.hpp>

#include <algorithm>
#include <cmath>

#include "compare.hpp"

namespace crosscheck {
namespace {

using scenes::SceneDef;
using scenes::Vec2;

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

// Tolerances: the landing time agrees within two steps, and the spin within 5 % of the closed form
// for a sticking corner. Gravity has changed the spin for up to three steps by then. The final pose
// is flat, on the same side, at the same height within 1 cm (Box2D's slop is 5 mm). The final x
// depends on slipping; 0.1 m is a tenth of the width.
TEST(CrossDrops, ABoxOnItsCornerTipsOverAndLiesFlat) {
    const SceneDef scene = scenes::boxOnItsCorner();
    const auto figures = inBoth(scene, [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const double spin = engine.state(1).spin;
        const double rest = runToRest(engine, 1, 1, 8);
        const State end = engine.state(1);
        return {hit.time,       hit.impulse,          spin,      rest,
                end.position.y, offSquare(end.angle), end.angle, end.position.x};
    });
    const Vec2 arm = scene.bodies[1].rotation * Vec2{-0.5, -0.5};
    const double spin = land(massOf(scene.bodies[1]), arm, std::sqrt(20.0), 0.6, 0).spin;
    Comparison table;
    table.witness("first hit [s]", std::sqrt(0.2), figures[0], 2 * kDt);
    table.agree("impulse of three steps [N s]", figures[1], 0.2);
    table.witness("spin after [rad/s]", spin, figures[2], 0.05 * std::abs(spin));
    table.agree("at rest from [s]", figures[3], 0.5);
    table.witness("height at rest [m]", 0.5, figures[4], 0.01);
    table.witness("off square at rest [rad]", 0, figures[5], 2e-3);
    table.agree("angle at rest [rad]", figures[6], 4e-3);
    table.agree("place at rest [m]", figures[7], 0.1);
    EXPECT_TRUE(table.holds());
}

// With e = 0.5 the corner sticks while it bounces, and free fall follows. Both agree within 3 %,
// since the fall is up to one step longer or shorter than to the touch.
TEST(CrossDrops, ABoxOnItsCornerBouncesWithFriction) {
    const SceneDef scene = scenes::boxOnItsCorner(0.5);
    const auto figures = inBoth(scene, [](Engine& engine) -> std::vector<double> {
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State now = engine.state(1);
        return {hit.time, hit.impulse, now.velocity.x, now.velocity.y, now.spin};
    });
    const Vec2 arm = scene.bodies[1].rotation * Vec2{-0.5, -0.5};
    const double fall = std::sqrt(20.0);
    const Landing exact = land(massOf(scene.bodies[1]), arm, fall, 0.6, 0.5);
    Comparison table;
    table.witness("first hit [s]", std::sqrt(0.2), figures[0], 2 * kDt);
    table.witness("impulse [N s]", exact.impulse.y, figures[1], 0.03 * exact.impulse.y);
    table.witness("after, x [m/s]", exact.velocity.x, figures[2], 0.03 * fall);
    table.witness("after, y [m/s]", exact.velocity.y, figures[3], 0.03 * fall + 10 * kDt);
    table.witness("spin after [rad/s]", exact.spin, figures[4], 0.03 * fall);
    EXPECT_TRUE(table.holds());
}

// Checks mass and centre by closed form, since State holds the centre of mass; the first touch; and
// the spin after it. The corner slips; 8 % covers half a step of rotation by gravity. At rest, the
// long box lies flat on the ground, with the centre of mass at its closed form.
TEST(CrossDrops, ACompoundOfTwoBoxesLandsAndLiesAsOneBody) {
    const SceneDef scene = scenes::compoundDropped();
    const auto figures = inBoth(scene, [](Engine& engine) -> std::vector<double> {
        const State start = engine.state(1);
        const Hit hit = runToHit(engine, 0, 1, 2);
        const State afterHit = engine.state(1);
        const double rest = runToRest(engine, 1, 1, 8);
        const State end = engine.state(1);
        return {start.position.x, start.position.y,    hit.time,
                afterHit.spin,    afterHit.velocity.y, rest,
                end.position.y,   end.angle,           end.position.x};
    });
    const scenes::BodyDef& body = scene.bodies[1];
    const Vec2 center = massOf(body).center;
    const Vec2 start = body.position + body.rotation * center;
    const Vec2 corner = body.position + body.rotation * Vec2{1, -0.25};
    const double fall = std::sqrt(20 * corner.y);
    const double spin = land(massOf(body), corner - start, fall, 0.6, 0).spin;
    Comparison table;
    table.witness("centre of mass x [m]", start.x, figures[0], 1e-6);
    table.witness("centre of mass y [m]", start.y, figures[1], 1e-6);
    table.witness("first hit [s]", std::sqrt(2 * corner.y / 10), figures[2], 2 * kDt);
    table.judge("spin after [rad/s]", spin, figures[3], 0.08 * std::abs(spin));
    table.agree("spin after, both [rad/s]", figures[3], 0.1 * std::abs(spin));
    table.agree("fall after [m/s]", figures[4], 0.15);
    table.agree("at rest from [s]", figures[5], 0.5);
    table.witness("height of the centre at rest [m]", 0.25 + center.y, figures[6], 0.01);
    table.witness("angle at rest [rad]", 0, figures[7], 4e-3);
    table.agree("place at rest [m]", figures[8], 0.1);
    EXPECT_TRUE(table.holds());
}

// A ball among pins is chaotic: each bounce on a round pin multiplies a difference in position by
// about 2 d / R = 10. Only the first bounce can agree; its closed form uses Coulomb friction on a
// ball without spin. After that, every ball must fall through in about the same time without a gain
// of energy.
TEST(CrossDrops, ABallThroughPegsBouncesAndFallsOut) {
    const SceneDef scene = scenes::ballThroughPins();
    const auto figures = inBoth(scene, [&](Engine& engine) -> std::vector<double> {
        const double start = energy(engine, scene);
        const Hit hit = runToHit(engine, 0, 3, 2);
        const State bounced = engine.state(0);
        double most = 0;
        double out = -1;
        for (int i = 0; i < 600 && out < 0; ++i) {
            engine.step(kDt);
            most = std::max(most, energy(engine, scene));
            out = engine.state(0).position.y < -3 ? i * kDt : -1;
        }
        return {hit.time,     hit.impulse, bounced.velocity.x, bounced.velocity.y, bounced.spin,
                most / start, out};
    });
    // The centre is 0.35 m from the pin's centre, vertically above x = 0.15.
    const Vec2 normal = (1 / 0.35) * Vec2{0.15, std::sqrt(0.35 * 0.35 - 0.15 * 0.15)};
    const Vec2 tangent{-normal.y, normal.x};
    const double speed = std::sqrt(2 * 10 * (3 - 0.35 * normal.y));
    const Mass mass = massOf(scene.bodies[0]);
    const double impulse = 1.6 * mass.mass * speed * normal.y;
    const double stick = mass.mass * speed * tangent.y / 3; // of a disc: m_t = m / 3
    const double frictionImpulse = std::clamp(stick, -0.3 * impulse, 0.3 * impulse);
    const Vec2 after =
        Vec2{0, -speed} + (1 / mass.mass) * (impulse * normal + frictionImpulse * tangent);
    Comparison table;
    table.witness("first hit [s]", speed / 10, figures[0], 2 * kDt);
    table.judge("impulse [N s]", impulse, figures[1], 0.02 * impulse);
    // Up to three steps of gravity since the impact.
    table.judge("after the bounce, x [m/s]", after.x, figures[2], 0.25);
    table.judge("after the bounce, y [m/s]", after.y, figures[3], 0.25 + 3 * 10 * kDt);
    table.agree("after the bounce, x, both [m/s]", figures[2], 0.5);
    table.agree("spin after the bounce, both [rad/s]", figures[4], 1.5);
    table.show("largest share of the energy", figures[5]);
    table.show("out below from [s]", figures[6]);
    EXPECT_TRUE(table.holds());
    EXPECT_LE(figures[5].kodo, 1.001); // the initial potential energy is the total
    EXPECT_GT(figures[6].kodo, 0);
    EXPECT_GT(figures[6].box2d, 0);
}

} // namespace
} // namespace crosscheck
