// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

/// Sound of a menu; `sound` in percent.
void chirp(Speaker& speaker, int sound, bool chosen) {
    const float volume = (chosen ? 1 : 0.6f) * share(sound);
    if (volume > 0) {
        speaker.play({Voice::Choose, chosen ? 1.5f : 1, volume, 0});
    }
}

/// Adds the scores of the profile to recordings that do not note their own.
std::vector<ShowEntry> withScores(std::vector<ShowEntry> replays, const Profile& profile) {
    for (ShowEntry& replay : replays) {
        const Best best =
            replay.best ? profile.bestOf(replay.best->first, replay.best->second) : Best{};
        if (!replay.score && best.score > 0) {
            replay.score = best.score;
        }
    }
    return replays;
}

bool anything(const Signals& signals) {
    return signals.anyKey || !signals.commands.empty() || signals.clicked ||
           signals.pointer.has_value();
}

/// Checks the scores that the title shows.
void checkRuns(Records& records, Day today) {
    records.checkFirst(records.profile().mode, dailyKey(today));
    records.checkFirst(records.profile().mode, kEndlessKey);
}

/// Checks the scores of the chosen level first, then all others.
void checkScores(Records& records, const LevelList& levels, std::size_t chosen) {
    const Mode mode = records.profile().mode;
    for (Mode each = next(mode); each != mode; each = next(each)) {
        records.checkFirst(each, levels[chosen]->name);
    }
    records.checkFirst(mode, levels[chosen]->name);
    for (const auto& level : levels) {
        records.checkLast(mode, level->name);
    }
}

} // namespace

void Stage::open(Screen screen, Menu menu) {
    screen_ = screen;
    menu_ = std::move(menu);
}

TitleOffer offerOf(const StageDef& def, std::size_t level) {
    return {fmt::format("Play   {}  {}", level + 1, shortened(def.levels[level]->title, 32)),
            def.endless != nullptr, def.today && def.daily ? def.today() : 0, def.quits};
}

void Stage::toTitle() {
    screen_ = Screen::Title;
    games_.choose(map_.nextLevel(records_));
    games_.demo(games_.level(), true);
    if (def_.endless) {
        checkRuns(records_, offerOf(def_, games_.level()).today);
    }
    open(Screen::Title, titleMenu(offerOf(def_, games_.level()), records_));
}

/// `duel`: the chosen level is played by two players.
void Stage::toLevels(bool duel) {
    screen_ = Screen::Levels;
    map_.setDuel(duel);
    map_.update(records_);
    map_.choose(games_.level());
    games_.demo(games_.level(), false);
    checkScores(records_, def_.levels, map_.chosen());
}

/// The game goes on, or begins.
void Stage::toGame() {
    screen_ = Screen::Playing;
    inputMapper_.letGo();
}

void Stage::toReplays() {
    if (!session().isDemo()) {
        games_.choose(map_.nextLevel(records_));
        games_.demo(games_.level(), true);
    }
    watched_.list.entries = withScores(def_.replays(), records_.profile());
    open(Screen::Replays, replaysMenu(watched_.list.entries));
    menu_.chooseAt(watched_.list.shown.value_or(0));
}

void Stage::toOptions(int page) {
    pages_.behind = screen_ == Screen::Options ? pages_.behind : screen_;
    pages_.dials = page % static_cast<int>(kDialPages.size());
    open(Screen::Options, optionsMenu(records_.profile().settings, pages_.dials));
}

void Stage::take(const Signals& signals, Speaker& speaker) {
    if (signals.closed) {
        return quit();
    }
    const bool asleep = attracting();
    if (anything(signals)) {
        idleSeconds_ = 0;
        if (asleep) {
            return; // the first input only restores the menu
        }
    }
    // Commands of one frame are handled one by one: the first may change the screen.
    Signals one = signals;
    one.commands.resize(std::min<std::size_t>(signals.commands.size(), 1));
    takeOne(one, speaker);
    one.pointer.reset();
    one.presses.clear();
    one.moved = 0;
    for (SeatSignals& seat : one.seats) {
        seat.serves = false;
    }
    one.clicked = one.focusLost = false;
    for (std::size_t i = 1; i < signals.commands.size(); ++i) {
        one.commands = {signals.commands[i]};
        takeOne(one, speaker);
    }
}

