// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/records/replay_store.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

// Ticks of the check of a score in one frame; a tick of a busy level takes 0.04 ms.
constexpr std::uint32_t kCheckInMenus = 150;
constexpr std::uint32_t kCheckInGames = 30;
constexpr double kAttractSeconds = 20; // without input

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
      games_(def_, records_),
      map_(def_.levels, def_.campaign) {
    records_.setMarks(std::move(def_.marks));
    records_.checkDoubtful();
    if (!records_.profile().mapped) {
        records_.profile().mapped = true;
        records_.profile().reached = reachedBy(def_.levels, records_.profile());
    }
    games_.choose(std::min(def_.firstLevel, def_.levels.size() - 1));
    if (def_.reload) {
        records_.setLevel(def_.levels[games_.level()]);
    }
    if (def_.show) {
        games_.choose(map_.nextLevel(records_));
        games_.show(std::move(*def_.show));
        toGame();
    } else if (def_.firstEdit) {
        edit(std::move(*def_.firstEdit));
    } else if (def_.firstEndless > 0 || def_.firstDay > 0) {
        games_.beginRun(def_.firstDay);
        toGame();
    } else if (def_.duel) {
        beginDuel(games_.level());
    } else if (def_.startAtOnce) {
        begin(games_.level());
    } else {
        games_.choose(map_.nextLevel(records_));
        toTitle();
    }
}

/// `namesBoss`: a boss without a result yet is named before the game.
void Stage::begin(std::size_t level, bool namesBoss) {
    const bool isFirst = !isPlayed(*def_.levels[level], records_.profile());
    games_.begin(level);
    toGame();
    if (namesBoss && isFirst && map_.stops()[level].boss) {
        screen_ = Screen::BossCard;
        over_.seconds = 0;
    }
}

void Stage::next() {
    if (games_.run().number > 0) {
        games_.nextOfRun();
        toGame();
    } else if (map_.isLastBoss(games_.level())) {
        over_.seconds = 0;
        open(Screen::Ending, endingMenu());
    } else {
        begin(std::min(games_.level() + 1, def_.levels.size() - 1), true);
    }
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
    speaker.follow(soundOf(session(), screen_ == Screen::Playing, records_.profile().audible(),
                           dueling ? duel_.get() : nullptr));
    reloadLevel();
    const bool playing = screen_ == Screen::Playing || dueling;
    if (records_.advance(playing ? kCheckInGames : kCheckInMenus, !playing) &&
        screen_ == Screen::Title) {
        games_.choose(map_.nextLevel(records_));
        refreshTitle(menu_, offerOf(def_, games_.level()), records_);
    }
    if (pages_.help && screen_ == Screen::Help) {
        pages_.help->advance(seconds);
    }
    const bool menu =
        screen_ == Screen::Options || screen_ == Screen::Keys || screen_ == Screen::Help;
    if (screen_ == Screen::Paused || screen_ == Screen::BossCard || (menu && !session().isDemo())) {
        return;
    }
    if (screen_ == Screen::Editor) {
        return editor_->advance();
    }
    if (dueling) {
        return duel_->advance(seconds, records_.profile().audible(), def_.pilot, speaker);
    }
    if (games_.end().rerun) {
        return games_.end().rerun->advance(seconds);
    }
    games_.session().elapse(seconds, session().isShow() ? games_.theatre().pace() : 1,
                            records_.profile().settings);
    while (games_.session().takeTick()) {
        games_.tick(inputMapper_.next(), speaker);
        if (session().overdue() && screen_ == Screen::Playing) {
            std::string problem;
            const bool goesOn = session().isShow() && games_.showNext(problem);
            records_.note(problem);
            goesOn ? toGame() : finish();
        }
    }
    if (!session().divergedAt()) {
        watched_.divergence = {};
    } else if (session().isShow() && watched_.divergence.news.empty()) {
        watched_.divergence.news = divergenceText(session());
        watched_.divergence.newsAt = seconds_;
    }
}

void Stage::finish() {
    if (editor_) { // a try
        screen_ = Screen::Editor;
        return;
    }
    screen_ = Screen::Over;
    over_ = {0, notesOf(session(), records_)};
    games_.finish();
    const Game& game = session().game();
    std::vector<MenuItem> items;
    map_.update(records_);
    const bool run = games_.run().number > 0;
    const bool ends = !run && map_.isLastBoss(games_.level());
    const bool more =
        run || ends ||
        (games_.level() + 1 < def_.levels.size() && map_.stops()[games_.level() + 1].open());
    const bool won = game.result() == Result::Won && !session().isShow();
    if (won && more) {
        items.push_back({Action::NextLevel, ends ? "The ending" : "Next level"});
    } else if (won && games_.level() + 1 < def_.levels.size()) { // what the next level asks for
        items.push_back({Action::Levels, "Map"});
    }
    items.push_back({Action::Restart, session().isShow() ? "Watch again" : "Play again"});
    if (watched_.list.leadsFrom(session())) {
        items.push_back({Action::Replays, "All replays"});
    }
    if (items[0].action != Action::Levels) {
        items.push_back({Action::Levels, "Map"});
    }
    items.push_back({Action::ToTitle, "Title"});
    menu_ = Menu(std::move(items), Real(5.1));
}

} // namespace apart
