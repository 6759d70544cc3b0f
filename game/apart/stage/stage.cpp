// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/own_levels.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

// Ticks of the check of a score in one frame; a tick of a busy level takes 0.04 ms.
constexpr std::uint32_t kCheckInMenus = 150;
constexpr std::uint32_t kCheckInGames = 30;
constexpr double kAttractSeconds = 20;                     // without input
constexpr std::uint32_t kDemoTicks = 60 * kTicksPerSecond; // until the bot shows the next level

/// Continuous sounds of the game, or of a duel; a menu muffles them, and the bot's game behind one
/// makes none.
SoundScene soundOf(const Session& session, bool playing, const Settings& settings,
                   const Duel* duel) {
    const bool own = playing && session.kind() != Session::Kind::Demo;
    SoundScene scene = duel != nullptr ? duel->sound()
                       : own           ? sceneOf(session.game())
                                       : SoundScene{};
    playing = duel != nullptr ? duel->phase() == Duel::Phase::Playing : playing;
    scene.theme = session.game().level().theme;
    scene.muffled = !playing;
    scene.volume = share(settings.sound);
    scene.music = share(settings.music) * (playing ? 1.0f : 0.7f);
    return scene;
}

/// The notices at the start: the first error of the levels that are left out, with the number of
/// the others, and the rest.
std::vector<std::string> noticesOf(const StageDef& def) {
    std::vector<std::string> all = def.notices;
    if (!def.leftOut.empty()) {
        std::string first = def.leftOut[0];
        if (def.leftOut.size() > 1 && first.ends_with('.')) {
            first.pop_back();
            first += fmt::format(", and {} more.", def.leftOut.size() - 1);
        }
        all.insert(all.begin(), first);
    }
    return all;
}

/// About a replay that is not the recorded game.
std::string divergenceText(const Session& session) {
    return fmt::format("The replay diverges from the recording at {}.",
                       clockText(session.divergedAt().value_or(0)));
}

/// Text about a game that is over.
std::vector<std::string> notesOf(const Session& session, const Records& records) {
    if (session.isShow()) {
        return session.divergedAt() ? std::vector{divergenceText(session)}
                                    : std::vector<std::string>{};
    }
    const Level& level = session.game().level();
    const Standing standing = records.standingOf(session.game().mode(), level.name);
    if (standing.proof == Proof::Older && standing.note == kOlderLevel) {
        return {fmt::format("{} of an earlier content of the level are kept, but are no mark any "
                            "more.",
                            countText(standing.score, "point"))};
    }
    if (session.kind() == Session::Kind::Own && !isRecorded(level)) {
        return {level.name + " is played without scores, honours and replays."};
    }
    return {};
}

} // namespace

Stage::Stage(StageDef def)
    : def_(std::move(def)),
      records_(std::move(def_.profile), def_.pilot ? Keeping{} : std::move(def_.keeping),
               std::move(def_.scores), noticesOf(def_)),
      map_(def_.levels, def_.campaign) {
    records_.setMarks(std::move(def_.marks));
    records_.checkDoubtful();
    if (!profile().mapped) {
        records_.profile().mapped = true;
        records_.profile().reached = reachedBy(def_.levels, profile());
    }
    played_.level = std::min(def_.firstLevel, def_.levels.size() - 1);
    if (def_.reload) {
        records_.setLevel(def_.levels[played_.level]);
    }
    if (def_.show) {
        played_.level = map_.nextLevel(records_);
        watched_.theatre.begin(*def_.show);
        enterShow();
    } else if (def_.firstEdit) {
        edit(std::move(*def_.firstEdit));
    } else if (def_.firstEndless > 0 || def_.firstDay > 0) {
        beginRun(def_.firstDay);
    } else if (def_.duel) {
        beginDuel(played_.level);
    } else if (def_.startAtOnce) {
        begin(played_.level);
    } else {
        played_.level = map_.nextLevel(records_);
        toTitle();
    }
}

