// SPDX-License-Identifier: MIT
// Any text as a level: it is refused with a sentence, or it can be played.
#include <apart/core/game.hpp>
#include <apart/core/level_file.hpp>

#include <fuzz/fuzz.hpp>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = apart::parseLevel(fuzz::textOf(data, size), "fuzz", "fuzz.toml");
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        fuzz::require(!problem->reason.empty(), "a level is refused without a reason");
        return 0;
    }
    apart::Game game(std::get<apart::Level>(read), 1);
    for (int tick = 0; tick < 30; ++tick) {
        game.tick({});
    }
    return 0;
}
