// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

#include <memory>

namespace kodo {

/// A field of a user who compiles without RTTI: mass * (0, 1).
std::shared_ptr<const ForceField> fieldWithoutRtti();
/// Gravity of (0, 1), made by the same user.
std::shared_ptr<const ForceField> gravityWithoutRtti();

} // namespace kodo
