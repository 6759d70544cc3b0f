// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/building.hpp>
#include <apart/core/theme.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// Material of a block. It decides how the block breaks, looks and sounds.
enum class Stuff : std::uint8_t { Glass, Wood, Brick, Stone, Steel };
inline constexpr std::array<std::string_view, 5> kStuffNames = {"glass", "wood", "brick", "stone",
                                                                "steel"};

/// What a block releases when it breaks: a part to catch, except for Split.
enum class Power : std::uint8_t {
    None,
    Weld,     // welded to the paddle when caught
    Launch,   // sticks to the paddle for kStickTicks, then flies straight up
    Split,    // no part: the block breaks into balls
    Heavy,    // balls become BallKind::Heavy for kEffectTicks
    Lopsided, // as Heavy, with BallKind::Lopsided
    Egg,      // as Heavy, with BallKind::Egg
    Rough,    // as Heavy, with BallKind::Rough
    Magnet,   // the paddle attracts balls and parts within kMagnetReach
    Spring,   // the paddle recoils; `launch` makes it leap
    Wings,    // two plates are welded to the paddle's ends
    Well,     // a gravity well at the centre of the broken block
    Wind,     // wind across the field, to a random side
};
inline constexpr std::array<std::string_view, 13> kPowerNames = {
    "none",  "weld",   "launch", "split", "heavy", "lopsided", "egg",
    "rough", "magnet", "spring", "wings", "well",  "wind"};

/// Whether catching a power helps or harms the player.
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

/// Fracture pattern of a block.
enum class Pattern : std::uint8_t { Halves, Slats, Bricks, Radial, Shatter };
inline constexpr std::array<std::string_view, 5> kPatternNames = {"halves", "slats", "bricks",
                                                                  "radial", "shatter"};

/// Support of a block.
enum class Support : std::uint8_t {
    Mounted, // kinematic: fixed until it breaks or its mount fails
    Hanging, // on a revolute joint above it: it swings
    Boss,    // part of the boss, one body of many blocks
    // By what is below it, or by joints. Gravity acts on both.
    Standing, // counts as cleared once it has fallen from its place
    Moving,   // of a machine: counts once it breaks or leaves the field
    Loose,    // unsupported: it falls
    Fallen,   // was standing; cleared
};
inline constexpr std::array<std::string_view, 5> kSupportNames = {"mounted", "hanging", "boss",
                                                                  "standing", "moving"};

enum class BallKind : std::uint8_t {
    Round,
    Heavy,    // kHeavyFactor times the mass
    Lopsided, // eccentric centre of mass, so impacts spin it
    Egg,
    Rough, // has friction, so sliding contacts spin it
};
inline constexpr std::array<std::string_view, 5> kBallKindNames = {"round", "heavy", "lopsided",
                                                                   "egg", "rough"};

/// Kind that a power gives to all balls; nullopt: it does not change them.
constexpr std::optional<BallKind> ballKindOf(Power power) {
    switch (power) {
    case Power::Heavy:
        return BallKind::Heavy;
    case Power::Lopsided:
        return BallKind::Lopsided;
    case Power::Egg:
        return BallKind::Egg;
    case Power::Rough:
        return BallKind::Rough;
    default:
        return std::nullopt;
    }
}

/// How the paddle is mounted on its carriage.
enum class PaddleKind : std::uint8_t {
    Steady,
    Tilting,   // eccentric impacts tilt it; a spring returns it
    Recoiling, // impacts push it down; a spring returns it
    Loose,     // both
};
inline constexpr std::array<std::string_view, 4> kPaddleKindNames = {"steady", "tilting",
                                                                     "recoiling", "loose"};

/// Kinds of unbreakable obstructions.
enum class ObstructionKind : std::uint8_t {
    Bumper, // adds a kick to the velocity of bodies that touch it
    Pin,    // a fixed peg
    Motor,  // a bar turned by a motor
    Gate,   // a one-sided line: bodies pass from behind only
    Ground, // an outline, solid from outside; or a height map, solid from above
    Ledge,  // a fixed rectangle to stand on
};
inline constexpr std::array<std::string_view, 6> kObstructionNames = {"bumper", "pin",    "motor",
                                                                      "gate",   "ground", "ledge"};

/// What ground is made of. It changes the picture alone.
enum class Turf : std::uint8_t { Grass, Rock, Sand, Timber };
inline constexpr std::array<std::string_view, 4> kTurfNames = {"grass", "rock", "sand", "timber"};

/// Direction of the front of a gate. Bodies that come from there bounce.
enum class Facing : std::uint8_t { Up, Down, Left, Right };
inline constexpr std::array<std::string_view, 4> kFacingNames = {"up", "down", "left", "right"};

