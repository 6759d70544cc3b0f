// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Throws BadDefinition if there is a problem.
inline void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw BadDefinition(*problem);
    }
}

// Checks shared by fields of all kinds. Each message names the given field.
Problem outOfRange(const char* field, Real value, Real low, Real high);
inline std::optional<Problem> checkRange(const char* field, Real value, Real low, Real high) {
    const bool inside = value >= low && value <= high; // false for NaN
    return inside ? std::nullopt : std::optional(outOfRange(field, value, low, high));
}
/// Range: 0 < value <= most.
std::optional<Problem> checkPositive(const char* field, Real value, Real most);
/// (x, y) must have length 1 within 5e-4.
std::optional<Problem> checkUnit(const char* field, Real x, Real y);

} // namespace KODO_PRECISION
} // namespace kodo
