// SPDX-License-Identifier: MIT
#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kFriction = "Friction";
constexpr std::string_view kRestitution = "Restitution";

kodo::BodyDef withMaterial(const kodo::Material& material, Vec2 velocity = {}) {
    return {.velocity = velocity, .material = material};
}

Ids buildSlope(kodo::World& world) {
    // The tangent of the slope is 0.5; friction of a contact is the mean of both, here equal.
    const Vec2 down = kodo::normalize(Vec2{2, -1});
    const Vec2 start{-9, 10};
    Ids ids;
    const Real frictions[] = {0.45_r, 0.55_r};
    for (int i = 0; i < 2; ++i) {
        const Vec2 from = start + Vec2{0, -5 * Real(i)};
        addWall(world, from, from + 18 * down, 1, kodo::withFriction(frictions[i]));
        kodo::BodyDef def = withMaterial(kodo::withFriction(frictions[i]));
        def.rotation = {down.x, down.y};
        ids.push_back(addBox(world, from + 3 * down + 0.5_r * kodo::perp(down), 1.5_r, 1, def));
    }
    return ids;
}

Ids buildBrakes(kodo::World& world) {
    Ids ids;
    for (int i = 0; i < 4; ++i) {
        const kodo::Material material = kodo::withFriction(0.1_r * Real(1 << i));
        const Real y = 3 * Real(3 - i);
        addWall(world, {-12, y}, {14, y}, 0.5_r, material);
        ids.push_back(addBox(world, {-11, y + 0.5_r}, 1, 1, withMaterial(material, {6, 0})));
    }
    return ids;
}

bool brakedAsCoulombSays(const kodo::World& world, const Ids& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Real friction = 0.1_r * Real(1 << i);
        const Real way = 36 / (2 * friction * 10); // v^2 / 2 mu g
        if (!isNear(world[ids[i]].center().x, -11 + way, 0.02_r * way)) {
            return false;
        }
    }
    return true;
}

Ids buildRolling(kodo::World& world) {
    const Vec2 down = kodo::normalize(Vec2{3, -1});
    addWall(world, Vec2{-12, 8}, Vec2{-12, 8} + 26 * down);
    const Vec2 on = Vec2{-11, 8 - 1 / 3.0_r} + 0.5_r * kodo::perp(down);
    return {addBall(world, on, 0.5_r)};
}

bool rolledTwoThirds(const kodo::World& world, const Ids& ids) {
    // A solid disc rolls with 2/3 of the acceleration with which it would slide.
    const Real sine = 1 / std::sqrt(10.0_r);
    return isNear(kodo::length(world[ids[0]].velocity()), 2 / 3.0_r * 10 * sine * 3, 0.1_r);
}

Ids buildRollingResistance(kodo::World& world) {
    Ids ids;
    for (int i = 0; i < 3; ++i) {
        const Real y = 4 * Real(2 - i);
        addWall(world, {-12, y}, {14, y}, 0.5_r);
        kodo::BodyDef def{.velocity = {5, 0}, .angularVelocity = -10};
        def.material.rollingResistance = 0.05_r * Real(i);
        ids.push_back(addBall(world, {-11, y + 0.5_r}, 0.5_r, def));
    }
    return ids;
}

Ids buildStiction(kodo::World& world) {
    const kodo::Material surface{0.8_r, 0.2_r, 0, 0};
    const Vec2 down = kodo::normalize(Vec2{2, -1});
    addWall(world, {-12, 11}, Vec2{-12, 11} + 28 * down, 1, surface);
    Ids ids;
    for (int i = 0; i < 2; ++i) {
        kodo::BodyDef def = withMaterial(surface, Real(i) * 2 * down);
        def.rotation = {down.x, down.y};
        ids.push_back(addBox(world,
                             Vec2{-12, 11} + (3 + 6 * Real(i)) * down + 0.5_r * kodo::perp(down),
                             1.5_r, 1, def));
    }
    return ids;
}

Ids buildBounces(kodo::World& world) {
    addGround(world, {.restitution = 1});
    Ids ids;
    for (int i = 0; i < 5; ++i) {
        const kodo::Material material{0.6_r, 0.6_r, 0.25_r * Real(i), 0};
        ids.push_back(addBall(world, {4 * Real(i) - 8, 10.5_r}, 0.5_r, withMaterial(material)));
    }
    return ids;
}

Ids buildCradle(kodo::World& world) {
    const kodo::Material steel{0, 0, 1, 0};
    Ids ids;
    for (int i = 0; i < 5; ++i) {
        ids.push_back(addBall(world, {Real(i), 6}, 0.5_r, withMaterial(steel)));
    }
    ids.push_back(addBall(world, {-6, 6}, 0.5_r, withMaterial(steel, {6, 0})));
    return ids;
}

