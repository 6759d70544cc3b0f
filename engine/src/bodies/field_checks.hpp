// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

#include "base/state_stream.hpp"

#include <memory>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// The reason why a World refuses a field: a number of one of the engine's own kinds that is not
/// finite, out of range, or has the wrong sign. Other kinds are accepted.
std::optional<Problem> checkField(const ForceField& field, Real lengthUnit);

/// User-defined fields, which bytes do not hold, in the order of their entries.
using OwnFields = std::span<const std::shared_ptr<const ForceField>>;
/// Lists an entry with the numbers of its field. Reading takes a user-defined one off `ownFields`.
void visitState(StateStream& stream, FieldEntry& entry, OwnFields& ownFields);

} // namespace KODO_PRECISION
} // namespace kodo
