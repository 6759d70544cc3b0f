// SPDX-License-Identifier: MIT
// Single steps that cost more than others: arrivals, removals and wake-ups of many bodies at once.
#include <cmath>
#include <memory>
#include <utility>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::Vec2;

/// Boxes of 1 m in rows of `columns`, each offset by half a box against the one below, so that all
/// touch each other over others.
void addBricks(scenes::SceneDef& scene, int count, int columns) {
    for (int i = 0; i < count; ++i) {
        const int row = i / columns;
        const double x = 1.01 * (i % columns - columns / 2) + 0.5 * (row % 2);
        scene.bodies.push_back(scenes::box(1, 1, {x, 0.5 + row}));
    }
}

} // namespace

/// Static tiles come and go in front of and behind a camera that moves over a long floor, on which
/// balls rest.
Scene stream(int size, std::uint64_t) {
    constexpr int kShown = 40; // steps for which a tile exists
    constexpr double kPitch = 1.5;
    const auto tile = [=](int i) { return wall(1, 1, {kPitch * (i / 10), 3 + kPitch * (i % 10)}); };
    Scene scene;
    scene.def = {"stream", scenes::kDown, {scenes::ground(4000)}};
    for (int i = 0; i < 500; ++i) {
        scene.def.bodies.push_back(scenes::ball(0.4, {static_cast<double>(i), 0.4}));
    }
    const std::size_t first = scene.def.bodies.size();
    for (int i = 0; i < size * kShown; ++i) {
        scene.def.bodies.push_back(tile(i));
    }
    scene.every = 1;
    scene.actIsTimed = true;
    scene.worstStep = true;
    const auto next = std::make_shared<std::size_t>(first);
    scene.act = [=](Stage& stage, int) {
        for (int i = 0; i < size; ++i) {
            stage.remove((*next)++);
            stage.add(tile(static_cast<int>(stage.placeOfNext() - first)));
        }
    };
    return scene;
}

/// All boxes of columns of ten are removed at once; the steps after that are timed.
Scene cleared(int size, std::uint64_t seed) {
    Scene scene = removals(size, seed);
    scene.def.name = "cleared";
    scene.stepIsTimed = true;
    scene.actIsTimed = false;
    scene.worstStep = true;
    return scene;
}

/// One island of sleeping boxes is woken by a push.
Scene woken(int size, std::uint64_t) {
    constexpr int kHigh = 5; // rows
    Scene scene;
    scene.def = {"woken", scenes::kDown, {scenes::ground(1.1 * size / kHigh + 20)}};
    addBricks(scene.def, size, size / kHigh);
    scene.rest = true;
    scene.warmUp = 150;
    scene.every = 1;
    scene.worstStep = true;
    scene.act = [=, warmUp = scene.warmUp](Stage& stage, int steps) {
        if (steps == warmUp + 1) {
            stage.engine().push(1, {0, 0.5});
        }
    };
    return scene;
}

/// A wall of boxes gets up to 20 m/s away from a point in its middle.
Scene explosion(int size, std::uint64_t) {
    constexpr int kWide = 60;
    constexpr double kRadius = 15; // m
    Scene scene;
    scene.def = {"explosion", scenes::kDown, {scenes::ground(400)}};
    addBricks(scene.def, size, kWide);
    const Vec2 center{0, 0.5 * size / kWide};
    scene.warmUp = 5;
    scene.every = 1;
    scene.actIsTimed = true;
    scene.worstStep = true;
    scene.act = [=, warmUp = scene.warmUp](Stage& stage, int steps) {
        for (std::size_t body = 1; steps == warmUp + 1 && body < stage.placeOfNext(); ++body) {
            const Vec2 away = stage.engine().state(body).position - center;
            const double distance = std::sqrt(dot(away, away)) + 0.1;
            if (distance < kRadius) {
                stage.engine().push(body, 20 * (1 - distance / kRadius) / distance * away);
            }
        }
    };
    return scene;
}

/// The blocks of a wall break in random order into five boxes: four around one in the middle.
Scene fracture(int size, std::uint64_t seed) {
    constexpr int kWide = 40;
    constexpr int kAtOnce = 20;
    constexpr double kLong = 0.6; // m, of a piece at the edge
    constexpr double kShort = 0.4;
    Scene scene;
    scene.def = {"fracture", scenes::kDown, {scenes::ground(400)}};
    addBricks(scene.def, size, kWide);
    scene.every = 1;
    scene.actIsTimed = true;
    scene.worstStep = true;
    const auto whole = std::make_shared<std::vector<std::size_t>>();
    for (std::size_t i = 1; i < scene.def.bodies.size(); ++i) {
        whole->push_back(i);
    }
    const auto dice = std::make_shared<scenes::Dice>(seed);
    scene.act = [=](Stage& stage, int) {
        for (int i = 0; i < kAtOnce && !whole->empty(); ++i) {
            std::swap((*whole)[dice->below(whole->size())], whole->back());
            const BodyState block = stage.engine().state(whole->back());
            stage.remove(whole->back());
            whole->pop_back();
            const auto add = [&](double width, double height, Vec2 place) {
                scenes::BodyDef piece =
                    scenes::box(width, height, block.position + block.rotation * place);
                piece.rotation = block.rotation;
                piece.velocity = block.velocity + block.spin * Vec2{-place.y, place.x};
                piece.spin = block.spin;
                stage.add(piece);
            };
            const double reach = (1 - kShort) / 2;
            const double aside = (1 - kLong) / 2;
            add(kLong - kShort, kLong - kShort, {0, 0});
            add(kLong, kShort, {-aside, -reach});
            add(kShort, kLong, {reach, -aside});
            add(kLong, kShort, {aside, reach});
            add(kShort, kLong, {-reach, aside});
        }
    };
    return scene;
}

/// Boxes on shelves continue from bytes; then a ray is cast through them.
Scene loaded(int size, std::uint64_t seed) {
    Scene scene = asleep(size, seed);
    scene.def.name = "loaded";
    scene.every = 1;
    scene.stepIsTimed = false;
    scene.actIsTimed = true;
    scene.worstStep = true;
    scene.prepare = [](Stage& stage) { stage.engine().reload(); };
    const auto sum = std::make_shared<double>(0); // no compiler removes the ray
    scene.act = [=](Stage& stage, int) { *sum += stage.engine().rayCast({-50, 1.5}, {50, 1.6}); };
    return scene;
}

} // namespace bench
