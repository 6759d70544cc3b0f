// SPDX-License-Identifier: MIT
// Stacks, and a row of dominoes.
#include <scenes/piles.hpp>

#include <algorithm>
#include <cmath>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::SceneDef;

const char* const kWalks = "passes in turn let a stack walk without shock passes, from rounding on";

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

CrossScene stack() {
    CrossScene scene{"StackOfFiveStandsAndCarriesItsWeight", "A stack of five boxes stands",
                     "Contact k of n carries (n - k) m g. Nothing moves sideways or turns.", "",
                     scenes::stack(5)};
    scene.drawn = {1, 2, 3, 4, 5};
    scene.measure = [def = scene.def](Engine& engine) -> std::vector<double> {
        run(engine, 9);
        const double onGround = meanForce(engine, 0, 1);
        const double onTop = meanForce(engine, 4, 5);
        const std::vector<double> moved = displacement(engine, def);
        return {onGround, onTop,    engine.state(1).position.y,          engine.state(5).position.y,
                moved[0], moved[1], std::abs(engine.state(5).velocity.y)};
    };
    const char* const force = "0.1 % of the weight";
    const char* const slop = "each contact may overlap by 5 mm, Box2D's slop";
    figure(scene, "force on the ground", "N").exact(50, 0.05, force).withShock(-1, kStatic);
    figure(scene, "force on the fourth box", "N")
        .exact(10, 0.05, force)
        .thesis(0.1, "1 %: passes without warm starting do not converge fully");
    figure(scene, "height of the first box", "m").exact(0.5, 0.006, slop);
    figure(scene, "height of the fifth box", "m").exact(4.5, 0.026, slop);
    figure(scene, "farthest sideways", "m")
        .exact(0, 1e-3, "symmetry; 1 mm of rounding")
        .withoutShock(-1, kWalks);
    figure(scene, "farthest turned", "rad")
        .exact(0, 1e-3, "symmetry; 1 mrad of rounding")
        .withoutShock(-1, kWalks);
    figure(scene, "speed of the fifth box", "m/s")
        .exact(0, 1e-3, "it stands")
        .withoutShock(-1, "between steps the velocity holds what the next passes remove");
    return scene;
}

CrossScene pyramid() {
    CrossScene scene{"PyramidOfTenRowsStands", "A pyramid of 55 boxes stands for ten seconds",
                     "The ground carries 550 N.",
                     "The thesis's solver holds ten rows with shock passes alone.",
                     scenes::pyramid(10)};
    scene.drawn = {1, 10, 50, 55};
    scene.measure = [def = scene.def](Engine& engine) -> std::vector<double> {
        run(engine, 10);
        double onGround = 0;
        for (std::size_t i = 1; i <= 10; ++i) {
            onGround += engine.impulse(0, i) / kDt;
        }
        const std::vector<double> moved = displacement(engine, def);
        return {onGround, engine.state(55).position.y, moved[0], moved[1]};
    };
    figure(scene, "force on the ground", "N").exact(550, 5.5, "1 % in a single step");
    figure(scene, "height of the top", "m")
        .exact(9.5, 0.05, "ten contacts within the slop of 5 mm");
    figure(scene, "farthest sideways", "m").exact(0, 0.01, "1 cm: a hundredth of a box");
    figure(scene, "farthest turned", "rad").exact(0, 0.01, "a hundredth of a box");
    for (Figure& one : scene.figures) {
        one.withoutShock = Own{-1, "falls without shock passes; see engine/docs/solvers.md"};
    }
    scene.figures[0].withShock = Own{-1, kStatic};
    scene.figures[2].withShock = Own{0.15, "an order of ten levels with a bias to one side"};
    return scene;
}

CrossScene heavyOnLight() {
    CrossScene scene{"LightBoxCarriesOneTenTimesAsHeavy", "A light box carries a heavy one",
                     "The light box carries ten times its weight, the ground eleven times.",
                     "Kodo's contacts are soft, Box2D corrects to its slop.",
                     scenes::heavyOnLight(10)};
    scene.drawn = {1, 2};
    scene.measure = [def = scene.def](Engine& engine) -> std::vector<double> {
        run(engine, 9);
        const double onLight = meanForce(engine, 1, 2);
        const double onGround = meanForce(engine, 0, 1);
        const std::vector<double> moved = displacement(engine, def);
        return {onLight,  onGround, engine.state(1).position.y, engine.state(2).position.y,
                moved[0], moved[1]};
    };
    const char* const soft = "1 cm of overlap per contact: contacts of Kodo are soft";
    figure(scene, "force on the light box", "N").exact(100, 0.1, "0.1 % of the weight");
    figure(scene, "force on the ground", "N")
        .exact(110, 0.1, "0.1 % of the weight")
        .withoutShock(0.3, "0.3 %: passes without warm starting do not converge fully")
        .withShock(-1, kStatic);
    figure(scene, "height of the light box", "m").exact(0.5, 0.01, soft);
    figure(scene, "height of the heavy box", "m").exact(1.5, 0.02, soft);
    figure(scene, "farthest sideways", "m")
        .exact(0, 1e-3, "symmetry; 1 mm of rounding")
        .thesis(0.02, kWalks);
    figure(scene, "farthest turned", "rad").exact(0, 1e-3, "symmetry; 1 mrad of rounding");
    return scene;
}

std::vector<double> watchDominoes(Engine& engine) {
    constexpr int kCount = 10;
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
}

CrossScene dominoes() {
    CrossScene scene{"DominoRowFallsToTheLast", "A row of ten dominoes falls",
                     "Each domino hits the next one in order; all but the last lie on a neighbour. "
                     "There is no closed form of the wave.",
                     "The engines differ in slip and overlap of the corners.",
                     scenes::dominoRow(10)};
    scene.drawn = {1, 5, 10};
    scene.measure = watchDominoes;
    const char* const slip = "10 %: slip and overlap of corners during impacts";
    figure(scene, "1 strikes 2", "s").agree(2 * kDt + 1e-6, "two steps, as for every touch");
    figure(scene, "5 strikes 6", "s").agree(0.12, slip);
    figure(scene, "9 strikes 10", "s").agree(0.2, slip);
    figure(scene, "in order", "").exact(1, 0, "a count");
    figure(scene, "lean of the first at rest", "rad").agree(0.05, "slip of corners at rest");
    figure(scene, "lean of the fifth at rest", "rad").agree(0.05, "slip of corners at rest");
    figure(scene, "the last lies flat", "rad").exact(-kPi / 2, 0.01, "1 cm over 1 m");
    return scene;
}

} // namespace

std::vector<CrossScene> pileScenes() {
    return {stack(), pyramid(), heavyOnLight(), dominoes()};
}

} // namespace crosscheck
