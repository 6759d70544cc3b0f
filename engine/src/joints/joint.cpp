// SPDX-License-Identifier: MIT
#include <kodo/joint.hpp>

#include "base/checks.hpp"
#include "joints/anchor.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kMost = std::numeric_limits<Real>::max();

std::optional<Problem> checkEnds(const JointEnds& ends, Real unit) {
    if (ends.a == ends.b) {
        return Problem{"ends", "must be two different bodies"};
    }
    if (auto problem = checkPosition("ends.anchorA", ends.anchorA, unit)) {
        return problem;
    }
    if (auto problem = checkPosition("ends.anchorB", ends.anchorB, unit)) {
        return problem;
    }
    if (!(ends.breakForce > 0)) {
        return Problem{"ends.breakForce", "must be greater than 0"};
    }
    if (!(ends.breakTorque > 0)) {
        return Problem{"ends.breakTorque", "must be greater than 0"};
    }
    return std::nullopt;
}

std::optional<Problem> checkLimits(const std::optional<Range>& limits, Real low, Real high) {
    if (!limits) {
        return std::nullopt;
    }
    if (auto problem = checkRange("limits.lower", limits->lower, low, high)) {
        return problem;
    }
    return checkRange("limits.upper", limits->upper, limits->lower, high);
}

/// A value and its range, for checkFields.
struct Field {
    const char* name;
    Real value;
    Real low;
    Real high;
};

std::optional<Problem> checkFields(std::initializer_list<Field> fields) {
    for (const Field& field : fields) {
        if (auto problem = checkRange(field.name, field.value, field.low, field.high)) {
            return problem;
        }
    }
    return std::nullopt;
}

constexpr Real kAngle = Real(1e4);

std::optional<Problem> checkKind(const RevoluteJoint& pin, Real) {
    if (auto problem = checkFields({{"reference", pin.reference, -kAngle, kAngle},
                                    {"motorSpeed", pin.motorSpeed, -kMaxSpeed, kMaxSpeed},
                                    {"motorTorque", pin.motorTorque, 0, kMost}})) {
        return problem;
    }
    return checkLimits(pin.limits, -3, 3);
}

std::optional<Problem> checkKind(const FixedJoint& weld, Real) {
    return checkRange("reference", weld.reference, -kAngle, kAngle);
}

std::optional<Problem> checkKind(const DistanceJoint& spring, Real unit) {
    if (auto problem = checkFields({{"length", spring.length, 0, kMaxCoordinate * unit},
                                    {"hertz", spring.hertz, 0, Real(1e4)},
                                    {"damping", spring.damping, 0, Real(1e4)}})) {
        return problem;
    }
    return checkLimits(spring.limits, 0, kMaxCoordinate * unit);
}

std::optional<Problem> checkKind(const PrismaticJoint& slider, Real unit) {
    if (auto problem = checkUnit("axis", slider.axis.x, slider.axis.y)) {
        return problem;
    }
    if (auto problem =
            checkFields({{"reference", slider.reference, -kAngle, kAngle},
                         {"motorSpeed", slider.motorSpeed, -kMaxSpeed * unit, kMaxSpeed * unit},
                         {"motorForce", slider.motorForce, 0, kMost}})) {
        return problem;
    }
    return checkLimits(slider.limits, -kMaxCoordinate * unit, kMaxCoordinate * unit);
}

std::optional<Problem> checkKind(const MotorJoint& motor, Real) {
    return checkFields({{"reference", motor.reference, -kAngle, kAngle},
                        {"force", motor.force, 0, kMost},
                        {"torque", motor.torque, 0, kMost},
                        {"hertz", motor.hertz, Real(1e-3), Real(1e4)},
                        {"damping", motor.damping, 0, Real(1e4)}});
}

} // namespace

std::optional<Problem> check(const JointDef& def, Real lengthUnit) {
    if (const auto* mouse = std::get_if<MouseJoint>(&def)) {
        if (auto problem = checkPosition("anchor", mouse->anchor, lengthUnit)) {
            return problem;
        }
        if (auto problem = checkPosition("target", mouse->target, lengthUnit)) {
            return problem;
        }
        return checkFields({{"force", mouse->force, 0, kMost},
                            {"hertz", mouse->hertz, Real(1e-3), Real(1e4)},
                            {"damping", mouse->damping, 0, Real(1e4)}});
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