/// Starts a game of the player.
void Stage::beginGame(std::shared_ptr<const Level> level, std::uint32_t seed) {
    const Mode mode = profile().mode;
    enter(std::make_unique<Play>(std::move(level), seed, mode, profile().audible()),
          Session::Kind::Own);
    ++played_.games;
    records_.checkFirst(mode, played_.endless.keyOf(game()));
    if (played_.endless.number > 0 || settings().ghost == 0 || def_.pilot) {
        return;
    }
    if (def_.rival && def_.rival->level == game().level().name &&
        !refusal(*def_.rival, game().level())) {
        return session_.setGhost(Ghost(*def_.rival, session_.play().sharedLevel()));
    }
    if (std::optional<Replay> best = records_.bestGame(mode, game().level())) {
        session_.setGhost(Ghost(std::move(*best), session_.play().sharedLevel()));
    }
}

void Stage::enterShow() {
    const Show& show = watched_.theatre.show();
    enter(std::make_unique<Play>(show.level, show.seed, show.mode, profile().audible()),
          Session::Kind::Show);
    session_.compareWith(show.hashes);
}

void Stage::enter(std::unique_ptr<Play> play, Session::Kind kind) {
    keepGame();
    session_.begin(std::move(play), kind);
    over_.rerun.reset();
    watched_.divergence = {};
    reload_.due = false;
    screen_ = Screen::Playing;
    inputMapper_.letGo();
}

/// `namesBoss`: a boss without a result yet is named before the game.
void Stage::begin(std::size_t level, bool namesBoss) {
    keepGame();
    played_.level = level;
    played_.endless = {};
    const bool isFirst = !isPlayed(*def_.levels[level], profile());
    beginGame(def_.levels[level], def_.seed + played_.games);
    if (namesBoss && isFirst && map_.stops()[level].boss) {
        screen_ = Screen::BossCard;
        over_.seconds = 0;
    }
}

void Stage::beginEndless(std::uint32_t number) {
    played_.endless.number = number;
    if (played_.endless.day > 0) {
        beginGame(def_.daily(played_.endless.day, number), dailySeed(played_.endless.day, number));
    } else {
        beginGame(def_.endless(played_.endless.seed, number), def_.seed + played_.games);
    }
}

/// Starts the daily run of a day, or an endless run if it is 0.
void Stage::beginRun(Day day) {
    keepGame();
    played_.endless = {};
    played_.endless.day = day;
    played_.endless.seed = def_.endlessSeed ? def_.endlessSeed() : def_.seed;
    beginEndless(day > 0 ? 1 : std::max(def_.firstEndless, 1u));
}

void Stage::again() {
    if (session_.isShow() || session_.isWhatIf()) {
        watched_.theatre.begin(*def_.show);
        return enterShow();
    }
    if (played_.endless.number == 0) {
        return begin(played_.level);
    }
    beginRun(played_.endless.day);
}

void Stage::next() {
    if (played_.endless.number == 0 && map_.isLastBoss(played_.level)) {
        open(Screen::Ending, endingMenu());
    } else if (played_.endless.number > 0) {
        played_.endless.score += session_.game().score();
        played_.endless.before = played_.endless.with(session_.record());
        beginEndless(played_.endless.number + 1);
    } else {
        begin(std::min(played_.level + 1, def_.levels.size() - 1), true);
    }
}

/// Starts a game of the bot behind a menu.
void Stage::demo(std::size_t level) {
    const Screen screen = screen_;
    keepGame();
    played_.level = level;
    played_.endless = {};
    enter(std::make_unique<Play>(def_.levels[level], def_.seed + played_.games, profile().mode,
                                 profile().audible()),
          Session::Kind::Demo);
    screen_ = screen;
}

bool Stage::attracting() const {
    return screen_ == Screen::Title && idleSeconds_ > kAttractSeconds;
}

void Stage::advance(double seconds, const Signals& signals, Speaker& speaker) {
    seconds_ += seconds;
    over_.seconds += seconds;
    idleSeconds_ += seconds;
    take(signals, speaker);
    const bool dueling = screen_ == Screen::Duel;
    speaker.follow(soundOf(session_, screen_ == Screen::Playing, profile().audible(),
                           dueling ? duel_.get() : nullptr));
    reloadLevel();
    const bool playing = screen_ == Screen::Playing || dueling;
    if (records_.advance(playing ? kCheckInGames : kCheckInMenus, !playing) &&
        screen_ == Screen::Title) {
        played_.level = map_.nextLevel(records_);
        refreshTitle(menu_, offerOf(def_, played_.level), records_);
    }
    if (pages_.help && screen_ == Screen::Help) {
        pages_.help->advance(seconds);
    }
    const bool menu =
        screen_ == Screen::Options || screen_ == Screen::Keys || screen_ == Screen::Help;
    if (screen_ == Screen::Paused || screen_ == Screen::BossCard || (menu && !session_.isDemo())) {
        return;
    }
    if (screen_ == Screen::Editor) {
        return editor_->advance();
    }
    if (dueling) {
        return duel_->advance(seconds, profile().audible(), def_.pilot, speaker);
    }
    if (over_.rerun) {
        return over_.rerun->advance(seconds);
    }
    session_.elapse(seconds, session_.isShow() ? watched_.theatre.pace() : 1, settings());
    while (session_.takeTick()) {
        tick(speaker);
    }
    if (session_.isShow() && session_.divergedAt() && watched_.divergence.news.empty()) {
        watched_.divergence.news = divergenceText(session_);
        watched_.divergence.newsAt = seconds_;
    }
}

