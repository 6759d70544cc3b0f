// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/confirm.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/input_mapper.hpp>
#include <apart/stage/level_select.hpp>
#include <apart/stage/menu.hpp>
#include <apart/stage/session.hpp>
#include <apart/stage/theatre.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace apart {

/// A level file that has changed: its new content, or its errors.
struct LevelChange {
    std::shared_ptr<const Level> level;
    std::vector<std::string> errors{};
};

struct StageDef {
    LevelList levels; // at least one
    std::size_t firstLevel = 0;
    bool startAtOnce = false; // in the first level, without the title screen
    std::uint32_t seed = 1;   // of the first game, incremented for each further game
    Profile profile{};
    /// Saves the profile. Returns a sentence for the player on failure, else an empty text.
    std::function<std::string(const Profile&)> save{};
    /// Saves a game of the player, finished or not; `best` if it has the best score of its level.
    /// Returns a sentence for the player on failure, else an empty text.
    std::function<std::string(const Replay&, bool best)> keepReplay{};
    std::vector<std::string> notices{}; // shown on the title screen
    /// Number of the endless level to start with; 0: none.
    std::uint32_t firstEndless = 0;
    /// The endless level of a number from 1. Empty if there are no endless levels.
    std::function<std::shared_ptr<const Level>(std::uint32_t)> endless{};
    /// Called twice a second, if set: the first level, if its file has changed.
    std::function<std::optional<LevelChange>()> reload{};
    /// Replays to watch, the latest first.
    std::function<std::vector<ShowEntry>()> replays{};
    std::optional<Show> show{}; // starts at once; later games are the player's
    Pilot bot{};                // plays behind the title screen, if set
    Pilot pilot{};              // plays all games instead of the player, if set
};

struct EndlessRun {
    std::uint32_t number = 0; // of the current level; 0: none
    std::int32_t score = 0;   // of the previous levels
};

enum class Screen : std::uint8_t { Title, Levels, Options, Replays, Help, Playing, Paused, Over };

/// The application without its window: screens, time, and the effect of input on each screen. All
/// external dependencies are arguments.
class Stage {
public:
    explicit Stage(StageDef def);

    /// Call once per frame with the input and the time since the previous frame (s). After a stall,
    /// game time beyond a limit is dropped instead of caught up.
    void advance(double seconds, const Signals& signals, Speaker& speaker);
    void draw(Canvas& canvas) const;

    bool wantsToQuit() const { return quit_; }
    bool wantsPointer() const { return screen_ != Screen::Playing; }
    Screen screen() const { return screen_; }
    const Game& game() const { return session_.game(); }
    const Profile& profile() const { return def_.profile; }
    const Settings& settings() const { return def_.profile.settings; }
    std::size_t levelIndex() const { return level_; }
    const Menu& menu() const { return menu_; }
    const LevelSelect& levelSelect() const { return select_; }
    /// True if the bot plays without a menu: the title screen has had no input for a while.
    bool attracting() const;

private:
    // Effects of input, by screen (stage_signals.cpp).
    void take(const Signals& signals, Speaker& speaker);
    void takeOne(const Signals& signals, Speaker& speaker);
    void takeLevels(const Signals& signals, Speaker& speaker);
    void takePlaying(const Signals& signals);
    void takeShow(const Signals& signals);
    void takeMenu(const Signals& signals, Speaker& speaker);
    bool takeShortcut(Command command);
    void back();
    void act(const MenuOutcome& outcome);
    void turn(std::size_t dial, int percent);

    // Screens and games.
    void toTitle();
    void toLevels();
    void toOptions(int page = 0);
    void toReplays();
    void toHelp();
    void pause();
    void begin(std::size_t level);
    void beginEndless(std::uint32_t number);
    void beginShow();
    void beginGame(std::shared_ptr<const Level> level, Session::Kind kind);
    void enter(std::unique_ptr<Play> play, Session::Kind kind);
    void again();
    void next();
    void demo(std::size_t level);
    std::size_t nextToPlay() const;
    void tick(Speaker& speaker);
    void tickDemo();
    void finish();
    void keepGame(bool best);
    void reloadLevel();
    bool showing() const { return session_.kind() == Session::Kind::Show; }
    void keep();
    void note(std::string problem);
    Settings audible() const;
    bool demoRuns() const;

    // Pictures (stage_picture.cpp).
    void drawTitle(Canvas& canvas) const;
    HudLook hudLook() const;

    StageDef def_;
    Screen screen_ = Screen::Title;
    Screen behind_ = Screen::Title; // the options or the help
    int optionsPage_ = 0;           // of kDialPages
    bool quit_ = false;
    std::size_t level_ = 0;
    EndlessRun endless_;
    bool showing_ = false;    // the current game is the recorded one
    std::uint32_t games_ = 0; // number of games started by the player
    std::size_t demos_ = 0;   // number of games started by the bot
    Session session_;
    std::optional<Rerun> rerun_; // behind the result screen
    Theatre theatre_;
    std::vector<ShowEntry> replays_; // of Screen::Replays
    Confirm confirm_;
    double reloadAt_ = 0;             // s, of the next look at the file of the level
    std::vector<std::string> faults_; // of that file
    InputMapper inputMapper_;
    Menu menu_;
    LevelSelect select_;
    double seconds_ = 0;     // s since the start, for animations
    double idleSeconds_ = 0; // s since the last input
    double overSeconds_ = 0; // s since the result screen appeared
    bool newBest_ = false;
    Best before_{}; // best results of the level before the last game
};

} // namespace apart
