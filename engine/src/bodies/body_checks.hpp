// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include "base/checks.hpp"
#include "bodies/part_list.hpp"
#include "math/vec2_checks.hpp"

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

// Checks for definitions and setters. Each message names the given field.
std::optional<Problem> checkPosition(const char* field, Vec2 value, Real lengthUnit = 1);
/// lower <= upper on both axes; infinite corners are permitted.
std::optional<Problem> checkBox(const char* field, const Aabb& box);
/// By its length, as a step does. Also for accelerations, with another unit.
std::optional<Problem> checkVelocity(const char* field, Vec2 value, Real lengthUnit = 1,
                                     const char* unit = "m/s");
std::optional<Problem> checkAngularVelocity(const char* field, Real value);
std::optional<Problem> checkDensity(Real value);
std::optional<Problem> checkTimeStep(Real dt);
std::optional<Problem> check(const MotionRules& rules);
inline std::optional<Problem> checkType(BodyType type) {
    return problemIf(type > BodyType::Static, "type", "must be one of the enumerators of BodyType");
}
inline constexpr const char* kMustBeZeroForStatic =
    "must be zero for a static body: make it Kinematic";
// Flag bits in which the engine stores the type of a body; neither: dynamic.
inline constexpr Flags kTypeStatic = 1u << 25;
inline constexpr Flags kTypeKinematic = 1u << 26;
inline constexpr Flags kTypeBits = kTypeStatic | kTypeKinematic;
inline constexpr Flags kLockBoth = kLockMove | kLockRotate;

constexpr Flags bitsOf(BodyType type) {
    return type == BodyType::Static      ? kTypeStatic
           : type == BodyType::Kinematic ? kTypeKinematic
                                         : Flags{0};
}
constexpr BodyType typeOf(Flags flags) {
    return (flags & kTypeStatic) != 0      ? BodyType::Static
           : (flags & kTypeKinematic) != 0 ? BodyType::Kinematic
                                           : BodyType::Dynamic;
}
/// The motion locks that follow from flags and type.
constexpr Flags locksOf(Flags flags) {
    return (flags & kTypeBits) != 0 ? kLockBoth : flags & kLockBoth;
}

/// Bits that have a meaning, or had one when flags() was read.
inline constexpr Flags kKnownFlags =
    kUserFlags | kLockBoth | kDisabled | kNeverSleep | kSensor | kStatusFlags | kMatchModes;

/// The flags of a body.
std::optional<Problem> checkFlags(const char* field, Flags value);
/// The categories that a mode compares.
std::optional<Problem> checkRequired(const char* field, Flags value);
/// A filter of a part.
std::optional<Problem> checkPartFilter(const CollisionFilter& filter);
/// A filter of a query, a field or of forces on all bodies: without a mode, `required` would
/// accept all.
std::optional<Problem> checkFilter(CollisionFilter which);
/// Checks that a shape or part without mass is on a static or kinematic body.
std::optional<Problem> checkPlaneType(const Shape& shape, Flags flags);
std::optional<Problem> checkPlaneType(const Primitive& part, Flags flags);

} // namespace KODO_PRECISION
} // namespace kodo
