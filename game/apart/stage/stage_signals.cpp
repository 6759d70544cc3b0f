// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

constexpr double kPercent = 100;
constexpr std::size_t kMostReplays = 10; // in the list

std::string modeLabel(Mode mode) {
    return mode == Mode::Pure ? "\u2039  Pure: no path is ever bent  \u203a"
                              : "\u2039  Standard rules  \u203a";
}

std::string playLabel(std::size_t index, const Level& level) {
    return fmt::format("Play   {}  {}", index + 1, level.title);
}

/// Sound of a menu; `sound` in percent.
void chirp(Speaker& speaker, int sound, bool chosen) {
    const float volume = (chosen ? 1 : 0.6f) * share(sound);
    if (volume > 0) {
        speaker.play({Voice::Choose, chosen ? 1.5f : 1, volume, 0});
    }
}

bool anything(const Signals& signals) {
    return signals.anyKey || !signals.commands.empty() || signals.clicked ||
           signals.pointer.has_value();
}

} // namespace

void Stage::toTitle() {
    screen_ = Screen::Title;
    level_ = nextToPlay();
    demo(level_);
    std::vector<MenuItem> items = {{Action::Play, playLabel(level_, *def_.levels[level_])},
                                   {Action::Levels, "Choose a level"}};
    if (def_.endless) {
        items.push_back({Action::Endless, "Endless"});
    }
    items.push_back({Action::Mode, modeLabel(def_.profile.mode)});
    if (def_.replays) {
        items.push_back({Action::Replays, "Replays"});
    }
    items.push_back({Action::Help, "How to play"});
    items.push_back({Action::Options, "Options"});
    items.push_back({Action::Quit, "Quit"});
    menu_ = Menu(std::move(items), Real(10.2));
}

void Stage::toReplays() {
    screen_ = Screen::Replays;
    replays_ = def_.replays();
    replays_.resize(std::min(replays_.size(), kMostReplays));
    std::vector<MenuItem> items;
    for (std::size_t i = 0; i < replays_.size(); ++i) {
        items.push_back({Action::Replay, replays_[i].label, std::nullopt, i});
    }
    items.push_back({Action::Back, "Back"});
    menu_ = Menu(std::move(items), Real(13.2));
}

void Stage::toHelp() {
    behind_ = screen_;
    screen_ = Screen::Help;
    menu_ = Menu({{Action::Back, "Back"}}, Real(-2)); // below the picture
}

void Stage::toLevels() {
    screen_ = Screen::Levels;
    select_.choose(level_);
    demo(level_);
}

void Stage::toOptions(int page) {
    behind_ = screen_ == Screen::Options ? behind_ : screen_;
    screen_ = Screen::Options;
    optionsPage_ = page % static_cast<int>(kDialPages.size());
    std::vector<MenuItem> items;
    for (std::size_t i = 0; i < kDials.size(); ++i) {
        const Dial& dial = kDials[i];
        if (dial.page == optionsPage_) {
            items.push_back({Action::Dial, std::string(dial.label),
                             Gauge{settings().*dial.value, dial.least, dial.most, dial.words}, i});
        }
    }
    const std::string_view name = kDialPages[static_cast<std::size_t>(optionsPage_)];
    items.push_back({Action::Page, fmt::format("\u2039  {}  \u203a", name)});
    items.push_back({Action::Reset, "As they were at first"});
    items.push_back({Action::Back, "Back"});
    menu_ = Menu(std::move(items), Real(13.2));
}

void Stage::pause() {
    screen_ = Screen::Paused;
    menu_ = Menu({{Action::Resume, "Go on"},
                  {Action::Restart, "Restart"},
                  {Action::Help, "How to play"},
                  {Action::Options, "Options"},
                  {Action::Levels, "All levels"},
                  {Action::ToTitle, "Title"}},
                 Real(11.6));
}

