// SPDX-License-Identifier: MIT
#include <solve/strategy_scenes.hpp>

#include <chrono>
#include <cstdio>

// What each strategy makes of each scene, as a Markdown table. Nothing may rest meanwhile, since
// that would hide what a solver cannot hold.
int main() {
    using namespace strategies;
    std::printf("Answer, deepest overlap of the last second (mm), visits to contacts a step, "
                "time a step (us). Steps of 1/60 s, nothing rests.\n\n| scene | question |");
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
            settings.leaveOut |= static_cast<std::uint8_t>(kodo::Feature::Resting);
            const auto start = std::chrono::steady_clock::now();
            const Outcome outcome = run(trial, settings);
            const std::chrono::duration<double, std::micro> took =
                std::chrono::steady_clock::now() - start;
            std::printf(" %s, %.2f, %.0f, %.0f |", outcome.yes ? "yes" : "**no**",
                        1000 * static_cast<double>(outcome.depth), outcome.visitsPerStep,
                        took.count() / (trial.seconds * 60));
        }
    }
    std::printf("\n");
    return 0;
}