void Stage::takeOne(const Signals& signals, Speaker& speaker) {
    if (screen_ == Screen::Keys) { // before all commands: a key may be about to change
        return takeKeys(signals, speaker);
    }
    if (editor_ && takeEditor(signals)) { // its keys have meanings of their own
        return;
    }
    if (screen_ == Screen::Over && over_.take(signals, games_, def_.sharing)) {
        return;
    }
    if (!signals.commands.empty() && signals.commands[0] == Command::Mute) {
        records_.profile().muted = !records_.profile().muted;
        games_.session().setSettings(records_.profile().audible());
        return records_.save();
    }
    switch (screen_) {
    case Screen::Levels:
        return takeLevels(signals, speaker);
    case Screen::Playing:
        return session().isShow() ? takeShow(signals) : takePlaying(signals);
    case Screen::Duel:
        return takeDuel(signals) ? chirp(speaker, records_.profile().audible().sound, true)
                                 : void();
    case Screen::BossCard:
        if (signals.clicked || !signals.commands.empty()) {
            toGame();
        }
        return;
    default:
        return takeMenu(signals, speaker);
    }
}

void Stage::takeKeys(const Signals& signals, Speaker& speaker) {
    const Bindings before = records_.profile().bindings;
    const bool left = pages_.keys.take(signals, records_.profile().bindings);
    if (left || records_.profile().bindings != before) {
        chirp(speaker, records_.profile().audible().sound, true);
    }
    if (left) {
        open(Screen::Options, optionsMenu(records_.profile().settings, 0));
        menu_.choose(Action::Keys);
    }
}

void Stage::takeLevels(const Signals& signals, Speaker& speaker) {
    const auto pressed = [&](Command command) {
        return std::count(signals.commands.begin(), signals.commands.end(), command) > 0;
    };
    const std::size_t before = map_.chosen();
    map_.point(signals, seconds_);
    if (pressed(Command::Back) ||
        (signals.clicked && map_.backPlace().contains(signals.pointerNow))) {
        return toTitle();
    }
    if (def_.edit && (map_.wantsNew(signals) || map_.wantsEdit(signals))) {
        const bool fresh = map_.wantsNew(signals);
        return edit(def_.edit(fresh ? nullptr : def_.levels[map_.shown()].get()));
    }
    if (const std::optional<std::size_t> level = map_.take(signals)) {
        chirp(speaker, records_.profile().audible().sound, true);
        map_.forDuel() ? beginDuel(*level) : begin(*level, true);
    } else if (map_.chosen() != before) {
        chirp(speaker, records_.profile().audible().sound, false);
        games_.demo(map_.chosen(), false);
        checkScores(records_, def_.levels, map_.chosen());
    }
}

/// Shortcuts that do not depend on the chosen item.
bool Stage::takeShortcut(Command command) {
    const bool paused = screen_ == Screen::Paused;
    const bool over = screen_ == Screen::Over;
    if (command == Command::Back) {
        back();
        return true;
    }
    if (pages_.help && screen_ == Screen::Help &&
        (command == Command::Left || command == Command::Right)) {
        pages_.help->turn();
        return true;
    }
    if (command == Command::Pause && paused) {
        back();
        return true;
    }
    if (command == Command::Restart && (paused || over)) {
        if (mayEnd(Ending::Restart)) {
            games_.again();
            toGame();
        }
        return true;
    }
    if (command == Command::Next && over && menu_.items()[0].action == Action::NextLevel) {
        next();
        return true;
    }
    return false;
}

/// True if no points are lost by it, or if it was asked for twice.
bool Stage::mayEnd(Ending ending) {
    return !games_.hasStake() || confirm_.ask(ending, seconds_);
}

void Stage::quit() {
    const bool fanfare = screen_ == Screen::Playing && session().kind() == Session::Kind::Own &&
                         session().game().result() != Result::Playing;
    if (fanfare) {
        finish(); // its result is not entered yet
    }
    quit_ = true;
    games_.keep();
    records_.close();
}

