// SPDX-License-Identifier: MIT
// Bodies on revolute joints: figures, chains, wheels and cars. The initial rotation of each is 0.
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::SceneDef;
using scenes::Vec2;

constexpr std::uint16_t kGround = 1; // categories
constexpr std::uint16_t kGhost = 2;  // collides with kNothing
constexpr std::uint16_t kNothing = 4;

/// A box between the soles at y = 0 and the head.
struct Limb {
    Vec2 center; // m
    double width = 0;
    double height = 0;
};

/// A joint between two limbs, with its limits.
struct Hinge {
    std::size_t a = 0; // indices of limbs
    std::size_t b = 0;
    Vec2 point;
    scenes::AngleLimits limits;
};

constexpr Limb kLimbs[] = {
    {{0, 1.65}, 0.20, 0.26},   {{0, 1.35}, 0.35, 0.32},    {{0, 1.05}, 0.30, 0.26},
    {{-0.25, 1.3}, 0.1, 0.32}, {{-0.25, 1}, 0.08, 0.3},    {{0.25, 1.3}, 0.1, 0.32},
    {{0.25, 1}, 0.08, 0.3},    {{-0.1, 0.74}, 0.14, 0.42}, {{-0.1, 0.28}, 0.12, 0.5},
    {{0.1, 0.74}, 0.14, 0.42}, {{0.1, 0.28}, 0.12, 0.5},
};
constexpr Hinge kHinges[] = {
    {1, 0, {0, 1.52}, {-0.5, 0.5}},    {1, 2, {0, 1.18}, {-0.4, 0.4}},
    {1, 3, {-0.25, 1.45}, {-1, 2}},    {3, 4, {-0.25, 1.15}, {0, 2.2}},
    {1, 5, {0.25, 1.45}, {-1, 2}},     {5, 6, {0.25, 1.15}, {0, 2.2}},
    {2, 7, {-0.1, 0.94}, {-0.7, 1.5}}, {7, 8, {-0.1, 0.53}, {-2, 0}},
    {2, 9, {0.1, 0.94}, {-0.7, 1.5}},  {9, 10, {0.1, 0.53}, {-2, 0}},
};

/// Limbs of one figure do not collide: they collide with the ground and with `others`.
void addRagdoll(SceneDef& scene, Vec2 at, std::uint16_t category, std::uint16_t others) {
    const std::size_t first = scene.bodies.size();
    for (const Limb& limb : kLimbs) {
        BodyDef body = scenes::box(limb.width, limb.height, at + limb.center);
        body.category = category;
        body.mask = kGround | others;
        scene.bodies.push_back(body);
    }
    for (const Hinge& hinge : kHinges) {
        scene.joints.push_back(
            {first + hinge.a, first + hinge.b, at + hinge.point, 0, 0, hinge.limits});
    }
}

/// Tiles of `pitch` (m) between points of random height, from x = -length / 2 on.
void addHills(SceneDef& scene, double length, double pitch, double height, Dice& dice) {
    Vec2 from{-length / 2, 0};
    while (from.x < length / 2) {
        const Vec2 to = from + Vec2{pitch, dice.between(0, height) - from.y};
        const Vec2 way = to - from;
        const double size = std::sqrt(dot(way, way));
        const Vec2 down{way.y / size, -way.x / size};
        BodyDef tile = wall(size, 1, 0.5 * (from + to) + 0.5 * down);
        tile.rotation = scenes::slope(way.y, way.x);
        scene.bodies.push_back(tile);
        from = to;
    }
}

/// Two wheels with motors on a box.
void addCar(SceneDef& scene, Vec2 at) {
    constexpr double kSpeed = -12; // rad/s: to the right
    constexpr double kTorque = 3;  // N m
    const std::size_t chassis = scene.bodies.size();
    scene.bodies.push_back(scenes::box(2, 0.4, at));
    for (const double x : {-0.7, 0.7}) {
        const Vec2 axle = at + Vec2{x, -0.25};
        scene.joints.push_back({chassis, scene.bodies.size(), axle, kSpeed, kTorque});
        scene.bodies.push_back(scenes::ball(0.35, axle));
    }
}

/// A body that collides with nothing.
BodyDef ghost(BodyDef body) {
    body.category = kGhost;
    body.mask = kNothing;
    return body;
}

/// Measures the largest gap of a run as a share of a link of this length (m).
void measureGap(Scene& scene, double link) {
    const auto worst = std::make_shared<double>(0);
    const Error widest = widestJoint(scene.def); // mm
    scene.every = 6;
    scene.act = [=](Stage& stage, int) {
        *worst = std::max(*worst, widest.measure(stage, {}) / (1000 * link));
    };
    scene.error = {"largest gap, share of a link", "",
                   [=](const Stage&, const Depths&) { return *worst; }};
}