/// Default pattern, by Stuff.
inline constexpr std::array<Pattern, 5> kUsualPattern = {
    Pattern::Radial, Pattern::Slats, Pattern::Bricks, Pattern::Shatter, Pattern::Halves};

/// One kind of block, as the legend of a level describes it. Steel never breaks.
struct BlockKind {
    char letter = '?';
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    Pattern pattern = Pattern::Bricks;
    std::int32_t strength = 0; // 1/1000 N s
    Support support = Support::Mounted;
    std::int32_t arm = 0; // 1/1000 m, from the centre of a hanging block up to its pin
    bool core = false;    // of a boss: its other blocks fall with the last core

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

/// A corner of ground.
struct GroundPoint {
    std::int32_t x = 0; // 1/1000 m
    std::int32_t y = 0;

    friend bool operator==(const GroundPoint&, const GroundPoint&) = default;
};

struct ObstructionDef {
    ObstructionKind kind = ObstructionKind::Bumper;
    std::int32_t x = 0; // 1/1000 m, of its centre; of the first height of a ground
    std::int32_t y = 0;
    std::int32_t size = 0;  // 1/1000 m: radius of a bumper or pin, length of a bar, gate or ledge
    std::int32_t speed = 0; // 1/1000 m/s of a bumper's kick, 1/1000 rad/s of a motor
    Facing facing = Facing::Up;
    std::int32_t spacing = 0;          // 1/1000 m, of a ground
    std::vector<std::int32_t> heights; // 1/1000 m above y, of a ground; at least two, or none
    std::vector<GroundPoint> points{}; // outline of a ground without heights; at least three
    Turf turf = Turf::Grass;           // of a ground with an outline
    std::int32_t height = 0;           // 1/1000 m, of a ledge
    std::int32_t turn = 0;             // 1/1000 degree, of a ledge

    friend bool operator==(const ObstructionDef&, const ObstructionDef&) = default;
};

/// A gravity well that stays for the whole level.
struct WellDef {
    std::int32_t x = 0; // 1/1000 m
    std::int32_t y = 0;
    std::int32_t strength = 0; // 1/1000 m^3/s^2; negative: it repels

    friend bool operator==(const WellDef&, const WellDef&) = default;
};

/// Water in a rectangle. It carries what is lighter, and slows what is in it. Balls fly through it.
struct WaterDef {
    std::int32_t x = 0; // 1/1000 m, of its middle
    std::int32_t y = 0; // of its surface
    std::int32_t width = 0;
    std::int32_t depth = 0;
    std::int32_t density = 0; // 1/1000 kg/m^2
    // Index into Level::kinds; -1: none. The water runs out through the first block of this kind
    // that breaks or falls.
    std::int32_t dam = -1;

    friend bool operator==(const WaterDef&, const WaterDef&) = default;
};

inline constexpr int kColumns = 15;
inline constexpr int kMostRows = 15;

/// A level as the rules use it. All numbers are integers, so every machine reads the same values.
struct Level {
    std::string name;  // of the file, without .toml
    std::string title; // shown to the player
    std::string idea;  // one sentence about its physics
    Theme theme = Theme::Daybreak;
    std::int32_t place = 9999;      // rank in the order of levels
    std::int32_t ballSpeed = 12000; // 1/1000 m/s, while no block is broken
    std::int32_t lives = 3;
    BallKind ball = BallKind::Round;
    PaddleKind paddle = PaddleKind::Steady;
    std::int32_t wind = 0;      // 1/1000 m/s, to the right
    std::int32_t bossDrift = 0; // 1/1000 m, amplitude of the boss
    std::int32_t bossSpeed = 0; // 1/1000 m/s
    std::vector<BlockKind> kinds;
    std::vector<Cell> cells; // row by row, left to right
    std::vector<FreeBlock> freeBlocks;
    std::vector<LinkDef> links;
    std::vector<ObstructionDef> obstructions;
    std::vector<WellDef> wells;
    std::vector<WaterDef> waters;
    std::int32_t keep = -1; // index into freeBlocks, for an honour: it stands at the end; -1: none
    std::string keepName;
    std::vector<WayDef> ways; // honours; at most kMostWays, the elegant one first

    friend bool operator==(const Level&, const Level&) = default;
};

bool hasGround(const Level& level);

/// True if at least half of the blocks that break stand.
bool isBuilding(const Level& level);
/// A serve alone clears nothing: with a building or joints a paddle that moved must return it.
bool asksForReturn(const Level& level);

/// Hash of all that affects play; leaves out name, title, idea, theme, place, ways and turf.
std::uint64_t digestOf(const Level& level);

} // namespace apart
