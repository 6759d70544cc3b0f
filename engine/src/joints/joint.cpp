// SPDX-License-Identifier: MIT
#include <kodo/joint.hpp>

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A joint may be described before its bodies exist, but not added.
std::optional<Problem> checkSet(const char* field, BodyId body) {
    if (body.generation == 0) {
        return Problem{field, "is not set: give the id that World::add() returned for the body"};
    }
    return std::nullopt;
}

std::optional<Problem> checkBreak(const char* field, Real value, const char* unit) {
    if (!(value > 0)) { // also for NaN
        return Problem{field, std::string("must be greater than 0 ") + unit + ", but is " +
                                  textOf(value) + ": the default, kUnbreakable, never breaks"};
    }
    return std::nullopt;
}

std::optional<Problem> checkEnds(const JointEnds& ends, Real unit) {
    if (auto problem = checkSet("ends.a", ends.a)) {
        return problem;
    }
    if (auto problem = checkSet("ends.b", ends.b)) {
        return problem;
    }
    if (ends.a == ends.b) {
        return Problem{"ends", "must be two different bodies"};
    }
    if (auto problem = checkPosition("ends.anchorA", ends.anchorA, unit)) {
        return problem;
    }
    if (auto problem = checkPosition("ends.anchorB", ends.anchorB, unit)) {
        return problem;
    }
    if (auto problem = checkBreak("ends.breakForce", ends.breakForce, "N")) {
        return problem;
    }
    return checkBreak("ends.breakTorque", ends.breakTorque, "N m");
}

std::optional<Problem> checkLimits(const std::optional<Range>& limits, Real low, Real high,
                                   const char* unit) {
    if (!limits) {
        return std::nullopt;
    }
    if (auto problem = checkRange("limits.lower", limits->lower, low, high, unit)) {
        return problem;
    }
    if (limits->upper < limits->lower) {
        return Problem{"limits.upper", "must be at least limits.lower, which is " +
                                           textOf(limits->lower) + " " + unit + ", but is " +
                                           textOf(limits->upper)};
    }
    return checkRange("limits.upper", limits->upper, low, high, unit);
}

/// A value and its range, for checkFields.
struct Field {
    const char* name;
    Real value;
    Real low;
    Real high;
    const char* unit;
};

std::optional<Problem> checkFields(std::initializer_list<Field> fields) {
    for (const Field& field : fields) {
        auto problem = std::isinf(field.high)
                           ? checkNotNegative(field.name, field.value, field.unit)
                           : checkRange(field.name, field.value, field.low, field.high, field.unit);
        if (problem) {
            return problem;
        }
    }
    return std::nullopt;
}

constexpr Real kAngle = Real(1e4);
constexpr Real kNoLimit = std::numeric_limits<Real>::infinity(); // the value itself is finite

std::optional<Problem> checkReference(Real reference) {
    return checkRange("reference", reference, -kAngle, kAngle, "rad");
}

/// Stiffness 0 means no spring.
template <typename Joint>
std::optional<Problem> checkSpring(const Joint& joint) {
    return checkFields(
        {{"hertz", joint.hertz, 0, Real(1e4), "Hz"}, {"damping", joint.damping, 0, Real(1e4), ""}});
}

std::optional<Problem> checkKind(const RevoluteJoint& joint, Real) {
    if (auto problem = checkReference(joint.reference)) {
        return problem;
    }
    if (auto problem =
            checkFields({{"motorSpeed", joint.motorSpeed, -kMaxSpeed, kMaxSpeed, "rad/s"},
                         {"motorTorque", joint.motorTorque, 0, kNoLimit, "N m"}})) {
        return problem;
    }
    if (auto problem = checkSpring(joint)) {
        return problem;
    }
    if (auto problem = checkRange("target", joint.target, -kAngle, kAngle, "rad")) {
        return problem;
    }
    return checkLimits(joint.limits, -kAngle, kAngle, "rad");
}

std::optional<Problem> checkKind(const FixedJoint& joint, Real) {
    auto problem = checkReference(joint.reference);
    return problem ? problem : checkSpring(joint);
}

std::optional<Problem> checkKind(const DistanceJoint& joint, Real unit) {
    const Real speed = kMaxSpeed * unit;
    if (auto problem = checkFields({{"length", joint.length, 0, kMaxCoordinate * unit, "m"},
                                    {"hertz", joint.hertz, 0, Real(1e4), "Hz"},
                                    {"damping", joint.damping, 0, Real(1e4), ""},
                                    {"motorSpeed", joint.motorSpeed, -speed, speed, "m/s"},
                                    {"motorForce", joint.motorForce, 0, kNoLimit, "N"}})) {
        return problem;
    }
    if (joint.hertz == 0 && !joint.limits && joint.motorForce == 0) {
        return Problem{"hertz", "is 0 and there are no limits, so the joint would do nothing: set "
                                "hertz for a spring, equal limits for a rod, limits from 0 to "
                                "the length of a rope, or motorForce for a winch"};
    }
    return checkLimits(joint.limits, 0, kMaxCoordinate * unit, "m");
}

