// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

/// Small scenes and the sums that physics keeps.
namespace support {

inline constexpr kodo::Real kDt = kodo::Real(1) / 60; // s, a step unless a test says otherwise
inline constexpr kodo::Vec2 kEarth{0, -10};           // m/s^2

/// Nothing comes to rest, under the gravity of the earth.
inline kodo::WorldDef wakeful() {
    kodo::WorldDef def{.gravity = kEarth};
    def.settings.leaveOut = static_cast<std::uint8_t>(kodo::Feature::Resting);
    return def;
}

inline void run(kodo::World& world, int steps, kodo::Real dt = kDt) {
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
    }
}

/// No friction, no rolling resistance.
constexpr kodo::Material slippery(kodo::Real restitution = 0) {
    return kodo::withFriction(0, restitution);
}

/// Its upper face is the line y = 0, 2000 m long.
inline kodo::BodyId addFloor(kodo::World& world, const kodo::Material& material = {}) {
    return world.add({.shape = kodo::Box{2000, 1},
                      .position = {0, kodo::Real(-0.5)},
                      .material = material,
                      .flags = kodo::kLocked});
}

/// A wall of that thickness with its left face at x.
inline kodo::BodyId addWall(kodo::World& world, kodo::Real x, kodo::Real thickness,
                            const kodo::Material& material) {
    return world.add({.shape = kodo::Box{thickness, 100},
                      .position = {x + thickness / 2, 0},
                      .material = material,
                      .flags = kodo::kLocked});
}

inline kodo::BodyDef ballDef(kodo::Vec2 position, kodo::Real radius,
                             const kodo::Material& material = {}) {
    return {.shape = kodo::Circle{radius}, .position = position, .material = material};
}

inline kodo::BodyDef boxDef(kodo::Vec2 position, kodo::Real width, kodo::Real height,
                            const kodo::Material& material = {}) {
    return {.shape = kodo::Box{width, height}, .position = position, .material = material};
}

/// count unit boxes, one on the other, from y = 0 up.
inline std::vector<kodo::BodyId> addStack(kodo::World& world, int count, kodo::Real x = 0) {
    std::vector<kodo::BodyId> boxes;
    for (int i = 0; i < count; ++i) {
        boxes.push_back(world.add(boxDef({x, kodo::Real(0.5) + static_cast<kodo::Real>(i)}, 1, 1)));
    }
    return boxes;
}

/// A heap of many kinds between two walls, to be dropped.
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

/// Sums over all bodies that are not locked, in long double.
struct Totals {
    kodo::BasicVec2<long double> momentum; // kg m/s
    long double spin = 0;                  // kg m^2/s, about the origin
    long double kinetic = 0;               // J
};

inline Totals totalsOf(const kodo::World& world) {
    Totals sum;
    for (const kodo::BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if ((body.flags() & kodo::kLocked) == kodo::kLocked) {
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

/// The record of this pair in the last step, or nullptr.
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
