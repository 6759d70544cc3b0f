// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <optional>
#include <stdexcept>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {

/// Why a value is refused: the field, and a reason as a sentence.
struct Problem {
    std::string field;  // as written in the definition, for example "shape.radius"
    std::string reason; // for example "must be greater than 0, but is -1"

    std::string text() const { return field + ": " + reason; }
};

/// A definition, a setter or a step was given a value that it cannot use. Nothing has changed.
class KODO_API BadDefinition : public std::invalid_argument {
public:
    explicit BadDefinition(Problem problem);
    ~BadDefinition() override;

    const Problem& problem() const { return problem_; }

private:
    Problem problem_;
};

/// An id that names no body of this World: the body was removed, was never added, or belongs to
/// another World. Nothing has changed.
class KODO_API BadBodyId : public std::out_of_range {
public:
    using std::out_of_range::out_of_range;
    ~BadBodyId() override;
};

/// Bytes that are no snapshot of a World, or that this build cannot continue from.
class KODO_API BadSnapshot : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~BadSnapshot() override;
};

} // namespace KODO_PRECISION
} // namespace kodo
