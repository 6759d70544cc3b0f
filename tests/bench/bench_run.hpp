// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bench_scenes.hpp"

namespace bench {

struct RunOptions {
    std::string scene = "pyramid";
    std::string engine = "kodo";
    StepOptions step{};
    std::optional<int> size{};  // default: the size of the recipe
    std::optional<int> steps{}; // default: the steps of the recipe
    std::uint64_t seed = 1;
    bool peak = false;     // also measure the maximum overlap, every 20 steps
    bool worst = false;    // also measure the longest step
    bool snapshot = false; // also measure a snapshot and a copy of the state at the end
};

/// Median CPU time and size of something that was repeated.
struct Cost {
    double seconds = 0;
    std::size_t bytes = 0;
};

/// Results of one run of a scene.
struct Result {
    RunOptions options;
    int size = 0;
    int steps = 0;
    std::size_t bodies = 0; // dynamic bodies at the end
    std::size_t locked = 0;
    double cpuSeconds = 0; // of the calling thread, during the measured steps
    double wallSeconds = 0;
    std::optional<double> worstSeconds; // CPU time of the longest step with its action, if timed
    Depths depths;                      // at the end
    std::optional<double> maxOverlap;   // m, sampled every 20 steps
    std::optional<std::size_t> escaped; // empty: the scene has no region
    Drift displacement;
    bool stands = false;      // of the scene: all bodies should keep their places
    double kineticEnergy = 0; // J
    double mass = 0;          // kg
    std::uint64_t stateHash = 0;
    std::string errorName;
    std::string errorUnit;
    std::optional<double> error;
    std::vector<StageTime> stages;
    std::optional<double> pairWorkPerStep; // ns: see Engine::pairWork()
    double allocationsPerStep = 0;         // during the second half of the steps
    double bytesPerBody = 0; // of the heap: all memory of the engine, including static bodies
    std::optional<ContactBytes> contactBytes;
    std::optional<Cost> snapshot; // if measured, and the engine has it
    std::optional<Cost> copy;

    double cpuMsPerStep() const { return 1e3 * cpuSeconds / steps; }
    double wallMsPerStep() const { return 1e3 * wallSeconds / steps; }
    double nsPerBodyStep() const {
        return bodies == 0 ? 0 : 1e9 * cpuSeconds / steps / static_cast<double>(bodies);
    }
};

/// Throws WrongUse for invalid options.
Result run(const RunOptions& options);

} // namespace bench