void Stage::back() {
    switch (screen_) {
    case Screen::Title:
        return def_.quits && confirm_.ask(Ending::Quit, seconds_) ? quit() : void();
    case Screen::Paused:
        return toGame();
    case Screen::Options:
    case Screen::Help: {
        const Action left = screen_ == Screen::Options ? Action::Options : Action::Help;
        records_.save();
        pages_.help.reset();
        if (pages_.behind == Screen::Title) {
            toTitle();
        } else if (pages_.behind == Screen::Duel) {
            screen_ = Screen::Duel;
            return;
        } else {
            open(Screen::Paused, pauseMenu(watched_.list.leadsFrom(session())));
        }
        return menu_.choose(left);
    }
    case Screen::Replays:
        return open(Screen::Records, recordsMenu(true));
    case Screen::Records:
        toTitle();
        return menu_.choose(Action::Records);
    default:
        return screen_ == Screen::Over && watched_.list.leadsFrom(session())
                   ? act({Action::Replays})
                   : toTitle();
    }
}

void Stage::takeMenu(const Signals& signals, Speaker& speaker) {
    for (const Command command : signals.commands) {
        if (takeShortcut(command)) {
            return;
        }
    }
    if (signals.clicked && pages_.help && screen_ == Screen::Help) {
        const bool leaves = records_.profile().bindings.fingers && pages_.help->showsPowers();
        return leaves ? back() : pages_.help->turn(); // a finger has no key to leave by
    }
    Signals heard = signals;
    if (!takesChoice()) {
        heard.commands.clear();
        heard.clicked = false;
    }
    const std::size_t before = menu_.chosen();
    const std::optional<MenuOutcome> outcome = menu_.take(heard);
    if (outcome || menu_.chosen() != before) {
        chirp(speaker, records_.profile().audible().sound, outcome.has_value());
    }
    if (!outcome && menu_.chosen() != before) {
        confirm_.withdraw(); // another item is chosen
    }
    if (outcome) {
        act(*outcome);
    }
}

void Stage::act(const MenuOutcome& outcome) {
    const auto turn = [&](std::size_t dial, int percent) {
        records_.profile().settings.*kDials[dial].value = percent;
        menu_.setPercent(dial, percent);
        games_.session().setSettings(records_.profile().audible());
    };
    switch (outcome.action) {
    case Action::Play:
        return begin(games_.level(), true);
    case Action::Levels:
        return mayEnd(Ending::Levels) ? toLevels() : void();
    case Action::Duel:
        return toLevels(true);
    case Action::Endless:
        games_.beginRun(0);
        return toGame();
    case Action::Daily:
        games_.beginRun(offerOf(def_, games_.level()).today);
        return toGame();
    case Action::Records:
        return open(Screen::Records, recordsMenu(def_.replays != nullptr));
    case Action::Replays:
        return mayEnd(Ending::Replays) ? toReplays() : void();
    case Action::Replay: {
        std::variant<Show, std::string> read = watched_.list.entries[outcome.dial].load();
        if (auto* show = std::get_if<Show>(&read)) {
            watched_.list.shown = outcome.dial;
            games_.show(std::move(*show));
            return toGame();
        }
        records_.note(std::get<std::string>(read));
        return toTitle();
    }
    case Action::Help:
        pages_.behind = screen_;
        pages_.help.emplace(records_.profile().audible());
        return open(Screen::Help, helpMenu());
    case Action::Mode:
        records_.profile().mode = apart::next(records_.profile().mode);
        games_.choose(map_.nextLevel(records_));
        checkRuns(records_, offerOf(def_, games_.level()).today);
        records_.save(); // a page may be closed at any time
        return refreshTitle(menu_, offerOf(def_, games_.level()), records_);
    case Action::Options:
        return toOptions();
    case Action::Keys:
        pages_.keys = {};
        return open(Screen::Keys, {});
    case Action::Quit:
    case Action::Back:
    case Action::Resume:
        return back();
    case Action::Restart:
        if (mayEnd(Ending::Restart)) {
            games_.again();
            toGame();
        }
        return;
    case Action::NextLevel:
        return next();
    case Action::ToTitle:
        return mayEnd(Ending::Title) ? toTitle() : void();
    case Action::Page:
        toOptions(pages_.dials + 1);
        return menu_.choose(Action::Page);
    case Action::Reset:
        if (records_.profile().settings == Settings{} || confirm_.ask(Ending::Settings, seconds_)) {
            for (std::size_t i = 0; i < kDials.size(); ++i) {
                turn(i, Settings{}.*kDials[i].value);
            }
        }
        return;
    case Action::Dial:
        return turn(outcome.dial, outcome.percent);
    }
}

} // namespace apart
