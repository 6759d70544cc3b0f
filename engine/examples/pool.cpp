// SPDX-License-Identifier: MIT
// Pool from above: no gravity, drag instead of cloth, and a symmetric break of fifteen balls.
#include <kodo/kodo.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

int main(int argc, char** argv) {
    constexpr float kRadius = 0.0285f; // m
    kodo::World world{{.lengthUnit = 0.05f}};
    const kodo::Chain cushion{
        .points = {{-1.27f, -0.635f}, {1.27f, -0.635f}, {1.27f, 0.635f}, {-1.27f, 0.635f}},
        .closed = true};
    world.add({.shape = cushion,
               .material = kodo::withFriction(0.2f, 0.8f),
               .type = kodo::BodyType::Static});
    world.addField({std::make_shared<kodo::Drag>(kodo::DragLaw{.linear = 0.9f}), {}});

    const auto addBall = [&](float x, float y) {
        return world.add({.shape = kodo::Circle{kRadius},
                          .position = {x, y},
                          .material = kodo::withFriction(0.05f, 0.95f),
                          .mass = kodo::MassDef{.mass = 0.17f}}); // kg
    };
    std::vector<kodo::BodyId> balls;
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i <= row; ++i) {
            const float x = 0.6f + std::sqrt(3.0f) * kRadius * static_cast<float>(row);
            balls.push_back(addBall(x, kRadius * static_cast<float>(2 * i - row)));
        }
    }
    const kodo::BodyId cue = addBall(-0.6f, 0);
    world[cue].setVelocity({6, 0});

    int cushions = 0;
    for (int step = 0; step < 240; ++step) {
        world.step(1.0f / 120);
        for (const kodo::CollisionRecord& hit : world.hits(0.1f)) {
            cushions += hit.a.index == 0 ? 1 : 0; // the cushion is the first body
        }
    }
    // The rack is its own mirror image. So are the balls after the break: those of the first row
    // lie on the axis, and the outer balls of the second one on both sides of it.
    const kodo::Vec2 upper = world[balls[2]].position();
    const kodo::Vec2 lower = world[balls[1]].position();
    std::printf("second row: (%.3f, %.3f) and (%.3f, %.3f)\n", upper.x, upper.y, lower.x, lower.y);
    std::printf("first ball and cue ball off the axis by %.3f and %.3f m\n",
                std::abs(world[balls[0]].position().y), std::abs(world[cue].position().y));
    std::printf("cushions were hit %d times\n", cushions);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true});
    }
}
