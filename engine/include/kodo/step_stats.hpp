// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kodo {
inline namespace KODO_PRECISION {

class World;

// For measurements: counters without a clock, and the stages of a step.

/// Work of the last step.
struct StepStats {
    std::size_t bodies = 0;   // awake bodies
    std::size_t contacts = 0; // visits of contacts by the solver, summed over all passes
    std::size_t joints = 0;   // joints of awake bodies
    /// Parts into which the soft solver divided each substep of the island that needed the most,
    /// up to 8: for heavy bodies on light ones, pins under a load, and very large forces.
    std::uint32_t mostParts = 1;
    std::size_t refinedBodies = 0;   // bodies of islands with more than one part
    std::size_t pairs = 0;           // of parts of awake bodies that are near each other
    std::size_t continuousPairs = 0; // whose paths continuous collision compared
    std::size_t continuousStops = 0; // bodies that it stopped
    std::uint64_t pairWork = 0;      // pairs of nodes of bounds trees compared, all steps so far
    /// Bodies and parts that calls visited which concern many: setRegion(), forces on all, and
    /// welds whose parts need more room in the next step. Also contacts outside the region that
    /// calls and steps visited. Of all calls so far.
    std::uint64_t changeVisits = 0;
};

KODO_API StepStats stepStats(const World& world);

/// Stages of World::step(), in their order.
enum class StepStage : std::uint8_t { Broad, Narrow, Forces, Solve, Continuous, Record, Sleep };
inline constexpr std::array<std::string_view, 7> kStepStageNames = {
    "broad", "narrow", "forces", "solve", "continuous", "record", "sleep"};

/// Called when a step enters a stage, to measure times. The engine itself reads no clock. It may
/// read the World, which is then between two states, but not change it, see World::step().
class KODO_API StageListener {
public:
    virtual ~StageListener();
    virtual void enter(StepStage stage) = 0;
    virtual void leave() = 0; // the last one
};

} // namespace KODO_PRECISION
} // namespace kodo
