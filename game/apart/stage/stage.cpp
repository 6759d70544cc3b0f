// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/stage.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr double kAttractSeconds = 20;                     // without input
constexpr std::uint32_t kDemoTicks = 60 * kTicksPerSecond; // until the bot shows the next level
constexpr const char* kEndlessName = "endless";            // key of endless runs in the profile

/// Continuous sounds of the game; a menu muffles them, and the bot's game behind one makes none.
SoundScene soundOf(const Session& session, bool playing, const Settings& settings) {
    const bool own = playing && session.kind() != Session::Kind::Demo;
    SoundScene scene = own ? sceneOf(session.game()) : SoundScene{};
    scene.theme = session.game().level().theme;
    scene.muffled = !playing;
    scene.volume = share(settings.sound);
    scene.music = share(settings.music) * (playing ? 1.0f : 0.7f);
    return scene;
}

} // namespace

Stage::Stage(StageDef def) : def_(std::move(def)), select_(def_.levels) {
    level_ = std::min(def_.firstLevel, def_.levels.size() - 1);
    if (def_.show) {
        level_ = nextToPlay();
        beginShow();
    } else if (def_.firstEndless > 0) {
        beginEndless(def_.firstEndless);
    } else if (def_.startAtOnce) {
        begin(level_);
    } else {
        level_ = nextToPlay();
        toTitle();
    }
}

std::size_t Stage::nextToPlay() const {
    for (std::size_t i = 0; i < def_.levels.size(); ++i) {
        if (!def_.profile.bestOf(def_.profile.mode, def_.levels[i]->name).cleared) {
            return i;
        }
    }
    return 0;
}

Settings Stage::audible() const {
    Settings settings = def_.profile.settings;
    settings.sound = def_.profile.muted ? 0 : settings.sound;
    settings.music = def_.profile.muted ? 0 : settings.music;
    return settings;
}

void Stage::beginGame(std::shared_ptr<const Level> level, Session::Kind kind) {
    enter(
        std::make_unique<Play>(std::move(level), def_.seed + games_, def_.profile.mode, audible()),
        kind);
    games_ += kind == Session::Kind::Own ? 1 : 0;
}

void Stage::beginShow() {
    theatre_.begin();
    enter(std::make_unique<Play>(def_.show->level, def_.show->seed, def_.show->mode, audible()),
          Session::Kind::Show);
}

void Stage::enter(std::unique_ptr<Play> play, Session::Kind kind) {
    keepGame(false);
    session_.begin(std::move(play), kind);
    rerun_.reset();
    screen_ = Screen::Playing;
    inputMapper_.letGo();
}

void Stage::begin(std::size_t level) {
    level_ = level;
    endless_.number = 0;
    beginGame(def_.levels[level], Session::Kind::Own);
}

void Stage::beginEndless(std::uint32_t number) {
    endless_.number = number;
    beginGame(def_.endless(number), Session::Kind::Own);
}

void Stage::again() {
    if (showing()) {
        return beginShow();
    }
    if (endless_.number == 0) {
        return begin(level_);
    }
    endless_.score = 0;
    beginEndless(std::max(def_.firstEndless, 1u));
}

void Stage::next() {
    if (endless_.number > 0) {
        endless_.score += session_.game().score();
        beginEndless(endless_.number + 1);
    } else {
        begin(std::min(level_ + 1, def_.levels.size() - 1));
    }
}

/// Starts a game of the bot behind a menu.
void Stage::demo(std::size_t level) {
    const Screen screen = screen_;
    level_ = level;
    endless_.number = 0;
    beginGame(def_.levels[level], Session::Kind::Demo);
    screen_ = screen;
}

bool Stage::demoRuns() const {
    return session_.kind() == Session::Kind::Demo;
}

bool Stage::attracting() const {
    return screen_ == Screen::Title && idleSeconds_ > kAttractSeconds;
}

