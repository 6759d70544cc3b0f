// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/body_def.hpp>
#include <kodo/shapes/convex.hpp>
#include <kodo/shapes/mass.hpp>

#include <memory>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// One convex piece of a body, with what it is made of.
struct Part {
    Primitive primitive; // as given, in the frame of the shape
    Material material;
    Real density = 1; // kg/m^2
    Convex convex{};  // the same outline about the centre of mass of the whole body
};

/// All that never changes about the build of a body. Immutable, so that equal bodies, clones and
/// copies of a World share one.
struct Form {
    std::vector<Part> parts;
    Mass mass;       // centre in the frame of the shape
    Real area = 0;   // m^2; parts that overlap count twice
    Real reach = 0;  // m; no point of the body is farther from the centre of mass
    Real swing = 0;  // m; the largest of all parts: see Convex
    Real inside = 0; // m; the thinnest part's
};

/// The parts of a valid definition: one, or one for each part of a compound.
std::vector<Part> partsOf(const BodyDef& def);

/// What is wrong with the mass or the moment of inertia of a body or a part, or nothing.
std::optional<Problem> checkMass(const Mass& mass);

/// What is wrong with the size or the mass of parts that are to be one body, or nothing.
std::optional<Problem> checkBuild(std::span<const Part> parts, Real lengthUnit);

/// Finds mass, centre and outlines. The parts' `convex` is overwritten.
std::shared_ptr<const Form> makeForm(std::vector<Part> parts);

} // namespace kodo::inline KODO_PRECISION
