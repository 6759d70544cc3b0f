// SPDX-License-Identifier: MIT
// Bridge: planks on pins between two cliffs. It carries a crate, and breaks under a heavier one.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <vector>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    const auto addCliff = [&](float x) {
        return world.add(
            {.shape = kodo::Box{4, 4}, .position = {x, -2}, .type = kodo::BodyType::Static});
    };
    const kodo::BodyId left = addCliff(-8);
    const kodo::BodyId right = addCliff(8);

    // 12 planks in the shape of a V, on pins that break.
    std::vector<kodo::BodyId> planks;
    const auto pin = [&](kodo::BodyId a, kodo::Vec2 anchorA, kodo::BodyId b, kodo::Vec2 anchorB) {
        world.add(kodo::RevoluteJoint{
            .ends = {.a = a, .b = b, .anchorA = anchorA, .anchorB = anchorB, .breakForce = 6000}});
    };
    for (int i = 0; i < 12; ++i) {
        const float side = i < 6 ? -1.0f : 1.0f;
        const float x = static_cast<float>(i) - 5.5f;
        planks.push_back(world.add({.shape = kodo::Box{1.05f, 0.2f},
                                    .position = {x, -0.1f - 0.32f * (6 - side * x)},
                                    .rotation = kodo::Rot::fromAngle(0.31f * side),
                                    .density = 10}));
        if (i > 0) {
            pin(planks[planks.size() - 2], {0.525f, 0}, planks.back(), {-0.525f, 0});
        }
    }
    pin(left, {2, 1.9f}, planks.front(), {-0.525f, 0});
    pin(planks.back(), {0.525f, 0}, right, {-2, 1.9f});

    const auto run = [&](const char* what, int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(1.0f / 60);
        }
        std::printf("%s: %zu of 13 pins, the middle sags by %.2f m\n", what, world.joints().size(),
                    -world[planks[6]].position().y);
    };
    run("empty", 240);
    world.add({.shape = kodo::Box{1, 1}, .position = {0, -0.9f}, .density = 20});
    run("20 kg", 240);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {.contacts = true},
                                            kodo::Aabb{{-8, -3}, {8, 2}});
    }
    world.add({.shape = kodo::Box{1, 1}, .position = {0, 4}, .density = 400});
    run("420 kg", 90);
}
