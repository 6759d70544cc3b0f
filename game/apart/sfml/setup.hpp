// SPDX-License-Identifier: MIT
#pragma once

#include <apart/sfml/options.hpp>
#include <apart/stage/stage.hpp>

#include <string>
#include <variant>

namespace apart {

/// The stage for these options, or the reason why there is none, as a sentence.
std::variant<StageDef, std::string> setUp(const Options& options);

} // namespace apart
