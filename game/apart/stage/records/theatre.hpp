// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/daily.hpp>
#include <apart/core/replay.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/controls.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace apart {

/// Replaces the player: input of the next tick, or nothing at its end.
using Pilot = std::function<std::optional<Input>(const Game&)>;

/// A recorded game to watch. Its level need not be in the level list.
struct Show {
    std::shared_ptr<const Level> level;
    std::uint32_t seed = 1;
    Mode mode = Mode::Standard;
    Pilot pilot;
    std::uint32_t end = 0; // ticks
    /// The next level of a recorded run, or the reason why it cannot be played. Empty after the
    /// last one.
    std::function<std::variant<Show, std::string>()> next{};
    std::vector<HashMark> hashes{}; // of the recording, by rising tick
    Day day = 0;                    // of a daily run; 0: it is none
};

/// A replay of the player's list. `load` reads it, or gives the reason why it cannot be played.
struct ShowEntry {
    std::string title;    // of the level, or the name of a file that cannot be read
    std::string date{};   // of the file: 2026-11-26
    std::string result{}; // won, lost or left
    std::optional<std::int64_t> score{};
    /// Mode and key of the scores whose best game it is.
    std::optional<std::pair<Mode, std::string>> best{};
    std::function<std::variant<Show, std::string>()> load{};
};
inline constexpr std::size_t kMostReplays = 10; // in the list

/// The show on the screen, and its controls: pause, speed, and places to go to.
class Theatre {
public:
    static constexpr int kSlowest = -3; // powers of 2: 1/8 to 8
    static constexpr int kFastest = 3;
    static constexpr std::int64_t kSkip = 600; // ticks: 5 s

    /// Actions that a command requests.
    struct Request {
        std::optional<std::int64_t> tick{}; // to go to; may lie outside of the show
        bool takeOver = false;
    };
    void begin(Show show);
    /// Goes on with the next level of the show and keeps the speed. False if there is none, or if
    /// it cannot be played: then `problem` is a sentence.
    bool next(std::string& problem);
    const Show& show() const { return show_; }
    Request take(Command command, std::uint32_t tick);
    /// The tick to go to while the mouse holds the bar.
    std::optional<std::int64_t> drag(const Signals& signals);
    /// Clickable area of the bar.
    static Aabb barPlace();

    bool paused() const { return paused_; }
    /// Ratio to the usual speed; 0 while paused.
    double pace() const;
    std::string speedText() const; // 1/4, 1, 2
    /// "0:12 of 1:30"
    std::string timeText(std::uint32_t tick) const;

private:
    Show show_; // its current level
    bool paused_ = false;
    int speed_ = 0;
    bool held_ = false; // the bar, by the mouse
};

/// "0:12"
std::string clockText(std::uint32_t ticks);

/// Paints the bar and the keys of a show. `back`: where escape leads.
void paintTheatre(Canvas& canvas, const Theatre& theatre, std::uint32_t tick,
                  std::string_view back);

} // namespace apart
