// SPDX-License-Identifier: MIT
// What the panel says beside what it reads from the game.
#include <apart/core/endless.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace apart {

namespace {

/// Position of a level in the list, or in an endless run, or in the daily run of a day.
std::string placeOf(const Level& level, const LevelList& levels, std::uint32_t number, Day day) {
    const std::optional<EndlessName> row = parseEndless(level.name);
    if (row || number > 0) {
        number = row ? row->number : number;
        return day > 0 ? fmt::format("{}, level {}", dailyName(day), number)
                       : fmt::format("ENDLESS {}", number);
    }
    const auto found = std::find_if(levels.begin(), levels.end(), [&](const auto& other) {
        return other->name == level.name && digestOf(*other) == digestOf(level);
    });
    if (found == levels.end()) {
        return "A LEVEL OF ITS OWN";
    }
    return fmt::format("LEVEL {} OF {}", found - levels.begin() + 1, levels.size());
}

/// The replay and the time at which the player took over.
std::string takenOverText(const ReplayList& list, const Theatre& theatre, std::uint32_t tick) {
    const bool listed = list.shown && *list.shown < list.entries.size();
    const std::string date = listed ? list.entries[*list.shown].date + " " : "";
    return fmt::format("replay {}at {}", date, theatre.timeText(tick));
}

/// The next medal, and the honours of a level beside its ways down.
void takeMarks(HudLook& look, const Session& session, const MedalMarks& marks) {
    const Game& game = session.game();
    const std::span<const MedalMarks> all{&marks, 1};
    const auto medal = static_cast<std::size_t>(medalOf(game.score(), marks.level, all));
    if (const std::int32_t next = nextMark(game.score(), marks.level, all); next > 0) {
        look.medal = fmt::format("{} from {}", kMedalNames[medal + 1], grouped(next));
    }
    if (marks.fewHits > 0) {
        look.honours.push_back(
            {countText(marks.fewHits, "hit") + " at most",
             game.result() != Result::Lost && game.counts().hits <= marks.fewHits});
    }
    if (marks.oneFall > 0) {
        look.honours.push_back({fmt::format("a fall of {}", marks.oneFall),
                                session.statistics().largestFall >= marks.oneFall});
    }
}

} // namespace

HudLook hudLookOf(const Stage& stage) {
    HudLook look;
    const Session& session = stage.session();
    const EndlessRun& run = stage.games_.run();
    const bool replay = session.isShow() || session.isWhatIf();
    look.place = placeOf(stage.session().game().level(), stage.def_.levels, run.number,
                         replay ? stage.games_.theatre().show().day : run.day);
    look.scoreBefore = run.number > 0 ? run.score : 0;
    look.best = stage.records_.provedScore(stage.session().game().mode(),
                                           run.keyOf(stage.session().game()));
    look.ticks = session.clock();
    const MedalMarks* marks =
        run.number > 0 ? nullptr : marksFor(session.game().level().name, stage.records_.marks());
    if (marks != nullptr) {
        takeMarks(look, session, *marks);
    }
    if (session.game().result() != Result::Lost) { // a way counts if the level is won
        look.ways = session.statistics().way.ways(session.game().level());
    }
    if (stage.editor_) {
        look.place = "TRY OF " + shortened(stage.editor_->document().level()->name, 24);
        look.foot = "escape: back to the editor";
    }
    look.keys = stage.records_.profile().bindings;
    look.muted = stage.records_.profile().audible().sound == 0;
    if (session.isShow()) {
        look.pilot = stage.games_.theatre().paused()
                         ? "REPLAY  paused"
                         : "REPLAY  " + stage.games_.theatre().speedText() + " x";
        look.foot = stage.games_.theatre().timeText(session.clock());
    } else if (session.isWhatIf()) {
        look.pilot = "WHAT IF   no score";
        look.takenOver = true;
        look.foot =
            takenOverText(stage.watched_.list, stage.games_.theatre(), session.takenOverAt());
    }
    return look;
}

} // namespace apart
