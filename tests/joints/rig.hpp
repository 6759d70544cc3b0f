// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

#include <memory>
#include <vector>

/// What the tests of joints hang things on.
namespace joints {

inline constexpr double kPi = 3.14159265358979;
inline constexpr double kG = 10; // m/s^2, of support::kEarth

/// A locked post at the origin, which touches nothing.
struct Rig {
    kodo::World world;
    kodo::BodyId post;

    explicit Rig(kodo::Vec2 gravity = support::kEarth, const kodo::StepSettings& settings = {})
        : world({.gravity = gravity, .settings = settings}) {
        post = world.add({.shape = kodo::Box{1, 1}, .flags = kodo::kLocked | kodo::kDisabled});
    }

    /// A free ball of radius 0.25 m.
    kodo::BodyId addBob(kodo::Vec2 position) {
        return world.add(support::ballDef(position, kodo::Real(0.25)));
    }
    /// Lets everything come to hang still, in thick air; then the air is gone again for a second.
    void settle(int steps) {
        const std::vector<kodo::FieldEntry> fields = world.fields();
        world.addField({std::make_shared<kodo::Drag>(kodo::DragLaw{1, 0})});
        support::run(world, steps);
        world.setFields(fields);
        support::run(world, 60);
    }
    double weightOf(kodo::BodyId id) const { return kG * static_cast<double>(world[id].mass()); }
};

/// World place of a point of a body's shape.
inline kodo::Vec2 placeOf(const kodo::World& world, kodo::BodyId id, kodo::Vec2 anchor) {
    return world[id].position() + world[id].rotation() * anchor;
}

/// How far the anchors of a joint lie apart.
inline kodo::Vec2 gapOf(const kodo::World& world, const kodo::JointEnds& ends) {
    return placeOf(world, ends.b, ends.anchorB) - placeOf(world, ends.a, ends.anchorA);
}

} // namespace joints
