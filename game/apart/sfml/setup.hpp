// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/options.hpp>
#include <apart/stage/stage.hpp>

#include <string>
#include <variant>

namespace apart {

/// The stage that the options ask for, or a sentence why there is none.
std::variant<StageDef, std::string> setUp(const Options& options);

} // namespace apart