void Stage::take(const Signals& signals, Speaker& speaker) {
    if (signals.closed) {
        quit_ = true;
        keepGame(false);
        return keep();
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
    one.moved = 0;
    one.clicked = one.focusLost = false;
    for (std::size_t i = 1; i < signals.commands.size(); ++i) {
        one.commands = {signals.commands[i]};
        takeOne(one, speaker);
    }
}

void Stage::takeOne(const Signals& signals, Speaker& speaker) {
    if (!signals.commands.empty() && signals.commands[0] == Command::Mute) {
        def_.profile.muted = !def_.profile.muted;
        session_.setSettings(audible());
        return keep();
    }
    switch (screen_) {
    case Screen::Levels:
        return takeLevels(signals, speaker);
    case Screen::Playing:
        return showing() ? takeShow(signals) : takePlaying(signals);
    default:
        return takeMenu(signals, speaker);
    }
}

void Stage::takeLevels(const Signals& signals, Speaker& speaker) {
    const auto pressed = [&](Command command) {
        return std::count(signals.commands.begin(), signals.commands.end(), command) > 0;
    };
    if (pressed(Command::Back) ||
        (signals.clicked && select_.backPlace().contains(signals.pointerNow))) {
        return toTitle();
    }
    const std::size_t before = select_.chosen();
    if (const std::optional<std::size_t> level = select_.take(signals)) {
        chirp(speaker, audible().sound, true);
        begin(*level);
    } else if (select_.chosen() != before) {
        chirp(speaker, audible().sound, false);
        demo(select_.chosen());
    }
}

void Stage::takePlaying(const Signals& signals) {
    const Game& game = session_.game();
    const Real paddleX = game.world()[game.paddle()].position().x;
    inputMapper_.take(signals, paddleX, static_cast<Real>(settings().mouse / kPercent));
    const bool over = game.result() != Result::Playing;
    const bool clickLaunches = game.serving() || game.secondsLeft(Power::Spring) > 0;
    if (signals.clicked && clickLaunches) {
        inputMapper_.launch();
    }
    if (signals.clicked && over) {
        return finish();
    }
    for (const Command command : signals.commands) {
        switch (command) {
        case Command::Launch:
        case Command::Confirm:
            if (over) {
                return finish();
            }
            inputMapper_.launch();
            break;
        case Command::Back:
        case Command::Pause:
            return over ? finish() : pause();
        case Command::Restart:
            if (over || game.score() == 0 || confirm_.ask(Command::Restart, seconds_)) {
                return again();
            }
            break;
        default:
            break;
        }
    }
    if (signals.focusLost && !over) {
        pause();
    }
}

void Stage::takeShow(const Signals& signals) {
    for (const Command command : signals.commands) {
        if (command == Command::Back) {
            return pause();
        }
        const Theatre::Request request = theatre_.take(command, game().ticks());
        if (request.tick) {
            session_.seek(*request.tick, def_.show->pilot, settings());
        }
        if (request.takeOver && game().result() == Result::Playing) {
            session_.takeOver();
            return inputMapper_.letGo();
        }
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
    if (command == Command::Pause && paused) {
        back();
        return true;
    }
    if (command == Command::Restart && (paused || over)) {
        again();
        return true;
    }
    if (command == Command::Next && over && menu_.items()[0].action == Action::NextLevel) {
        next();
        return true;
    }
    return false;
}

void Stage::back() {
    switch (screen_) {
    case Screen::Title:
        quit_ = confirm_.ask(Command::Back, seconds_);
        return quit_ ? keep() : void();
    case Screen::Paused:
        screen_ = Screen::Playing;
        return inputMapper_.letGo();
    case Screen::Options:
    case Screen::Help: {
        const Action left = screen_ == Screen::Options ? Action::Options : Action::Help;
        keep();
        if (behind_ == Screen::Title) {
            toTitle();
        } else {
            pause();
        }
        return menu_.choose(left);
    }
    default:
        return toTitle();
    }
}

void Stage::takeMenu(const Signals& signals, Speaker& speaker) {
    for (const Command command : signals.commands) {
        if (takeShortcut(command)) {
            return;
        }
    }
    const std::size_t before = menu_.chosen();
    const std::optional<MenuOutcome> outcome = menu_.take(signals);
    if (outcome || menu_.chosen() != before) {
        chirp(speaker, audible().sound, outcome.has_value());
    }
    if (outcome) {
        act(*outcome);
    }
}

void Stage::act(const MenuOutcome& outcome) {
    switch (outcome.action) {
    case Action::Play:
        return begin(level_);
    case Action::Levels:
        return toLevels();
    case Action::Endless:
        endless_.score = 0;
        return beginEndless(std::max(def_.firstEndless, 1u));
    case Action::Replays:
        return toReplays();
    case Action::Replay: {
        std::variant<Show, std::string> read = replays_[outcome.dial].load();
        if (auto* show = std::get_if<Show>(&read)) {
            def_.show = std::move(*show);
            return beginShow();
        }
        note(std::get<std::string>(read));
        return toTitle();
    }
    case Action::Help:
        return toHelp();
    case Action::Mode:
        def_.profile.mode = def_.profile.mode == Mode::Pure ? Mode::Standard : Mode::Pure;
        level_ = nextToPlay();
        menu_.setLabel(Action::Play, playLabel(level_, *def_.levels[level_]));
        return menu_.setLabel(Action::Mode, modeLabel(def_.profile.mode));
    case Action::Options:
        return toOptions();
    case Action::Quit:
    case Action::Back:
    case Action::Resume:
        return back();
    case Action::Restart:
        return again();
    case Action::NextLevel:
        return next();
    case Action::ToTitle:
        return toTitle();
    case Action::Page:
        toOptions(optionsPage_ + 1);
        return menu_.choose(Action::Page);
    case Action::Reset:
        for (std::size_t i = 0; i < kDials.size(); ++i) {
            turn(i, Settings{}.*kDials[i].value);
        }
        return;
    case Action::Dial:
        return turn(outcome.dial, outcome.percent);
    }
}

void Stage::turn(std::size_t dial, int percent) {
    def_.profile.settings.*kDials[dial].value = percent;
    menu_.setPercent(dial, percent);
    session_.setSettings(audible());
}

} // namespace apart
