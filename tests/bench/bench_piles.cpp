// SPDX-License-Identifier: MIT
// Scenes that stand, fall into a heap, or sleep.
#include <scenes/piles.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::SceneDef;

/// A floor and two walls of 1 m thickness around x = -width / 2 .. width / 2, y = 0 .. height.
SceneDef container(const char* name, double width, double height) {
    SceneDef scene{name, scenes::kDown, {}};
    scene.bodies = {wall(width + 2, 1, {0, -0.5}), wall(1, height, {-(width + 1) / 2, height / 2}),
                    wall(1, height, {(width + 1) / 2, height / 2})};
    return scene;
}

/// Width factor of a container for `size` bodies instead of `usual`. More bodies make the heap
/// wider, not higher, which keeps the work per body constant. Fewer bodies form a smaller heap.
double broaden(int size, int usual) {
    return size > usual ? static_cast<double>(size) / usual : stretch(size, usual);
}

/// Fills a container with rows of bodies at a distance of `pitch` (m), slightly displaced.
template <typename Make>
Scene dropped(const char* name, double width, double pitch, int count, Dice& dice, Make make) {
    const int columns = static_cast<int>((width - 0.2) / pitch);
    const int rows = (count + columns - 1) / columns;
    const double height = 2 + pitch * rows;
    Scene scene{container(name, width, height)};
    const double left = -(columns - 1) * pitch / 2;
    for (int i = 0; i < count; ++i) {
        BodyDef body = make(i);
        body.position = {left + pitch * (i % columns) + dice.between(-0.02, 0.02),
                         pitch / 2 + pitch * (i / columns)};
        scene.def.bodies.push_back(body);
    }
    scene.region = Region{{-width / 2, 0}, {width / 2, 2 * height}};
    scene.error = meanDepth();
    return scene;
}

/// Two boxes in the shape of an L. All corners lie within `radius` of the centre.
std::vector<scenes::Part> angle(double radius) {
    const double r = radius;
    return {scenes::Box{1.4 * r, 0.45 * r, {0, -0.475 * r}},
            scenes::Box{0.45 * r, 0.95 * r, {-0.475 * r, 0.225 * r}}};
}

/// Vertical displacement of the top of a column of unit boxes, relative to its height. A collapsed
/// column counts as 1.
double sunk(const Stage& stage, std::size_t boxes, double height) {
    const double top = static_cast<double>(boxes) - 0.5;
    return std::min(std::abs(top - stage.engine().state(boxes).position.y) / height, 1.0);
}

} // namespace

Scene pyramid(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"pyramid", scenes::kDown, {scenes::ground(3.0 * size + 20)}};
    for (int row = 0; row < size; ++row) {
        for (int i = row; i < size; ++i) {
            const double x = i - 0.5 * (row + size - 1);
            scene.def.bodies.push_back(scenes::box(1, 1, {x, 0.5 + row}));
        }
    }
    scene.region = Region{{-1.5 * size - 10, 0}, {1.5 * size + 10, 2.0 * size}};
    scene.stands = true;
    scene.error = meanDepth();
    return scene;
}

Scene circles(int size, std::uint64_t seed) {
    Dice dice(seed);
    return dropped("circles", 60 * broaden(size, 5000), 0.58, size, dice,
                   [](int) { return scenes::ball(0.25, {}); });
}

Scene debris(int size, std::uint64_t seed) {
    Dice dice(seed);
    return dropped("debris", 50 * broaden(size, 2000), 1.26, size, dice, [&](int i) {
        BodyDef body;
        const double radius = dice.between(0.3, 0.6);
        if (i % 5 == 4) {
            body.parts = angle(radius);
        } else {
            body.parts = {shard(dice, radius)};
        }
        body.rotation = scenes::turnedBy(dice.between(-1, 1));
        return body;
    });
}

Scene stack(int size, std::uint64_t) {
    Scene scene;
    scene.def = scenes::stack(size);
    scene.region = Region{{-10, 0}, {10, 2.0 * size}};
    scene.stands = true;
    scene.error = {"top sinks", "mm", [=](const Stage& stage, const Depths&) {
                       return 1000 * size * sunk(stage, static_cast<std::size_t>(size), size);
                   }};
    return scene;
}

Scene massRatio(int size, std::uint64_t) {
    Scene scene;
    scene.def = scenes::stack(11);
    scene.def.name = "massratio";
    scene.def.bodies[11].density = size;
    scene.region = Region{{-10, 0}, {10, 20}};
    scene.stands = true;
    scene.error = {"light boxes compressed", "%",
                   [](const Stage& stage, const Depths&) { return 100 * sunk(stage, 11, 10); }};
    return scene;
}

Scene asleep(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"asleep", scenes::kDown, {}};
    for (const scenes::Vec2 foot : addShelves(scene.def, size, {1.5, 3})) {
        scene.def.bodies.push_back(scenes::box(1, 1, foot + scenes::Vec2{0, 0.5}));
    }
    scene.rest = true;
    scene.warmUp = 120;
    return scene;
}

Scene shots(int size, std::uint64_t seed) {
    Scene scene = asleep(size, seed);
    scene.def.name = "shots";
    scene.every = 1;
    scene.actIsTimed = true;
    const auto last = std::make_shared<std::optional<std::size_t>>();
    const double above = 3 * std::ceil(std::sqrt(static_cast<double>(size))) + 10;
    scene.act = [=](Stage& stage, int) {
        if (*last) {
            stage.remove(**last);
        }
        *last = stage.placeOfNext();
        BodyDef shot = scenes::ball(0.25, {0, above});
        shot.velocity = {20, 0};
        stage.add(shot);
    };
    return scene;
}

/// Small balls of 0.1 m fill a container; the large ones fall on them.
Scene unlike(int size, std::uint64_t seed) {
    constexpr double kSmall = 0.1; // m
    constexpr double kPitch = 2.2 * kSmall;
    constexpr int kCount = 2000;
    constexpr int kLarge = 20;
    Dice dice(seed);
    const double large = kSmall * size;
    const double width = std::max(20.0, 9 * large);
    const double top = 1 + kCount * kPitch * kPitch / (width - 1); // of the small ones
    const double high = top + 12 * large;
    Scene scene = dropped("unlike", width, kPitch, kCount, dice,
                          [](int) { return scenes::ball(kSmall, {}); });
    scene.def.bodies[1] = wall(1, high, {-(width + 1) / 2, high / 2});
    scene.def.bodies[2] = wall(1, high, {(width + 1) / 2, high / 2});
    for (int i = 0; i < kLarge; ++i) {
        scene.def.bodies.push_back(
            scenes::ball(large, {2.1 * large * (i % 4 - 1.5), top + large * (1 + 2.1 * (i / 4))}));
    }
    scene.region = Region{{-width / 2, 0}, {width / 2, 2 * high}};
    return scene;
}

} // namespace bench
