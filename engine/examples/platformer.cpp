// SPDX-License-Identifier: MIT
// Platformer ground: a heightmap without ghost collisions, and a one-way ledge.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -20}}};
    // Ten flat cells of 1 m, then a slope. Bodies slide over the joins.
    world.add(
        {.shape = kodo::Heightmap{.spacing = 1,
                                  .heights = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1, 1.5f, 2}},
         .type = kodo::BodyType::Static});
    // The front of a one-sided segment is on the left of from -> to: here, above.
    world.add({.shape = kodo::Segment{.from = {7, 2}, .to = {9, 2}, .oneSided = true},
               .type = kodo::BodyType::Static});

    const kodo::BodyId player = world.add({.shape = kodo::Box{0.6f, 1},
                                           .position = {1, 0.5f},
                                           .material = kodo::withFriction(0),
                                           .flags = kodo::kLockRotate | kodo::kNeverSleep});

    // Supported: a contact of the last step that carries the player.
    const auto onGround = [&] {
        for (const kodo::CollisionRecord& hit : world.collisions(player)) {
            const float up = hit.a == player ? -hit.normal.y : hit.normal.y;
            if (hit.totalImpulse > 0 && up > 0.7f) {
                return true;
            }
        }
        return false;
    };
    const auto tell = [&](const char* what, int step) {
        const kodo::Vec2 place = world[player].position();
        std::printf("step %3d: %s at (%.1f, %.1f)\n", step, what, place.x, place.y);
    };

    bool wasOnGround = true;
    for (int step = 1; step <= 240; ++step) {
        kodo::Vec2 velocity = world[player].velocity();
        const bool grounded = onGround();
        velocity.x = step < 90 ? 5.0f : 0.0f; // run to the right, then stand
        if (step == 72 && grounded) {         // jump through the ledge
            velocity.y = 10;
            tell("jumps", step);
        }
        world[player].setVelocity(velocity);
        world.step(1.0f / 60);
        if (onGround() && !wasOnGround) {
            tell("lands", step);
        }
        wasOnGround = onGround();
        if (argc > 1 && step == 90) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true});
        }
    }
    tell("stands", 240);
}