/// Chains that start level.
Scene levelChains(const char* name, int count, int links) {
    constexpr double kLength = 0.3; // m, of a link
    Scene scene;
    scene.def = {name, scenes::kDown, {}};
    for (int chain = 0; chain < count; ++chain) {
        const Vec2 end{0, -2.0 * chain};
        BodyDef anchor = wall(0.2, 0.2, end);
        anchor.category = kGround;
        scene.def.bodies.push_back(anchor);
        for (int i = 0; i < links; ++i) {
            const std::size_t body = scene.def.bodies.size();
            scene.def.joints.push_back({body - 1, body, end + Vec2{kLength * i, 0}});
            scene.def.bodies.push_back(
                ghost(scenes::box(kLength, 0.1, end + Vec2{kLength * (i + 0.5), 0})));
        }
    }
    measureGap(scene, kLength);
    return scene;
}

constexpr int kBridges = 4;
constexpr double kPlank = 0.6; // m

/// Planks between two static banks, drawn level.
void addBridge(SceneDef& scene, int planks, Vec2 middle) {
    constexpr double kHigh = 0.2; // m
    const double left = middle.x - 0.5 * kPlank * planks;
    const double right = middle.x + 0.5 * kPlank * planks;
    const std::size_t first = scene.bodies.size();
    scene.bodies.push_back(wall(1, kHigh, {left - 0.5, middle.y}));
    for (int i = 0; i < planks; ++i) {
        const double x = left + kPlank * i;
        scene.joints.push_back(
            {first + static_cast<std::size_t>(i), scene.bodies.size(), {x, middle.y}});
        scene.bodies.push_back(scenes::box(kPlank, kHigh, {x + 0.5 * kPlank, middle.y}));
    }
    scene.joints.push_back({scene.bodies.size() - 1, scene.bodies.size(), {right, middle.y}});
    scene.bodies.push_back(wall(1, kHigh, {right + 0.5, middle.y}));
}

} // namespace

/// Ten figures in a row; ten rows above each other for 100.
Scene ragdolls(int size, std::uint64_t) {
    constexpr int kColumns = 10;
    constexpr std::uint16_t kEven = 2;
    constexpr std::uint16_t kOdd = 4;
    const double high = 2.0 * (size / kColumns + 2);
    Scene scene;
    scene.def = {
        "ragdolls",
        scenes::kDown,
        {wall(16, 1, {0, -0.5}), wall(1, high, {-8.5, high / 2}), wall(1, high, {8.5, high / 2})}};
    for (BodyDef& body : scene.def.bodies) {
        body.category = kGround;
    }
    for (int i = 0; i < size; ++i) {
        const int column = i % kColumns;
        const int row = i / kColumns;
        const bool even = (column + row) % 2 == 0;
        const Vec2 at{1.3 * (column - 0.5 * (kColumns - 1)) + 0.2 * (row % 2), 0.3 + 2.0 * row};
        addRagdoll(scene.def, at, even ? kEven : kOdd, even ? kOdd : kEven);
    }
    scene.error = widestJoint(scene.def);
    return scene;
}

Scene chains(int size, std::uint64_t) {
    return levelChains("chains", size, 100);
}

Scene shortChains(int size, std::uint64_t) {
    return levelChains("shortchains", size, 10);
}

Scene bridge(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"bridge", scenes::kDown, {}};
    for (int i = 0; i < kBridges; ++i) {
        addBridge(scene.def, size, {0, 6.0 * i});
    }
    measureGap(scene, kPlank);
    return scene;
}

Scene bridgeCars(int size, std::uint64_t) {
    Scene scene;
    scene.def = {"bridgecars", scenes::kDown, {}};
    for (int i = 0; i < kBridges; ++i) {
        addBridge(scene.def, size, {0, 6.0 * i});
        for (const double x : {-6.0, 0.0, 6.0}) {
            addCar(scene.def, {x, 6.0 * i + 0.75});
        }
    }
    measureGap(scene, kPlank);
    return scene;
}

