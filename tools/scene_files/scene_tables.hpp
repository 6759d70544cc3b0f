// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene_file.hpp"
#include "scene_table.hpp"

// The tables of a scene file.
namespace scene_files {
inline namespace KODO_PRECISION {

/// Match mode, what it compares with, and group.
kodo::CollisionFilter readMatch(Table& table);
FileBody readBody(apart::TomlKeys& keys, const toml::table& own);
/// A joint of bodies that have been read.
FileJoint readJoint(apart::TomlKeys& keys, const toml::table& own,
                    const std::vector<FileBody>& bodies);

} // namespace KODO_PRECISION
} // namespace scene_files
