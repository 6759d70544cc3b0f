// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/text_file.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace apart {

/// Parses a level in TOML. All numbers are integers. x is measured from the middle of the field, y
/// from its bottom. The field is 24 m by 18 m, a cell 1.6 m by 0.8 m.
///
///   format = 1
///   place = 1               # rank in the order of levels; 9999 unless given
///   title = "First light"
///   idea = "One sentence."
///   theme = "daybreak"      # daybreak quarry fairground harbour clockwork observatory fortress;
///                           # daybreak unless given
///   ball-speed = 11000      # 1/1000 m/s, while no block is broken; 12000 unless given
///   lives = 3               # 3 unless given
///   ball = "round"          # round heavy lopsided egg rough; round unless given
///   paddle = "steady"       # steady tilting recoiling loose; steady unless given
///   wind = 0                # 1/1000 m/s to the right, -30000 to 30000; 0 unless given
///   boss = { drift = 3000, speed = 2000 } # 1/1000 m to each side and 1/1000 m/s; it does not
///                                         # move unless given
///   grid = '''
///   ...............         # 15 letters a row, at most 15 rows from the top; . is empty
///   ..bbbbb.bbbbb..
///   '''
///   [legend.b]              # one table for each letter: a block
///   stuff = "brick"         # glass wood brick stone steel
///   strength = 12000        # 1/1000 N s; default by stuff
///   pattern = "bricks"      # halves slats bricks radial shatter; default by stuff
///   power = "weld"          # weld launch split heavy lopsided egg rough magnet spring wings well
///                           # wind; none unless given
///   hold = "mounted"        # mounted hanging boss; mounted unless given
///   arm = 800               # 1/1000 m up to the pin of a hanging block; 800 unless given
///   core = true             # of a block of the boss: the others fall with the last core
///   [legend.o]              # or an obstruction, at the centre of its cell
///   obstruction = "bumper"  # bumper pin motor gate
///   size = 500              # 1/1000 m: radius of a bumper (500) or pin (200), length of the
///                           # bar of a motor (3000) or of a gate (that of the cell)
///   speed = 6000            # 1/1000 m/s of a bumper's kick (6000), 1/1000 rad/s of a motor
///                           # (2000)
///   facing = "up"           # of a gate: up down left right; bodies from there bounce
///   [[ground]]              # a height map, solid from above
///   x = -12000              # 1/1000 m, of the first height
///   y = 0
///   spacing = 1000          # 1/1000 m
///   heights = [900, 300, 0] # 1/1000 m above y; 2 to 64
///   [[well]]                # attracts balls, shards, parts, loose and hanging blocks
///   x = 0
///   y = 9000
///   strength = 60000        # 1/1000 m^3/s^2; negative: it repels
Read<Level> parseLevel(std::string_view text, const std::string& name, const std::string& file);

/// The level's name is that of the file without its ending.
Read<Level> readLevelFile(const std::filesystem::path& path);

inline constexpr std::size_t kLargestLevel = 256 * 1024; // bytes

} // namespace apart