/// The hub is light beside what hangs on it.
Scene hub(int size, std::uint64_t) {
    constexpr double kRadius = 0.5; // m
    Scene scene;
    scene.def = {"hub", scenes::kDown, {wall(1, 1, {}), scenes::ball(kRadius, {})}};
    scene.def.joints = {{0, 1, {}}};
    for (int i = 0; i < size; ++i) {
        const Vec2 rim = kRadius * scenes::direction(static_cast<double>(i) / size);
        scene.def.joints.push_back({1, scene.def.bodies.size(), rim});
        scene.def.bodies.push_back(ghost(scenes::box(0.1, 1, rim - Vec2{0, 0.5})));
    }
    scene.def.bodies[0].category = scene.def.bodies[1].category = kGround;
    measureGap(scene, 1);
    return scene;
}

/// Five segments with motors and limits carry a load at their end.
Scene arm(int size, std::uint64_t) {
    constexpr double kSegment = 1; // m
    constexpr int kSegments = 5;
    Scene scene;
    scene.def = {"arm", scenes::kDown, {}};
    for (int i = 0; i < size; ++i) {
        const Vec2 foot{0, -4.0 * i};
        scene.def.bodies.push_back(ghost(wall(0.5, 0.5, foot)));
        for (int k = 0; k < kSegments; ++k) {
            const Vec2 pin = foot + Vec2{kSegment * k, 0};
            const std::size_t body = scene.def.bodies.size();
            scene.def.joints.push_back(
                {body - 1, body, pin, 0.2, 400.0, scenes::AngleLimits{-0.5, 0.5}});
            scene.def.bodies.push_back(
                ghost(scenes::box(kSegment, 0.2, pin + Vec2{0.5 * kSegment, 0})));
        }
        scene.def.bodies.back().density = 20;
    }
    measureGap(scene, kSegment);
    return scene;
}

/// A jib with a motor, and a rope of links with a load of 20 times a link's mass on the end.
Scene crane(int size, std::uint64_t) {
    constexpr double kLink = 0.3; // m
    constexpr int kLinks = 20;
    Scene scene;
    scene.def = {"crane", scenes::kDown, {}};
    for (int i = 0; i < size; ++i) {
        const Vec2 mast{20.0 * i, 0};
        const std::size_t jib = scene.def.bodies.size() + 1;
        scene.def.bodies.push_back(ghost(wall(0.5, 0.5, mast)));
        scene.def.bodies.push_back(ghost(scenes::box(8, 0.4, mast + Vec2{4, 0})));
        scene.def.joints.push_back(
            {jib - 1, jib, mast, 0.2, 5000.0, scenes::AngleLimits{-0.3, 0.8}});
        for (int k = 0; k < kLinks; ++k) {
            const Vec2 pin = mast + Vec2{8, -kLink * k};
            const std::size_t body = scene.def.bodies.size();
            scene.def.joints.push_back({body - 1, body, pin});
            scene.def.bodies.push_back(ghost(scenes::box(0.1, kLink, pin - Vec2{0, 0.5 * kLink})));
        }
        scene.def.bodies.back().density = 20;
    }
    measureGap(scene, kLink);
    return scene;
}

/// Bars hang from the rim of a hub that a motor turns.
Scene wheel(int size, std::uint64_t) {
    constexpr double kRadius = 5; // m
    Scene scene;
    scene.def = {"wheel", scenes::kDown, {wall(1, 1, {}), scenes::ball(kRadius, {})}};
    scene.def.joints = {{0, 1, {}, 1, 1e5}};
    for (int i = 0; i < size; ++i) {
        const Vec2 rim = kRadius * scenes::direction(static_cast<double>(i) / size);
        BodyDef spoke = scenes::box(0.05, 1, rim - Vec2{0, 0.5});
        spoke.category = kGhost;
        spoke.mask = kNothing;
        scene.def.joints.push_back({1, scene.def.bodies.size(), rim});
        scene.def.bodies.push_back(spoke);
    }
    scene.def.bodies[0].category = scene.def.bodies[1].category = kGround;
    scene.error = widestJoint(scene.def);
    return scene;
}

Scene cars(int size, std::uint64_t seed) {
    constexpr double kGap = 5; // m, from car to car
    Dice dice(seed);
    Scene scene;
    scene.def = {"cars", scenes::kDown, {}};
    const double length = kGap * size + 100;
    addHills(scene.def, length, 1.5, 0.3, dice);
    scene.def.bodies.push_back(wall(1, 10, {-length / 2, 5}));
    scene.def.bodies.push_back(wall(1, 10, {length / 2, 5}));
    for (int i = 0; i < size; ++i) {
        addCar(scene.def, {kGap * (i - 0.5 * size) - 20, 1.1});
    }
    scene.region = Region{{-length / 2, 0}, {length / 2, 10}};
    scene.error = widestJoint(scene.def);
    return scene;
}

} // namespace bench
