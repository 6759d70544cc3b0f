// SPDX-License-Identifier: MIT
// Explosion: crates that the centre sees are thrown, those behind a wall are not.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Box{0.4f, 3}, .position = {2, 1.5f}, .type = kodo::BodyType::Static});
    const auto addCrate = [&](float x, float y) {
        return world.add({.shape = kodo::Box{0.8f, 0.8f}, .position = {x, y}});
    };
    const kodo::BodyId open = addCrate(-2, 0.4f);
    const kodo::BodyId above = addCrate(-2, 1.2f);
    const kodo::BodyId sheltered = addCrate(3, 0.4f);
    for (int step = 0; step < 30; ++step) {
        world.step(1.0f / 60);
    }
    const auto hits = kodo::explode(
        world, {.center = {0, 0.5f}, .radius = 1, .falloff = 4, .impulse = 8}); // N s/m
    for (const kodo::ExplosionHit& hit : hits) {
        std::printf("%s: %.1f N s over %.2f m\n", hit.body == open ? "below" : "above",
                    length(hit.impulse), hit.width);
    }
    for (int step = 0; step < 24; ++step) {
        world.step(1.0f / 60);
    }
    const auto tell = [&](const char* name, kodo::BodyId id) {
        const kodo::Vec2 place = world[id].position();
        std::printf("%s: (%.2f, %.2f)\n", name, place.x, place.y);
    };
    tell("in the open", open);
    tell("on top of it", above);
    tell("behind the wall", sheltered);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true},
                                            kodo::Aabb{{-9, -0.5f}, {5, 5}});
    }
}
