// SPDX-License-Identifier: MIT
// continue_snapshot FILE STEPS: continues from the snapshot of a busyWorld() and prints the state
// hash after STEPS steps of 1/60 s.
#include <world/snapshot_scenes.hpp>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("continue_snapshot FILE STEPS\n", stderr);
        return 2;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> chars{std::istreambuf_iterator<char>(file), {}};
    try {
        kodo::World world = kodo::fromBytes(std::as_bytes(std::span(chars)), support::ownFields());
        for (int i = std::atoi(argv[2]); i > 0; --i) {
            world.step(kodo::Real(1) / 60);
        }
        std::printf("%016" PRIx64 "\n", world.stateHash());
    } catch (const kodo::BadSnapshot& bad) {
        std::fprintf(stderr, "%s: %s\n", argv[1], bad.what());
        return 1;
    }
    return 0;
}
