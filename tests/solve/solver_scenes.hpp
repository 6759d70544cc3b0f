// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/in_kodo.hpp>
#include <scenes/piles.hpp>
#include <scenes/slides.hpp>
#include <support/depth.hpp>

#include <algorithm>
#include <functional>

/// Scenes that show differences of the solvers, each with a question, and the profiles that answer
/// it.
namespace strategies {
inline namespace KODO_PRECISION {

using scenes::KodoScene;
using scenes::SceneDef;

/// A house of cards: two tents, a plank over both, and a tent on it. Cards are 1 m long and lean by
/// 17 degrees; friction below 0.3 does not hold them.
inline SceneDef cardHouse() {
    SceneDef scene{"card house", scenes::kDown, {scenes::ground(20)}};
    const scenes::Rot lean = scenes::turnedBy(-0.15); // to the right
    const double thick = 0.05;
    const double c = lean.c;
    const double s = -lean.s;
    const auto tent = [&](double x, double base) {
        for (const double side : {-1.0, 1.0}) {
            scenes::BodyDef card =
                scenes::box(thick, 1, {x + side * (c * thick + s) / 2, base + (s * thick + c) / 2});
            card.rotation = {c, side * s};
            scene.bodies.push_back(card);
        }
    };
    const double storey = s * thick + c;
    tent(-0.5, 0);
    tent(0.5, 0);
    scene.bodies.push_back(scenes::box(1.4, thick, {0, storey + thick / 2}));
    tent(0, storey + thick);
    return scene;
}

/// A round arch of eight voussoirs, inner radius 2 m, outer radius 3 m.
inline SceneDef arch() {
    SceneDef scene{"arch", scenes::kDown, {scenes::ground(20)}};
    for (int i = 0; i < 8; ++i) {
        const auto direction = [](int k) { // mirrored at the crown
            const scenes::Rot q = scenes::turnedBy((k <= 4 ? k : 8 - k) / 4.0);
            return scenes::Vec2{k <= 4 ? q.c : -q.c, q.s};
        };
        const scenes::Vec2 from = direction(i);
        const scenes::Vec2 to = direction(i + 1);
        scenes::BodyDef block;
        const scenes::Vec2 middle = 0.25 * (2.0 * from + 3.0 * from + 3.0 * to + 2.0 * to);
        block.position = middle;
        block.parts = {scenes::Polygon{
            {2.0 * from - middle, 3.0 * from - middle, 3.0 * to - middle, 2.0 * to - middle}}};
        scene.bodies.push_back(block);
    }
    return scene;
}

/// Boxes in rows and columns, each overlapping its neighbours by a fifth.
inline SceneDef overlapping() {
    SceneDef scene{"overlap recovery", scenes::kDown, {scenes::ground(40)}};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            scene.bodies.push_back(scenes::box(1, 1, {0.8 * column - 1.2, 0.5 + 0.8 * row}));
        }
    }
    return scene;
}

/// 60 balls fall between two walls.
inline SceneDef circlePile() {
    SceneDef scene{"circle pile", scenes::kDown, {scenes::ground(20)}};
    for (const double x : {-2.5, 2.5}) {
        scene.bodies.push_back(scenes::box(1, 20, {x, 10}));
        scene.bodies.back().locked = true;
    }
    scenes::Dice dice(3);
    for (int i = 0; i < 60; ++i) {
        const double radius = dice.between(0.15, 0.25);
        const double x = -1.5 + 0.6 * (i % 6) + dice.between(-0.05, 0.05);
        scene.bodies.push_back(scenes::ball(radius, {x, 0.5 + 0.6 * (i / 6)}));
    }
    return scene;
}

/// Sets the restitution of all bodies to 1.
inline SceneDef lossless(SceneDef scene) {
    for (scenes::BodyDef& body : scene.bodies) {
        body.material.restitution = 1;
    }
    return scene;
}

/// Largest distance (m) of a body's centre of mass from its definition.
inline kodo::Real farthestMove(const KodoScene& now, const SceneDef& scene) {
    kodo::Real farthest = 0;
    for (std::size_t i = 0; i < now.ids.size(); ++i) {
        const kodo::Vec2 start = scenes::toKodo(scene.bodies[i].position);
        farthest = std::max(farthest, length(now.world[now.ids[i]].position() - start));
    }
    return farthest;
}

