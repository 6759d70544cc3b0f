// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// The reason why a World refuses a field: a number of one of the engine's own kinds that is not
/// finite, out of range, or has the wrong sign. Other kinds are accepted.
std::optional<Problem> checkField(const ForceField& field, Real lengthUnit);

} // namespace KODO_PRECISION
} // namespace kodo
