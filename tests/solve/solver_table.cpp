// SPDX-License-Identifier: MIT
#include <solve/solver_scenes.hpp>

#include <cstdio>
#include <ctime>

// Prints the result of each solver in each scene as a Markdown table. Sleep is off, since it would
// hide what a solver cannot hold.
int main() {
    using namespace strategies;
    std::printf("Answer, deepest overlap of the last second (mm), visits of contacts a step, "
                "CPU time a step (us). Steps of 1/60 s, sleep off.\n\n| scene | question |");
    for (const Profile& profile : profiles()) {
        std::printf(" %s |", profile.name);
    }
    std::printf("\n|---|---|");
    for (std::size_t i = 0; i < profiles().size(); ++i) {
        std::printf("---|");
    }
    for (const Trial& trial : trials()) {
        std::printf("\n| %s | %s |", trial.scene.name.c_str(), trial.question);
        for (const Profile& profile : profiles()) {
            kodo::StepSettings settings = profile.settings;
            settings.leaveOut |= kodo::Feature::Sleep;
            const std::clock_t start = std::clock();
            const Outcome outcome = run(trial, settings);
            const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            std::printf(" %s, %.2f, %.0f, %.0f |", outcome.yes ? "yes" : "**no**",
                        1000 * static_cast<double>(outcome.depth), outcome.visitsPerStep,
                        1e6 * took / (trial.seconds * 60));
        }
    }
    std::printf("\n");
    return 0;
}
