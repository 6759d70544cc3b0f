// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/play/endless_run.hpp>
#include <apart/stage/play/session.hpp>
#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/records.hpp>
#include <apart/stage/records/theatre.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace apart {

/// Where games come from.
struct GameSource {
    LevelList levels;       // at least one
    std::uint32_t seed = 1; // of the first game, incremented for each further game
    /// Number of the endless level to start with; 0: none.
    std::uint32_t firstEndless = 0;
    /// The endless level of a seed and a number from 1. Empty if there are no endless levels.
    std::function<std::shared_ptr<const Level>(std::uint32_t, std::uint32_t)> endless{};
    /// The seed of a new endless run. Empty: that of the first game.
    std::function<std::uint32_t()> endlessSeed{};
    std::function<std::shared_ptr<const Level>(Day, std::uint32_t)> daily{};
    std::optional<Replay> rival{}; // played beside the games of its level, instead of the best one
    Pilot bot{};                   // plays behind the title screen, if set
    Pilot pilot{};                 // plays all games instead of the player, if set
};

/// What came of a game.
struct GameEnd {
    bool entered = false; // its score is one of the player's
    bool newBest = false;
    std::optional<Rerun> rerun{}; // of the collapse that ended it
};

/// The games, one after another: which one is played, and which one follows it. Those of the player
/// enter the records. Source and records outlive it.
class Games {
public:
    Games(const GameSource& source, Records& records) : source_(source), records_(records) {}

    // What is played from now on. The game before it is kept.
    void begin(std::size_t level);
    void beginRun(Day day); // the daily run of a day; 0: an endless run
    void nextOfRun();
    void beginTry(std::unique_ptr<Play> play); // of the editor; it enters no records
    void show(Show show);                      // all levels of a replay
    /// The next level of a replay. False if there is none, or if it cannot be played: then
    /// `problem` is a sentence.
    bool showNext(std::string& problem);
    /// The game of the bot behind a menu. `tours`: it goes on with the other levels.
    void demo(std::size_t level, bool tours);
    void again();

    /// One tick. `input` is the player's; another may play instead.
    void tick(std::optional<Input> input, Speaker& speaker);
    /// Saves the replay of the player's game and counts it, whether it has ended or not. Once per
    /// game, and not for a level that is not recorded.
    void keep();
    /// Enters the game on the screen, which has ended.
    void finish();
    GameEnd& end() { return end_; } // of the game on the screen, after finish()
    const GameEnd& end() const { return end_; }
    /// True if points of the player are lost with the game on the screen.
    bool hasStake() const;

    Session& session() { return session_; }
    const Session& session() const { return session_; }
    Theatre& theatre() { return theatre_; } // of a replay
    const Theatre& theatre() const { return theatre_; }
    const EndlessRun& run() const { return run_; }
    ReplayRun record() const { return run_.with(session_.record()); } // up to now
    /// The level of the list that is offered, played or was played last.
    std::size_t level() const { return level_; }
    void choose(std::size_t level) { level_ = level; }
    std::uint32_t takeSeed() { return source_.seed + started_++; } // of the next game

private:
    void beginOwn(std::shared_ptr<const Level> level, std::uint32_t seed);
    void beginEndless(std::uint32_t number);
    void enterShow();
    void enter(std::unique_ptr<Play> play, Session::Kind kind);

    const GameSource& source_;
    Records& records_;
    Session session_;
    Theatre theatre_;
    std::optional<Show> first_; // level of the replay
    GameEnd end_;
    EndlessRun run_;
    std::size_t level_ = 0;
    std::uint32_t started_ = 0; // number of games started by the player
    std::size_t demos_ = 0;     // number of levels that the bot went on with
    bool tours_ = false;
};

} // namespace apart
