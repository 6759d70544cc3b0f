// SPDX-License-Identifier: MIT
#include <kodo/joint.hpp>

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "joints/anchor.hpp"

#include <cmath>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A joint may be described before its bodies exist, but not added.
std::optional<Problem> checkSet(const char* field, BodyId body) {
    return problemIf(body.generation == 0, field,
                     "is not set: give the id that World::add() returned for the body");
}

std::optional<Problem> checkBreak(const char* field, Real value, const char* unit) {
    if (!(value > 0)) { // also for NaN
        return Problem{field, std::string("must be greater than 0 ") + unit + ", but is " +
                                  textOf(value) + ": the default, kUnbreakable, never breaks"};
    }
    return std::nullopt;
}

std::optional<Problem> checkEnds(const JointEnds& ends, Real unit) {
    return firstOf({checkSet("ends.a", ends.a), checkSet("ends.b", ends.b),
                    problemIf(ends.a == ends.b, "ends", "must be two different bodies"),
                    checkPosition("ends.anchorA", ends.anchorA, unit),
                    checkPosition("ends.anchorB", ends.anchorB, unit),
                    checkBreak("ends.breakForce", ends.breakForce, "N"),
                    checkBreak("ends.breakTorque", ends.breakTorque, "N m")});
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

constexpr Real kAngle = Real(1e4);

std::optional<Problem> checkReference(Real reference) {
    return checkRange("reference", reference, -kAngle, kAngle, "rad");
}

/// Stiffness 0 means no spring.
template <typename Joint>
std::optional<Problem> checkSpring(const Joint& joint) {
    return firstOf({checkRange("hertz", joint.hertz, 0, Real(1e4), "Hz"),
                    checkRange("damping", joint.damping, 0, Real(1e4))});
}

/// A motor that turns: rad/s and N m.
template <typename Joint>
std::optional<Problem> checkRotaryMotor(const Joint& joint) {
    return firstOf({checkAngularVelocity("motorSpeed", joint.motorSpeed),
                    checkNotNegative("motorTorque", joint.motorTorque, "N m")});
}

/// A motor along a line: m/s and N.
template <typename Joint>
std::optional<Problem> checkLinearMotor(const Joint& joint, Real unit) {
    const Real speed = kMaxSpeed * unit;
    return firstOf({checkRange("motorSpeed", joint.motorSpeed, -speed, speed, "m/s"),
                    checkNotNegative("motorForce", joint.motorForce, "N")});
}

std::optional<Problem> checkKind(const RevoluteJoint& joint, Real) {
    const Real tooth = std::abs(joint.ratchet);
    return firstOf(
        {problemIf(tooth != 0 && !(joint.limits && tooth >= Real(1e-6) && tooth <= kAngle),
                   "ratchet",
                   "needs limits, one of which follows the angle, and teeth of 1e-6 to "
                   "1e4 rad"),
         checkReference(joint.reference), checkRotaryMotor(joint), checkSpring(joint),
         checkRange("target", joint.target, -kAngle, kAngle, "rad"),
         checkLimits(joint.limits, -kAngle, kAngle, "rad")});
}

std::optional<Problem> checkKind(const FixedJoint& joint, Real) {
    return firstOf({checkReference(joint.reference), checkSpring(joint)});
}

std::optional<Problem> checkKind(const DistanceJoint& joint, Real unit) {
    const Real most = kMaxCoordinate * unit;
    return firstOf(
        {checkRange("length", joint.length, 0, most, "m"), checkSpring(joint),
         checkLinearMotor(joint, unit),
         problemIf(joint.hertz == 0 && !joint.limits && joint.motorForce == 0, "hertz",
                   "is 0 and there are no limits, so the joint would do nothing: set hertz for a "
                   "spring, equal limits for a rod, limits from 0 to the length of a rope, or "
                   "motorForce for a winch"),
         checkLimits(joint.limits, 0, most, "m")});
}

std::optional<Problem> checkKind(const PrismaticJoint& joint, Real unit) {
    const Real most = kMaxCoordinate * unit;
    return firstOf({checkUnit("axis", joint.axis), checkReference(joint.reference),
                    checkLinearMotor(joint, unit), checkSpring(joint),
                    checkRange("target", joint.target, -most, most, "m"),
                    checkLimits(joint.limits, -most, most, "m")});
}

std::optional<Problem> checkKind(const WheelJoint& joint, Real unit) {
    const Real most = kMaxCoordinate * unit;
    return firstOf({checkUnit("axis", joint.axis), checkRotaryMotor(joint), checkSpring(joint),
                    checkLimits(joint.limits, -most, most, "m")});
}

std::optional<Problem> checkKind(const PulleyJoint& joint, Real unit) {
    return firstOf({checkPosition("groundA", joint.groundA, unit),
                    checkPosition("groundB", joint.groundB, unit),
                    checkRange("length", joint.length, 0, kMaxCoordinate * unit, "m"),
                    checkRange("ratio", joint.ratio, Real(1e-3), Real(1e3))});
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
    return firstOf({checkRange("ratio", joint.ratio, -kMost, kMost),
                    joint.rack ? checkUnit("rack", *joint.rack) : std::nullopt});
}

std::optional<Problem> checkKind(const FilterJoint& joint, Real) {
    const char* const unbreakable =
        "must be kUnbreakable: a FilterJoint has no load that could break it";
    return firstOf(
        {problemIf(joint.ends.collide, "ends.collide", "is true, so the joint would do nothing"),
         problemIf(!std::isinf(joint.ends.breakForce), "ends.breakForce", unbreakable),
         problemIf(!std::isinf(joint.ends.breakTorque), "ends.breakTorque", unbreakable)});
}

std::optional<Problem> checkKind(const MotorJoint& joint, Real) {
    const Real softest = joint.hertz == 0 ? 0 : Real(1e-3);
    return firstOf({checkReference(joint.reference), checkNotNegative("force", joint.force, "N"),
                    checkNotNegative("torque", joint.torque, "N m"),
                    checkRange("hertz", joint.hertz, softest, Real(1e4), "Hz"),
                    checkRange("damping", joint.damping, 0, Real(1e4)),
                    problemIf(joint.force == 0 && joint.torque == 0, "force",
                              "and torque are 0, so the joint would do nothing: set the largest "
                              "force, the largest torque, or both")});
}

std::optional<Problem> checkKind(const MouseJoint& mouse, Real unit) {
    return firstOf({checkSet("body", mouse.body), checkPosition("anchor", mouse.anchor, unit),
                    checkPosition("target", mouse.target, unit),
                    checkNotNegative("force", mouse.force, "N"),
                    checkRange("hertz", mouse.hertz, Real(1e-3), Real(1e4), "Hz"),
                    checkRange("damping", mouse.damping, 0, Real(1e4)),
                    problemIf(mouse.force == 0, "force",
                              "is 0, so the joint would do nothing: set the largest force")});
}

} // namespace

std::optional<Problem> check(const JointDef& def, Real lengthUnit) {
    const JointEnds* const ends = endsOf(def);
    if (auto problem = ends != nullptr ? checkEnds(*ends, lengthUnit) : std::nullopt) {
        return problem;
    }
    return std::visit([=](const auto& kind) { return checkKind(kind, lengthUnit); }, def);
}

BodyId firstBody(const JointDef& def) {
    const JointEnds* const ends = endsOf(def);
    return ends != nullptr ? ends->a : std::get<MouseJoint>(def).body;
}

BodyId secondBody(const JointDef& def) {
    const JointEnds* const ends = endsOf(def);
    return ends != nullptr ? ends->b : std::get<MouseJoint>(def).body;
}

} // namespace KODO_PRECISION
} // namespace kodo
