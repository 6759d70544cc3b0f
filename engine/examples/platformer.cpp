// SPDX-License-Identifier: MIT
// Platformer: a mover walks over tiles, up a slope and steps, rides on a lift, and jumps through a
// one-way ledge.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world; // the mover has its own gravity
    const auto addStatic = [&](const kodo::Shape& shape) {
        world.add({.shape = shape, .type = kodo::BodyType::Static});
    };
    // Ten flat cells of 1 m, a slope of 27 degrees, and two steps of 0.25 m.
    addStatic(
        kodo::Heightmap{.spacing = 1, .heights = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1, 1}});
    addStatic(kodo::Box{1, 0.25f, {13.5f, 1.125f}});
    addStatic(kodo::Box{1, 0.5f, {14.5f, 1.25f}});
    // The front of a one-sided segment is on the left of from -> to: here, above.
    addStatic(kodo::Segment{.from = {4, 2}, .to = {9, 2}, .oneSided = true});
    const kodo::BodyId lift = world.add(
        {.shape = kodo::Box{2, 0.5f}, .position = {16, 1.25f}, .type = kodo::BodyType::Kinematic});

    kodo::Mover player{.position = {1, 0.71f}};
    const auto tell = [&](const char* what, int step) {
        std::printf("step %3d: %s at (%.2f, %.2f)\n", step, what, player.position.x,
                    player.position.y);
    };
    constexpr float kStep = 1.0f / 60, kGravity = 20; // s, m/s^2
    bool wasGrounded = false;
    for (int step = 1; step <= 420; ++step) {
        if (step == 300) {
            world[lift].setVelocity({0, 1});
        }
        world.step(kStep);
        const bool jumps = step == 40 && player.grounded;
        const float run = player.position.x < 16 ? 5.0f : 0.0f;
        player.move(world, {run, jumps ? 10 : player.velocity.y - kGravity * kStep}, kStep);
        if (player.grounded != wasGrounded) {
            tell(player.grounded ? "lands" : "leaves the ground", step);
        }
        wasGrounded = player.grounded;
        if (argc > 1 && step == 90) { // a picture, with the mover as a body
            world.add({.shape = kodo::shapeOf(player.shape), .position = player.position});
            std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{0, -0.5f}, {18, 5}});
            return 0;
        }
    }
    tell(player.groundBody == lift ? "rides on the lift" : "stands", 420);
}
