// SPDX-License-Identifier: MIT
#include "math/vec2_checks.hpp"

#include "base/checks.hpp"

#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {

std::string textOf(Vec2 value) {
    return std::string("{") + textOf(value.x) + ", " + textOf(value.y) + "}";
}

std::optional<Problem> checkCoordinates(const char* field, Vec2 value, Real most,
                                        const char* unit) {
    for (const bool isX : {true, false}) {
        if (auto problem = checkRange(field, isX ? value.x : value.y, -most, most, unit)) {
            problem->reason = (isX ? "x " : "y ") + problem->reason;
            return problem;
        }
    }
    return std::nullopt;
}

std::optional<Problem> checkLength(const char* field, Vec2 value, Real most, const char* unit) {
    if (!isFinite(value)) {
        return checkFinite(field, value);
    }
    if (!(lengthSquared(value) <= most * most)) {
        return Problem{field, "must be at most " + textOf(most, unit) + " long, but is " +
                                  textOf(value) + ", of length " +
                                  textOf(most * length(value / most))};
    }
    return std::nullopt;
}

std::optional<Problem> checkFinite(const char* field, Vec2 value) {
    return isFinite(value)
               ? std::nullopt
               : std::optional(Problem{field, "must be finite, but is " + textOf(value)});
}

std::optional<Problem> checkUnit(const char* field, Vec2 value) {
    const Real squared = lengthSquared(value);
    if (!(std::abs(squared - 1) < Real(1e-3))) { // false for NaN
        return Problem{field, "must be a unit vector, but is " + textOf(value) + ", of length " +
                                  textOf(std::sqrt(squared)) + ": use normalize()"};
    }
    return std::nullopt;
}

std::optional<Problem> checkRotation(const char* field, Rot value) {
    const Vec2 axis = value.xAxis();
    auto problem = checkUnit(field, axis);
    if (problem) {
        problem->reason = "must be the {cosine, sine} of an angle, but is " + textOf(axis) +
                          ": use Rot::fromAngle(radians); 90 degrees are 1.5708 radians";
    }
    return problem;
}

} // namespace KODO_PRECISION
} // namespace kodo
