// SPDX-License-Identifier: MIT
#include <kodo/bodies/form.hpp>

namespace kodo::inline KODO_PRECISION {
namespace {

std::optional<Problem> checkLock(bool needed, Flags flags) {
    if (needed && (flags & kLocked) != kLocked) {
        return Problem{"flags",
                       "must have kLocked: a plane or a heightmap is only for locked bodies"};
    }
    return std::nullopt;
}

} // namespace

std::optional<Problem> checkPosition(const char* field, Vec2 value, Real lengthUnit) {
    const Real most = kFarthest * lengthUnit;
    if (auto problem = checkRange(field, value.x, -most, most)) {
        return problem;
    }
    return checkRange(field, value.y, -most, most);
}

std::optional<Problem> checkVelocity(const char* field, Vec2 value, Real lengthUnit) {
    const Real most = kHighestSpeed * lengthUnit;
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

std::optional<Problem> checkLock(const Shape& shape, Flags flags) {
    return checkLock(needsLock(shape), flags);
}

std::optional<Problem> checkLock(const Primitive& part, Flags flags) {
    return checkLock(needsLock(part), flags);
}

std::optional<Problem> checkRotation(const char* field, Rot value) {
    return checkUnit(field, value.c, value.s);
}

std::optional<Problem> check(const BodyDef& def, Real lengthUnit) {
    if (auto problem = check(def.shape)) {
        problem->field = "shape." + problem->field;
        return problem;
    }
    if (auto problem = checkLock(def.shape, def.flags)) {
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
    if (auto problem =
            checkRange("angularVelocity", def.angularVelocity, -kHighestSpeed, kHighestSpeed)) {
        return problem;
    }
    if (auto problem = check(def.material)) {
        return problem;
    }
    if (auto problem = checkRange("density", def.density, kLowestDensity, kHighestDensity)) {
        return problem;
    }
    return checkBuild(partsOf(def), lengthUnit);
}

} // namespace kodo::inline KODO_PRECISION
