// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>

#include <string>

namespace apart {

/// The level as a file of level_file.hpp. Reading it gives an equal level, except for the name,
/// which is that of the file. Copies at equal distances share a table. Names of blocks are made up,
/// since a level keeps none but that of Level::keep.
std::string toToml(const Level& level);

} // namespace apart