std::optional<Problem> checkKind(const PrismaticJoint& joint, Real unit) {
    if (auto problem = checkUnit("axis", joint.axis)) {
        return problem;
    }
    if (auto problem = checkReference(joint.reference)) {
        return problem;
    }
    const Real speed = kMaxSpeed * unit;
    if (auto problem = checkFields({{"motorSpeed", joint.motorSpeed, -speed, speed, "m/s"},
                                    {"motorForce", joint.motorForce, 0, kNoLimit, "N"}})) {
        return problem;
    }
    if (auto problem = checkSpring(joint)) {
        return problem;
    }
    const Real most = kMaxCoordinate * unit;
    if (auto problem = checkRange("target", joint.target, -most, most, "m")) {
        return problem;
    }
    return checkLimits(joint.limits, -most, most, "m");
}

std::optional<Problem> checkKind(const WheelJoint& joint, Real unit) {
    if (auto problem = checkUnit("axis", joint.axis)) {
        return problem;
    }
    if (auto problem =
            checkFields({{"motorSpeed", joint.motorSpeed, -kMaxSpeed, kMaxSpeed, "rad/s"},
                         {"motorTorque", joint.motorTorque, 0, kNoLimit, "N m"}})) {
        return problem;
    }
    if (auto problem = checkSpring(joint)) {
        return problem;
    }
    return checkLimits(joint.limits, -kMaxCoordinate * unit, kMaxCoordinate * unit, "m");
}

std::optional<Problem> checkKind(const PulleyJoint& joint, Real unit) {
    if (auto problem = checkPosition("groundA", joint.groundA, unit)) {
        return problem;
    }
    if (auto problem = checkPosition("groundB", joint.groundB, unit)) {
        return problem;
    }
    return checkFields({{"length", joint.length, 0, kMaxCoordinate * unit, "m"},
                        {"ratio", joint.ratio, Real(1e-3), Real(1e3), ""}});
}

std::optional<Problem> checkKind(const GearJoint& joint, Real) {
    if (joint.ratio == 0) {
        return Problem{"ratio", "is 0, so the gear would not turn: give the speed of b per speed "
                                "of a, below 0 for teeth and above 0 for a belt"};
    }
    constexpr Real kMost = 1000; // beyond its inverse, rounding turns the gear as much as b does
    if (std::abs(joint.ratio) < 1 / kMost) {
        return Problem{"ratio", "must have a size of 0.001 to 1000, but is " + textOf(joint.ratio) +
                                    ": swap a and b for its inverse"};
    }
    if (auto problem = checkRange("ratio", joint.ratio, -kMost, kMost, "")) {
        return problem;
    }
    return joint.rack ? checkUnit("rack", *joint.rack) : std::nullopt;
}

std::optional<Problem> checkKind(const FilterJoint& joint, Real) {
    if (joint.ends.collide) {
        return Problem{"ends.collide", "is true, so the joint would do nothing"};
    }
    const bool breaks = !std::isinf(joint.ends.breakForce);
    if (breaks || !std::isinf(joint.ends.breakTorque)) {
        return Problem{breaks ? "ends.breakForce" : "ends.breakTorque",
                       "must be kUnbreakable: a FilterJoint has no load that could break it"};
    }
    return std::nullopt;
}

std::optional<Problem> checkKind(const MotorJoint& joint, Real) {
    if (auto problem = checkReference(joint.reference)) {
        return problem;
    }
    if (auto problem =
            checkFields({{"force", joint.force, 0, kNoLimit, "N"},
                         {"torque", joint.torque, 0, kNoLimit, "N m"},
                         {"hertz", joint.hertz, joint.hertz == 0 ? 0 : Real(1e-3), Real(1e4), "Hz"},
                         {"damping", joint.damping, 0, Real(1e4), ""}})) {
        return problem;
    }
    if (joint.force == 0 && joint.torque == 0) {
        return Problem{"force", "and torque are 0, so the joint would do nothing: set the largest "
                                "force, the largest torque, or both"};
    }
    return std::nullopt;
}

std::optional<Problem> checkMouse(const MouseJoint& mouse, Real unit) {
    if (auto problem = checkSet("body", mouse.body)) {
        return problem;
    }
    if (auto problem = checkPosition("anchor", mouse.anchor, unit)) {
        return problem;
    }
    if (auto problem = checkPosition("target", mouse.target, unit)) {
        return problem;
    }
    if (auto problem = checkFields({{"force", mouse.force, 0, kNoLimit, "N"},
                                    {"hertz", mouse.hertz, Real(1e-3), Real(1e4), "Hz"},
                                    {"damping", mouse.damping, 0, Real(1e4), ""}})) {
        return problem;
    }
    if (mouse.force == 0) {
        return Problem{"force", "is 0, so the joint would do nothing: set the largest force"};
    }
    return std::nullopt;
}

} // namespace

std::optional<Problem> check(const JointDef& def, Real lengthUnit) {
    if (const auto* mouse = std::get_if<MouseJoint>(&def)) {
        return checkMouse(*mouse, lengthUnit);
    }
    return std::visit(
        [=](const auto& kind) -> std::optional<Problem> {
            if constexpr (requires { kind.ends; }) {
                const auto problem = checkEnds(kind.ends, lengthUnit);
                return problem ? problem : checkKind(kind, lengthUnit);
            } else {
                return std::nullopt;
            }
        },
        def);
}

BodyId firstBody(const JointDef& def) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.ends; }) {
                return kind.ends.a;
            } else {
                return kind.body;
            }
        },
        def);
}

BodyId secondBody(const JointDef& def) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.ends; }) {
                return kind.ends.b;
            } else {
                return kind.body;
            }
        },
        def);
}

} // namespace KODO_PRECISION
} // namespace kodo
