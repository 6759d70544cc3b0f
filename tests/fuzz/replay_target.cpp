// SPDX-License-Identifier: MIT
// Any text as a replay: it is refused with a sentence, or its text gives the same replay again.
#include <apart/core/replay.hpp>

#include <fuzz/fuzz.hpp>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = apart::parseReplay(fuzz::textOf(data, size), "fuzz.replay");
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        fuzz::require(!problem->reason.empty(), "a replay is refused without a reason");
        return 0;
    }
    const apart::Replay& replay = std::get<apart::Replay>(read);
    const auto again = apart::parseReplay(apart::toText(replay), "again.replay");
    fuzz::require(std::holds_alternative<apart::Replay>(again), "a written replay is refused");
    apart::Replay other = std::get<apart::Replay>(again);
    fuzz::require(other.expectations.size() == replay.expectations.size(), "expectations are lost");
    for (std::size_t i = 0; i < other.expectations.size(); ++i) {
        other.expectations[i].line = replay.expectations[i].line; // comments are not written
    }
    fuzz::require(other == replay, "a written replay is another one");
    return 0;
}
