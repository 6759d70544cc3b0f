// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/play/games.hpp>
#include <apart/stage/records/replay_store.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr std::uint32_t kDemoTicks = 60 * kTicksPerSecond; // until the bot shows the next level

} // namespace

void Games::begin(std::size_t level) {
    keep();
    level_ = level;
    run_ = {};
    beginOwn(source_.levels[level], source_.seed + started_);
}

void Games::beginRun(Day day) {
    keep();
    run_ = {};
    run_.day = day;
    run_.seed = source_.endlessSeed ? source_.endlessSeed() : source_.seed;
    beginEndless(day > 0 ? 1 : std::max(source_.firstEndless, 1u));
}

void Games::nextOfRun() {
    run_.score += session_.game().score();
    run_.before = record();
    beginEndless(run_.number + 1);
}

void Games::beginEndless(std::uint32_t number) {
    run_.number = number;
    if (run_.day > 0) {
        beginOwn(source_.daily(run_.day, number), dailySeed(run_.day, number));
    } else {
        beginOwn(source_.endless(run_.seed, number), source_.seed + started_);
    }
}

void Games::beginTry(std::unique_ptr<Play> play) {
    run_ = {};
    enter(std::move(play), Session::Kind::Own);
}

void Games::show(Show show) {
    first_ = std::move(show);
    theatre_.begin(*first_);
    enterShow();
}

bool Games::showNext(std::string& problem) {
    if (!theatre_.next(problem)) {
        return false;
    }
    enterShow();
    return true;
}

void Games::demo(std::size_t level, bool tours) {
    keep();
    level_ = level;
    tours_ = tours;
    run_ = {};
    const Profile& profile = records_.profile();
    enter(std::make_unique<Play>(source_.levels[level], source_.seed + started_, profile.mode,
                                 profile.audible()),
          Session::Kind::Demo);
}

void Games::again() {
    if (session_.isShow() || session_.isWhatIf()) {
        theatre_.begin(*first_);
        enterShow();
    } else if (run_.number > 0) {
        beginRun(run_.day);
    } else {
        begin(level_);
    }
}

/// A game of the player, with the ghost of an earlier one.
void Games::beginOwn(std::shared_ptr<const Level> level, std::uint32_t seed) {
    const Profile& profile = records_.profile();
    enter(std::make_unique<Play>(std::move(level), seed, profile.mode, profile.audible()),
          Session::Kind::Own);
    ++started_;
    const Game& game = session_.game();
    records_.checkFirst(profile.mode, run_.keyOf(game));
    if (run_.number > 0 || profile.settings.ghost == 0 || source_.pilot) {
        return;
    }
    const std::optional<Replay>& rival = source_.rival;
    const bool rivals =
        rival && rival->level == game.level().name && !refusal(*rival, game.level());
    std::optional<Replay> other = rivals ? rival : records_.bestGame(profile.mode, game.level());
    if (other) {
        session_.setGhost(Ghost(std::move(*other), session_.play().sharedLevel()));
    }
}

void Games::enterShow() {
    const Show& show = theatre_.show();
    enter(std::make_unique<Play>(show.level, show.seed, show.mode, records_.profile().audible()),
          Session::Kind::Show);
    session_.compareWith(show.hashes);
}

void Games::enter(std::unique_ptr<Play> play, Session::Kind kind) {
    keep();
    session_.begin(std::move(play), kind);
    end_ = {};
}

void Games::tick(std::optional<Input> input, Speaker& speaker) {
    const Settings& settings = records_.profile().settings;
    const Game& game = session_.game();
    if (session_.isDemo()) {
        SilentSpeaker silence;
        const std::optional<Input> wish = source_.bot ? source_.bot(game) : Input{};
        session_.tick(wish.value_or(Input{}), settings, silence);
        if (session_.overdue() || session_.game().ticks() >= kDemoTicks) {
            const std::size_t offered = level_;
            demo(tours_ ? demos_++ % source_.levels.size() : offered, tours_);
            level_ = offered;
        }
        return;
    }
    if (const Pilot& pilot = session_.isShow() ? theatre_.show().pilot : source_.pilot) {
        input = pilot(game);
    }
    session_.tick(input, settings, speaker);
}

void Games::keep() {
    if (session_.takeUncounted() && !source_.pilot && isRecorded(session_.game().level())) {
        records_.count(session_.game().level().theme,
                       session_.statistics().totalsOf(session_.game()));
    }
    if (session_.takeUnkept() && isRecorded(session_.game().level())) {
        records_.keepLast(record());
    }
}

void Games::finish() {
    session_.endFanfare();
    const Game& game = session_.game();
    end_.entered = !source_.pilot && session_.kind() == Session::Kind::Own &&
                   isRecorded(game.level()) && game.result() != Result::Playing;
    if (end_.entered) {
        session_.takeUnkept(); // enter() keeps it
        keep();
        const std::string key = run_.keyOf(game);
        Best best = session_.statistics().bestOf(
            game, run_.number > 0 ? nullptr : marksFor(key, records_.marks()));
        best.score += run_.number > 0 ? run_.score : 0;
        end_.newBest = records_.enter({{game.mode(), key}, best, record()});
    }
    end_.rerun = session_.rerun();
}

bool Games::hasStake() const {
    const bool own = session_.kind() == Session::Kind::Own || session_.isWhatIf();
    const bool points = session_.game().score() > 0 || run_.score > 0;
    return own && points && session_.game().result() == Result::Playing;
}

} // namespace apart
