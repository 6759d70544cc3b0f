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
    std::optional<int> size{};  // what the scene's recipe says unless given
    std::optional<int> steps{}; // likewise
    std::uint64_t seed = 1;
    bool peak = false; // also look for the deepest overlap in every 20th step
};

/// What one run of a scene came to.
struct Result {
    RunOptions options;
    int size = 0;
    int steps = 0;
    std::size_t bodies = 0; // at the end, without the locked ones
    std::size_t locked = 0;
    double cpuSeconds = 0; // of the thread, in the steps alone
    double wallSeconds = 0;
    Depths depths;                      // at the end
    std::optional<double> deepest;      // m, of every 20th step
    std::optional<std::size_t> escaped; // empty: the scene has no bounds
    Drift drift;
    double kineticEnergy = 0; // J
    double mass = 0;          // kg
    std::uint64_t stateHash = 0;
    std::string errorName;
    std::string errorUnit;
    std::optional<double> error;
    std::vector<StageTime> stages;
    std::optional<double> pairWorkPerStep; // ns: see Engine::pairWork()
    double allocationsPerStep = 0;         // of the later half of the steps
    double bytesPerBody = 0; // of the heap, for all that the engine holds, locked bodies too
    std::optional<ContactBytes> contactBytes;

    double cpuMsPerStep() const { return 1e3 * cpuSeconds / steps; }
    double wallMsPerStep() const { return 1e3 * wallSeconds / steps; }
    double nsPerBodyStep() const {
        return bodies == 0 ? 0 : 1e9 * cpuSeconds / steps / static_cast<double>(bodies);
    }
};

/// Throws WrongUse when the options ask for what is not there.
Result run(const RunOptions& options);

} // namespace bench
