// SPDX-License-Identifier: MIT
// Threads: a pool helps each step; and several Worlds, each on a thread of its own.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

constexpr float kDt = 1.0f / 60; // s

/// A wall of bricks, and a ball that flies towards it (m/s).
kodo::World wall(int rows, float speed) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < 24; ++i) {
            const float x = static_cast<float>(i) + (row % 2 == 0 ? 0.0f : 0.5f);
            world.add({.shape = kodo::Box{1, 0.5f},
                       .position = {x, 0.25f + 0.5f * static_cast<float>(row)}});
        }
    }
    world.add(
        {.shape = kodo::Circle{1}, .position = {-4, 3}, .velocity = {speed, 0}, .density = 5});
    return world;
}

int main(int argc, char** argv) {
    kodo::World alone = wall(20, 30);
    kodo::World helped = alone;
    kodo::ThreadPool pool(3); // and the thread that calls step()
    for (int step = 0; step < 60; ++step) {
        alone.step(kDt);
        helped.step(kDt, {.executor = &pool});
    }
    std::printf("%zu bodies with 1 and with 4 threads: %s\n", alone.bodyCount(),
                alone.stateHash() == helped.stateHash() ? "same bits" : "different");

    // Worlds share nothing that changes, so each may have a thread.
    std::vector<kodo::World> worlds{wall(2, 5), wall(2, 10), wall(2, 20), wall(2, 30)};
    std::vector<std::thread> threads;
    for (kodo::World& world : worlds) {
        threads.emplace_back([&world] {
            for (int step = 0; step < 120; ++step) {
                world.step(kDt);
            }
        });
    }
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        threads[i].join();
        const kodo::BodyId ball = worlds[i].bodies().back();
        std::printf("World %zu: the ball is at x = %.1f m\n", i, worlds[i][ball].position().x);
    }
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(worlds[1]);
    }
}
