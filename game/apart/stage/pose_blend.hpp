// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world/world.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// Where bodies are between two ticks, so that motion is smooth whatever the frame rate.
class PoseBlend {
public:
    /// Call before each tick.
    void remember(const kodo::World& world);
    /// At that share of the way from the remembered tick to the present one: takes a point of
    /// part(i).convex to the world. A body that is new, or has jumped, is where it is.
    kodo::Transform placement(const kodo::BodyView& body, kodo::Real share) const;
    kodo::Vec2 center(const kodo::BodyView& body, kodo::Real share) const {
        return placement(body, share).position;
    }

private:
    struct Pose {
        std::uint32_t generation = 0;
        kodo::Vec2 position; // of the shape's frame: a weld moves the centre of mass, but not this
        kodo::Rot rotation;
    };
    std::vector<Pose> poses_; // by BodyId::index
};

} // namespace apart
