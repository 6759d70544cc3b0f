// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/stage/fanfare.hpp>
#include <apart/stage/hands.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/level_select.hpp>
#include <apart/stage/menu.hpp>
#include <apart/stage/pace.hpp>
#include <apart/stage/play.hpp>
#include <apart/stage/tally.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace apart {

/// Plays in the player's place: the input of the next tick, or nothing when it has no more to say.
using Pilot = std::function<std::optional<Input>(const Game&)>;

/// A recorded game, to be watched. Its level may be one that no list has.
struct Show {
    std::shared_ptr<const Level> level;
    std::uint32_t seed = 1;
    Mode mode = Mode::Standard;
    Pilot pilot;
};

struct StageDef {
    LevelList levels; // at least one
    std::size_t firstLevel = 0;
    bool startAtOnce = false; // in the first level, without the title screen
    std::uint32_t seed = 1;   // of the first game; the next games count on from it
    Profile profile{};
    /// Keeps the profile for the next time; a sentence when it cannot.
    std::function<std::string(const Profile&)> save{};
    /// Keeps a game that the player has finished, and whether it is the best of its level; a
    /// sentence when it cannot.
    std::function<std::string(const Replay&, bool best)> keepReplay{};
    std::vector<std::string> notices{}; // sentences for the title screen
    std::uint32_t firstEndless = 0; // start at once with the endless level of that number; 0: none
    /// The level of that number, from 1, of a row without end; if there is one.
    std::function<std::shared_ptr<const Level>(std::uint32_t)> endless{};
    std::optional<Show> show{}; // begins at once; other games are the player's
    Pilot bot{};                // plays behind the title screen, if there is one
    Pilot pilot{};              // plays all games instead of the player, if there is one
};

enum class Screen : std::uint8_t { Title, Levels, Options, Playing, Paused, Over };

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
    const Profile& profile() const { return def_.profile; }
    const Settings& settings() const { return def_.profile.settings; }
    std::size_t levelIndex() const { return level_; }
    const Menu& menu() const { return menu_; }
    const LevelSelect& levelSelect() const { return select_; }
    /// The bot plays and no menu hides it: nobody has touched anything for a while.
    bool attracting() const;

private:
    // What the player did, by screen (stage_signals.cpp).
    void take(const Signals& signals, Speaker& speaker);
    void takeOne(const Signals& signals, Speaker& speaker);
    void takeLevels(const Signals& signals, Speaker& speaker);
    void takePlaying(const Signals& signals);
    void takeMenu(const Signals& signals, Speaker& speaker);
    bool takeShortcut(Command command);
    void back();
    void act(const MenuOutcome& outcome);
    void turn(std::size_t dial, int percent);
    void applySettings();
    void chirp(Speaker& speaker, bool chosen) const;

    // Screens and games.
    void toTitle();
    void toLevels();
    void toOptions();
    void pause();
    void resume();
    void begin(std::size_t level);
    void beginEndless(std::uint32_t number);
    void startEndless();
    void beginShow();
    void beginGame(std::shared_ptr<const Level> level);
    void enter(std::unique_ptr<Play> play);
    void again();
    void next();
    void demo(std::size_t level);
    std::size_t nextToPlay() const;
    std::string playLabel() const;
    void tick(Speaker& speaker);
    void tickDemo();
    void finish();
    void keep();
    void note(std::string problem);
    Settings audible() const;
    bool demoRuns() const;

    // Pictures (stage_picture.cpp).
    void drawTitle(Canvas& canvas) const;
    void drawNotices(Canvas& canvas) const;
    void drawFeast(Canvas& canvas) const;
    void drawPaused(Canvas& canvas) const;
    void drawOver(Canvas& canvas) const;
    HudLook hudLook() const;
    std::string placeOfLevel() const;

    StageDef def_;
    Screen screen_ = Screen::Title;
    Screen behindOptions_ = Screen::Title;
    bool quit_ = false;
    std::size_t level_ = 0;
    std::uint32_t endless_ = 0;     // number of the endless level in play; 0: another level
    std::int32_t endlessScore_ = 0; // of the endless levels before it
    bool showing_ = false;          // the recorded game
    std::uint32_t games_ = 0;       // of the player, begun so far
    std::size_t demos_ = 0;         // that the bot has begun by itself
    std::unique_ptr<Play> play_;
    std::optional<Recorder> recorder_; // of the player's game
    std::optional<Replay> played_;     // that game, once it has ended
    Tally tally_;
    Hands hands_;
    Menu menu_;
    LevelSelect select_;
    Pace pace_;
    Fanfare fanfare_;
    double owed_ = 0;        // s of game time not yet played
    double seconds_ = 0;     // since the start, for what only moves on the screen
    double idleSeconds_ = 0; // since the player did anything
    double overSeconds_ = 0; // since the result came up
    int endTicks_ = 0;       // since the game ended
    bool muted_ = false;
    bool newBest_ = false;
    Best before_{}; // of the level, before the game that has just ended
};

} // namespace apart
