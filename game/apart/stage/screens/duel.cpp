// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/screens/duel.hpp>

#include <algorithm>
#include <tuple>

namespace apart {

namespace {

constexpr double kLongestPicture = 0.1;         // s; longer frames lose the excess
constexpr int kEndOfDuel = kTicksPerSecond * 2; // ticks from the end of both games to the result

/// A player hears the own game from the side where it is shown.
class SideSpeaker final : public Speaker {
public:
    SideSpeaker(Speaker& both, float side) : both_(both), side_(side) {}
    void play(const Note& note) override {
        Note moved = note;
        moved.pan = 0.5f * (note.pan + side_);
        both_.play(moved);
    }

private:
    Speaker& both_;
    float side_; // -1 left, 1 right
};

Duel::Half halfOf(const std::shared_ptr<const Level>& level, std::uint32_t seed, Mode mode) {
    return {Play(level, seed, mode, Settings{})};
}

/// A level that is brought down first, then points.
std::tuple<bool, std::int32_t> worthOf(const Game& game) {
    return {game.result() == Result::Won, game.score()};
}

} // namespace

Duel::Duel(const std::shared_ptr<const Level>& level, std::uint32_t seed, Mode mode, bool goesOn)
    : goesOn_(goesOn), halves_{halfOf(level, seed, mode), halfOf(level, seed, mode)} {}

void Duel::open(Phase phase) {
    phase_ = phase;
    openedAt_ = now_;
    for (Half& half : halves_) {
        half.mapper.letGo();
    }
    std::vector<MenuItem> items;
    if (phase == Phase::Paused) {
        items = {{Action::Resume, "Go on"},
                 {Action::Restart, "Start again"},
                 {Action::Options, "Options"}};
    } else {
        items = {{Action::Restart, "Rematch"}};
        if (goesOn_) {
            items.push_back({Action::NextLevel, "Next level"});
        }
    }
    items.push_back({Action::Levels, "Map"});
    items.push_back({Action::ToTitle, "Title"});
    menu_ = Menu(std::move(items), phase == Phase::Paused ? Real(11.6) : Real(5.1));
}

std::optional<std::size_t> Duel::winner() const {
    const auto first = worthOf(game(0));
    const auto second = worthOf(game(1));
    return first == second ? std::nullopt : std::optional<std::size_t>(first > second ? 0 : 1);
}

std::optional<Action> Duel::take(const Signals& signals, const Settings& settings) {
    return phase_ == Phase::Playing ? takePlaying(signals, Real(settings.mouse) / 100)
                                    : takeMenu(signals);
}

std::optional<Action> Duel::takePlaying(const Signals& signals, Real mouse) {
    for (std::size_t i = 0; i < kSeats; ++i) {
        Half& half = halves_[i];
        const Game& game = half.game();
        SeatSignals seat = signals.seats[i];
        if (i == 0) {
            seat.moved = signals.moved / scale();
            seat.serves = seat.serves || signals.clicked;
        }
        half.mapper.take(seat, game.world()[game.paddle()].position().x, mouse);
        if (seat.serves) {
            half.mapper.launch(seat,
                               game.serving() ? std::optional(game.serveHeading()) : std::nullopt);
        }
    }
    for (const Command command : signals.commands) {
        if (command == Command::Back || command == Command::Pause) {
            open(Phase::Paused);
        }
        const bool points = game(0).score() > 0 || game(1).score() > 0;
        if (command == Command::Restart && (!points || confirm_.ask(Ending::Restart, now_))) {
            return Action::Restart;
        }
    }
    if (signals.focusLost) {
        open(Phase::Paused);
    }
    return std::nullopt;
}

std::optional<Action> Duel::takeMenu(const Signals& signals) {
    constexpr double kReading = 1; // s; a late serve does not leave the result
    const bool paused = phase_ == Phase::Paused;
    if (!paused && now_ < openedAt_ + kReading) {
        return std::nullopt;
    }
    for (const Command command : signals.commands) {
        if (paused && (command == Command::Back || command == Command::Pause)) {
            open(Phase::Playing);
            return std::nullopt;
        }
        if (command == Command::Back) {
            return Action::Levels;
        }
        if (command == Command::Restart) {
            return Action::Restart;
        }
        if (command == Command::Next && !paused && goesOn_) {
            return Action::NextLevel;
        }
    }
    const std::optional<MenuOutcome> outcome = menu_.take(signals);
    if (outcome && outcome->action == Action::Resume) {
        open(Phase::Playing);
        return std::nullopt;
    }
    return outcome ? std::optional(outcome->action) : std::nullopt;
}

void Duel::advance(double seconds, const Settings& settings, const Pilot& pilot, Speaker& speaker) {
    const double pace = settings.speed / 100.0;
    for (Half& half : halves_) {
        half.play.setSettings(settings);
        half.play.setPace(2 * pace); // the limit of flashes is that of both fields together
    }
    if (phase_ == Phase::Paused) {
        return;
    }
    now_ += seconds;
    owed_ += pace * std::min(seconds, kLongestPicture);
    constexpr double kTick = 1.0 / kTicksPerSecond;
    for (; owed_ >= kTick; owed_ -= kTick) {
        tick(pilot, speaker);
    }
}

void Duel::tick(const Pilot& pilot, Speaker& speaker) {
    bool ended = true;
    for (std::size_t i = 0; i < kSeats; ++i) {
        Half& half = halves_[i];
        SideSpeaker side(speaker, i == 0 ? -1.0f : 1.0f);
        const bool before = half.ended();
        const Input input = half.mapper.next();
        half.play.tick(pilot ? pilot(half.game()).value_or(Input{}) : input, side);
        half.statistics.update(half.game());
        if (!before && half.game().result() == Result::Won) {
            half.fanfare.begin();
        }
        if (!half.fanfare.done()) {
            half.play.celebrate(half.fanfare, side);
        }
        ended = ended && half.ended() && half.fanfare.done();
    }
    endTicks_ += ended ? 1 : 0;
    if (endTicks_ == kEndOfDuel && phase_ == Phase::Playing) {
        open(Phase::Over);
    }
}

SoundScene Duel::sound() const {
    const SoundScene first = sceneOf(game(0));
    const SoundScene second = sceneOf(game(1));
    SoundScene scene = first;
    scene.combo = std::max(first.combo, second.combo);
    scene.danger = std::max(first.danger, second.danger);
    scene.rumble = std::max(first.rumble, second.rumble);
    scene.won = halves_[0].ended() && halves_[1].ended() && (first.won || second.won);
    return scene;
}

} // namespace apart
