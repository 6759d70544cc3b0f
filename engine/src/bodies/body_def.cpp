// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/body_geometry.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

std::optional<Problem> checkPlaneType(bool needed, Flags flags) {
    if (needed && locksOf(flags) != kLockBoth) {
        return Problem{"type", "must be Static or Kinematic: a plane or a heightmap has no mass"};
    }
    return std::nullopt;
}

std::optional<Problem> checkType(const BodyDef& def) {
    if (def.type > BodyType::Static) {
        return Problem{"type", "must be one of the enumerators of BodyType"};
    }
    if (def.type == BodyType::Static && (def.velocity != Vec2{} || def.angularVelocity != 0)) {
        return Problem{"velocity", "must be zero for a static body: make it Kinematic"};
    }
    return checkPlaneType(needsLock(def.shape), def.flags | bitsOf(def.type));
}

} // namespace

std::optional<Problem> checkPosition(const char* field, Vec2 value, Real lengthUnit) {
    const Real most = kMaxCoordinate * lengthUnit;
    if (auto problem = checkRange(field, value.x, -most, most)) {
        return problem;
    }
    return checkRange(field, value.y, -most, most);
}

std::optional<Problem> checkVelocity(const char* field, Vec2 value, Real lengthUnit) {
    const Real most = kMaxSpeed * lengthUnit;
    if (auto problem = checkRange(field, value.x, -most, most)) {
        return problem;
    }
    return checkRange(field, value.y, -most, most);
}

std::optional<Problem> checkFlags(const char* field, Flags value) {
    const Flags mode = value & kMatchModes;
    if ((mode & (mode - 1)) != 0) {
        return Problem{field, "must have one of kMatchAny, kMatchAll and kMatchEqual at most"};
    }
    return std::nullopt;
}

std::optional<Problem> checkPlaneType(const Shape& shape, Flags flags) {
    return checkPlaneType(needsLock(shape), flags);
}

std::optional<Problem> checkPlaneType(const Primitive& part, Flags flags) {
    return checkPlaneType(needsLock(part), flags);
}

std::optional<Problem> checkRotation(const char* field, Rot value) {
    return checkUnit(field, value.c, value.s);
}

std::optional<Problem> check(const BodyDef& def, Real lengthUnit) {
    if (auto problem = check(def.shape)) {
        problem->field = "shape." + problem->field;
        return problem;
    }
    if (auto problem = checkType(def)) {
        return problem;
    }
    if (auto problem = checkFlags("flags", def.flags)) {
        return problem;
    }
    if (auto problem = checkPosition("position", def.position, lengthUnit)) {
        return problem;
    }
    if (auto problem = checkRotation("rotation", def.rotation)) {
        return problem;
    }
    if (auto problem = checkVelocity("velocity", def.velocity, lengthUnit)) {
        return problem;
    }
    if (auto problem = checkRange("angularVelocity", def.angularVelocity, -kMaxSpeed, kMaxSpeed)) {
        return problem;
    }
    if (auto problem = check(def.material)) {
        return problem;
    }
    if (auto problem = checkRange("density", def.density, kMinDensity, kMaxDensity)) {
        return problem;
    }
    return checkParts(partsOf(def), lengthUnit);
}

} // namespace KODO_PRECISION
} // namespace kodo
