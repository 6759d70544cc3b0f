// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>

/// Tuning constants of the game. Lengths in m, times in s, masses in kg unless stated otherwise.
namespace apart {

using kodo::Real;

// To be raised whenever the same inputs give another game. Older replays are then refused.
inline constexpr std::uint32_t kRulesVersion = 39;

inline constexpr int kTicksPerSecond = 120;
inline constexpr Real kTickSeconds = Real(1) / 120;

// The field. The grid of blocks starts at its top; the lower third stays empty.
inline constexpr Real kFieldWidth = 24;
inline constexpr Real kFieldHeight = 18;
inline constexpr Real kWallThickness = 1; // outside the field
inline constexpr Real kWallBelow = 4;     // extension of the side walls below the field
inline constexpr Real kCellWidth = Real(1.6);
inline constexpr Real kCellHeight = Real(0.8);

// The ball flies straight, at constant speed, and has no friction.
inline constexpr Real kBallRadius = Real(0.3);
inline constexpr Real kBallDensity = Real(3.5); // about 1 kg: 24 N s for an impact at 12 m/s
inline constexpr kodo::Material kBallMaterial = kodo::withFriction(0, 1);
inline constexpr Real kHeavyFactor = 3;         // mass of a heavy ball relative to a round one
inline constexpr Real kRoughFriction = 1;       // of a rough ball
inline constexpr Real kCoreRadius = Real(0.13); // of the dense core of a lopsided ball
inline constexpr Real kCoreOffset = Real(0.15); // from the centre of the ball to that of the core
inline constexpr Real kCoreShare = Real(0.5);   // share of the ball's mass in the core
inline constexpr Real kEggLong = Real(0.42);    // from an egg's widest line to its tip
inline constexpr Real kEggShort = Real(0.28);   // from its widest line to its blunt end
inline constexpr Real kEggHalfWidth = Real(0.27);
inline constexpr int kEggFacets = 20;
// In a level with a building or joints a served ball is hollow until a paddle that has moved since
// the serve returns it. One that does not come down within kFailTicks is served again. It cracks
// blocks, but breaks none, makes no blow, and no mount fails or is torn: launching alone clears
// nothing.
inline constexpr Real kHollowShare = Real(1) / 16; // of the mass
inline constexpr Real kMovedWay = 2 * kBallRadius; // m from the serve; then it has moved
inline constexpr Real kMostSpin = 25;              // rad/s; limit applied by the governor
inline constexpr Real kLostDepth = Real(0.7);      // below the field; deeper balls are lost
inline constexpr std::size_t kMostBalls = 8;       // further balls of a split become shards
inline constexpr Real kSpeedUp = Real(0.35);       // relative gain of speed up to the last block
inline constexpr Real kAssistedSpeed = Real(0.7);  // of the speed, in Mode::Assisted
inline constexpr Real kServeSlope = Real(0.6);     // |x/y| of the flattest serve that is not aimed
inline constexpr std::int16_t kMostAim = 1732;     // 1/1000, |x/y| of the flattest aimed serve
inline constexpr Real kServeSeconds = 1;   // of flight within which a serve is to meet a block
inline constexpr int kServeDraws = 32;     // of directions, until one does
inline constexpr int kAssistedBounces = 2; // of the path that Mode::Assisted shows
inline constexpr Real kFarSight = 40;      // m; length of casts along a ball's path

// The governor. A servo holds the speed along the heading. The smallest rotation at a contact keeps
// a ball out of a cone around the horizontal, where it would bounce between the side walls for
// minutes.
inline constexpr Real kServoBand = Real(0.01);        // tolerated relative error of the speed
inline constexpr Real kServoShare = Real(1) / 8;      // share of the error corrected per tick
inline constexpr Real kMostBallFactor = 4;            // of its speed; no ball flies faster
inline constexpr Real kMostPressed = kBallRadius / 2; // m; deeper in a wall, a ball is moved out
inline constexpr Real kSwallowed = Real(0.7);         // share of speed; a slower ball is thrown off
inline constexpr std::uint32_t kCarriedTicks = 20;    // slow on a dynamic body; then thrown off
// After this time without damage a ball above this height flies faster, so that a miss costs
// little; a hollow one at once.
inline constexpr std::uint32_t kQuickTicks = 108; // 0.9 s
inline constexpr Real kQuickHeight = 4;           // m
inline constexpr Real kQuickFactor = Real(2.25);
inline constexpr Real kHaltSpeed = Real(0.1);        // m/s; below it the last heading is kept
inline constexpr Real kFlatSine = Real(0.1908090);   // sine of 11 degrees
inline constexpr Real kFlatCosine = Real(0.9816272); // cosine of 11 degrees

// The progress clock, in ticks without damage.
inline constexpr std::uint32_t kGlowTicks = 360;  // 3 s: targets glow
inline constexpr std::uint32_t kShakeTicks = 660; // 5.5 s: mounts shake
inline constexpr std::uint32_t kFailTicks = 960;  // 8 s: the lowest mount fails
inline constexpr std::uint32_t kFailEvery = 240;  // 2 s: interval of further failures
inline constexpr std::int32_t kLastBlocks = 3;    // at most so many left: the clock runs faster
inline constexpr std::uint32_t kLastHurry = 2;    // factor of the clock for the last blocks
inline constexpr Real kTornSpeed = 7;             // m/s that a pull would give a free block; then
                                                  // the mount of the block fails
inline constexpr std::uint32_t kLooseTicks = 840; // 7 s: lifetime of a loose block
inline constexpr int kLoopTimes = 3;              // similar paddle hits that make a loop
inline constexpr Real kLoopCell = Real(0.25);     // m; resolution of the place of a paddle hit
inline constexpr Real kLoopHeading = Real(0.05);  // resolution of its heading; 3 degrees

// The paddle is a dome, so that the bounce depends on the place of the hit. Its motor is limited in
// force and energy, so that a heavier paddle has a lower acceleration and a lower top speed.
inline constexpr Real kPaddleY = Real(1.2); // of its widest line
inline constexpr Real kPaddleHalfWidth = 2;
inline constexpr Real kPaddleFoot = Real(1.7);  // half the width at its bottom
inline constexpr Real kPaddleDepth = Real(0.3); // height below the widest line
inline constexpr Real kDomeRadius = Real(4.7);  // slope of 25 degrees at the rim
inline constexpr int kDomeFacets = 24;
inline constexpr Real kPaddleDensity = 3;
inline constexpr Real kPaddleForce = 8000;  // N; about 1150 m/s^2 for the bare paddle
inline constexpr Real kPaddleEnergy = 5000; // J; about 38 m/s for the bare paddle
inline constexpr Real kKeySpeed = 22;       // m/s, by keys
inline constexpr kodo::Material kPaddleMaterial = kodo::withFriction(Real(0.6), 1);
// Springs of the paddle, in tilt and in lift: x'' = -stiffness x - damping x'.
inline constexpr Real kSwayStiffness = 500;   // 1/s^2; 3.6 oscillations a second
inline constexpr Real kSwayDamping = 12;      // 1/s; an oscillation loses 4/5 of its amplitude
inline constexpr Real kMostTilt = Real(0.35); // rad
inline constexpr Real kMostSag = Real(0.5);   // m below its place
inline constexpr Real kMostLeap = Real(1.2);  // m above its place
inline constexpr Real kLeapSpeed = 18;        // m/s, upwards, with Power::Spring
inline constexpr Real kLeapReady = Real(0.1); // m; largest lift at which it can leap
// Wings: a plate at each end, rising outwards.
inline constexpr Real kWingDensity = Real(1.5);
inline constexpr int kMostWelded = 8;       // further parts bounce off
inline constexpr Real kWeldStrength = 300;  // N s; reduced by the impulse of each impact
inline constexpr Real kKnockOffImpact = 48; // N s; a single impact that breaks any weld
inline constexpr Real kKnockOffSpeed = 5;   // m/s, away from the middle of the paddle

// Blocks.
inline constexpr kodo::Material kBlockMaterial = kodo::withFriction(Real(0.5), 1);
inline constexpr Real kSlightestImpact = 1; // N s; weaker impacts are ignored
// By Stuff: glass, wood, brick, stone, steel.
inline constexpr std::array<std::int32_t, 5> kStrength = {3000, 8000, 12000, 30000,
                                                          0}; // 1/1000 N s
inline constexpr std::array<Real, 5> kStuffDensity = {Real(0.4), Real(0.4), Real(0.6), Real(0.8),
                                                      Real(4)};
inline constexpr std::array<std::int32_t, 5> kPoints = {50, 70, 100, 200, 0};
inline constexpr std::int32_t kPowerPoints = 50;
inline constexpr std::int32_t kCatchPoints = 100;
inline constexpr std::int32_t kLifePoints = 1000;   // for each life left at the end
inline constexpr std::int32_t kSparedPoints = 2000; // for what Level::keep spares
// The prize of a won level: its blocks' points times this, times the blocks of the best blow,
// divided by one more than it left.
inline constexpr std::int32_t kPrizeFactor = 4;
inline constexpr std::uint32_t kHitTicks = 30; // 0.25 s: touches of the paddle in it are one hit
inline constexpr std::int32_t kMostCombo = 8;  // largest factor of points

// Obstructions.
inline constexpr kodo::Material kObstructionMaterial = kodo::withFriction(Real(0.3), 1);
inline constexpr Real kBarThickness = Real(0.3);
inline constexpr Real kBarDensity = 2;
inline constexpr Real kMotorTorque = 300;       // N m at most
inline constexpr Real kPinRadius = Real(0.12);  // of the pin of a hanging block
inline constexpr Real kHingeTorque = Real(0.2); // N m; friction of its joint
inline constexpr kodo::Material kLooseMaterial = kodo::withFriction(Real(0.5), Real(0.6));
inline constexpr std::int32_t kFallDivisor = 2;  // divides the points of a block that fell
inline constexpr Real kBossBreakOff = Real(0.5); // share of strength of a block that broke off

// Buildings. A standing block has fallen once it is this far from its place on what carries it, or
// turned this much.
inline constexpr Real kFallenWay = 1;              // m
inline constexpr Real kFallenCosine = Real(0.766); // cosine of 40 degrees
inline constexpr kodo::Material kStandingMaterial = kodo::withFriction(Real(0.6), Real(0.15));
inline constexpr Real kBuildingHertz = 120;       // contact stiffness in levels with buildings
inline constexpr Real kHarmlessSpeed = Real(0.5); // m/s; a slower contact of blocks is no impact
inline constexpr Real kFallenStrength =
    Real(0.4); // share of the strength that a fallen block keeps
inline constexpr std::uint32_t kFallenTicks = 480;   // 4 s: lifetime of a fallen block
inline constexpr std::uint32_t kRubbleTicks = 180;   // 1.5 s: lifetime of its shards
inline constexpr std::uint32_t kCollapseGap = 120;   // 1 s without another block ends a collapse
inline constexpr std::uint32_t kLastFallTicks = 180; // 1.5 s; so long the end waits for a landing
inline constexpr std::int32_t kLeastCollapse = 3;    // blocks; a smaller collapse is no event
inline constexpr std::uint32_t kTouchTicks = 12; // 0.1 s: then contacts tell what carries a block
inline constexpr Real kLandingSpeed = Real(1.5); // m/s, of a fallen block against what it lands on
// A building is down once nothing has fallen for a while and the heights of its standing blocks
// that are left, above the lowest one, add up to this share of the sum at the start. The rest then
// comes down: the lowest block breaks into halves, and the next, under what they carry. A ball that
// is not hollow must be in play.
inline constexpr Real kDownShare = Real(0.5);
inline constexpr std::uint32_t kDownTicks = 60;   // 0.5 s
inline constexpr std::uint32_t kCrumbleTicks = 3; // from one block to the next

// Force field of the paddle: acceleration towards or away from it, linear in the distance.
inline constexpr Real kForceAcceleration = 36;        // m/s^2, at the paddle
inline constexpr Real kForceReach = 24;               // m; range, where it is 0
inline constexpr Real kMeterSeconds = 3;              // duration of a full meter
inline constexpr Real kRefillSeconds = 15;            // time to fill an empty meter
inline constexpr Real kHurry = 4;                     // factor of filling from Patience::Glowing on
inline constexpr Real kMeterStart = Real(0.1);        // least meter to start
inline constexpr Real kMeterPerKilogram = Real(0.25); // gain by shards caught while it pulls

// Timed powers.
inline constexpr std::uint32_t kEffectTicks = 1800;    // 15 s
inline constexpr std::uint32_t kBriefTicks = 960;      // 8 s, of wells and winds
inline constexpr Real kMagnetAcceleration = 60;        // m/s^2, at the paddle
inline constexpr Real kMagnetReach = 6;                // m; range, where it is 0
inline constexpr Real kWellStrength = 120;             // m^3/s^2
inline constexpr Real kWellSoftening = Real(1.5);      // m
inline constexpr Real kWindSpeed = 14;                 // m/s
inline constexpr kodo::DragLaw kWindLaw{Real(1.2), 0}; // N per m/s and m of width

// Water.
inline constexpr std::int32_t kUsualWaterDensity = 700; // 1/1000 kg/m^2: brick floats, stone sinks
inline constexpr Real kWaterDrag = Real(1.2);   // kg/(m^2 s); a block of wood slows by 1/e in 0.3 s
inline constexpr Real kOutflow = Real(0.9);     // m/s, by which the surface of open water sinks
inline constexpr Real kCurrent = 5;             // m/s, of open water towards its breach
inline constexpr Real kBreachDepth = Real(0.4); // m below a breach the water ends
inline constexpr Real kSplashSpeed = Real(1.5); // m/s; what is slower does not splash

// Shards.
inline constexpr Real kGravity = 12; // m/s^2, on shards, parts and loose or hanging blocks
// Without restitution: with any, however small, impacts pass through all that touch in a heap of
// shards, and a tick of a large fall takes twice as long.
inline constexpr kodo::Material kShardMaterial = kodo::withFriction(Real(0.5), 0);
inline constexpr Real kShardSpeed = 4;            // m/s; limit, see impulseOnPieces()
inline constexpr Real kBurstSpeed = 2;            // m/s, outwards, from internal stress
inline constexpr std::uint32_t kShardTicks = 720; // lifetime
inline constexpr std::size_t kMostShards = 160;
inline constexpr Real kCrushed = Real(0.2);     // m; a shard with more overlap is removed
inline constexpr Real kLeastArea = Real(0.04);  // of a shard, as share of its block
inline constexpr Real kLeastWidth = Real(0.12); // of a shard, as share of the block's height

inline constexpr Real kShardToughness = Real(0.6); // relative to its block, per share of the area

// Parts.
inline constexpr kodo::Material kPartMaterial = kodo::withFriction(Real(0.5), Real(0.3));
inline constexpr Real kPartDensity = Real(2.5);
inline constexpr std::uint32_t kPartTicks = 3600; // lifetime of a loose part
inline constexpr std::uint32_t kStickTicks = 120; // from touch to launch
inline constexpr Real kLaunchSpeed = 20;          // m/s, straight up
inline constexpr int kSplitBalls = 2;

} // namespace apart
