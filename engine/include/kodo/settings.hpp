// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>

#include <cstdint>
#include <optional>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// Features that a step can leave out. A feature that is left out costs nothing and changes nothing
/// else.
enum class Feature : std::uint8_t {
    Friction = 1,
    RollingResistance = 2,
    Restitution = 4,
    ContinuousCollision = 8, // without it fast bodies can tunnel
    Records = 16,            // World::collisions()
    Sleep = 32,
    Rotation = 64,   // without it all bodies have kLockRotate, and spins are set to zero
    Collision = 128, // without it nothing touches, and queries visit all parts
};

/// A set of features, for example Feature::Sleep | Feature::Records.
struct Features {
    std::uint8_t bits = 0;

    constexpr Features() = default;
    constexpr Features(Feature feature) : bits(static_cast<std::uint8_t>(feature)) {}

    constexpr bool has(Feature feature) const {
        return (bits & static_cast<std::uint8_t>(feature)) != 0;
    }
    constexpr Features& operator|=(Features other) {
        bits = static_cast<std::uint8_t>(bits | other.bits);
        return *this;
    }
    friend bool operator==(const Features&, const Features&) = default;
};

constexpr Features operator|(Features a, Features b) {
    return a |= b;
}
constexpr Features operator|(Feature a, Feature b) {
    return Features(a) | b;
}

/// The soft solver: substeps of soft contacts with warm starting and a relax pass [Catto24].
///
/// Limits at these defaults, at 60 Hz under the earth's gravity:
///   mass ratio  4000 : 1, a heavy box on ten light ones of 1 m, compressed by at most 1.6 %
///   overlap     bodies placed on one point separate slowly: 20 of them take 5 s, 60 take 17 s
struct SoftSettings {
    int substeps = 5;       // 1 to 64
    int impactPasses = 16;  // 0 to 1000; passes over impacts (restitution) through touching bodies
    Real contactHertz = 60; // > 0, up to 1e9; contact stiffness; at most 0.21 of the substep rate
    Real contactDamping = 10; // > 0, up to 1e6; damping ratio of contacts; 1 is critical
    Real jointHertz =
        60; // > 0, up to 1e9; joint stiffness in loops; at most 1/4 of the substep rate
    Real jointDamping = 1; // > 0, up to 1e6; damping ratio of joints in loops
    /// > 0, up to 1e7; length units/s; largest speed that separates overlaps, and that closes the
    /// gaps of articulated trees, such as chains.
    Real pushSpeed = 3;
    /// 1e-4 to 1e4; by how much of the smaller body's size a loaded joint may open. The smaller,
    /// the more trees of joints are solved directly and the more parts loaded substeps have.
    Real jointGap = Real(0.04);

    friend bool operator==(const SoftSettings&, const SoftSettings&) = default;
};

/// The solver of the thesis: collisions, then contacts with rising restitution, in the order of
/// [Guendelman03]. Shock propagation carries any mass ratio on a stack.
struct PropagationSettings {
    int substeps = 1;       // 1 to 64
    int impactPasses = 5;   // 0 to 1000; passes over collisions
    int contactPasses = 10; // 1 to 1000; passes over contacts, in each substep
    int shockPasses = 0;    // 0 to 1000; passes in each level; 0: no shock propagation
    Real jointHertz = 60;   // as in SoftSettings, but without a cap
    Real jointDamping = 1;
    Real pushSpeed = 3;

    friend bool operator==(const PropagationSettings&, const PropagationSettings&) = default;
};

/// How a World steps: the trade of speed against accuracy.
struct StepSettings {
    std::variant<SoftSettings, PropagationSettings> solver = SoftSettings{};
    int sleepSteps = 30; // 1 to 1000000; calm steps in a row before an island falls asleep
    Features leaveOut{};

    /// The numbers of the solver in use. Asking for those of the other one throws BadDefinition.
    KODO_API SoftSettings& soft();
    KODO_API const SoftSettings& soft() const;
    KODO_API PropagationSettings& propagation();
    KODO_API const PropagationSettings& propagation() const;

    bool has(Feature feature) const { return !leaveOut.has(feature); }
    friend bool operator==(const StepSettings&, const StepSettings&) = default;
};

KODO_API std::optional<Problem> check(const StepSettings& settings);

// Profiles. Each sets every number; times and errors of each are in docs/tuning.md.

/// For many bodies without close inspection: piles overlap five times as much as with balanced().
constexpr StepSettings fast() {
    return {.solver = SoftSettings{.substeps = 2, .impactPasses = 4}};
}

/// The defaults: for a game, as a rule.
constexpr StepSettings balanced() {
    return {.solver = SoftSettings{}};
}

/// For measurements, nets under load, and columns under a thousandfold weight. A step takes 1.1
/// to 2.3 times as long as with balanced().
constexpr StepSettings accurate() {
    return {.solver = SoftSettings{
                .substeps = 16, .impactPasses = 64, .contactHertz = 192, .jointHertz = 240}};
}

/// The solver of the thesis, with the passes that [Guendelman03] found enough, and with shock
/// propagation. Without it a stack of three boxes walks off and falls within half a minute.
constexpr StepSettings thesis2006() {
    return {.solver = PropagationSettings{.shockPasses = 4}};
}

inline constexpr Real kMinTimeStep = Real(1e-7); // s
inline constexpr Real kMaxTimeStep = 1;          // s

/// Distances (m) that scale with the length unit of a World.
struct Tolerances {
    Real slop;   // separation up to which two parts count as touching
    Real margin; // separation up to which a contact is kept ready
    Real grown;  // largest growth of stored bounds, so that small moves leave them valid

    static constexpr Real kSlopsPerUnit = 256;

    constexpr Real unit() const { return kSlopsPerUnit * slop; } // m, exactly as it was given
    static constexpr Tolerances forUnit(Real unit) {
        return {1 / kSlopsPerUnit * unit, Real(1) / 64 * unit, Real(1) / 16 * unit};
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
