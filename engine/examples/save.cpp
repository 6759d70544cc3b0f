// SPDX-License-Identifier: MIT
// Save and load: a World as bytes in a file. The World that is read continues with the same bits.
#include <kodo/kodo.hpp>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    for (int i = 0; i < 5; ++i) {
        world.add({.shape = kodo::Box{1, 1},
                   .position = {0.3f * static_cast<float>(i), 0.5f + static_cast<float>(i)}});
    }
    const auto run = [](kodo::World& each, int steps) {
        for (int i = 0; i < steps; ++i) {
            each.step(1.0f / 60);
        }
    };
    run(world, 40);
    const kodo::BodyId top = world.bodies().back();

    const char* file = "example_save.kodo";
    {
        const std::vector<std::byte> bytes = kodo::toBytes(world);
        std::ofstream out(file, std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
    }
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> read{std::istreambuf_iterator<char>(in), {}};
    kodo::World loaded = kodo::fromBytes(std::as_bytes(std::span(read)));
    std::remove(file);
    std::printf("step %d, %zu bodies, the top one at (%.2f, %.2f)\n",
                static_cast<int>(loaded.stepCount()), loaded.bodyCount(), loaded[top].position().x,
                loaded[top].position().y);

    run(world, 100);
    run(loaded, 100);
    std::printf("100 steps later: %s\n",
                world.stateHash() == loaded.stateHash() ? "same bits" : "different");

    std::vector<char> damaged = read;
    damaged[damaged.size() / 2] ^= 1;
    try {
        kodo::fromBytes(std::as_bytes(std::span(damaged)));
    } catch (const kodo::BadSnapshot& error) {
        std::printf("one bit changed: %s\n", error.what());
    }
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(loaded, {.contacts = true});
    }
}
