// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>
#include <support/every_kind.hpp>
#include <support/random_numbers.hpp>

#include "base/checksum.hpp"
#include "base/state_stream.hpp"

#include <memory>
#include <vector>

/// Scenes of the snapshot tests and of the program that continues from a file.
namespace support {
inline namespace KODO_PRECISION {

using Bytes = std::vector<std::byte>;

/// A user-defined field: a force around the origin.
class Swirl final : public kodo::ForceField {
public:
    explicit Swirl(kodo::Real strength) : strength_(strength) {} // 1/s^2
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real) const override {
        return {strength_ * body.mass() * perp(body.center())};
    }

private:
    kodo::Real strength_;
};

using OwnFields = std::vector<std::shared_ptr<const kodo::ForceField>>;

/// The fields of busyWorld() that a snapshot does not contain.
inline OwnFields ownFields() {
    return {std::make_shared<Swirl>(kodo::Real(0.01)), std::make_shared<Swirl>(kodo::Real(-0.02))};
}

inline void addFields(kodo::World& world) {
    const OwnFields own = ownFields();
    const kodo::DragLaw law{kodo::Real(0.05), kodo::Real(0.01)};
    const kodo::CollisionFilter marked{kodo::kMatchAny, 2};
    world.addField({own[0]});
    world.addField({std::make_shared<kodo::Drag>(law)});
    world.addField(
        {std::make_shared<kodo::Wind>(law, kodo::Vec2{1, 0}, kodo::Aabb{{-3, 2}, {3, 8}}), marked});
    world.addField({own[1], marked});
    world.addField({std::make_shared<kodo::Attractor>(
        kodo::Attractor::Law::InverseSquare, kodo::Vec2{0, 3}, kodo::Real(0.5), kodo::Real(0.25))});
    world.addField(
        {std::make_shared<kodo::Buoyancy>(kodo::Buoyancy::Fluid{kodo::Real(0.5), kodo::Real(0.2)},
                                          kodo::Vec2{0, kodo::Real(0.5)}, kodo::Vec2{0, -10})});
}

/// Uneven ground between two walls, a moving platform, a sensor, a one-sided segment, and a body
/// outside the region.
inline void addGround(kodo::World& world) {
    kodo::Heightmap ground{{-6, 0}, kodo::Real(0.75), {}};
    for (int i = 0; i <= 16; ++i) {
        ground.heights.push_back(i % 3 == 0 ? kodo::Real(0.2) : kodo::Real(0));
    }
    world.add({.shape = ground, .type = kodo::BodyType::Static});
    for (const kodo::Real x : {kodo::Real(-6), kodo::Real(6)}) {
        world.add({.shape = kodo::Box{1, 40}, .position = {x, 0}, .type = kodo::BodyType::Static});
    }
    world.add({.shape = kodo::Plane{{0, 1}, -2}, .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Box{2, kodo::Real(0.2)},
               .position = {-2, 1},
               .velocity = {kodo::Real(0.125), 0},
               .type = kodo::BodyType::Kinematic});
    world.add({.shape = kodo::Circle{1},
               .position = {2, 2},
               .type = kodo::BodyType::Static,
               .flags = kodo::kSensor});
    world.add({.shape = kodo::Segment{{-1, 3}, {1, 3}, true}, .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Circle{1}, .position = {0, 500}, .userData = 0x123456789abcdef0});
}

/// Definition of piece i: four kinds of shapes, in several sizes.
inline kodo::BodyDef pieceDef(RandomNumbers& random, int i) {
    kodo::BodyDef def;
    const kodo::Real size = kodo::Real(0.2) + kodo::Real(0.05) * static_cast<kodo::Real>(i % 4);
    if (i % 4 == 0) {
        def.shape = kodo::Circle{size};
    } else if (i % 4 == 1) {
        def.shape = kodo::Box{2 * size, size};
    } else if (i % 4 == 2) {
        def.shape = kodo::Polygon{{{-size, -size}, {size, -size}, {0, size}}};
    } else {
        def.shape = kodo::Compound{{kodo::Box{2 * size, size / 2},
                                    kodo::Circle{size / 2, {size, 0}}, kodo::Point{{-size, 0}}}};
    }
    def.position = {random.between(-4, 4), 1 + static_cast<kodo::Real>(i) / 6};
    def.rotation = random.rotation();
    def.material = kodo::withFriction(random.between(0, 1), i % 5 == 0 ? kodo::Real(0.5) : 0);
    def.material.rollingResistance = kodo::Real(0.01);
    def.flags = static_cast<kodo::Flags>(i % 4);
    def.userData = static_cast<std::uint64_t>(i);
    return def;
}

/// One joint of each kind between neighbours; the last one breaks soon.
inline void addJoints(kodo::World& world, const std::vector<kodo::BodyId>& pieces) {
    const auto ends = [&](std::size_t i) {
        return kodo::JointEnds{pieces[i], pieces[i + 1], {0, kodo::Real(0.25)}, {}};
    };
    kodo::JointEnds named = ends(37);
    named.userData = 9;
    kodo::JointEnds weak = ends(11);
    weak.breakForce = kodo::Real(0.5);
    const EveryKind<kodo::JointDef> kinds{
        kodo::RevoluteJoint{ends(0), 0, kodo::Range{-1, 1}, 2, 1},
        kodo::FixedJoint{ends(2)},
        kodo::DistanceJoint{ends(4), kodo::Real(0.75), 3, kodo::Real(0.5), kodo::Range{0, 2}},
        kodo::PrismaticJoint{ends(6), {1, 0}, 0, kodo::Range{-1, 1}, 1, 2},
        kodo::MotorJoint{ends(8), 0, 1, 1},
        kodo::MouseJoint{pieces[10], {}, {1, 4}, 3},
        kodo::RevoluteJoint{.ends = ends(22), .target = 5, .hertz = 1},
        kodo::RevoluteJoint{
            .ends = ends(23), .limits = kodo::Range{-9, 9}, .ratchet = kodo::Real(0.125)},
        kodo::FixedJoint{.ends = ends(24), .hertz = 3, .damping = 1},
        kodo::PrismaticJoint{.ends = ends(26), .hertz = 2},
        kodo::DistanceJoint{.ends = ends(30), .motorSpeed = 1, .motorForce = 3},
        kodo::WheelJoint{
            .ends = ends(31), .hertz = 3, .damping = 1, .motorSpeed = 9, .motorTorque = 1},
        kodo::PulleyJoint{ends(33), {0, 9}, {2, 9}, 16, 1},
        kodo::GearJoint{.ends = ends(35)},
        kodo::GearJoint{.ends = ends(36), .ratio = 1, .rack = kodo::Vec2{1, 0}},
        kodo::FilterJoint{named},
        kodo::RevoluteJoint{weak}};
    for (const kodo::JointDef& def : kinds.list) {
        world.add(def);
    }
}

/// A World with every feature: heap, compounds, joints, fields, sensor, region.
inline kodo::World busyWorld(const kodo::StepSettings& settings = {}) {
    kodo::World world({.gravity = {0, -10}, .lengthUnit = kodo::Real(0.5), .settings = settings});
    addFields(world);
    addGround(world);
    RandomNumbers random(11);
    std::vector<kodo::BodyId> pieces;
    for (int i = 0; i < 40; ++i) {
        pieces.push_back(world.add(pieceDef(random, i)));
    }
    addJoints(world, pieces);
    for (const int gone : {13, 17, 29}) {
        world.remove(pieces[static_cast<std::size_t>(gone)]);
    }
    // A mass that was set, and a part with flags, user data and a set mass of its own.
    world[pieces[20]].setMass({.mass = 3, .center = kodo::Vec2{kodo::Real(0.05), 0}});
    world[pieces[21]].setMass(2);
    world.weld(pieces[22], pieces[21]);
    // A stack inside the region that falls asleep early.
    for (int i = 0; i < 3; ++i) {
        world.add({.shape = kodo::Box{kodo::Real(0.5), kodo::Real(0.5)},
                   .position = {20, kodo::Real(-1.75) + kodo::Real(0.5) * kodo::Real(i)}});
    }
    world.setRegion(kodo::Aabb{{-30, -30}, {30, 30}});
    return world;
}

/// Updates the checksum, so that the checks behind it are reached.
inline void seal(Bytes& bytes) {
    const std::size_t size = bytes.size() - 8;
    const std::uint64_t checksum = kodo::checksumOf(std::span(bytes).first(size));
    for (std::size_t i = 0; i < 8; ++i) {
        bytes[size + i] = static_cast<std::byte>(checksum >> 8 * i);
    }
}

} // namespace KODO_PRECISION
} // namespace support
