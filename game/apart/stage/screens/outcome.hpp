// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls/controls.hpp>
#include <apart/stage/play/games.hpp>

#include <functional>
#include <string>
#include <vector>

namespace apart {

/// What the result screen can do with a game, where it can.
struct Sharing {
    /// Copies a text to the clipboard.
    std::function<void(const std::string&)> copy{};
    /// Writes a film of a fall. Returns what to tell the player, as a sentence.
    std::function<std::string(const Rerun&)> film{};
};

/// What the result screen adds to the end of a game.
struct Outcome {
    /// s until an item can be chosen: what is pressed earlier was meant for the game.
    static constexpr double kReading = 0.7;

    double seconds = 0;               // since it appeared, or the ending, or the name of a boss
    std::vector<std::string> notes{}; // sentences for the player

    bool isRead() const { return seconds >= kReading; }
    /// C copies a link to the game; of a daily run its result in a line before it. G writes a film
    /// of its largest fall, from the start of it. True if one of them was pressed.
    bool take(const Signals& signals, const Games& games, const Sharing& sharing);
};

} // namespace apart
