// SPDX-License-Identifier: MIT
// Loads whose cost depends on where weight rests, and on how many groups of bodies there are.
#include "bench_scenes.hpp"

namespace bench {

using scenes::BodyDef;
using scenes::Vec2;

/// The pair stands 300 m beside a pyramid of 820 boxes.
Scene heavyPair(int size, std::uint64_t seed) {
    constexpr double kAside = 300; // m
    Scene scene = pyramid(40, seed);
    scene.def.name = "heavypair";
    scene.def.bodies.push_back(wall(4, 2, {kAside, -1}));
    scene.def.bodies.push_back(scenes::box(1, 1, {kAside, 0.5}));
    scene.def.bodies.push_back(scenes::box(1, 1, {kAside, 1.5}));
    scene.def.bodies.back().density = size;
    scene.region = {};
    return scene;
}

/// Columns of ten boxes stand on one slab of 1,000 times their mass each, which lies on the ground.
Scene slab(int size, std::uint64_t) {
    constexpr int kHigh = 10;       // boxes
    constexpr double kPitch = 0.6;  // m
    constexpr double kWidth = 0.5;  // m, of a box
    constexpr double kRatio = 1000; // mass of the slab to that of a box
    const int columns = (size + kHigh - 1) / kHigh;
    const double width = kPitch * columns + 1;
    Scene scene;
    scene.def = {"slab", scenes::kDown, {scenes::ground(width + 20)}};
    BodyDef slab = scenes::box(width, 1, {0, 0.5});
    slab.density = kRatio * kWidth * kWidth / width;
    scene.def.bodies.push_back(slab);
    for (int i = 0; i < size; ++i) {
        const double x = kPitch * (i / kHigh - 0.5 * (columns - 1));
        scene.def.bodies.push_back(
            scenes::box(kWidth, kWidth, {x, 1 + kWidth * (0.5 + i % kHigh)}));
    }
    scene.error = meanDepth();
    return scene;
}

Scene plank(int size, std::uint64_t) {
    constexpr double kRadius = 0.2; // m
    constexpr double kPitch = 0.5;  // m
    Scene scene;
    scene.def = {"plank", scenes::kDown, {scenes::ground(kPitch * size + 20)}};
    for (int i = 0; i < size; ++i) {
        const double x = kPitch * (i - 0.5 * (size - 1));
        scene.def.bodies.push_back(scenes::ball(kRadius, {x, kRadius}));
    }
    scene.def.bodies.push_back(scenes::box(kPitch * size, 0.2, {0, 2 * kRadius + 0.1}));
    scene.error = meanDepth();
    return scene;
}

/// Two boxes, one on the other, on each place of the shelves.
Scene pairs(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"pairs", scenes::kDown, {}};
    for (const Vec2 foot : addShelves(scene.def, size, {1.5, 4})) {
        scene.def.bodies.push_back(scenes::box(1, 1, foot + Vec2{0, 0.5}));
        scene.def.bodies.push_back(scenes::box(1, 1, foot + Vec2{0, 1.5}));
    }
    scene.error = meanDepth();
    return scene;
}

Scene balls(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"balls", scenes::kDown, {}};
    for (const Vec2 foot : addShelves(scene.def, size, {1.5, 3})) {
        scene.def.bodies.push_back(scenes::ball(0.5, foot + Vec2{0, 0.5}));
    }
    scene.error = meanDepth();
    return scene;
}

} // namespace bench
