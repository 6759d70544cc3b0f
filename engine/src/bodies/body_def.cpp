// SPDX-License-Identifier: MIT
#include <kodo/settings.hpp>

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/body_geometry.hpp"

#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

std::optional<Problem> checkPlaneType(bool needed, Flags flags) {
    return problemIf(needed && locksOf(flags) != kLockBoth, "type",
                     "must be Static or Kinematic: a plane has no mass");
}

std::optional<Problem> checkType(const BodyDef& def) {
    const bool still = def.type == BodyType::Static;
    return firstOf(
        {checkType(def.type),
         problemIf(still && def.velocity != Vec2{}, "velocity", kMustBeZeroForStatic),
         problemIf(still && def.angularVelocity != 0, "angularVelocity", kMustBeZeroForStatic),
         checkPlaneType(def.shape, def.flags | bitsOf(def.type))});
}

/// Match mode and categories of a body or a part.
std::optional<Problem> checkMatch(const char* field, const CollisionFilter& filter) {
    return firstOf(
        {checkRequired(field, filter.required),
         problemIf(filter.required == 0 && (filter.flags & (kMatchAny | kMatchAll)) != 0, field,
                   "must have a category with kMatchAny or kMatchAll, but is 0: the body would "
                   "collide with nothing, as kDisabled says"),
         problemIf(filter.required != 0 && (filter.flags & kMatchModes) == 0, field,
                   "has no effect without a match mode: add kMatchNone, kMatchAny, kMatchAll or "
                   "kMatchEqual to flags")});
}

std::optional<Problem> checkModes(const char* field, Flags value) {
    const Flags mode = value & kMatchModes;
    return problemIf((mode & (mode - 1)) != 0, field,
                     "must have one of kMatchNone, kMatchAny, kMatchAll and kMatchEqual at most");
}

} // namespace

std::optional<Problem> checkPosition(const char* field, Vec2 value, Real lengthUnit) {
    auto problem = checkCoordinates(field, value, kMaxCoordinate * lengthUnit, "m");
    if (problem && isFinite(value)) {
        problem->reason += ": a larger WorldDef::lengthUnit or kodo64 reaches farther";
    }
    return problem;
}

std::optional<Problem> checkVelocity(const char* field, Vec2 value, Real lengthUnit,
                                     const char* unit) {
    return checkLength(field, value, kMaxSpeed * lengthUnit, unit);
}

std::optional<Problem> checkAngularVelocity(const char* field, Real value) {
    return checkRange(field, value, -kMaxSpeed, kMaxSpeed, "rad/s");
}

std::optional<Problem> checkDensity(Real value) {
    auto problem = checkRange("density", value, kMinDensity, kMaxDensity, "kg/m^2");
    if (problem && value == 0) {
        problem->reason += ": BodyType::Static makes a body immovable, at any density";
    }
    return problem;
}

std::optional<Problem> checkTimeStep(Real dt) {
    auto problem = checkRange("dt", dt, kMinTimeStep, kMaxTimeStep, "s");
    if (problem && dt == 0) {
        problem->reason += ": 1/60 divides integers, which gives 0; write 1.0f / 60";
    } else if (problem && dt > kMaxTimeStep) {
        problem->reason += ": it is in seconds; divide a longer time into several steps";
    }
    return problem;
}

std::optional<Problem> check(const MotionRules& rules) {
    return firstOf(
        {checkRange("linearDamping", rules.linearDamping, 0, kMaxDamping, "1/s"),
         checkRange("angularDamping", rules.angularDamping, 0, kMaxDamping, "1/s"),
         checkRange("gravityScale", rules.gravityScale, -kMaxGravityScale, kMaxGravityScale),
         problemIf(rules.continuousMode > ContinuousMode::All, "continuousMode",
                   "must be one of the enumerators of ContinuousMode")});
}

