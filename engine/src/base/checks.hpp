// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>

#include <initializer_list>
#include <optional>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {

/// Throws BadDefinition if there is a problem.
inline void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw BadDefinition(*problem);
    }
}

/// The first problem of several checks. All of them are made, so none may need an earlier one.
std::optional<Problem> firstOf(std::initializer_list<std::optional<Problem>> checks);

/// A problem of a field under a condition.
inline std::optional<Problem> problemIf(bool bad, const char* field, const char* reason) {
    return bad ? std::optional(Problem{field, reason}) : std::nullopt;
}

/// A number as the C library prints it in a locale with the given decimal point, with ".".
std::string withPoint(std::string text, const std::string& point);
/// The shortest of 6 or more digits that reads back as the same number, with "." in any locale.
std::string textOf(Real value);
/// "2 m"; "2" for a number without a unit.
std::string textOf(Real value, const char* unit);

// Checks shared by fields of all kinds. Each message names the given field, and the unit if there
// is one.
Problem outOfRange(const char* field, Real value, Real low, Real high, const char* unit = "");
inline std::optional<Problem> checkRange(const char* field, Real value, Real low, Real high,
                                         const char* unit = "") {
    const bool inside = value >= low && value <= high; // false for NaN
    return inside ? std::nullopt : std::optional(outOfRange(field, value, low, high, unit));
}
/// Range: 0 < value <= most.
std::optional<Problem> checkPositive(const char* field, Real value, Real most,
                                     const char* unit = "");
/// Range: 0 <= value < infinity.
std::optional<Problem> checkNotNegative(const char* field, Real value, const char* unit);
std::optional<Problem> checkFinite(const char* field, Real value);

} // namespace KODO_PRECISION
} // namespace kodo
