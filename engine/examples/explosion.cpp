// SPDX-License-Identifier: MIT
// Explosion: crates near it are thrown, those behind a wall are not. A ray tells what is in sight.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

namespace {

/// Pushes what the centre sees within a radius (m), with at most `strength` N s per m^2 of area.
int explode(kodo::World& world, kodo::Vec2 center, float radius, float strength) {
    int thrown = 0;
    for (const kodo::BodyId id : kodo::overlap(world, kodo::Circle{radius}, {center, {}})) {
        kodo::BodyRef body = world[id];
        const auto seen = kodo::rayCast(world, center, body.center());
        if (body.type() != kodo::BodyType::Dynamic || !seen || seen->body != id) {
            continue; // something else is in between
        }
        const kodo::Vec2 way = seen->point - center;
        const float share = 1 - length(way) / radius;
        if (share > 0) {
            body.applyImpulse(share * strength * body.area() * normalize(way), seen->point);
            ++thrown;
        }
    }
    return thrown;
}

} // namespace

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
    std::printf("%d crates are thrown\n", explode(world, {0, 0.5f}, 5, 12));
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
