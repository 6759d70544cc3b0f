// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include "base/state_stream.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// Duration of calm, and the island in which a body sleeps.
struct SleepState {
    static constexpr std::uint32_t kNoIsland = ~std::uint32_t{};

    std::uint32_t calmSteps = 0;
    std::uint32_t island = kNoIsland;
    Transform since; // pose when it became calm
    /// J; least kinetic energy since then.
    Real leastEnergy = std::numeric_limits<Real>::max();
    /// Velocities (m/s and rad/s) at the last two of regular intervals of the count, later first.
    struct Sample {
        Vec2 velocity;
        Real angularVelocity = 0;
    };
    std::array<Sample, 2> samples;

    void visitState(StateStream& stream) { // the island follows from its list
        auto& [count, ownIsland, pose, energy, ownSamples] = *this;
        stream(count, pose, energy, ownSamples);
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
