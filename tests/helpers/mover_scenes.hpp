// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

#include <algorithm>
#include <utility>
#include <vector>

/// Movers and their ground.
namespace support {

inline constexpr kodo::Real kStep = kodo::Real(1) / 60;
inline constexpr kodo::Real kGravity = 20; // m/s^2
inline const kodo::Primitive kShapes[] = {
    kodo::Circle{kodo::Real(0.4)},
    kodo::Capsule{{0, kodo::Real(-0.4)}, {0, kodo::Real(0.4)}, kodo::Real(0.3)},
    kodo::Box{kodo::Real(0.6), 1},
    kodo::Polygon{
        {{0, kodo::Real(-0.5)}, {kodo::Real(0.4), 0}, {0, kodo::Real(0.5)}, {kodo::Real(-0.4), 0}},
        kodo::Real(0.05)}};

/// One tick as of a platformer: a speed along the ground, gravity always.
inline void tick(kodo::World& world, kodo::Mover& mover, kodo::Real speed, kodo::Real jump = 0) {
    kodo::Vec2 wish{speed, mover.velocity.y - kGravity * kStep};
    if (jump > 0 && mover.grounded) {
        wish.y = jump;
    }
    world.step(kStep);
    mover.move(world, wish, kStep);
}

inline void addStatic(kodo::World& world, const kodo::Shape& shape, kodo::Vec2 position = {},
                      kodo::Real angle = 0) {
    world.add({.shape = shape,
               .position = position,
               .rotation = kodo::Rot::fromAngle(angle),
               .type = kodo::BodyType::Static});
}

inline kodo::Chain ground(std::vector<kodo::Vec2> points) {
    return kodo::Chain{.points = std::move(points), .oneSided = true};
}

/// A mover that stands on what is below x (m).
inline kodo::Mover standing(kodo::World& world, const kodo::Primitive& shape, kodo::Vec2 at) {
    kodo::Mover mover{.shape = shape, .position = at};
    for (int i = 0; i < 120; ++i) {
        tick(world, mover, 0);
    }
    EXPECT_TRUE(mover.grounded);
    return mover;
}

} // namespace support
