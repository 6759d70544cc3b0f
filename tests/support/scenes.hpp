// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

/// Small scenes and sums of conserved quantities.
namespace support {

inline constexpr kodo::Real kDt = kodo::Real(1) / 60; // s, default step
inline constexpr kodo::Vec2 kEarth{0, -10};           // m/s^2

/// World with gravity and without sleep.
inline kodo::WorldDef withoutSleep() {
    kodo::WorldDef def{.gravity = kEarth};
    def.settings.leaveOut = kodo::Feature::Sleep;
    return def;
}

inline void run(kodo::World& world, int steps, kodo::Real dt = kDt) {
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
    }
}

/// Material without friction and rolling resistance.
constexpr kodo::Material slippery(kodo::Real restitution = 0) {
    return kodo::withFriction(0, restitution);
}

/// A static floor 2000 m wide, with its upper face at y = 0.
inline kodo::BodyId addFloor(kodo::World& world, const kodo::Material& material = {}) {
    return world.add({.shape = kodo::Box{2000, 1},
                      .position = {0, kodo::Real(-0.5)},
                      .material = material,
                      .type = kodo::BodyType::Static});
}

/// A static wall with its left face at x.
inline kodo::BodyId addWall(kodo::World& world, kodo::Real x, kodo::Real thickness,
                            const kodo::Material& material) {
    return world.add({.shape = kodo::Box{thickness, 100},
                      .position = {x + thickness / 2, 0},
                      .material = material,
                      .type = kodo::BodyType::Static});
}

inline kodo::BodyDef ballDef(kodo::Vec2 position, kodo::Real radius,
                             const kodo::Material& material = {}) {
    return {.shape = kodo::Circle{radius}, .position = position, .material = material};
}

inline kodo::BodyDef boxDef(kodo::Vec2 position, kodo::Real width, kodo::Real height,
                            const kodo::Material& material = {}) {
    return {.shape = kodo::Box{width, height}, .position = position, .material = material};
}

/// A stack of `count` unit boxes, from y = 0 up.
inline std::vector<kodo::BodyId> addStack(kodo::World& world, int count, kodo::Real x = 0) {
    std::vector<kodo::BodyId> boxes;
    for (int i = 0; i < count; ++i) {
        boxes.push_back(world.add(boxDef({x, kodo::Real(0.5) + static_cast<kodo::Real>(i)}, 1, 1)));
    }
    return boxes;
}

/// A random heap of several shapes between two walls, initially in the air.
inline void addHeap(kodo::World& world, std::uint64_t seed, int count) {
    RandomNumbers random(seed);
    addFloor(world);
    addWall(world, -6, 1, {});
    addWall(world, 5, 1, {});
    for (int i = 0; i < count; ++i) {
        kodo::BodyDef def;
        const kodo::Real size = random.between(0.2, 0.5);
        if (i % 3 == 0) {
            def.shape = kodo::Circle{size};
        } else if (i % 3 == 1) {
            def.shape = kodo::Box{2 * size, size};
        } else {
            def.shape = kodo::Polygon{{{-size, -size}, {size, -size}, {0, size}}};
        }
        def.position = {random.between(-4, 4), 1 + static_cast<kodo::Real>(i) / 4};
        def.rotation = random.rotation();
        def.material.restitution = i % 4 == 0 ? kodo::Real(0.5) : kodo::Real(0);
        world.add(def);
    }
}

/// Sums over all dynamic bodies, in long double.
struct Totals {
    kodo::BasicVec2<long double> momentum; // kg m/s
    long double spin = 0;                  // kg m^2/s, about the origin
    long double kinetic = 0;               // J
};

inline Totals totalsOf(const kodo::World& world) {
    Totals sum;
    for (const kodo::BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if (body.type() != kodo::BodyType::Dynamic) {
            continue;
        }
        const auto wide = [](kodo::Vec2 v) {
            return kodo::BasicVec2<long double>{static_cast<long double>(v.x),
                                                static_cast<long double>(v.y)};
        };
        const auto m = static_cast<long double>(body.mass());
        const auto inertia = static_cast<long double>(body.inertia());
        const auto w = static_cast<long double>(body.angularVelocity());
        const kodo::BasicVec2<long double> v = wide(body.velocity());
        sum.momentum += m * v;
        sum.spin += inertia * w + m * cross(wide(body.center()), v);
        sum.kinetic += (m * dot(v, v) + inertia * w * w) / 2;
    }
    return sum;
}

/// The record of a pair in the last step, or nullptr.
inline const kodo::CollisionRecord* recordOf(const kodo::World& world, kodo::BodyId one,
                                             kodo::BodyId other) {
    for (const kodo::CollisionRecord& record : world.collisions()) {
        if (record.involves(one) && record.involves(other)) {
            return &record;
        }
    }
    return nullptr;
}

} // namespace support
