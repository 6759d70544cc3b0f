// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/hands.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/menu.hpp>
#include <apart/stage/pace.hpp>
#include <apart/stage/play.hpp>
#include <apart/stage/title.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace apart {

/// Plays in the player's place: the input of the next tick, or nothing when it has no more to say.
using Pilot = std::function<std::optional<Input>(const Game&)>;

struct StageDef {
    std::vector<std::shared_ptr<const Level>> levels; // at least one
    std::size_t firstLevel = 0;
    bool startAtOnce = false; // in the first level, without the title screen
    std::uint32_t seed = 1;   // of the first game; the next games count on from it
    EffectSettings effects{};
    Pilot bot{};             // plays behind the title screen, if there is one
    Pilot pilot{};           // plays all games instead of the player, if there is one
    std::string pilotName{}; // shown while it does
};

enum class Screen : std::uint8_t { Title, Playing, Paused, Over };

/// The application without its window: screens, time, and what the player's wishes mean on each.
/// Everything that it needs from outside comes in as arguments.
class Stage {
public:
    explicit Stage(StageDef def);

    /// Once a frame: what the player did, and the time since the last frame (s). After a stall the
    /// game slows down instead of hurrying to catch up.
    void advance(double seconds, const Signals& signals, Speaker& speaker);
    void draw(Canvas& canvas) const;

    bool wantsToQuit() const { return quit_; }
    bool wantsPointer() const { return screen_ != Screen::Playing; }
    Screen screen() const { return screen_; }
    const Game& game() const { return play_->game(); }
    const EffectSettings& effects() const { return def_.effects; }
    std::size_t levelIndex() const { return level_; }

private:
    void take(const Signals& signals, Speaker& speaker);
    void takeOne(const Signals& signals, Speaker& speaker);
    void takeTitle(const Signals& signals, Speaker& speaker);
    void takePlaying(const Signals& signals);
    void takeMenu(const Signals& signals, Speaker& speaker);
    void act(const MenuOutcome& outcome);
    void change(Action setting, int percent);
    void toggleMute();

    void tick(Speaker& speaker);
    void begin(std::size_t level);
    void toTitle();
    void pause();
    void finish();
    int* setting(Action action);
    void drawOver(Canvas& canvas) const;
    void drawPaused(Canvas& canvas) const;
    HudLook hudLook() const;

    StageDef def_;
    Screen screen_ = Screen::Title;
    bool quit_ = false;
    std::size_t level_ = 0;
    std::uint32_t games_ = 0; // begun so far
    std::unique_ptr<Play> play_;
    Hands hands_;
    Menu menu_;
    Title title_;
    Pace pace_;
    double owed_ = 0;                // s of game time not yet played
    double seconds_ = 0;             // since the start, for what only moves on the screen
    int endTicks_ = 0;               // since the game ended
    int mutedSound_ = 0;             // the volume that comes back
    std::vector<std::int32_t> best_; // score of each level since the start
    bool newBest_ = false;
};

} // namespace apart