void Stage::advance(double seconds, const Signals& signals, Speaker& speaker) {
    seconds_ += seconds;
    overSeconds_ += seconds;
    idleSeconds_ += seconds;
    take(signals, speaker);
    speaker.follow(soundOf(session_, screen_ == Screen::Playing, audible()));
    reloadLevel();
    const bool menu = screen_ == Screen::Options || screen_ == Screen::Help;
    if (screen_ == Screen::Paused || (menu && !demoRuns())) {
        return;
    }
    if (rerun_) {
        return rerun_->advance(seconds);
    }
    session_.elapse(seconds, showing() ? theatre_.pace() : 1, settings());
    while (session_.takeTick()) {
        tick(speaker);
    }
}

void Stage::tickDemo() {
    SilentSpeaker silence;
    const std::optional<Input> input = def_.bot ? def_.bot(game()) : Input{};
    session_.tick(input.value_or(Input{}), settings(), silence);
    if (session_.overdue() || game().ticks() >= kDemoTicks) {
        const std::size_t own = level_;
        const std::size_t shown = screen_ == Screen::Levels ? own : demos_++ % def_.levels.size();
        demo(shown);
        level_ = own;
    }
}

void Stage::tick(Speaker& speaker) {
    if (demoRuns()) {
        return tickDemo();
    }
    std::optional<Input> input = inputMapper_.next();
    if (const Pilot& pilot = showing() ? def_.show->pilot : def_.pilot) {
        input = pilot(game());
    }
    session_.tick(input, settings(), speaker);
    if (session_.overdue() && screen_ == Screen::Playing) {
        finish();
    }
}

/// Saves the profile, except for games of a pilot.
void Stage::keep() {
    if (!def_.save || def_.pilot) {
        return;
    }
    note(def_.save(def_.profile));
}

/// Adds a notice unless it is already shown.
void Stage::note(std::string problem) {
    std::vector<std::string>& notices = def_.notices;
    if (!problem.empty() && std::find(notices.begin(), notices.end(), problem) == notices.end()) {
        notices.push_back(std::move(problem));
    }
}

/// Starts the level of a file again when the file has changed, or shows its errors.
void Stage::reloadLevel() {
    constexpr double kEvery = 0.5; // s
    if (!def_.reload || seconds_ < reloadAt_) {
        return;
    }
    reloadAt_ = seconds_ + kEvery;
    if (std::optional<LevelChange> change = def_.reload()) {
        faults_ = std::move(change->errors);
        if (change->level) {
            def_.levels[def_.firstLevel] = std::move(change->level);
            select_ = LevelSelect(def_.levels);
            if (screen_ == Screen::Playing && level_ == def_.firstLevel) {
                begin(level_);
            }
        }
    }
}

/// Saves the replay of the player's game, whether it has ended or not. Once per game.
void Stage::keepGame(bool best) {
    if (def_.pilot || !def_.keepReplay || !session_.takeUnkept()) {
        return;
    }
    if (const std::optional<Replay> record = session_.record()) {
        note(def_.keepReplay(*record, best));
    }
}

void Stage::finish() {
    screen_ = Screen::Over;
    overSeconds_ = 0;
    session_.endFanfare();
    const Game& game = session_.game();
    const std::string name = endless_.number > 0 ? kEndlessName : game.level().name;
    Best best = session_.statistics().bestOf(game);
    best.score += endless_.number > 0 ? endless_.score : 0;
    before_ = def_.profile.bestOf(game.mode(), name);
    newBest_ = false;
    if (!def_.pilot && session_.kind() == Session::Kind::Own && game.result() != Result::Playing) {
        newBest_ = def_.profile.enter(game.mode(), name, best);
        keep();
        keepGame(best.score > before_.score);
    }
    rerun_ = session_.rerun();
    std::vector<MenuItem> items;
    const bool more = endless_.number > 0 || level_ + 1 < def_.levels.size();
    if (game.result() == Result::Won && more && !showing()) {
        items.push_back({Action::NextLevel, "Next level"});
    }
    items.push_back({Action::Restart, showing() ? "Watch again" : "Play again"});
    items.push_back({Action::Levels, "All levels"});
    items.push_back({Action::ToTitle, "Title"});
    menu_ = Menu(std::move(items), Real(5.6));
}

} // namespace apart
