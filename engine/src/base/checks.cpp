// SPDX-License-Identifier: MIT
#include "base/checks.hpp"

#include <kodo/error.hpp>

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// The shortest of 6 or more digits that reads back as the same number: a value just beyond a limit
/// must not print as the limit. Uses a stream, since libc++ 13 has no std::to_chars for floats.
/// Streams of libc++ do not read subnormal numbers, which are printed with all digits.
std::string number(Real value) {
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

} // namespace

Problem outOfRange(const char* field, Real value, Real low, Real high) {
    return {field,
            "must be from " + number(low) + " to " + number(high) + ", but is " + number(value)};
}

std::optional<Problem> checkPositive(const char* field, Real value, Real most) {
    if (!(value > 0 && value <= most)) { // false for NaN
        return Problem{field, "must be greater than 0 and at most " + number(most) + ", but is " +
                                  number(value)};
    }
    return std::nullopt;
}

std::optional<Problem> checkUnit(const char* field, Real x, Real y) {
    const Real squared = x * x + y * y;
    if (!(std::abs(squared - 1) < Real(1e-3))) { // false for NaN
        return Problem{field,
                       "must be a unit vector, but has length " + number(std::sqrt(squared))};
    }
    return std::nullopt;
}

} // namespace KODO_PRECISION
} // namespace kodo