void Stage::tick(Speaker& speaker) {
    if (session_.isDemo()) {
        SilentSpeaker silence;
        const std::optional<Input> wish = def_.bot ? def_.bot(game()) : Input{};
        session_.tick(wish.value_or(Input{}), settings(), silence);
        if (session_.overdue() || game().ticks() >= kDemoTicks) {
            const std::size_t own = played_.level;
            demo(screen_ == Screen::Levels ? own : played_.demos++ % def_.levels.size());
            played_.level = own;
        }
        return;
    }
    std::optional<Input> input = inputMapper_.next();
    if (const Pilot& pilot = session_.isShow() ? watched_.theatre.show().pilot : def_.pilot) {
        input = pilot(game());
    }
    session_.tick(input, settings(), speaker);
    if (session_.overdue() && screen_ == Screen::Playing) {
        std::string problem;
        if (session_.isShow() && watched_.theatre.next(problem)) {
            return enterShow();
        }
        records_.note(problem);
        finish();
    }
}

/// Saves the replay of the player's game and counts it, whether it has ended or not. Once per game,
/// and not for a level that is not recorded.
void Stage::keepGame() {
    if (session_.takeUncounted() && !def_.pilot && isRecorded(game().level())) {
        records_.count(game().level().theme, session_.statistics().totalsOf(game()));
    }
    if (session_.takeUnkept() && isRecorded(game().level())) {
        records_.keepLast(played_.endless.with(session_.record()));
    }
}

void Stage::finish() {
    if (editor_) { // a try
        screen_ = Screen::Editor;
        return;
    }
    screen_ = Screen::Over;
    over_.seconds = 0;
    session_.endFanfare();
    const Game& game = session_.game();
    const std::string name = played_.endless.keyOf(game);
    const MedalMarks* marks =
        played_.endless.number > 0 ? nullptr : marksFor(name, records_.marks());
    Best best = session_.statistics().bestOf(game, marks);
    best.score += played_.endless.number > 0 ? played_.endless.score : 0;
    over_.newBest = false;
    over_.notes = notesOf(session_, records_);
    over_.entered = !def_.pilot && session_.kind() == Session::Kind::Own &&
                    isRecorded(game.level()) && game.result() != Result::Playing;
    if (over_.entered) {
        session_.takeUnkept(); // enter() keeps it
        keepGame();
        over_.newBest =
            records_.enter({{game.mode(), name}, best, played_.endless.with(session_.record())});
    }
    over_.rerun = session_.rerun();
    std::vector<MenuItem> items;
    map_.update(records_);
    const bool run = played_.endless.number > 0;
    const bool ends = !run && map_.isLastBoss(played_.level);
    const bool more =
        run || ends ||
        (played_.level + 1 < def_.levels.size() && map_.stops()[played_.level + 1].open());
    const bool won = game.result() == Result::Won && !session_.isShow();
    if (won && more) {
        items.push_back({Action::NextLevel, ends ? "The ending" : "Next level"});
    } else if (won && played_.level + 1 < def_.levels.size()) { // what the next level asks for
        items.push_back({Action::Levels, "Map"});
    }
    items.push_back({Action::Restart, session_.isShow() ? "Watch again" : "Play again"});
    if (watched_.list.leadsFrom(session_)) {
        items.push_back({Action::Replays, "All replays"});
    }
    if (items[0].action != Action::Levels) {
        items.push_back({Action::Levels, "Map"});
    }
    items.push_back({Action::ToTitle, "Title"});
    menu_ = Menu(std::move(items), Real(5.1));
}

} // namespace apart
