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
inline constexpr std::uint32_t kRulesVersion = 18;

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
inline constexpr Real kHeavyFactor = 3;         // of the mass of a heavy ball
inline constexpr Real kRoughFriction = 1;       // of a rough ball; it takes spin, and gives it back
inline constexpr Real kCoreRadius = Real(0.13); // of the dense core of a lopsided ball
inline constexpr Real kCoreOffset = Real(0.15); // from its middle to that of the core
inline constexpr Real kCoreShare = Real(0.5);   // of the ball's mass that is in the core
inline constexpr Real kEggLong = Real(0.42);    // from an egg's widest line to its tip
inline constexpr Real kEggShort = Real(0.28);   // and to its blunt end
inline constexpr Real kEggHalfWidth = Real(0.27);
inline constexpr int kEggFacets = 20;
inline constexpr Real kMostSpin = 25;          // rad/s; the governor takes what is above it
inline constexpr Real kLostDepth = Real(0.7);  // below the field; there nobody sees a ball
inline constexpr std::size_t kMostBalls = 8;   // what splits off beyond is rubble
inline constexpr Real kSpeedUp = Real(0.35);   // share of speed gained until the last block
inline constexpr Real kServeSlope = Real(0.6); // |x/y| of the flattest serve

// The governor. The servo holds the speed along the heading; the smallest turn at a contact keeps
// a ball out of a cone around the horizontal, where it would bounce from wall to wall for minutes.
inline constexpr Real kServoBand = Real(0.01);   // share of the speed within which it does nothing
inline constexpr Real kServoShare = Real(1) / 8; // of the error, each tick
inline constexpr Real kSwallowed = Real(0.7);    // share of speed; with less, rubble throws it off
inline constexpr std::uint32_t kCarriedTicks = 20;   // on what moves; then that throws the ball off
inline constexpr Real kHaltSpeed = Real(0.1);        // m/s; slower, and the last heading counts
inline constexpr Real kFlatSine = Real(0.1908090);   // 11 degrees
inline constexpr Real kFlatCosine = Real(0.9816272); // 11 degrees

// The progress clock, in ticks without damage.
inline constexpr std::uint32_t kGlowTicks = 720;   // 6 s: what is worth hitting glows
inline constexpr std::uint32_t kShakeTicks = 1440; // 12 s: mounts shake
inline constexpr std::uint32_t kFailTicks = 2400;  // 20 s: the lowest mount gives way
inline constexpr std::uint32_t kFailEvery = 240;   // 2 s: and then another, and so on
inline constexpr std::int32_t kLastBlocks = 3;     // with so few left the clock goes faster
inline constexpr std::uint32_t kLastHurry = 2;     // so many times
inline constexpr Real kTornSpeed = 7;              // m/s that a pull would give what a mount holds;
                                                   // then a mount of a block that glows gives way
inline constexpr std::uint32_t kLooseTicks =
    1200;                                     // 10 s: a fallen block that lies somewhere crumbles
inline constexpr int kLoopTimes = 3;          // meetings with the paddle that are alike make a loop
inline constexpr Real kLoopCell = Real(0.25); // of a meeting's place that counts as the same
inline constexpr Real kLoopHeading = Real(0.05); // of x and y of its heading; 3 degrees

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
// An unruly paddle hangs on springs: x'' = -stiffness x - damping x', in tilt and in height.
inline constexpr Real kSwayStiffness = 500;   // 1/s^2; 3.6 swings a second
inline constexpr Real kSwayDamping = 12;      // 1/s; a swing loses four fifths of its height
inline constexpr Real kMostTilt = Real(0.35); // rad
inline constexpr Real kMostSag = Real(0.5);   // m below its place
inline constexpr Real kMostLeap = Real(1.2);  // m above its place
inline constexpr Real kLeapSpeed = 18;        // m/s, upwards, with Power::Spring
inline constexpr Real kLeapReady = Real(0.1); // m off its place at most, to leap again
// Wings: a plate at each end, as a bowl.
inline constexpr Real kWingDensity = Real(1.5);
inline constexpr int kMostWelded = 8;      // further parts bounce off
inline constexpr Real kWeldStrength = 300; // N s; each blow uses up its own impulse
inline constexpr Real kKnockOffBlow = 48;  // N s; a single one that breaks any weld
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

// What stands in the way.
inline constexpr kodo::Material kObstructionMaterial = kodo::withFriction(Real(0.3), 1);
inline constexpr Real kBarThickness = Real(0.3);
inline constexpr Real kBarDensity = 2;
inline constexpr Real kMotorTorque = 300;       // N m at most
inline constexpr Real kPinRadius = Real(0.12);  // of the pin of a hanging block
inline constexpr Real kHingeTorque = Real(0.2); // N m; its friction
inline constexpr kodo::Material kLooseMaterial = kodo::withFriction(Real(0.5), Real(0.6));
inline constexpr std::int32_t kFallDivisor = 2;  // a block that fell is worth its points by this
inline constexpr Real kBossBreakOff = Real(0.5); // of its strength, left to what breaks off

// The paddle's field: acceleration towards the paddle or away, fading with the distance.
inline constexpr Real kForceAcceleration = 36; // m/s^2, at the paddle
inline constexpr Real kForceReach = 24;        // m, where it has faded to nothing
inline constexpr Real kMeterSeconds = 3;       // that a full meter lasts
inline constexpr Real kRefillSeconds = 15;     // that an empty one needs
inline constexpr Real kHurry = 4; // times faster when nothing has been damaged for long
inline constexpr Real kMeterStart = Real(0.1);        // it must be so full to begin
inline constexpr Real kMeterPerKilogram = Real(0.25); // of shards caught while it pulls

// Powers that last.
inline constexpr std::uint32_t kEffectTicks = 1800;    // 15 s
inline constexpr std::uint32_t kBriefTicks = 960;      // 8 s, of wells and winds
inline constexpr Real kMagnetAcceleration = 60;        // m/s^2, at the paddle
inline constexpr Real kMagnetReach = 6;                // m, where it has faded to nothing
inline constexpr Real kWellStrength = 120;             // m^3/s^2
inline constexpr Real kWellSoftening = Real(1.5);      // m
inline constexpr Real kWindSpeed = 14;                 // m/s
inline constexpr kodo::DragLaw kWindLaw{Real(1.2), 0}; // N per m/s and m of width

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

inline constexpr Real kShardToughness = Real(0.6); // of its block's, by its share of the area

// Parts.
inline constexpr Real kPartDensity = Real(2.5);
inline constexpr std::uint32_t kPartTicks = 3600; // then one that nobody caught crumbles
inline constexpr std::uint32_t kStickTicks = 120; // from touch to launch
inline constexpr Real kLaunchSpeed = 20;          // m/s, straight up
inline constexpr int kSplitBalls = 2;

} // namespace apart
