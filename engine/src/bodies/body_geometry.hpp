// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>
#include <kodo/measure.hpp>
#include <kodo/shape.hpp>

#include "bodies/body_checks.hpp"

#include <memory>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Immutable geometry of a body, shared by equal bodies, clones and copies of a World.
struct BodyGeometry {
    std::vector<Part> parts;
    Mass mass;               // centre in the frame of the shape
    Real area = 0;           // m^2; overlapping parts count twice
    Real boundingRadius = 0; // m; largest distance of a point from the centre of mass
    Real rotationReach = 0;  // m; largest of all parts, see ConvexShape
    Real coreRadius = 0;     // m; smallest of all parts
};

/// The parts of a valid definition: one for each primitive of its shape.
std::vector<Part> partsOf(const BodyDef& def);

/// Checks mass and moment of inertia of a body or a part.
std::optional<Problem> checkMass(const Mass& mass);

/// Checks the size of a part in the frame of its body.
std::optional<Problem> checkExtent(const Primitive& primitive, Real lengthUnit);

/// Checks size and mass of parts that form one body.
std::optional<Problem> checkParts(std::span<const Part> parts, Real lengthUnit);

/// Computes mass, centre and convex shapes. Overwrites `convex` of the parts.
std::shared_ptr<const BodyGeometry> makeGeometry(std::vector<Part> parts);

} // namespace KODO_PRECISION
} // namespace kodo
