// SPDX-License-Identifier: MIT
// Scenes with a closed form, which gives the error of each engine.
#include <scenes/impacts.hpp>
#include <scenes/piles.hpp>
#include <scenes/scene_mass.hpp>
#include <scenes/slides.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_scenes.hpp"

namespace bench {

// Contact k (the ground's is 1) carries the sum of m g above it.
Scene forces(int size, std::uint64_t) {
    Scene scene;
    scene.def = scenes::stack(10);
    scene.def.name = "forces";
    scene.def.bodies[10].density = size;
    scene.error = {"contact force, worst", "", [=](const Stage& stage, const Depths&) {
                       double worst = 0;
                       for (std::size_t k = 1; k <= 10; ++k) {
                           const double weight = 10 * (static_cast<double>(10 - k) + size);
                           const double force = stage.engine().impulse(k - 1, k) / kDt;
                           worst = std::max(worst, std::abs(force / weight - 1));
                       }
                       return worst;
                   }};
    return scene;
}

// s = v^2 / (2 mu g) = 25/6 m.
Scene slide(int, std::uint64_t) {
    Scene scene;
    scene.def = scenes::slidingBox(0.3);
    scene.error = {"stop distance", "", [](const Stage& stage, const Depths&) {
                       return std::abs(stage.engine().state(1).position.x / (25.0 / 6) - 1);
                   }};
    return scene;
}

// From 5 m with e = 0.8, the third peak has the height 5 e^6. Peaks lie between two steps: v^2 / (2
// g) above the position of the first falling step.
Scene bounce(int, std::uint64_t) {
    struct Peaks {
        bool rising = false;
        std::vector<double> heights;
    };
    const auto peaks = std::make_shared<Peaks>();
    Scene scene;
    scene.def = scenes::bouncingBall(0.8);
    scene.every = 1;
    scene.act = [=](Stage& stage, int) {
        const BodyState ball = stage.engine().state(1);
        const double v = ball.velocity.y;
        if (peaks->rising && v <= 0) {
            peaks->heights.push_back(ball.position.y - 0.5 + v * v / 20);
        }
        peaks->rising = v > 0;
    };
    scene.error = {"third peak", "", [=](const Stage&, const Depths&) {
                       return peaks->heights.size() < 3
                                  ? 1.0
                                  : std::abs(peaks->heights[2] / (5 * std::pow(0.8, 6)) - 1);
                   }};
    return scene;
}

// A bar of 1 m with a revolute joint at its end, released horizontally. The total energy stays at
// 0; the swing has m g / 2. The error oscillates with the swing, so its value at the end would
// depend on the phase. The maximum magnitude counts, sampled ten times per second.
Scene pendulum(int, std::uint64_t) {
    const auto worst = std::make_shared<double>(0);
    Scene scene;
    scene.def = {"pendulum", scenes::kDown, {scenes::ball(0.1, {}), scenes::box(1, 0.1, {0.5, 0})}};
    scene.def.bodies[0].locked = true;
    scene.def.joints = {{0, 1, {0, 0}}};
    scene.every = 6;
    scene.act = [=](Stage& stage, int) {
        const std::vector<Placed> bodies = stage.bodies();
        const double weight = 10 * scenes::massOf(*bodies[1].def).mass;
        const double energy = kineticEnergy(bodies) + weight * bodies[1].state.position.y;
        *worst = std::max(*worst, std::abs(energy) / (weight / 2));
    };
    scene.error = {"energy lost or won, at most", "",
                   [=](const Stage&, const Depths&) { return *worst; }};
    return scene;
}

} // namespace bench
