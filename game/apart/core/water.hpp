// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

namespace apart {

/// The part of a convex shape at pose t inside a rectangle. A circle counts as a regular polygon
/// with 16 corners and the same area.
kodo::Submerged wetPart(const kodo::ConvexShape& convex, const kodo::Transform& t,
                        const kodo::Aabb& water);

/// Water in a rectangle. As kodo::Buoyancy, but with sides and a bottom, and it may flow:
///
///   F = density A g - drag A (v - flow),  at the centroid of the wet part, whose area is A
class Pool final : public kodo::ForceField {
public:
    struct Fluid {
        kodo::Real density = 1; // kg/m^2
        kodo::Real drag = 0;    // kg/(m^2 s)
        kodo::Vec2 flow{};      // m/s
    };
    Pool(Fluid fluid, const kodo::Aabb& region) : fluid_(fluid), region_(region) {}
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real dt) const override;

private:
    Fluid fluid_;
    kodo::Aabb region_; // m, world
};

} // namespace apart
