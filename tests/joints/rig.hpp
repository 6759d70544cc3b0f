// SPDX-License-Identifier: MIT
#pragma once

#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <memory>
#include <vector>

/// Common scenes of the joint tests.
namespace joints {

inline constexpr double kPi = 3.14159265358979;
inline constexpr double kG = 10; // m/s^2, of support::kEarth

/// A kinematic post at the origin, without collisions.
struct Rig {
    kodo::World world;
    kodo::BodyId post;

    explicit Rig(kodo::Vec2 gravity = support::kEarth, const kodo::StepSettings& settings = {})
        : world({.gravity = gravity, .settings = settings}) {
        post = world.add({.shape = kodo::Box{1, 1},
                          .type = kodo::BodyType::Kinematic,
                          .flags = kodo::kDisabled});
    }

    /// A dynamic ball of radius 0.25 m.
    kodo::BodyId addBob(kodo::Vec2 position) {
        return world.add(support::ballDef(position, kodo::Real(0.25)));
    }
    /// Damps all motion with drag for `steps` steps, then runs one second without drag.
    void settle(int steps) {
        const std::vector<kodo::FieldEntry> fields = world.fields();
        world.addField({std::make_shared<kodo::Drag>(kodo::DragLaw{1, 0})});
        support::run(world, steps);
        world.setFields(fields);
        support::run(world, 60);
    }
    double weightOf(kodo::BodyId id) const { return kG * static_cast<double>(world[id].mass()); }
};

/// m, world position of a point in the frame of a body's shape.
inline kodo::Vec2 placeOf(const kodo::World& world, kodo::BodyId id, kodo::Vec2 anchor) {
    return world[id].position() + world[id].rotation() * anchor;
}

/// m, from anchor a to anchor b; 0 if the joint holds exactly.
inline kodo::Vec2 gapOf(const kodo::World& world, const kodo::JointEnds& ends) {
    return placeOf(world, ends.b, ends.anchorB) - placeOf(world, ends.a, ends.anchorA);
}

/// J, kinetic energy and energy of height of all dynamic bodies.
inline double energyOf(const kodo::World& world) {
    const support::Totals totals = support::totalsOf(world);
    double height = 0;
    for (const kodo::BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if (body.type() == kodo::BodyType::Dynamic) {
            height += static_cast<double>(body.mass()) * static_cast<double>(body.center().y);
        }
    }
    return static_cast<double>(totals.kinetic) + kG * height;
}

} // namespace joints
