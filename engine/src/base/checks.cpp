// SPDX-License-Identifier: MIT
#include "base/checks.hpp"

#include <kodo/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace kodo {
inline namespace KODO_PRECISION {

std::optional<Problem> firstOf(std::initializer_list<std::optional<Problem>> checks) {
    const auto* const first = std::find_if(checks.begin(), checks.end(),
                                           [](const auto& problem) { return problem.has_value(); });
    return first == checks.end() ? std::nullopt : *first;
}

/// A value just beyond a limit must not print as the limit. Uses a stream, since libc++ 13 has no
/// std::to_chars for floats. Streams of libc++ do not read subnormal numbers, which are printed
/// with all digits.
std::string textOf(Real value) {
    if (std::isnan(value)) {
        return "nan"; // for either sign
    }
    std::stringstream text;
    text.imbue(std::locale::classic()); // decimal point in any locale
    Real back = 0;
    for (int digits = 6; digits <= std::numeric_limits<Real>::max_digits10; ++digits) {
        text.str("");
        text.clear();
        text.precision(digits);
        text << value;
        if (std::isinf(value) || (text >> back && back == value)) {
            break;
        }
    }
    return text.str();
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
