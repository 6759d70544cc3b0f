// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls/controls.hpp>
#include <apart/stage/controls/input_mapper.hpp>
#include <apart/stage/play/play.hpp>
#include <apart/stage/records/run_statistics.hpp>
#include <apart/stage/records/theatre.hpp>
#include <apart/stage/screens/confirm.hpp>
#include <apart/stage/screens/menu.hpp>

#include <array>
#include <memory>
#include <optional>

namespace apart {

/// Two players at one screen: two games of a level with the same serves, side by side. Nothing of
/// them enters the records, and no time is slowed or zoomed: both games tick at once.
class Duel {
public:
    /// A player: a game, and what acts on it.
    struct Half {
        Play play;
        RunStatistics statistics{};
        InputMapper mapper{};
        Fanfare fanfare{};

        const Game& game() const { return play.game(); }
        bool ended() const { return game().result() != Result::Playing; }
    };
    enum class Phase : std::uint8_t { Playing, Paused, Over };

    /// `goesOn`: the result offers the next level.
    Duel(const std::shared_ptr<const Level>& level, std::uint32_t seed, Mode mode, bool goesOn);

    /// What the stage has to do: Action::Restart, NextLevel, Options, Levels or ToTitle.
    std::optional<Action> take(const Signals& signals, const Settings& settings);
    /// `pilot` plays both games instead of the players, if set.
    void advance(double seconds, const Settings& settings, const Pilot& pilot, Speaker& speaker);
    /// The continuous sounds of both games; its volumes are left at 0.
    SoundScene sound() const;
    void draw(Canvas& canvas, const Bindings& keys) const;

    Phase phase() const { return phase_; }
    const Play& play(std::size_t player) const { return halves_[player].play; }
    const Game& game(std::size_t player) const { return play(player).game(); }
    /// Index of the player with the better game; none if they are equal. A level that is brought
    /// down is better than one that is not; then the score decides.
    std::optional<std::size_t> winner() const;
    const Menu& menu() const { return menu_; } // of a pause, or below the result
    /// Where the field of a player is in the picture (m). Nothing of its game is outside.
    static Aabb boxOf(std::size_t player);
    static Real scale(); // of a field in the picture

private:
    void open(Phase phase);
    std::optional<Action> takePlaying(const Signals& signals, Real mouse);
    std::optional<Action> takeMenu(const Signals& signals);
    void tick(const Pilot& pilot, Speaker& speaker);
    // Pictures (duel_painter.cpp).
    void paintHalf(Canvas& canvas, std::size_t player) const;
    void paintResult(Canvas& canvas) const;

    bool goesOn_;
    std::array<Half, kSeats> halves_;
    Phase phase_ = Phase::Playing;
    Menu menu_;
    Confirm confirm_;
    double now_ = 0;      // s, since the start
    double owed_ = 0;     // s of game time to be simulated
    int endTicks_ = 0;    // since both games have ended
    double openedAt_ = 0; // s, of now_: the phase
};

} // namespace apart
