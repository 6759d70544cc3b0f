// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls/input_mapper.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/play/games.hpp>
#include <apart/stage/screens/confirm.hpp>
#include <apart/stage/screens/duel.hpp>
#include <apart/stage/screens/editor_screen.hpp>
#include <apart/stage/screens/help.hpp>
#include <apart/stage/screens/key_screen.hpp>
#include <apart/stage/screens/level_map.hpp>
#include <apart/stage/screens/menus.hpp>
#include <apart/stage/screens/outcome.hpp>
#include <apart/stage/screens/reload.hpp>

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

struct StageDef : GameSource {
    Campaign campaign{};
    std::size_t firstLevel = 0;
    bool startAtOnce = false; // in the first level, without the title screen
    bool duel = false;        // starts in the first level with two players
    bool quits = true;        // false: of a page, which the browser closes
    Profile profile{};
    Keeping keeping{};
    ScoreStore scores{};                // the best games
    std::vector<MedalMarks> marks{};    // of the levels
    std::vector<std::string> leftOut{}; // sentences: the first error of each level that is left out
    std::vector<std::string> notices{}; // shown on the title screen, below the first of these
    std::function<Day()> today{};       // the current day, for daily runs
    Day firstDay = 0;                   // of the daily run to start with; 0: none
    /// Called twice a second, if set: the first level, if its file has changed.
    std::function<std::optional<LevelChange>()> reload{};
    /// Replays to watch, the latest first.
    std::function<std::vector<ShowEntry>()> replays{};
    std::string replayFolder{}; // shown with the list of replays
    std::optional<Show> show{}; // starts at once; later games are the player's
    /// What the editor starts with; the level: of the list, or none for a new one. Empty: levels
    /// cannot be edited.
    std::function<EditorStart(const Level* level)> edit{};
    std::optional<EditorStart> firstEdit{}; // starts at once
    Sharing sharing{};
};

enum class Screen : std::uint8_t {
    Title,
    Levels,
    Options,
    Keys,
    Records,
    Replays,
    Help,
    Playing,
    Paused,
    Over,
    Editor,
    BossCard, // before the first game of a boss
    Ending,   // after the last boss
    Duel
};

/// What the title screen offers, with this level to play.
TitleOffer offerOf(const StageDef& def, std::size_t level);

/// The game in the picture: on the result screen that of the rerun.
struct ShownGame {
    const Game& game;
    Closeup closeup{};
    bool wide = false; // in the middle, without the panel
};

/// The list of replays.
struct ReplayList {
    std::vector<ShowEntry> entries{};
    std::optional<std::size_t> shown{}; // the one that was chosen; none: a file was given

    /// True if the game is a replay of the list, or was taken over from one.
    bool leadsFrom(const Session& session) const {
        return shown && (session.isShow() || session.isWhatIf());
    }
};

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
    bool wantsPointer() const {
        return screen_ == Screen::Duel ? duel_->phase() != Duel::Phase::Playing
                                       : screen_ != Screen::Playing || session().isShow();
    }
    Screen screen() const { return screen_; }
    const Session& session() const { return games_.session(); }
    const Records& records() const { return records_; }
    const Menu& menu() const { return menu_; }
    /// False while a result, which has just appeared, lets nothing be chosen.
    bool takesChoice() const {
        return (screen_ != Screen::Over && screen_ != Screen::Ending) || over_.isRead();
    }
    const LevelMap& levelMap() const { return map_; }
    const EditorScreen* editor() const { return editor_.get(); } // nullptr: none is open
    const Duel* duel() const { return duel_.get(); }             // nullptr: there was none
    /// True if the bot plays without a menu: the title screen has had no input for a while.
    bool attracting() const;
    friend ShownGame shownBy(const Stage& stage);
    friend void paintOver(Canvas& canvas, const Stage& stage); // its result, or the ending
    friend HudLook hudLookOf(const Stage& stage);
    friend void paintPlaying(Canvas& canvas, const Stage& stage, std::string_view question);

private:
    // Effects of input, by screen (stage_signals.cpp).
    void take(const Signals& signals, Speaker& speaker);
    void takeOne(const Signals& signals, Speaker& speaker);
    void takeLevels(const Signals& signals, Speaker& speaker);
    void takeKeys(const Signals& signals, Speaker& speaker);
    void takePlaying(const Signals& signals);
    void takeShow(const Signals& signals);
    void takeMenu(const Signals& signals, Speaker& speaker);
    bool takeEditor(const Signals& signals);
    bool takeDuel(const Signals& signals);
    bool takeShortcut(Command command);
    bool mayEnd(Ending ending);
    void quit();
    void back();
    void act(const MenuOutcome& outcome);

    // Screens.
    void toTitle();
    void toLevels(bool duel = false);
    void toOptions(int page = 0);
    void toGame();
    void toReplays();
    void open(Screen screen, Menu menu);
    void begin(std::size_t level, bool namesBoss = false);
    void beginDuel(std::size_t level);
    void next();
    void edit(EditorStart start);
    void finish();
    void reloadLevel();

    /// The replays, and the one that is shown.
    struct Watched {
        ReplayList list{};
        Reload divergence{}; // news of the replay
    };

    /// The options, the keys and the help.
    struct Pages {
        Screen behind = Screen::Title; // behind options or help
        int dials = 0;                 // page of the options, of kDialPages
        KeyScreen keys{};
        std::optional<HelpPage> help{}; // of Screen::Help
    };

    StageDef def_;
    Records records_;
    Games games_; // of def_, into records_
    Screen screen_ = Screen::Title;
    bool quit_ = false;
    Watched watched_;
    Pages pages_;
    Confirm confirm_;
    Reload reload_;
    InputMapper inputMapper_;
    Menu menu_;
    LevelMap map_;
    std::unique_ptr<EditorScreen> editor_; // also while its level is tried
    std::unique_ptr<Duel> duel_;           // the last one
    double seconds_ = 0;                   // s since the start, for animations
    double idleSeconds_ = 0;               // s since the last input
    Outcome over_;                         // of Screen::Over
};

} // namespace apart
