// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/text_file.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace apart {

/// Parses a level in TOML. All numbers are integers. x is measured from the middle of the field, y
/// from its bottom. The field is 24 m by 18 m, a cell 1.6 m by 0.8 m. The problem has all faults
/// by line, at most TomlKeys::kMostFaults, and none that follows from another one.
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
///   keep = "bell"           # an honour: this block, by its name, stands or hangs when the level
///   is
///                           # won; of steel, standing or moving; none unless given
///   [[way]]                 # an honour: how the largest fall of a won game began; the elegant
///                           # one first, at most 3
///   name = "by the keystone"
///   strikes = "kg"          # the ball had struck a block of one of these letters last
///   bank = true             # it had touched a wall or an obstruction before its first block;
///                           # false: it had not. Either, unless given
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
///   hold = "mounted"        # mounted hanging boss standing moving; mounted unless given. Standing
///                           # blocks rest on what is below them and count once they have fallen
///                           # from their place, by 1 m or 40 degrees. Moving ones belong to a
///                           # machine: they count once they break or leave the field.
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
///   [[ground]]              # or an outline, solid from all sides
///   points = [[-4000, 4000], [4000, 4000], [0, 5000]]
///                           # 1/1000 m; 3 to 64 corners in order, each at y = 3000 or higher
///   turf = "grass"          # grass rock sand timber: its picture; grass unless given
///   mirror = true           # the same again with left and right exchanged
///   [[well]]                # attracts balls, shards, parts, loose and hanging blocks
///   x = 0
///   y = 9000
///   strength = 60000        # 1/1000 m^3/s^2; negative: it repels
///
///   [[water]]               # carries what is lighter; balls fly through it
///   x = 0                   # 1/1000 m, of its middle
///   y = 11000               # of its surface
///   width = 8000
///   depth = 2000
///   density = 700           # 1/1000 kg/m^2; 700 unless given. Glass and wood have 400, brick 600,
///                           # stone 800, steel 4000.
///   dam = "b"               # letter of a block: the water runs out through the first one of its
///                           # kind that breaks or falls; it stays unless given
///
/// Buildings have free blocks, which need no grid. A level has at most 64 ledges, 240 free blocks
/// and 120 joints, copies included. A block lies within the field as a whole, the middle of a
/// ledge too. At most 20 blocks have their middles at one place.
///
///   [[ledge]]               # a fixed rectangle to stand on
///   x = 0                   # 1/1000 m, of its middle
///   y = 6000
///   width = 8000            # 1/1000 m
///   height = 400            # 400 unless given
///   turn = 0                # 1/1000 degree, counter-clockwise; 0 unless given
///   [[block]]
///   kind = "b"              # letter of the legend; mounted, standing or moving
///   shape = "beam"          # brick beam plank square wedge gable round wheel voussoir L T; brick
///                           # unless given. A power needs one of the first four.
///   x = 0                   # 1/1000 m, of its middle
///   y = 6400
///   width = 3200            # 1/1000 m, also the diameter of a round one; default by shape, as is
///   height = 400            # the height
///   thick = 400             # 1/1000 m, of L and T; 400 unless given
///   turn = 90000            # 1/1000 degree, counter-clockwise; 0 unless given
///   flip = true             # left and right of its shape exchanged, for a wedge or L
///   name = "beam"           # for joints; copies are beam1, beam2, ...
///   count = 4               # copies in a row; 1 unless given
///   step = [1600, 0]        # 1/1000 m, from one copy to the next
///   step-turn = 0           # 1/1000 degree, likewise
///   rows = 3                # rows of copies; 1 unless given
///   row-step = [0, 800]     # 1/1000 m, from one row to the next
///   mirror = true           # the same again with left and right exchanged
///   [[block]]               # of an arch: x and y are the centre of its ring
///   shape = "voussoir"
///   radius = 3000           # 1/1000 m, the inner one; height goes along the radius
///   span = 20000            # 1/1000 degree; turn is measured from the crown
///   [[joint]]
///   kind = "pin"            # pin rope spring slider motor
///   a = "beam1"             # a block by its name; the field unless given
///   b = "beam2"
///   at = [0, 8000]          # 1/1000 m, place of a pin, motor or slider
///   from = [0, 12000]       # of a rope or spring: its end at a
///   to = [0, 8000]          # and its end at b
///   slack = 0               # 1/1000 m, of a rope beyond this distance; or by which a spring is
///                           # pressed at the start
///   hertz = 2000            # 1/1000 Hz, of a spring
///   axis = 0                # 1/1000 degree, direction of a slider
///   limits = [-30000, 9000] # 1/1000 degree of a pin, 1/1000 m of a slider; none unless given
///   speed = 2000            # 1/1000 rad/s, of a motor
///   torque = 300000         # 1/1000 N m, of a motor, or friction of a pin (0)
///   break = 90000           # 1/1000 N; a larger force breaks it; unbreakable unless given
///   count = 3               # copies; numbers at the end of names rise by 1
///   step = [800, 0]         # 1/1000 m, from one copy to the next
Read<Level> parseLevel(std::string_view text, const std::string& name, const std::string& file);

/// The level's name is that of the file without its ending.
Read<Level> readLevelFile(const std::filesystem::path& path);

inline constexpr std::size_t kLargestLevel = 256 * 1024; // bytes

} // namespace apart
