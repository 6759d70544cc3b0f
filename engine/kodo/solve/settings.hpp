// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/problem.hpp>

#include <cstdint>
#include <optional>

namespace kodo::inline KODO_PRECISION {

/// Features that a step can do without. What is left out costs nothing and changes nothing else.
///
/// Without Rotation every body acts as if it had kLockRotate: no blow, force or joint turns it, and
/// only a spin that is set from then on goes on, unhindered. The spins of before are forgotten.
enum class Feature : std::uint8_t {
    Friction = 1,
    RollingResistance = 2,
    Restitution = 4,
    Sweep = 8,
    Records = 16,
    Resting = 32,
    Rotation = 64,
};

/// The solver of a step.
enum class Strategy : std::uint8_t {
    SoftStep,    // soft contacts in substeps, warm-started: solve/soft_step
    Propagation, // the thesis's order of processing: solve/propagation
};

/// How a World steps: the user's dial between speed and accuracy. Every number can be set alone.
///
/// Limits at the default settings, at 60 steps a second under the earth's gravity:
///   weight  up to 3000 times that of what carries it, a tower of ten boxes of 1 m: each gives by
///           less than 1 %. Beyond that the light ones are crushed; Propagation with shockPasses
///           carries a millionfold.
///   crowds  bodies put on one point part gently, and so take their time: 20 of them 5 s, 60 of
///           them 17 s. n of them are n^2 / 2 contacts, and each step looks at all of these.
struct StepSettings {
    Strategy strategy = Strategy::SoftStep;
    int substeps = 5;          // 1..64; more: smaller errors, more time
    int impactPasses = 16;     // 0..1000; rounds of restitution through bodies that touch
    int contactPasses = 10;    // 1..1000; of Propagation, in each substep
    int shockPasses = 0;       // 0..1000; of Propagation, in each level; 0: no shock propagation
    Real contactHertz = 60;    // > 0, up to 1e9; stiffness of contacts; substep rate * 0.21 at most
    Real contactDamping = 10;  // > 0, up to 1e6; damping ratio of contacts; 1 is critical
    Real jointHertz = 60;      // > 0, up to 1e9; of joints in loops; substep rate / 4 at most
    Real jointDamping = 1;     // > 0, up to 1e6; damping ratio of these
    Real pushSpeed = 3;        // > 0, up to 1e7; length units/s at most, when overlaps are parted
    int restSteps = 30;        // 1..1000000; calm steps in a row before an island is put to rest
    std::uint8_t leaveOut = 0; // a set of Feature

    bool has(Feature feature) const { return (leaveOut & static_cast<std::uint8_t>(feature)) == 0; }
    friend bool operator==(const StepSettings&, const StepSettings&) = default;
};

std::optional<Problem> check(const StepSettings& settings);

/// The solver of the thesis, with the passes that [Guendelman03] found enough.
constexpr StepSettings thesis2006() {
    StepSettings settings;
    settings.strategy = Strategy::Propagation;
    settings.substeps = 1;
    settings.impactPasses = 5;
    settings.contactPasses = 10;
    return settings;
}

/// Shortest and longest step (s).
inline constexpr Real kShortestStep = Real(1e-7);
inline constexpr Real kLongestStep = 1;

} // namespace kodo::inline KODO_PRECISION
