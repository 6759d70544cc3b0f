// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>
#include <kodo/convex_shape.hpp>
#include <kodo/measure.hpp>

#include "bodies/body_checks.hpp"
#include "bodies/part_list.hpp"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Immutable geometry of a body, shared by equal bodies, clones and copies of a World.
struct BodyGeometry : PartList {
    Mass mass;               // centre in the frame of the shape
    Real area = 0;           // m^2; overlapping parts count twice
    Real boundingRadius = 0; // m; largest distance of a point from the centre of mass
    Real rotationReach = 0;  // m; largest of all parts, see ConvexShape
    Real coreRadius = 0;     // m; smallest of all parts
    bool filters = false;    // some part has a filter of its own
};

/// A body without one of its parts, and that part.
struct DividedGeometry {
    std::shared_ptr<const BodyGeometry> rest;
    std::shared_ptr<const BodyGeometry> taken;
};

/// Checks mass and moment of inertia of a body or a part.
std::optional<Problem> checkMass(const Mass& mass);

/// Checks the size of a part in the frame of its body.
std::optional<Problem> checkExtent(const Primitive& primitive, Real lengthUnit);

/// Checks size and mass of parts that form one body.
std::optional<Problem> checkParts(std::span<const Part> parts, Real lengthUnit);

/// Checks that no part is a plane, which has no mass to set.
std::optional<Problem> checkHasMass(std::span<const Part> parts);

/// Checks a mass that is to be set for a body of these parts. `leastShare`: of m r^2, as
/// kMinInertiaShare.
std::optional<Problem> checkMassDef(const MassDef& def, std::span<const Part> parts,
                                    Real lengthUnit, Real leastShare = kMinInertiaShare);

/// False if an impulse at the rim of a body with a set mass could give a speed that is not finite.
bool hasFirmRim(const BodyGeometry& geometry);

/// Computes mass, centre and convex shapes. Overwrites `convex` of the parts.
std::shared_ptr<const BodyGeometry> makeGeometry(PartList list);
inline std::shared_ptr<const BodyGeometry> makeGeometry(std::vector<Part> parts) {
    return makeGeometry(PartList{std::move(parts), {}, {}});
}

} // namespace KODO_PRECISION
} // namespace kodo
