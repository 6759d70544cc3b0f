// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>
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
    float parts = 1;    // of a substep, in the island that needed the most
    float refined = 0;  // bodies of islands with more than one part
    std::array<float, kodo::kStepStageNames.size()> stages{}; // us
    float step = 0;                                           // us, their sum
};

/// A number of each step, of which panel and page draw a graph.
struct Measure {
    std::string_view name;
    std::string_view unit;
    float Sample::*value;
};
inline constexpr std::array<Measure, 9> kMeasures = {{
    {"Time", "us", &Sample::step},
    {"Deepest overlap", "mm", &Sample::overlap},
    {"Widest gap of a joint", "mm", &Sample::gap},
    {"Energy", "J", &Sample::energy},
    {"Momentum", "kg m/s", &Sample::momentum},
    {"Awake", "bodies", &Sample::awake},
    {"Visits of contacts", "", &Sample::visits},
    {"Parts of a substep, most of an island", "", &Sample::parts},
    {"In islands with more parts", "bodies", &Sample::refined},
}};
/// Value of a sample: one of kMeasures, then time (us) of one of kStepStageNames.
constexpr float valueOf(const Sample& sample, std::size_t which) {
    return which < kMeasures.size() ? sample.*kMeasures[which].value
                                    : sample.stages[which - kMeasures.size()];
}

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
