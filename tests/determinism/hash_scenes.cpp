// SPDX-License-Identifier: MIT
// Prints "scene precision tick hash" of every recipe, as golden.txt keeps them. Self-contained, so
// that any compiler for any machine can build it from its one file and those of engine/src.
#include <determinism/player.hpp>

#include <cinttypes>
#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
    const bool last = argc == 2 && std::strcmp(argv[1], "--last") == 0;
    if (argc > 1 && !last) {
        std::puts("hash_scenes           prints: scene precision tick hash\n"
                  "hash_scenes --last    prints: scene precision hash, after the last tick only");
        return 2;
    }
    for (const determinism::Recipe& recipe : determinism::recipes()) {
        const std::vector<std::uint64_t> hashes = determinism::hashesOf(recipe);
        for (std::size_t i = last ? hashes.size() - 1 : 0; i < hashes.size(); ++i) {
            std::printf("%s %s ", recipe.name, determinism::kPrecision);
            if (!last) {
                std::printf("%d ", static_cast<int>(i + 1) * determinism::kHashEvery);
            }
            std::printf("%016" PRIx64 "\n", hashes[i]);
        }
    }
    return 0;
}
