// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace destructoooor {

/// Quality and cost of one step.
struct Sample {
    float overlap = 0;  // mm, deepest
    float energy = 0;   // J, kinetic and in the field of gravity, of dynamic bodies
    float momentum = 0; // kg m/s, length of its sum
    float fastest = 0;  // m/s
    float awake = 0;    // bodies
    float gap = 0;      // mm, the widest between the anchors of a revolute or fixed joint
    float visits = 0;   // of contacts by the solver: cost without a clock
    std::array<float, kodo::kStepStageNames.size()> stages{}; // us
    float step = 0;                                           // us, their sum
};

/// Samples of the last steps.
class Measures final : public kodo::StageListener {
public:
    static constexpr std::size_t kKept = 600;

    void clear();
    /// Adds a sample of the last step; gravity in m/s^2, downwards.
    void sample(const kodo::World& world, kodo::Real gravity);
    const std::vector<Sample>& samples() const { return samples_; } // the oldest one first
    Sample last() const { return samples_.empty() ? Sample{} : samples_.back(); }

    void enter(kodo::StepStage stage) override;
    void leave() override;

private:
    using Clock = std::chrono::steady_clock;
    void endStage();

    std::vector<Sample> samples_;
    std::array<float, kodo::kStepStageNames.size()> stages_{};
    std::size_t stage_ = 0;
    Clock::time_point since_{};
    bool within_ = false;
};

} // namespace destructoooor
