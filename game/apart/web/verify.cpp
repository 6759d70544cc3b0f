// SPDX-License-Identifier: MIT
// A page plays the game with the same bits as the program: shown by tests/browser/page_test.py.
#include <apart/core/assets.hpp>
#include <apart/core/replay_link.hpp>

#include <emscripten/emscripten.h>

#include <memory>
#include <string>
#include <utility>

namespace apart {
namespace {

std::string verdictOn(const std::string& file, const Replay& replay) {
    Read<Level> level = loadLevelOf(file, replay.level);
    if (const auto* problem = std::get_if<FileProblem>(&level)) {
        return problem->text();
    }
    auto shared = std::make_shared<const Level>(std::move(std::get<Level>(level)));
    if (const std::optional<std::string> reason = refusal(replay, *shared)) {
        return *reason;
    }
    Playback playback(replay, std::move(shared));
    while (!playback.done()) {
        playback.tick();
    }
    return replay.hashes.empty() ? "there is no hash line to verify"
           : playback.divergence()
               ? "differs at tick " + std::to_string(playback.divergence()->tick)
               : "";
}

std::string verdictOn(const std::string& file) {
    const Read<ReplayRun> run = readRunFile(file);
    if (const auto* problem = std::get_if<FileProblem>(&run)) {
        return problem->text();
    }
    std::string verdict;
    for (const Replay& replay : std::get<ReplayRun>(run)) {
        verdict = verdict.empty() ? verdictOn(file, replay) : verdict;
    }
    return verdict;
}

} // namespace
} // namespace apart

/// Plays a replay without a picture and compares its hashes: "" if all agree, else what does not.
/// Valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* verifyReplay(const char* file) {
    static std::string verdict;
    verdict = apart::verdictOn(file);
    return verdict.c_str();
}
