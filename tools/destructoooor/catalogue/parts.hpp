// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "scene.hpp"

namespace destructoooor {

// What scenes are built of. Lengths in m.

/// A number of a scene as a Real.
constexpr Real operator""_r(long double number) {
    return static_cast<Real>(number);
}
constexpr Real operator""_r(unsigned long long number) {
    return static_cast<Real>(number);
}

/// The solver of 2006 with numbers of passes. Nothing sleeps, so that overlap stays in sight.
inline kodo::StepSettings thesisWith(int impactPasses, int contactPasses, int shockPasses) {
    kodo::StepSettings settings = kodo::thesis2006();
    settings.propagation().impactPasses = impactPasses;
    settings.propagation().contactPasses = contactPasses;
    settings.propagation().shockPasses = shockPasses;
    settings.leaveOut = kodo::Feature::Sleep;
    return settings;
}

/// Static ground with its top at y = 0, 40 m wide.
inline BodyId addGround(kodo::World& world, const kodo::Material& material = {}) {
    return world.add(
        {.shape = kodo::Box{40, 2, {0, -1}}, .material = material, .type = kodo::BodyType::Static});
}

inline BodyId addBox(kodo::World& world, Vec2 center, Real width, Real height,
                     kodo::BodyDef rest = {}) {
    rest.shape = kodo::Box{width, height};
    rest.position = center;
    return world.add(rest);
}

inline BodyId addBall(kodo::World& world, Vec2 center, Real radius, kodo::BodyDef rest = {}) {
    rest.shape = kodo::Circle{radius};
    rest.position = center;
    return world.add(rest);
}

/// A small static box, to hang things on.
inline BodyId addAnchor(kodo::World& world, Vec2 at) {
    return addBox(world, at, 0.4_r, 0.4_r, {.type = kodo::BodyType::Static});
}

/// Static box between two points, on the right of the direction from one to the other.
inline BodyId addWall(kodo::World& world, Vec2 from, Vec2 to, Real thickness = 1,
                      const kodo::Material& material = {}) {
    const Vec2 along = to - from;
    const Vec2 unit = kodo::normalize(along);
    const Vec2 middle = Real(0.5) * (from + to) - (thickness / 2) * kodo::perp(unit);
    return world.add({.shape = kodo::Box{kodo::length(along), thickness},
                      .position = middle,
                      .rotation = {unit.x, unit.y},
                      .material = material,
                      .type = kodo::BodyType::Static});
}

/// Balls, boxes and triangles in rows above the ground, `across` of them side by side.
inline void addMixed(kodo::World& world, std::size_t bodies, std::size_t across) {
    for (std::size_t i = 0; i < bodies; ++i) {
        const Vec2 at{Real(i % across) * 1.2_r - Real(across - 1) * 0.6_r,
                      1 + Real(i / across) * 1.3_r};
        const Real size = 0.3_r + 0.06_r * Real(i * 7 % 5);
        switch (i % 3) {
        case 0:
            addBall(world, at, size);
            break;
        case 1:
            addBox(world, at, 2 * size, 1.5_r * size);
            break;
        default:
            world.add({.shape = kodo::Polygon{{{-size, -size}, {size, -size}, {0, size}}},
                       .position = at});
        }
    }
}

/// Static walls around a room from x = -width / 2 to width / 2 and from y = 0 to height.
inline void addRoom(kodo::World& world, Real width, Real height,
                    const kodo::Material& material = {}) {
    addWall(world, {-width / 2, 0}, {width / 2, 0}, 1, material);
    addWall(world, {width / 2, 0}, {width / 2, height}, 1, material);
    addWall(world, {width / 2, height}, {-width / 2, height}, 1, material);
    addWall(world, {-width / 2, height}, {-width / 2, 0}, 1, material);
}

/// The body collides with nothing more.
inline void meetNothing(kodo::World& world, BodyId id) {
    constexpr kodo::Flags kNobody = 0x8000; // a category that no body of a scene has
    world[id].setFlags(kodo::kMatchAny);
    world[id].setRequired(kNobody);
}

/// Ends of a joint at a world point.
inline kodo::JointEnds endsAt(const kodo::World& world, BodyId a, BodyId b, Vec2 point) {
    kodo::JointEnds ends;
    ends.a = a;
    ends.b = b;
    ends.anchorA = kodo::toLocal(world[a].transform(), point);
    ends.anchorB = kodo::toLocal(world[b].transform(), point);
    return ends;
}

inline kodo::JointId pin(kodo::World& world, BodyId a, BodyId b, Vec2 point) {
    return world.add(kodo::RevoluteJoint{.ends = endsAt(world, a, b, point)});
}

/// Spring, rod or rope between two points of two bodies.
inline kodo::JointId tie(kodo::World& world, BodyId a, Vec2 pointA, BodyId b, Vec2 pointB,
                         kodo::DistanceJoint joint) {
    joint.ends.a = a;
    joint.ends.b = b;
    joint.ends.anchorA = kodo::toLocal(world[a].transform(), pointA);
    joint.ends.anchorB = kodo::toLocal(world[b].transform(), pointB);
    return world.add(joint);
}

inline kodo::DistanceJoint rope(Real length) {
    return {.length = length, .limits = kodo::Range{0, length}};
}

/// Kinetic and potential energy (J) of the dynamic bodies, 0 at y = 0.
inline Real energyOf(const kodo::World& world, Real gravity) {
    Real sum = 0;
    for (const BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if (body.type() == kodo::BodyType::Dynamic) {
            const Real spin = body.angularVelocity();
            sum += body.mass() *
                       (kodo::lengthSquared(body.velocity()) / 2 + gravity * body.center().y) +
                   body.inertia() * spin * spin / 2;
        }
    }
    return sum;
}

/// Sum of the momenta (kg m/s) of the dynamic bodies.
inline Vec2 momentumOf(const kodo::World& world) {
    Vec2 sum{};
    for (const BodyId id : world.bodies()) {
        if (world[id].type() == kodo::BodyType::Dynamic) {
            sum += world[id].mass() * world[id].velocity();
        }
    }
    return sum;
}

inline bool isNear(Real value, Real wanted, Real tolerance) {
    return std::abs(value - wanted) <= tolerance;
}
inline bool isNear(Vec2 value, Vec2 wanted, Real tolerance) {
    return kodo::length(value - wanted) <= tolerance;
}

/// True if no dynamic body is outside a box, by its centre.
inline bool allWithin(const kodo::World& world, const kodo::Aabb& box) {
    const std::vector<BodyId> bodies = world.bodies();
    return std::all_of(bodies.begin(), bodies.end(), [&](BodyId id) {
        return world[id].type() != kodo::BodyType::Dynamic || box.contains(world[id].center());
    });
}

/// Largest overlap (m) of the last step.
inline Real deepestOverlap(const kodo::World& world) {
    Real deepest = 0;
    for (const kodo::CollisionRecord& record : world.collisions()) {
        if (record.phase != kodo::TouchPhase::End) {
            deepest = std::max(deepest, -record.separation);
        }
    }
    return deepest;
}

} // namespace destructoooor
