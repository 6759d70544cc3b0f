// SPDX-License-Identifier: MIT
// Dominoes: thirty fall in a row, then the World sleeps, and a step costs nothing.
#include <kodo/kodo.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    std::vector<kodo::BodyId> row;
    for (int i = 0; i < 30; ++i) {
        row.push_back(world.add(
            {.shape = kodo::Box{0.2f, 2}, .position = {0.9f * static_cast<float>(i), 1}}));
    }
    world[row[0]].applyImpulse({0.4f, 0}, {0, 2}); // at the upper end

    std::size_t fallen = 0;
    for (int step = 1; step <= 900; ++step) {
        world.step(1.0f / 60);
        while (fallen < row.size() && std::abs(world[row[fallen]].rotation().angle()) > 0.5f) {
            ++fallen;
            if (fallen % 10 == 0) {
                std::printf("%.2f s: %zu dominoes have fallen\n", step / 60.0, fallen);
            }
        }
        if (argc > 1 && step == 150) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{-1, -0.5f}, {27, 3}});
        }
        if (kodo::stepStats(world).bodies == 0) {
            std::printf("%.2f s: all sleep\n", step / 60.0);
            break;
        }
    }
}
