// SPDX-License-Identifier: MIT
// Sensors: a gate counts the balls of one team that roll through it, without touching them.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    constexpr kodo::Flags kRed = 1;
    constexpr kodo::Flags kBlue = 2;

    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    const kodo::BodyId gate =
        world.add({.shape = kodo::Box{0.2f, 3},
                   .position = {0, 1.5f},
                   .type = kodo::BodyType::Static,
                   .flags = kodo::kSensor | kodo::kMatchAny, // detects bodies with a required flag
                   .required = kRed});
    for (int i = 0; i < 4; ++i) {
        world.add({.shape = kodo::Circle{0.25f},
                   .position = {-2 - static_cast<float>(i), 0.25f},
                   .velocity = {4, 0},
                   .flags = i % 2 == 0 ? kRed : kBlue,
                   .userData = static_cast<std::uint64_t>(i)});
    }

    int inside = 0;
    for (int step = 1; step <= 150; ++step) {
        world.step(1.0f / 60);
        const auto report = [&](const kodo::CollisionRecord& touch, int change, const char* what) {
            if (touch.involves(gate)) {
                inside += change;
                const kodo::BodyId other = touch.other(gate);
                if (!world.contains(other)) { // it was removed while inside
                    return;
                }
                const auto ball = static_cast<int>(world[other].userData());
                std::printf("%.2f s: ball %d %s, %d inside\n", step / 60.0, ball, what, inside);
            }
        };
        for (const kodo::CollisionRecord& touch : world.begunCollisions()) {
            report(touch, 1, "enters");
        }
        for (const kodo::CollisionRecord& touch : world.endedCollisions()) {
            report(touch, -1, "leaves");
        }
        if (argc > 1 && step == 45) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {.labels = true}, {{{-4, -1}, {4, 3.5f}}});
        }
    }

    // A query finds what is in a region now, without a sensor.
    const auto blue = kodo::overlap(world, kodo::Aabb{{0, 0}, {20, 3}}, {kodo::kMatchAny, kBlue});
    std::printf("%zu blue balls behind the gate\n", blue.size());
}