Ids buildGas(kodo::World& world) {
    const kodo::Material elastic{0, 0, 1, 0};
    addRoom(world, 20, 12, elastic);
    for (int i = 0; i < 120; ++i) {
        const Vec2 velocity = kodo::Rot::fromAngle(Real(i)).xAxis() * 5;
        addBall(world, {Real(i % 15) * 1.2_r - 8.4_r, 1 + Real(i / 15) * 1.3_r}, 0.25_r,
                withMaterial(elastic, velocity));
    }
    return {};
}

bool gasKeepsEnergy(const kodo::World& world, const Ids&) {
    const Real mass = 3.14159265_r / 16;
    return isNear(energyOf(world, 0) / (120 * mass * 25 / 2), 1, 0.01_r) &&
           allWithin(world, {{-10, 0}, {10, 12}});
}

Ids buildSuperball(kodo::World& world) {
    addGround(world, {.restitution = 1});
    const kodo::Material rubber{0.6_r, 0.6_r, 0.95_r, 0};
    addBall(world, {0, 3}, 1, {.material = rubber, .density = 2});
    kodo::BodyDef small = withMaterial(rubber);
    small.density = 0.5_r;
    return {addBall(world, {0, 4.4_r}, 0.35_r, small)};
}

Ids buildBreak(kodo::World& world) {
    const kodo::Material ivory{0.1_r, 0.1_r, 0.95_r, 0};
    Ids ids;
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i <= row; ++i) {
            ids.push_back(addBall(world, {Real(row) * 0.87_r, 6 + Real(i) - Real(row) / 2}, 0.5_r,
                                  withMaterial(ivory)));
        }
    }
    ids.push_back(addBall(world, {-9, 6.02_r}, 0.5_r, withMaterial(ivory, {15, 0})));
    return ids;
}

bool keepsMomentum(const kodo::World& world, const Ids& ids) {
    const Real before = 15 * world[ids.back()].mass();
    return isNear(momentumOf(world), {before, 0}, 1e-3_r * before) &&
           world[ids[ids.size() - 2]].velocity().y > 1;
}

const Scene kSurfaceScenes[] = {
    {kFriction, "Slope", "When does a box slide down a slope with the tangent 1/2?",
     "With a friction of 0.45 it slides; with 0.55 it stays.", buildSlope, 2,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].velocity().x > 0.5_r &&
                kodo::length(world[ids[1]].velocity()) < 0.01_r;
     }},
    {kFriction, "Brakes", "How far do four boxes slide with friction 0.1, 0.2, 0.4 and 0.8?",
     "v^2 / (2 mu g): half as far with twice the friction.", buildBrakes, 8, brakedAsCoulombSays},
    {kFriction, "Rolling disc", "How fast is a disc that rolls down a slope?",
     "It gains 2/3 of the speed that it would gain without friction.", buildRolling, 3,
     rolledTwoThirds},
    {kFriction, "Rolling resistance", "What stops a ball that rolls?",
     "Without resistance nothing; with more of it, it stops sooner.", buildRollingResistance, 4,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].velocity().x > 4.9_r && world[ids[1]].velocity().x < 3.7_r &&
                world[ids[2]].velocity().x < world[ids[1]].velocity().x;
     }},
    {kFriction, "Stiction", "Is it harder to start than to go on?",
     "Static friction 0.8 holds one box; the pushed one slides on with 0.2.", buildStiction, 2,
     [](const kodo::World& world, const Ids& ids) {
         return kodo::length(world[ids[0]].velocity()) < 0.01_r &&
                kodo::length(world[ids[1]].velocity()) > 4;
     }},
    {kRestitution, "Five bounces", "How high do balls rise with restitution 0, 1/4, 1/2, 3/4, 1?",
     "By its square: the last one comes back to where it fell from.", buildBounces,
     4 * 1.41421356_r, // s: twice down and up from 10 m
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[4]].center().y, 10.5_r, 0.3_r) &&
                world[ids[0]].center().y < 0.55_r;
     }},
    {kRestitution,
     "Cradle",
     "One ball hits five that touch: how many leave?",
     "One, with the whole speed; the others stand still.",
     buildCradle,
     2,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[4]].velocity().x, 6, 0.01_r) &&
                kodo::length(world[ids[2]].velocity()) < 0.01_r;
     },
     {}},
    {kRestitution,
     "Gas",
     "Do 120 elastic discs keep their energy?",
     "Within one per cent in ten seconds, and none leaves.",
     buildGas,
     10,
     gasKeepsEnergy,
     {}},
    {kRestitution, "Small on large", "A small ball on a large one: how high does it fly?",
     "Several times as high as both fell from.", buildSuperball, 1.3_r,
     [](const kodo::World& world, const Ids& ids) { return world[ids[0]].center().y > 8; }},
    {kRestitution,
     "Break",
     "Where does the momentum go when a ball hits fifteen?",
     "It spreads; the sum stays, and so do its parts.",
     buildBreak,
     3,
     keepsMomentum,
     {}},
};

} // namespace

std::span<const Scene> surfaceScenes() {
    return kSurfaceScenes;
}

} // namespace destructoooor
