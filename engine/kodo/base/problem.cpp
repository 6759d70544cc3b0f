// SPDX-License-Identifier: MIT
#include <kodo/base/problem.hpp>

#include <cmath>
#include <sstream>

namespace kodo::inline KODO_PRECISION {
namespace {

std::string number(Real value) {
    std::ostringstream text;
    text << value;
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

} // namespace kodo::inline KODO_PRECISION
