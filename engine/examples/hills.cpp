// SPDX-License-Identifier: MIT
// Hills: balls roll over a heightmap of 100 cells. Nothing stops them where two cells meet.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    // Waves on a slope: heights by the engine's own sine, which has the same bits everywhere.
    kodo::Heightmap hills{.origin = {0, 0}, .spacing = 0.5f};
    for (int i = 0; i <= 100; ++i) {
        const float x = 0.5f * static_cast<float>(i);
        hills.heights.push_back(8 - 0.1f * x + 0.1f * kodo::sinCos(0.7f * x).sin);
    }
    world.add({.shape = hills, .type = kodo::BodyType::Static});

    const auto addBall = [&](float x, float rollingResistance) {
        kodo::Material rubber = kodo::withFriction(0.9f);
        rubber.rollingResistance = rollingResistance; // lever arm, as share of the radius
        return world.add(
            {.shape = kodo::Circle{0.4f}, .position = {x, 8.5f - 0.1f * x}, .material = rubber});
    };
    const kodo::BodyId free = addBall(8, 0);
    const kodo::BodyId braked = addBall(3, 0.3f);
    int step = 0;
    for (; step < 1200 && world[free].position().x < 49; ++step) {
        world.step(1.0f / 60);
    }
    // A solid disc that rolls keeps a third of its kinetic energy in its rotation.
    const float speed = length(world[free].velocity());
    std::printf("rolls 41 m in %.1f s: %.1f m/s, %.1f rad/s x 0.4 m = %.1f m/s\n", step / 60.0,
                speed, -world[free].angularVelocity(), -0.4f * world[free].angularVelocity());
    std::printf("with rolling resistance: at x = %.1f m, %s\n", world[braked].position().x,
                world[braked].isAsleep() ? "asleep" : "awake");
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{-1, -2}, {51, 10}});
    }
}
