// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <optional>
#include <stdexcept>
#include <string>

namespace kodo::inline KODO_PRECISION {

/// What is wrong with a value that a user gave: which field, and why, as a sentence.
struct Problem {
    std::string field;  // as written in the definition, for example "shape.radius"
    std::string reason; // for example "must be greater than 0, but is -1"

    std::string text() const { return field + ": " + reason; }
};

/// A definition, a setter or a step was given a value it cannot use. Nothing has changed.
class BadDefinition : public std::invalid_argument {
public:
    explicit BadDefinition(Problem problem)
        : std::invalid_argument(problem.text()), problem_(std::move(problem)) {}

    const Problem& problem() const { return problem_; }

private:
    Problem problem_;
};

/// Throws BadDefinition if there is a problem.
inline void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw BadDefinition(*problem);
    }
}

// The checks that fields of all kinds share. Each names the field that it was given.
Problem outOfRange(const char* field, Real value, Real low, Real high);
inline std::optional<Problem> checkRange(const char* field, Real value, Real low, Real high) {
    const bool inside = value >= low && value <= high; // false for NaN
    return inside ? std::nullopt : std::optional(outOfRange(field, value, low, high));
}
/// Greater than 0, and at most that.
std::optional<Problem> checkPositive(const char* field, Real value, Real most);
/// x and y of a vector of length 1, to half of a thousandth.
std::optional<Problem> checkUnit(const char* field, Real x, Real y);

/// A body id that names no body of this World: never given out, or its body was removed.
class BadBodyId : public std::out_of_range {
public:
    using std::out_of_range::out_of_range;
};

/// Bytes that are no snapshot of a World, or none that this build can go on from. The sentence says
/// why.
class BadSnapshot : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace kodo::inline KODO_PRECISION
