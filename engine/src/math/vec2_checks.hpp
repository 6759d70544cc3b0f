// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/math.hpp>

#include <optional>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {

// Checks of vectors, as those of numbers in base/checks.hpp.

/// As written in a definition: "{1, 2}".
std::string textOf(Vec2 value);

/// Both coordinates: -most <= value <= most.
std::optional<Problem> checkCoordinates(const char* field, Vec2 value, Real most, const char* unit);
/// Length at most `most`, by the same comparison as isSound().
std::optional<Problem> checkLength(const char* field, Vec2 value, Real most, const char* unit);
std::optional<Problem> checkFinite(const char* field, Vec2 value);
/// Must have length 1 within 5e-4.
std::optional<Problem> checkUnit(const char* field, Vec2 value);
/// The same for {cosine, sine}.
std::optional<Problem> checkRotation(const char* field, Rot value);

} // namespace KODO_PRECISION
} // namespace kodo
