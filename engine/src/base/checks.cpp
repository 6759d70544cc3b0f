// SPDX-License-Identifier: MIT
#include "base/checks.hpp"

#include <kodo/error.hpp>

#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

std::optional<Problem> firstOf(std::initializer_list<std::optional<Problem>> checks) {
    const auto* const first = std::find_if(checks.begin(), checks.end(),
                                           [](const auto& problem) { return problem.has_value(); });
    return first == checks.end() ? std::nullopt : *first;
}

std::string withPoint(std::string text, const std::string& point) {
    const std::size_t at = text.find(point);
    return at == std::string::npos ? text : text.replace(at, point.size(), ".");
}

/// A value just beyond a limit must not print as the limit. Streams would bring all locales of C++
/// into kodo.wasm, and libc++ 13 has no std::to_chars for floats.
std::string textOf(Real value) {
    if (std::isnan(value)) {
        return "nan"; // for either sign
    }
    const auto back = [](const char* text) {
        return sizeof(Real) == sizeof(float) ? static_cast<Real>(std::strtof(text, nullptr))
                                             : static_cast<Real>(std::strtod(text, nullptr));
    };
    std::array<char, 32> text{};
    for (int digits = 6; digits <= std::numeric_limits<Real>::max_digits10; ++digits) {
        std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(value));
        if (back(text.data()) == value) {
            break;
        }
    }
    return withPoint(text.data(), std::localeconv()->decimal_point);
}

std::string textOf(Real value, const char* unit) {
    return *unit == 0 ? textOf(value) : textOf(value) + " " + unit;
}

Problem outOfRange(const char* field, Real value, Real low, Real high, const char* unit) {
    return {field, "must be from " + textOf(low) + " to " + textOf(high, unit) + ", but is " +
                       textOf(value)};
}

std::optional<Problem> checkPositive(const char* field, Real value, Real most, const char* unit) {
    if (!(value > 0)) { // also for NaN
        return Problem{field,
                       "must be greater than " + textOf(0, unit) + ", but is " + textOf(value)};
    }
    if (value > most) {
        return Problem{field,
                       "must be at most " + textOf(most, unit) + ", but is " + textOf(value)};
    }
    return std::nullopt;
}

std::optional<Problem> checkNotNegative(const char* field, Real value, const char* unit) {
    if (!(value >= 0) || std::isinf(value)) { // also for NaN
        return Problem{field, "must be finite and at least " + textOf(0, unit) + ", but is " +
                                  textOf(value)};
    }
    return std::nullopt;
}

std::optional<Problem> checkFinite(const char* field, Real value) {
    return std::isfinite(value)
               ? std::nullopt
               : std::optional(Problem{field, "must be finite, but is " + textOf(value)});
}

} // namespace KODO_PRECISION
} // namespace kodo
