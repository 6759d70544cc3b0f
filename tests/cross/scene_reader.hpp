// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>

#include <string>
#include <string_view>

#include "cross_scene.hpp"

namespace crosscheck {

/// A scene of a user, in TOML: tests/cross/README.md has its keys. All mistakes are told, each with
/// its line and key.
apart::Read<CrossScene> readScene(std::string_view text, const std::string& file);

} // namespace crosscheck
