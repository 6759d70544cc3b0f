// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/backdrop.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/layout.hpp>
#include <apart/stage/palette.hpp>
#include <apart/stage/stage.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kLongestFrame = 0.1;              // s; what a stall takes longer is lost
constexpr int kEndTicks = kTicksPerSecond * 5 / 4; // from the last event to the result

} // namespace

Stage::Stage(StageDef def)
    : def_(std::move(def)), title_(def_.levels.size()), best_(def_.levels.size(), 0) {
    level_ = std::min(def_.firstLevel, def_.levels.size() - 1);
    begin(level_);
    if (!def_.startAtOnce) {
        toTitle();
    }
}

void Stage::begin(std::size_t level) {
    level_ = level;
    play_ = std::make_unique<Play>(def_.levels[level], def_.seed + games_, def_.effects);
    ++games_;
    screen_ = Screen::Playing;
    hands_.letGo();
    owed_ = 0;
    endTicks_ = 0;
}

void Stage::toTitle() {
    begin(level_); // the bot shows it
    --games_;
    title_.choose(level_);
    screen_ = Screen::Title;
}

void Stage::advance(double seconds, const Signals& signals, Speaker& speaker) {
    seconds_ += seconds;
    take(signals, speaker);
    if (screen_ == Screen::Paused) {
        return;
    }
    owed_ += pace_.next(play_->game(), seconds) * std::min(seconds, kLongestFrame);
    for (; owed_ >= kTick; owed_ -= kTick) {
        tick(speaker);
    }
}

void Stage::tick(Speaker& speaker) {
    SilentSpeaker silence;
    const bool title = screen_ == Screen::Title;
    const Pilot& pilot = title ? def_.bot : def_.pilot;
    std::optional<Input> input = hands_.next();
    if (title) {
        input = Input{};
    }
    if (pilot) {
        input = pilot(play_->game());
    }
    play_->tick(input.value_or(Input{}), title ? silence : speaker);
    if (input && play_->game().result() == Result::Playing) {
        return;
    }
    ++endTicks_;
    if (endTicks_ >= kEndTicks && title) {
        toTitle();
    } else if (endTicks_ >= kEndTicks && screen_ == Screen::Playing) {
        finish();
    }
}

void Stage::finish() {
    screen_ = Screen::Over;
    const std::int32_t score = play_->game().score();
    newBest_ = score > best_[level_] && best_[level_] > 0;
    best_[level_] = std::max(best_[level_], score);
    std::vector<MenuItem> items;
    if (play_->game().result() == Result::Won && level_ + 1 < def_.levels.size()) {
        items.push_back({Action::NextLevel, "Next level"});
    }
    items.push_back({Action::Restart, "Play again"});
    items.push_back({Action::ToTitle, "All levels"});
    menu_ = Menu(std::move(items), Real(8.2));
}

void Stage::pause() {
    screen_ = Screen::Paused;
    const EffectSettings& effects = def_.effects;
    menu_ = Menu({{Action::Resume, "Go on"},
                  {Action::Restart, "Restart"},
                  {Action::Sound, "Sound", effects.sound},
                  {Action::Particles, "Particles", effects.particles},
                  {Action::Trail, "Trail of the ball", effects.trail},
                  {Action::Shake, "Shake", effects.shake},
                  {Action::Flash, "Flashes", effects.flash},
                  {Action::ToTitle, "All levels"}},
                 Real(11.6));
}

void Stage::take(const Signals& signals, Speaker& speaker) {
    if (signals.closed) {
        quit_ = true;
        return;
    }
    // Two keys in one frame may belong to two screens: the first is done with before the second.
    Signals one = signals;
    one.commands.resize(std::min<std::size_t>(signals.commands.size(), 1));
    takeOne(one, speaker);
    one.pointer.reset();
    one.clicked = one.focusLost = false;
    for (std::size_t i = 1; i < signals.commands.size(); ++i) {
        one.commands = {signals.commands[i]};
        takeOne(one, speaker);
    }
}

void Stage::takeOne(const Signals& signals, Speaker& speaker) {
    if (!signals.commands.empty() && signals.commands[0] == Command::Mute) {
        toggleMute();
    }
    switch (screen_) {
    case Screen::Title:
        return takeTitle(signals, speaker);
    case Screen::Playing:
        return takePlaying(signals);
    case Screen::Paused:
    case Screen::Over:
        return takeMenu(signals, speaker);
    }
}

void Stage::takeTitle(const Signals& signals, Speaker& speaker) {
    if (std::count(signals.commands.begin(), signals.commands.end(), Command::Back) > 0) {
        quit_ = true;
        return;
    }
    const std::size_t before = title_.chosen();
    const std::optional<std::size_t> level = title_.take(signals);
    if (level) {
        speaker.play({Voice::Choose, 1.5f, share(def_.effects.sound), 0});
        begin(*level);
    } else if (title_.chosen() != before) {
        speaker.play({Voice::Choose, 1, 0.6f * share(def_.effects.sound), 0});
        level_ = title_.chosen();
        toTitle();
    }
}

