// SPDX-License-Identifier: MIT
#include <apart/core/replay_link.hpp>
#include <apart/stage/stage.hpp>

#include <algorithm>

namespace apart {

/// C copies a link to the game on the result screen; of a daily run its result in a line before it.
/// G writes a film of the fall behind it.
bool Stage::takeShare(const Signals& signals) {
    const auto pressed = [&](const char* key) {
        const Press press{false, keyNamed(key).value_or(kNoKey)};
        return std::count(signals.presses.begin(), signals.presses.end(), press) > 0;
    };
    if (def_.film && over_.rerun && pressed("G")) {
        over_.notes = {def_.film(*over_.rerun)};
        return true;
    }
    const ReplayRun run = played_.endless.with(session_.record());
    if (!def_.copy || run.empty() || !pressed("C")) {
        return false;
    }
    DailyResult daily{played_.endless.day, played_.endless.score + game().score(), run.size()};
    for (const Replay& replay : run) {
        daily.ticks += replay.end;
    }
    def_.copy((daily.day > 0 ? dailyLine(daily) + "\n" : "") + linkOf(run));
    over_.notes = {daily.day > 0 ? "Your result and a link to the run are copied."
                                 : "A link to the game is copied."};
    return true;
}

} // namespace apart
