// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// What a block is made of. It decides how the block breaks and how it looks and sounds.
enum class Stuff : std::uint8_t { Glass, Wood, Brick, Stone, Steel };
inline constexpr std::array<std::string_view, 5> kStuffNames = {"glass", "wood", "brick", "stone",
                                                                "steel"};

/// What a block lets go when it breaks: a body to be caught, but for Split.
enum class Power : std::uint8_t {
    None,
    Weld,     // becomes a part of the paddle
    Launch,   // sticks for a second and then fires straight up
    Split,    // no part: the block comes apart into balls
    Heavy,    // balls become BallKind::Heavy for a while
    Lopsided, // ... BallKind::Lopsided
    Egg,      // ... BallKind::Egg
    Rough,    // ... BallKind::Rough
    Magnet,   // the paddle draws balls and parts that are near
    Spring,   // the paddle recoils, and `launch` makes it leap
    Wings,    // two plates are welded to the paddle's ends
    Well,     // a gravity well where the block was
    Wind,     // blows across the field
};
inline constexpr std::array<std::string_view, 13> kPowerNames = {
    "none",  "weld",   "launch", "split", "heavy", "lopsided", "egg",
    "rough", "magnet", "spring", "wings", "well",  "wind"};

/// What a player should think of a power before it is caught.
enum class Mood : std::uint8_t { Good, Mixed, Bad };
constexpr Mood moodOf(Power power) {
    switch (power) {
    case Power::Lopsided:
    case Power::Egg:
    case Power::Wind:
        return Mood::Bad;
    case Power::Weld:
    case Power::Rough:
    case Power::Well:
        return Mood::Mixed;
    default:
        return Mood::Good;
    }
}

/// Into what pieces a block breaks.
enum class Pattern : std::uint8_t { Halves, Slats, Bricks, Radial, Shatter };
inline constexpr std::array<std::string_view, 5> kPatternNames = {"halves", "slats", "bricks",
                                                                  "radial", "shatter"};

/// What carries a block.
enum class Hold : std::uint8_t {
    Mounted, // on the field: it does not move until it breaks or its mount gives way
    Hanging, // on a pin above it: it swings
    Boss,    // a part of the one body of all blocks of the boss
    Loose,   // by nothing: it falls
};
inline constexpr std::array<std::string_view, 3> kHoldNames = {"mounted", "hanging", "boss"};

enum class BallKind : std::uint8_t {
    Round,
    Heavy,    // strikes harder
    Lopsided, // its mass lies off its middle, so blows turn it
    Egg,
    Rough, // takes spin from what it slides along
};
inline constexpr std::array<std::string_view, 5> kBallKindNames = {"round", "heavy", "lopsided",
                                                                   "egg", "rough"};

/// How the paddle is mounted on its carriage.
enum class PaddleKind : std::uint8_t {
    Steady,
    Tilting,   // blows off its middle turn it, and a spring turns it back
    Recoiling, // blows push it down, and a spring pushes it up again
    Loose,     // both
};
inline constexpr std::array<std::string_view, 4> kPaddleKindNames = {"steady", "tilting",
                                                                     "recoiling", "loose"};

/// What stands in the way and never breaks.
enum class ObstructionKind : std::uint8_t {
    Bumper, // kicks what touches it
    Pin,    // a peg; hanging blocks bring one of their own
    Motor,  // a bar that a motor turns
    Gate,   // a line that lets pass what comes from behind
    Ground, // hills, solid from above
};
inline constexpr std::array<std::string_view, 5> kObstructionNames = {"bumper", "pin", "motor",
                                                                      "gate", "ground"};

/// Where the front of a gate looks; what comes from there bounces.
enum class Facing : std::uint8_t { Up, Down, Left, Right };
inline constexpr std::array<std::string_view, 4> kFacingNames = {"up", "down", "left", "right"};

/// By Stuff; of a block whose kind says nothing else.
inline constexpr std::array<Pattern, 5> kUsualPattern = {
    Pattern::Radial, Pattern::Slats, Pattern::Bricks, Pattern::Shatter, Pattern::Halves};

/// One kind of block, as the legend of a level describes it. Steel never breaks.
struct BlockKind {
    char letter = '?';
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    Pattern pattern = Pattern::Bricks;
    std::int32_t strength = 0; // 1/1000 N s
    Hold hold = Hold::Mounted;
    std::int32_t arm = 0; // 1/1000 m, from the middle of a hanging block up to its pin
    bool core = false;    // of the boss: the rest falls with the last of these

    bool breakable() const { return stuff != Stuff::Steel; }
    friend bool operator==(const BlockKind&, const BlockKind&) = default;
};

/// One cell of the grid that holds a block. Row 0 is the highest, column 0 the leftmost.
struct Cell {
    std::uint8_t row = 0;
    std::uint8_t column = 0;
    std::uint8_t kind = 0; // index into Level::kinds

    friend bool operator==(const Cell&, const Cell&) = default;
};

struct ObstructionDef {
    ObstructionKind kind = ObstructionKind::Bumper;
    std::int32_t x = 0; // 1/1000 m, of its middle; of a ground's first height
    std::int32_t y = 0;
    std::int32_t size = 0;  // 1/1000 m: radius of a bumper or pin, length of a bar or gate
    std::int32_t speed = 0; // 1/1000: m/s of a bumper's kick, rad/s of a motor
    Facing facing = Facing::Up;
    std::int32_t spacing = 0;          // 1/1000 m, of a ground
    std::vector<std::int32_t> heights; // 1/1000 m above y, of a ground; at least two

    friend bool operator==(const ObstructionDef&, const ObstructionDef&) = default;
};

/// A gravity well that stays for the whole level.
struct WellDef {
    std::int32_t x = 0; // 1/1000 m
    std::int32_t y = 0;
    std::int32_t strength = 0; // 1/1000 m^3/s^2; negative: it repels

    friend bool operator==(const WellDef&, const WellDef&) = default;
};

inline constexpr int kColumns = 15;
inline constexpr int kMostRows = 15;

/// A level as the rules need it: numbers are whole, so that every machine reads the same.
struct Level {
    std::string name;  // of the file, without .toml
    std::string title; // shown to the player
    std::string idea;  // one sentence: what is special about its physics
    Theme theme = Theme::Daybreak;
    std::int32_t place = 9999;      // in the order of levels
    std::int32_t ballSpeed = 12000; // 1/1000 m/s, when all blocks stand
    std::int32_t lives = 3;
    BallKind ball = BallKind::Round;
    PaddleKind paddle = PaddleKind::Steady;
    std::int32_t wind = 0;      // 1/1000 m/s, to the right
    std::int32_t bossDrift = 0; // 1/1000 m, how far the boss goes to each side
    std::int32_t bossSpeed = 0; // 1/1000 m/s
    std::vector<BlockKind> kinds;
    std::vector<Cell> cells; // row by row, left to right
    std::vector<ObstructionDef> obstructions;
    std::vector<WellDef> wells;

    friend bool operator==(const Level&, const Level&) = default;
};

/// Equal for levels that play alike; title, idea and comments of the file do not count.
std::uint64_t digestOf(const Level& level);

} // namespace apart