void Stage::takePlaying(const Signals& signals) {
    hands_.take(signals);
    if (signals.clicked) {
        hands_.launch();
    }
    for (const Command command : signals.commands) {
        switch (command) {
        case Command::Launch:
        case Command::Confirm:
            hands_.launch();
            break;
        case Command::Back:
        case Command::Pause:
            return pause();
        case Command::Restart:
            return begin(level_);
        default:
            break;
        }
    }
    if (signals.focusLost) {
        pause();
    }
}

void Stage::takeMenu(const Signals& signals, Speaker& speaker) {
    for (const Command command : signals.commands) {
        if (command == Command::Restart) {
            return begin(level_);
        }
        if (command == Command::Pause || command == Command::Back) {
            return act({screen_ == Screen::Paused ? Action::Resume : Action::ToTitle});
        }
        if (command == Command::Next && screen_ == Screen::Over) {
            return act({Action::NextLevel});
        }
    }
    const std::size_t before = menu_.chosen();
    const std::optional<MenuOutcome> outcome = menu_.take(signals);
    if (outcome || menu_.chosen() != before) {
        speaker.play({Voice::Choose, outcome ? 1.5f : 1, 0.6f * share(def_.effects.sound), 0});
    }
    if (outcome) {
        act(*outcome);
    }
}

void Stage::act(const MenuOutcome& outcome) {
    switch (outcome.action) {
    case Action::Resume:
        screen_ = Screen::Playing;
        hands_.letGo();
        return;
    case Action::Restart:
        return begin(level_);
    case Action::NextLevel:
        return begin(std::min(level_ + 1, def_.levels.size() - 1));
    case Action::ToTitle:
        return toTitle();
    default:
        return change(outcome.action, outcome.change);
    }
}

int* Stage::setting(Action action) {
    switch (action) {
    case Action::Particles:
        return &def_.effects.particles;
    case Action::Trail:
        return &def_.effects.trail;
    case Action::Shake:
        return &def_.effects.shake;
    case Action::Flash:
        return &def_.effects.flash;
    case Action::Sound:
        return &def_.effects.sound;
    default:
        return nullptr;
    }
}

void Stage::change(Action action, int percent) {
    if (int* value = setting(action)) {
        *value = std::clamp(*value + percent, 0, 100);
        menu_.setPercent(action, *value);
        play_->setEffects(def_.effects);
    }
}

void Stage::toggleMute() {
    std::swap(def_.effects.sound, mutedSound_);
    menu_.setPercent(Action::Sound, def_.effects.sound);
    play_->setEffects(def_.effects);
}

HudLook Stage::hudLook() const {
    return {static_cast<int>(level_) + 1, static_cast<int>(def_.levels.size()),
            def_.effects.sound == 0, screen_ == Screen::Title ? "" : def_.pilotName.c_str()};
}

void Stage::draw(Canvas& canvas) const {
    const bool title = screen_ == Screen::Title;
    canvas.begin(title ? layout::kShownTitle : layout::kShown, play_->juice().shake());
    paintBackdrop(canvas);
    play_->draw(canvas, static_cast<Real>(owed_ / kTick));
    switch (screen_) {
    case Screen::Title:
        paintVeil(canvas, faded(palette::kNight, 0.74f));
        return title_.draw(canvas, *def_.levels[level_], seconds_);
    case Screen::Playing:
        paintHud(canvas, play_->game(), hudLook());
        return paintServeHint(canvas, play_->game());
    case Screen::Paused:
        return drawPaused(canvas);
    case Screen::Over:
        return drawOver(canvas);
    }
}

void Stage::drawPaused(Canvas& canvas) const {
    paintHud(canvas, play_->game(), hudLook());
    paintVeil(canvas, faded(palette::kNight, 0.72f));
    canvas.text("Paused", {0, Real(13)},
                {Real(1.6), palette::kText, Typeface::Bold, Align::Middle});
    menu_.draw(canvas);
}

void Stage::drawOver(Canvas& canvas) const {
    paintHud(canvas, play_->game(), hudLook());
    paintVeil(canvas, faded(palette::kNight, 0.66f));
    const Game& game = play_->game();
    constexpr std::array<const char*, 3> kTitles = {"The replay ends", "Level cleared",
                                                    "Game over"};
    constexpr std::array<Color, 3> kColors = {palette::kText, palette::kAccent, palette::kDanger};
    const auto result = static_cast<std::size_t>(game.result());
    canvas.text(kTitles[result], {0, Real(12.6)},
                {Real(1.8), kColors[result], Typeface::Bold, Align::Middle});
    canvas.text(grouped(game.score()), {0, Real(10.6)},
                {Real(1.5), palette::kText, Typeface::Bold, Align::Middle});
    std::string line = newBest_ ? "your best so far" : "points";
    if (game.result() != Result::Won) {
        line += ", " + std::to_string(game.blocksLeft()) + " blocks left";
    }
    canvas.text(line, {0, Real(9.5)},
                {Real(0.52), palette::kQuiet, Typeface::Plain, Align::Middle});
    menu_.draw(canvas);
}

} // namespace apart