std::optional<Problem> checkFlags(const char* field, Flags value) {
    if ((value & kTypeBits) != 0) {
        return Problem{field, "must not have bits 25 and 26: kNoSensors is of queries and "
                              "kDefaultCategory of `required`. The type of a body is "
                              "BodyDef::type, or set by setType()"};
    }
    if (const Flags unknown = value & ~kKnownFlags; unknown != 0) {
        std::string bits;
        for (unsigned bit = 0; bit < 32; ++bit) {
            if ((unknown >> bit & 1u) != 0) {
                bits += (bits.empty() ? "" : " and ") + std::to_string(bit);
            }
        }
        return Problem{
            field, "must not have bit " + bits +
                       ", which is reserved: categories of the user are bits 0 to 15 and 32 to 63"};
    }
    return checkModes(field, value);
}

std::optional<Problem> checkRequired(const char* field, Flags value) {
    return problemIf((value & ~(kUserFlags | kDefaultCategory)) != 0, field,
                     "must have categories alone: bits 0 to 15 and 32 to 63, and kDefaultCategory");
}

std::optional<Problem> checkPartFilter(const CollisionFilter& filter) {
    return firstOf(
        {problemIf((filter.flags & ~(kUserFlags | kMatchModes | kSensor)) != 0, "filter.flags",
                   "must have categories, a match mode and kSensor alone: locks and "
                   "other flags are those of the body"),
         checkModes("filter.flags", filter.flags), checkMatch("filter.required", filter)});
}

std::optional<Problem> checkFilter(CollisionFilter which) {
    return firstOf(
        {checkModes("which.flags", which.flags),
         problemIf((which.flags & ~(kUserFlags | kMatchModes)) != 0, "which.flags",
                   "must have a match mode alone: a filter does not compare locks, kSensor and "
                   "other flags"),
         checkRequired("which.required", which.required),
         problemIf(which.required != 0 && (which.flags & kMatchModes) == 0, "which.required",
                   "has no effect without a match mode: add kMatchNone, kMatchAny, kMatchAll or "
                   "kMatchEqual to which.flags"),
         problemIf((which.flags & kUserFlags) != 0, "which.flags",
                   "must have a match mode alone: put the categories to find into which.required, "
                   "as {kMatchAny, categories}"),
         problemIf(which.required == 0 && (which.flags & (kMatchAny | kMatchAll)) != 0,
                   "which.required",
                   "must name the categories to find: with kMatchAny or kMatchAll, 0 finds "
                   "nothing")});
}

std::optional<Problem> checkBox(const char* field, const Aabb& box) {
    const Vec2 lower = box.lower;
    const Vec2 upper = box.upper;
    if (lower.x <= upper.x && lower.y <= upper.y) {
        return std::nullopt;
    }
    const bool isNan = lower != lower || upper != upper;
    return Problem{
        field, std::string(isNan ? "must not be NaN" : "must have lower <= upper on both axes") +
                   ", but reaches from " + textOf(lower) + " to " + textOf(upper)};
}

std::optional<Problem> checkPlaneType(const Shape& shape, Flags flags) {
    auto problem = checkPlaneType(needsLock(shape), flags);
    if (problem && std::holds_alternative<Heightmap>(shape)) {
        problem->reason = "must be Static or Kinematic: a heightmap is ground; for a body that "
                          "moves freely, give a Compound of its segments";
    }
    return problem;
}

std::optional<Problem> checkPlaneType(const Primitive& part, Flags flags) {
    return checkPlaneType(needsLock(part), flags);
}

std::optional<Problem> check(const BodyDef& def, Real lengthUnit) {
    if (auto problem = check(def.shape)) {
        problem->field = "shape." + problem->field;
        return problem;
    }
    if (auto problem =
            firstOf({checkType(def), checkFlags("flags", def.flags),
                     checkMatch("required", {def.flags, def.required}),
                     checkPosition("position", def.position, lengthUnit),
                     checkRotation("rotation", def.rotation),
                     checkVelocity("velocity", def.velocity, lengthUnit),
                     checkAngularVelocity("angularVelocity", def.angularVelocity),
                     check(def.material), checkDensity(def.density), check(rulesOf(def))})) {
        return problem;
    }
    const std::vector<Part> parts = partsOf(def);
    if (auto problem = checkParts(parts, lengthUnit)) {
        return problem;
    }
    return def.mass ? checkMassDef(*def.mass, parts, lengthUnit) : std::nullopt;
}

} // namespace KODO_PRECISION
} // namespace kodo
