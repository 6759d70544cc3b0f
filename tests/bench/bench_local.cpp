// SPDX-License-Identifier: MIT
// Loads with many bodies of which few move or change. The cost should follow these few.
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::Material;
using scenes::Vec2;

constexpr int kPerStep = 100; // rays, or bodies that are removed and added

/// Casts so many rays of 20 m in each step, from the square of this side (m) at the origin.
void castRays(Scene& scene, int rays, double side, std::uint64_t seed) {
    scene.every = 1;
    scene.actIsTimed = true;
    scene.act = [=, random = std::make_shared<Dice>(seed)](Stage& stage, int) {
        for (int i = 0; i < rays; ++i) {
            const Vec2 from{random->between(0, side), random->between(0, side)};
            const Vec2 way = 20.0 * scenes::direction(random->between(0, 1));
            stage.engine().rayCast(from, from + way);
        }
    };
}

} // namespace

/// 200 balls and boxes bounce on a floor of static tiles.
Scene tiles(int size, std::uint64_t seed) {
    constexpr int kMovers = 200;
    Dice dice(seed);
    Scene scene;
    scene.def = {"tiles", scenes::kDown, {}};
    const int columns = std::max(size / 4, std::min(size, kMovers));
    const Material springy{0.5, 1};
    for (int i = 0; i < size; ++i) {
        const double x = i % columns - columns / 2;
        scene.def.bodies.push_back(wall(1, 1, {x, -0.5 - i / columns}, springy));
    }
    for (int i = 0; i < kMovers; ++i) {
        const double x = (i + 0.5) * columns / kMovers - columns / 2;
        const Vec2 at{x, dice.between(1, 3)};
        BodyDef mover = scenes::ball(0.3, at, springy);
        if (i % 2 == 0) {
            mover = scenes::box(0.5, 0.5, at, springy);
        }
        scene.def.bodies.push_back(mover);
    }
    scene.warmUp = 60;
    return scene;
}

/// Rays of 20 m among boxes that do not move, half of them static.
Scene rays(int size, std::uint64_t seed) {
    Dice dice(seed);
    Scene scene;
    scene.def = {"rays", {}, {}};
    const double side = 1.5 * std::sqrt(static_cast<double>(size));
    for (int i = 0; i < size; ++i) {
        const Vec2 at{dice.between(0, side), dice.between(0, side)};
        scene.def.bodies.push_back(i % 2 == 0 ? wall(0.8, 0.8, at) : scenes::box(0.8, 0.8, at));
        scene.def.bodies.back().category = 1; // its mask has another one: no collisions
        scene.def.bodies.back().mask = 2;
    }
    castRays(scene, kPerStep, side, seed + 1);
    return scene;
}

/// Rays of 20 m among balls that fly about in a closed box.
Scene flying(int size, std::uint64_t seed) {
    Dice dice(seed);
    Scene scene;
    scene.def = {"flying", {}, {}};
    const double side = 1.5 * std::sqrt(static_cast<double>(size));
    const Material springy{0, 1};
    for (const double end : {-0.5, side + 0.5}) {
        scene.def.bodies.push_back(wall(side + 2, 1, {side / 2, end}, springy));
        scene.def.bodies.push_back(wall(1, side + 2, {end, side / 2}, springy));
    }
    for (int i = 0; i < size; ++i) {
        const Vec2 at{dice.between(0.3, side - 0.3), dice.between(0.3, side - 0.3)};
        scene.def.bodies.push_back(scenes::ball(0.2, at, springy));
        scene.def.bodies.back().velocity = {dice.between(-5, 5), dice.between(-5, 5)};
    }
    castRays(scene, 10, side, seed + 1);
    scene.warmUp = 60;
    return scene;
}

/// A heap of which bodies are taken and on which others fall, in every step.
Scene churn(int size, std::uint64_t seed) {
    Dice dice(seed);
    Scene scene;
    scene.def = {"churn", scenes::kDown, {wall(0.3 * size + 20, 1, {0, -0.5})}};
    const auto newcomer = [=](Dice& from) {
        return scenes::ball(0.1, {from.between(-0.1, 0.1) * size, from.between(0.2, 3)});
    };
    const auto alive = std::make_shared<std::vector<std::size_t>>();
    for (int i = 0; i < size; ++i) {
        alive->push_back(scene.def.bodies.size());
        scene.def.bodies.push_back(newcomer(dice));
    }
    scene.every = 1;
    scene.actIsTimed = true;
    const auto random = std::make_shared<Dice>(seed + 1);
    scene.act = [=](Stage& stage, int) {
        for (int i = 0; i < std::min(kPerStep, size); ++i) {
            std::size_t& body = (*alive)[static_cast<std::size_t>(random->between(0, size - 1))];
            stage.remove(body);
            body = stage.placeOfNext();
            stage.add(newcomer(*random));
        }
    };
    scene.warmUp = 30;
    return scene;
}

} // namespace bench
