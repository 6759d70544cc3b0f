// SPDX-License-Identifier: MIT
#include <scenes/piles.hpp>

#include <algorithm>
#include <cmath>

#include "compare.hpp"

namespace crosscheck {
namespace {

using scenes::SceneDef;

/// Mean force (N) between two bodies over the next second.
double meanForce(Engine& engine, std::size_t a, std::size_t b) {
    double sum = 0;
    for (int i = 0; i < 60; ++i) {
        engine.step(kDt);
        sum += engine.impulse(a, b);
    }
    return sum; // N s during one second
}

/// Maximum horizontal displacement and rotation of all bodies since the start of the scene.
std::vector<double> displacement(const Engine& engine, const SceneDef& scene) {
    double sideways = 0;
    double turn = 0;
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        const State now = engine.state(i);
        sideways = std::max(sideways, std::abs(now.position.x - scene.bodies[i].position.x));
        turn = std::max(turn, std::abs(now.angle));
    }
    return {sideways, turn};
}

// Contact k of n carries (n - k) m g. Each contact may overlap by 5 mm, Box2D's slop. There is no
// horizontal displacement or rotation.
TEST(CrossPiles, AStackOfFiveStandsAndCarriesItsWeight) {
    const SceneDef scene = scenes::stack(5);
    const auto figures = inBoth(scene, [&](Engine& engine) -> std::vector<double> {
        run(engine, 9);
        const double onGround = meanForce(engine, 0, 1);
        const double onTop = meanForce(engine, 4, 5);
        const std::vector<double> moved = displacement(engine, scene);
        return {onGround, onTop,    engine.state(1).position.y,          engine.state(5).position.y,
                moved[0], moved[1], std::abs(engine.state(5).velocity.y)};
    });
    Comparison table;
    table.witness("force on the ground [N]", 50, figures[0], 0.05);
    table.witness("force on the fourth box [N]", 10, figures[1], 0.05);
    table.witness("height of the first box [m]", 0.5, figures[2], 0.006);
    table.witness("height of the fifth box [m]", 4.5, figures[3], 0.026);
    table.witness("farthest sideways [m]", 0, figures[4], 1e-3);
    table.witness("farthest turned [rad]", 0, figures[5], 1e-3);
    table.witness("speed of the fifth box [m/s]", 0, figures[6], 1e-3);
    EXPECT_TRUE(table.holds());
}

// 55 boxes stand for ten seconds. The top rests on ten contacts, each within Box2D's slop, and no
// box moves by 1 cm. The ground carries 55 boxes.
TEST(CrossPiles, APyramidOfTenRowsStands) {
    const SceneDef scene = scenes::pyramid(10);
    const auto figures = inBoth(scene, [&](Engine& engine) -> std::vector<double> {
        run(engine, 10);
        double onGround = 0;
        for (std::size_t i = 1; i <= 10; ++i) {
            onGround += engine.impulse(0, i) / kDt;
        }
        const std::vector<double> moved = displacement(engine, scene);
        return {onGround, engine.state(55).position.y, moved[0], moved[1]};
    });
    Comparison table;
    table.witness("force on the ground [N]", 550, figures[0], 5.5);
    table.witness("height of the top [m]", 9.5, figures[1], 0.05);
    table.witness("farthest sideways [m]", 0, figures[2], 0.01);
    table.witness("farthest turned [rad]", 0, figures[3], 0.01);
    EXPECT_TRUE(table.holds());
}

// The light box carries ten times its weight, the ground eleven times. Overlap stays within 1 cm
// per contact in Kodo, whose contacts are soft; Box2D corrects it to its slop.
TEST(CrossPiles, ALightBoxCarriesOneTenTimesAsHeavy) {
    const SceneDef scene = scenes::heavyOnLight(10);
    const auto figures = inBoth(scene, [&](Engine& engine) -> std::vector<double> {
        run(engine, 9);
        const double onLight = meanForce(engine, 1, 2);
        const double onGround = meanForce(engine, 0, 1);
        const std::vector<double> moved = displacement(engine, scene);
        return {onLight,  onGround, engine.state(1).position.y, engine.state(2).position.y,
                moved[0], moved[1]};
    });
    Comparison table;
    table.witness("force on the light box [N]", 100, figures[0], 0.1);
    table.witness("force on the ground [N]", 110, figures[1], 0.1);
    table.witness("height of the light box [m]", 0.5, figures[2], 0.01);
    table.witness("height of the heavy box [m]", 1.5, figures[3], 0.02);
    table.witness("farthest sideways [m]", 0, figures[4], 1e-3);
    table.witness("farthest turned [rad]", 0, figures[5], 1e-3);
    EXPECT_TRUE(table.holds());
}

// Every domino hits the next one in order, and all but the last end up lying on a neighbour. The
// wave reaches a constant speed after a few dominoes. The engines differ in slip and overlap of
// corners during impacts: 10 % of the time, 0.05 rad of the final angle.
TEST(CrossPiles, ADominoRowFallsToTheLast) {
    constexpr int kCount = 10;
    const auto figures =
        inBoth(scenes::dominoRow(kCount), [&](Engine& engine) -> std::vector<double> {
            std::vector<double> hitTimes(kCount, -1); // time of the impact of i on i + 1
            for (int step = 1; step <= 600; ++step) {
                engine.step(kDt);
                for (std::size_t i = 1; i < kCount; ++i) {
                    if (hitTimes[i] < 0 && engine.impulse(i, i + 1) > 0) {
                        hitTimes[i] = step * kDt;
                    }
                }
            }
            double inOrder = 1;
            for (std::size_t i = 2; i < kCount; ++i) {
                inOrder *= hitTimes[i] > hitTimes[i - 1] ? 1 : 0;
            }
            return {hitTimes[1],
                    hitTimes[5],
                    hitTimes[9],
                    inOrder,
                    engine.state(1).angle,
                    engine.state(5).angle,
                    engine.state(kCount).angle};
        });
    Comparison table;
    table.agree("1 strikes 2 [s]", figures[0], 2 * kDt + 1e-6);
    table.agree("5 strikes 6 [s]", figures[1], 0.1 * figures[1].box2d);
    table.agree("9 strikes 10 [s]", figures[2], 0.1 * figures[2].box2d);
    table.witness("in order", 1, figures[3], 0);
    table.agree("lean of the first at rest [rad]", figures[4], 0.05);
    table.agree("lean of the fifth at rest [rad]", figures[5], 0.05);
    table.witness("the last lies flat [rad]", -kPi / 2, figures[6], 0.01);
    EXPECT_TRUE(table.holds());
}

} // namespace
} // namespace crosscheck
