// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/text_file.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace apart {

/// A level as text, in TOML. All numbers are whole.
///
///   format = 1
///   place = 1               # in the order of levels
///   title = "First light"
///   idea = "One sentence."
///   theme = "daybreak"      # daybreak quarry fairground harbour clockwork observatory fortress;
///                           # daybreak unless given
///   ball-speed = 11000      # 1/1000 m/s, when all blocks stand; 12000 unless given
///   lives = 3               # 3 unless given
///   grid = '''
///   ...............         # 15 letters a row, at most 15 rows from the top; . is empty
///   ..bbbbb.bbbbb..
///   '''
///   [legend.b]              # one table for each letter
///   stuff = "brick"         # glass wood brick stone steel
///   strength = 12000        # 1/1000 N s; that of the stuff unless given
///   pattern = "bricks"      # halves slats bricks shatter; that of the stuff unless given
///   power = "weld"          # weld launch split; none unless given
Read<Level> parseLevel(std::string_view text, const std::string& name, const std::string& file);

/// The level's name is that of the file without its ending.
Read<Level> readLevelFile(const std::filesystem::path& path);

inline constexpr std::size_t kLargestLevel = 256 * 1024; // bytes

} // namespace apart
