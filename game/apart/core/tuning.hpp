// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>

/// Every number of the game's feel. Lengths in m, times in s, masses in kg unless a comment says
/// otherwise.
namespace apart {

using kodo::Real;

// Raise it whenever the same inputs no longer give the same game: older replays are then refused.
inline constexpr std::uint32_t kRulesVersion = 1;

inline constexpr int kTicksPerSecond = 120;
inline constexpr Real kTickSeconds = Real(1) / 120;

// The field. The grid of blocks hangs from its top; the player's third stays empty.
inline constexpr Real kFieldWidth = 24;
inline constexpr Real kFieldHeight = 18;
inline constexpr Real kWallThickness = 1; // outside the field
inline constexpr Real kWallBelow = 4;     // side walls go on below, so that nothing slips aside
inline constexpr Real kCellWidth = Real(1.6);
inline constexpr Real kCellHeight = Real(0.8);

// The ball flies straight, keeps its speed, and does not care for friction.
inline constexpr Real kBallRadius = Real(0.3);
inline constexpr Real kBallDensity = Real(3.5); // about 1 kg: a blow at 12 m/s brings 24 N s
inline constexpr kodo::Material kBallMaterial = kodo::withFriction(0, 1);
inline constexpr std::size_t kMostBalls = 8;   // what splits off beyond is rubble
inline constexpr Real kSpeedUp = Real(0.35);   // share of speed gained until the last block
inline constexpr Real kServeSlope = Real(0.6); // |x/y| of the flattest serve

// The governor. The servo holds the speed along the heading; the smallest turn at a contact keeps
// a ball out of a cone around the horizontal, where it would bounce from wall to wall for minutes.
inline constexpr Real kServoBand = Real(0.01);   // share of the speed within which it does nothing
inline constexpr Real kServoShare = Real(1) / 8; // of the error, each tick
inline constexpr Real kSwallowed = Real(0.7);    // share of speed; with less, rubble throws it off
inline constexpr Real kHaltSpeed = Real(0.1);    // m/s; slower, and the last heading counts
inline constexpr Real kFlatSine = Real(0.2079117);   // 12 degrees
inline constexpr Real kFlatCosine = Real(0.9781476); // 12 degrees

// The paddle: a dome, so that the bounce follows from the place of the hit. Its motor gives a force
// and an energy, so that a heavier paddle is slower to start and slower at best.
inline constexpr Real kPaddleY = Real(1.2); // of its widest line
inline constexpr Real kPaddleHalfWidth = 2;
inline constexpr Real kPaddleFoot = Real(1.7);  // half the width at its bottom
inline constexpr Real kPaddleDepth = Real(0.3); // of the part below the widest line
inline constexpr Real kDomeRadius = Real(4.7);  // 25 degrees at the rim
inline constexpr int kDomeFacets = 24;
inline constexpr Real kPaddleDensity = 3;
inline constexpr Real kPaddleForce = 8000;  // N; about 117 g for the bare paddle
inline constexpr Real kPaddleEnergy = 5000; // J; about 38 m/s for the bare paddle
inline constexpr Real kKeySpeed = 22;       // m/s, by keys
inline constexpr kodo::Material kPaddleMaterial = kodo::withFriction(Real(0.6), 1);
inline constexpr int kMostWelded = 8;      // further parts bounce off
inline constexpr Real kWeldStrength = 300; // N s; each blow uses up its own impulse
inline constexpr Real kKnockOffSpeed = 5;  // m/s, away from the middle of the paddle

// Blocks and what becomes of them.
inline constexpr kodo::Material kBlockMaterial = kodo::withFriction(Real(0.5), 1);
inline constexpr Real kSlightestBlow = 1; // N s; softer touches leave no mark
// By Stuff: glass, wood, brick, stone, steel.
inline constexpr std::array<std::int32_t, 5> kStrength = {3000, 8000, 12000, 30000,
                                                          0}; // 1/1000 N s
inline constexpr std::array<Real, 5> kStuffDensity = {Real(0.4), Real(0.4), Real(0.6), Real(0.8),
                                                      Real(4)};
inline constexpr std::array<std::int32_t, 5> kPoints = {50, 70, 100, 200, 0};
inline constexpr std::int32_t kPowerPoints = 50;
inline constexpr std::int32_t kCatchPoints = 100;
inline constexpr std::int32_t kLifePoints = 1000; // each life left at the end
inline constexpr std::int32_t kMostCombo = 8;     // points are multiplied by the combo, up to this

// Shards.
inline constexpr Real kGravity = 12; // m/s^2, on shards and parts alone
inline constexpr kodo::Material kShardMaterial = kodo::withFriction(Real(0.5), Real(0.3));
inline constexpr Real kShardSpeed = 4; // m/s; the mount of a block takes what would be faster
inline constexpr Real kBurstSpeed = 2; // m/s, outwards, of the stuff's own tension
inline constexpr std::uint32_t kShardTicks = 720; // then one that lies somewhere crumbles
inline constexpr std::size_t kMostShards = 160;
inline constexpr Real kCrushed = Real(0.2);     // m; a shard squeezed in so deep turns to dust
inline constexpr Real kLeastArea = Real(0.04);  // of a shard, as share of its block
inline constexpr Real kLeastWidth = Real(0.12); // of a shard, as share of the block's height

// Parts.
inline constexpr Real kPartDensity = Real(2.5);
inline constexpr std::uint32_t kPartTicks = 3600; // then one that nobody caught crumbles
inline constexpr std::uint32_t kStickTicks = 120; // from touch to launch
inline constexpr Real kLaunchSpeed = 20;          // m/s, straight up
inline constexpr int kSplitBalls = 2;

} // namespace apart
