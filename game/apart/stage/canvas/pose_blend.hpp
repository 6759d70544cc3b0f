// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// Interpolates body poses between two ticks, for smooth motion at any frame rate.
class PoseBlend {
public:
    /// Call before each tick.
    void remember(const kodo::World& world);
    /// Interpolated frame of the centre of mass, from the remembered tick (share 0) to the current
    /// one (share 1). It takes points of part(i).convex to the world. New and teleported bodies
    /// keep their current frame.
    kodo::Transform massFrame(const kodo::BodyView& body, kodo::Real share) const;
    kodo::Vec2 center(const kodo::BodyView& body, kodo::Real share) const {
        return massFrame(body, share).position;
    }

private:
    struct Pose {
        std::uint32_t generation = 0;
        kodo::Vec2 position; // of the shape's frame: unlike the centre of mass, it is unchanged by
                             // a weld
        kodo::Rot rotation;
    };
    std::vector<Pose> poses_; // by BodyId::index
};

} // namespace apart
