// SPDX-License-Identifier: MIT
// Breakable tower: a brick breaks into two halves if an impulse exceeds its strength.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});

    constexpr kodo::Flags kBrick = 1; // a category
    constexpr float kStrength = 3;    // N s; the lowest brick carries 0.7 N s per step
    for (int row = 0; row < 8; ++row) {
        world.add({.shape = kodo::Box{1, 0.5f},
                   .position = {0, 0.25f + 0.5f * static_cast<float>(row)},
                   .flags = kBrick});
    }
    for (int step = 0; step < 60; ++step) {
        world.step(1.0f / 60);
    }
    world.add(
        {.shape = kodo::Circle{0.4f}, .position = {-6, 2.2f}, .velocity = {25, 2}, .density = 4});

    std::vector<kodo::BodyId> broken;
    for (int step = 0; step < 240; ++step) {
        world.step(1.0f / 60);
        broken.clear();
        for (const kodo::CollisionRecord& hit : world.collisions()) {
            for (const kodo::BodyId id : {hit.a, hit.b}) {
                const bool isNew = std::find(broken.begin(), broken.end(), id) == broken.end();
                if (hit.totalImpulse > kStrength && (world[id].flags() & kBrick) != 0 && isNew) {
                    std::printf("step %d: brick %u breaks under %.1f N s\n", step, id.index,
                                hit.totalImpulse);
                    broken.push_back(id);
                }
            }
        }
        for (const kodo::BodyId id : broken) { // two halves keep mass, momentum and spin
            const kodo::BodyView brick = world[id];
            for (const float side : {-0.25f, 0.25f}) {
                const kodo::Vec2 place = brick.transform() * kodo::Vec2{side, 0};
                world.add({.shape = kodo::Box{0.5f, 0.5f},
                           .position = place,
                           .rotation = brick.rotation(),
                           .velocity = brick.velocityAt(place),
                           .angularVelocity = brick.angularVelocity()});
            }
            world.remove(id);
        }
        if (argc > 1 && step == 20) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{-4, -0.5f}, {5, 5}});
        }
    }
    std::printf("%zu bodies at the end\n", world.bodyCount());
}
