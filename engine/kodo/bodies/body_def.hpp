// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/flags.hpp>
#include <kodo/bodies/material.hpp>
#include <kodo/shapes/shape.hpp>

#include <compare>
#include <cstdint>
#include <optional>

namespace kodo::inline KODO_PRECISION {

/// Names a body in its World. The generation tells a reused slot from the body it once held.
struct BodyId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0; // 0 is never alive, so BodyId{} is the null id
    friend constexpr auto operator<=>(BodyId, BodyId) = default;
};

/// Everything a body starts with. `World::add` copies it.
struct BodyDef {
    Shape shape = Circle{Real(0.5)};
    Vec2 position{};          // m, world: where the origin of the shape's frame goes
    Rot rotation{};           // of the shape's frame
    Vec2 velocity{};          // m/s, of the centre of mass
    Real angularVelocity = 0; // rad/s, counter-clockwise
    Material material{};      // of all parts
    Real density = 1;         // kg/m^2
    Flags flags = 0;          // kLocked for what must not be pushed; user flags in the low 16 bits
    std::uint16_t required = 0; // see CollisionFilter
    std::uint64_t userData = 0; // never read by the engine
};

/// No body may lie farther than this from the origin, or be larger (m, times the length unit of the
/// World): beyond it a Real resolves less than 1 % of the unit.
inline constexpr Real kFarthest = sizeof(Real) == 4 ? Real(1e5) : Real(1e13);
inline constexpr Real kHighestSpeed = Real(1e7);   // m/s, times the length unit; or rad/s
inline constexpr Real kLowestDensity = Real(1e-9); // kg/m^2
inline constexpr Real kHighestDensity = Real(1e9); // kg/m^2
/// The mass (kg) of a body and of each of its parts lies between 1 / kHeaviest and kHeaviest, its
/// moment of inertia (kg m^2) between the squares of these, so that no product of two overflows.
inline constexpr Real kHeaviest = sizeof(Real) == 4 ? Real(1e18) : Real(1e100);

/// What World::add would refuse the definition for, in a World of that length unit, or nothing.
std::optional<Problem> check(const BodyDef& def, Real lengthUnit = 1);

// The checks behind it, for the setters. Each names the field it was given.
std::optional<Problem> checkPosition(const char* field, Vec2 value, Real lengthUnit = 1);
std::optional<Problem> checkRotation(const char* field, Rot value);
std::optional<Problem> checkVelocity(const char* field, Vec2 value, Real lengthUnit = 1);
std::optional<Problem> checkFlags(const char* field, Flags value);
/// Of a body with something in it that may need to be locked.
std::optional<Problem> checkLock(const Shape& shape, Flags flags);
std::optional<Problem> checkLock(const Primitive& part, Flags flags);

} // namespace kodo::inline KODO_PRECISION