inline kodo::Real fastest(const KodoScene& now) {
    kodo::Real speed = 0;
    for (const kodo::BodyId id : now.ids) {
        speed = std::max(speed, length(now.world[id].velocity()));
    }
    return speed;
}

/// A scene and its question.
struct Trial {
    SceneDef scene;
    double seconds;
    const char* question;
    std::function<bool(const KodoScene& end, const SceneDef& scene)> answer;
};

inline Trial standing(SceneDef scene, double seconds, double within) {
    return {std::move(scene), seconds, "stands", [=](const KodoScene& end, const SceneDef& start) {
                return farthestMove(end, start) < static_cast<kodo::Real>(within);
            }};
}

inline std::vector<Trial> trials() {
    std::vector<Trial> list;
    list.push_back(standing(scenes::stack(20), 10, 0.2));
    list.push_back(standing(scenes::pyramid(12), 10, 0.2));
    list.push_back(standing(lossless(scenes::boxOnSlope(0.8)), 10, 0.01));
    list.back().scene.name = "block on ramp, e = 1, holds";
    // Slides by g (sin - mu cos) t^2 / 2 = 1 m in a second.
    list.push_back({lossless(scenes::boxOnSlope(0.5)), 1, "slides 1 m",
                    [](const KodoScene& end, const SceneDef& start) {
                        const kodo::Real error = farthestMove(end, start) - 1;
                        return error < kodo::Real(0.02) && error > kodo::Real(-0.02);
                    }});
    list.back().scene.name = "block on ramp, e = 1, slides";
    list.push_back(standing(cardHouse(), 10, 0.1));
    list.push_back(standing(arch(), 10, 0.1));
    list.push_back(
        {scenes::dominoRow(20), 10, "all fall", [](const KodoScene& end, const SceneDef&) {
             return std::all_of(end.ids.begin() + 1, end.ids.end(), [&](auto id) {
                 return end.world[id].position().y < kodo::Real(0.4);
             });
         }});
    for (const double ratio : {10.0, 100.0, 1000.0}) {
        list.push_back(standing(scenes::heavyOnLight(ratio), 10, 0.1));
        list.back().scene.name += " 1:" + std::to_string(static_cast<int>(ratio));
    }
    list.push_back({overlapping(), 5, "separates to 5 mm, no burst",
                    [](const KodoScene& end, const SceneDef& start) {
                        return support::maxOverlap(end.world) < kodo::Real(0.005) &&
                               farthestMove(end, start) < 4;
                    }});
    list.push_back({circlePile(), 10, "comes to rest", [](const KodoScene& end, const SceneDef&) {
                        return fastest(end) < kodo::Real(0.05);
                    }});
    return list;
}

/// A solver and its settings.
struct Profile {
    const char* name;
    kodo::StepSettings settings;
};

inline kodo::StepSettings propagation(int contactPasses, int shockPasses) {
    kodo::StepSettings settings = kodo::thesis2006();
    settings.propagation().contactPasses = contactPasses;
    settings.propagation().shockPasses = shockPasses;
    return settings;
}

inline std::vector<Profile> profiles() {
    return {{"soft solver", {}},
            {"propagation 4", propagation(4, 0)},
            {"propagation 4 + shock 4", propagation(4, 4)},
            {"propagation 10", propagation(10, 0)},
            {"propagation 10 + shock 10", propagation(10, 10)},
            {"propagation 40", propagation(40, 0)}};
}

inline constexpr kodo::Real kStep = kodo::Real(1) / 60; // s

struct Outcome {
    bool yes = false;
    kodo::Real depth = 0; // m, the deepest overlap of the last second
    kodo::Real moved = 0; // m
    double visitsPerStep = 0;
};

inline Outcome run(const Trial& trial, const kodo::StepSettings& settings) {
    KodoScene scene = inKodo(trial.scene, settings);
    const int steps = static_cast<int>(trial.seconds * 60);
    Outcome outcome;
    for (int i = 0; i < steps; ++i) {
        scene.world.step(kStep);
        outcome.visitsPerStep += static_cast<double>(stepStats(scene.world).contacts) / steps;
        if (i >= steps - 60 && i % 6 == 0) {
            outcome.depth = std::max(outcome.depth, support::maxOverlap(scene.world));
        }
    }
    outcome.moved = farthestMove(scene, trial.scene);
    outcome.yes = trial.answer(scene, trial.scene);
    return outcome;
}

} // namespace KODO_PRECISION
} // namespace strategies
