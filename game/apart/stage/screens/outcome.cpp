// SPDX-License-Identifier: MIT
#include <apart/core/replay_link.hpp>
#include <apart/stage/screens/outcome.hpp>

#include <algorithm>
#include <memory>

namespace apart {

bool Outcome::take(const Signals& signals, const Games& games, const Sharing& sharing) {
    const auto pressed = [&](const char* key) {
        const Press press{false, keyNamed(key).value_or(kNoKey)};
        return std::count(signals.presses.begin(), signals.presses.end(), press) > 0;
    };
    if (sharing.film && games.end().rerun && pressed("G")) {
        const auto game = games.session().record();
        const auto level = std::make_shared<const Level>(games.session().game().level());
        const auto fall = game ? largestFall(*game, level) : std::nullopt;
        notes = {fall ? sharing.film(fall->rerun) : "Nothing falls in this game."};
        return true;
    }
    const ReplayRun run = games.record();
    if (!sharing.copy || run.empty() || !pressed("C")) {
        return false;
    }
    DailyResult daily{games.run().day, games.run().score + games.session().game().score(),
                      run.size()};
    for (const Replay& replay : run) {
        daily.ticks += replay.end;
    }
    sharing.copy((daily.day > 0 ? dailyLine(daily) + "\n" : "") + linkOf(run));
    notes = {daily.day > 0 ? "Your result and a link to the run are copied."
                           : "A link to the game is copied."};
    return true;
}

} // namespace apart
