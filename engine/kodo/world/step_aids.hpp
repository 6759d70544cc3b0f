// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/executor.hpp>
#include <kodo/base/real.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace kodo::inline KODO_PRECISION {

/// The stages of World::step(), as engine/README.md lists them, gathered into a few.
enum class StepStage : std::uint8_t { Broad, Narrow, Forces, Solve, Sweep, Record, Rest };
inline constexpr std::array<std::string_view, 7> kStepStageNames = {
    "broad", "narrow", "forces", "solve", "sweep", "record", "rest"};

/// Is told when a step goes on to its next stage: for those who want to know where the time goes.
/// The engine itself looks at no clock.
class StageWatch {
public:
    virtual ~StageWatch() = default;
    virtual void enter(StepStage stage) = 0;
    virtual void leave() = 0; // the last one
};

/// Who helps a step, and who watches it. Both may be left out.
struct StepAids {
    StageWatch* watch = nullptr;
    Executor* executor = nullptr; // lends threads to steps in which some hundred bodies are awake
};

} // namespace kodo::inline KODO_PRECISION
