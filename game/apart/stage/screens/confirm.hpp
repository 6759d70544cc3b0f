// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace apart {

/// What ends a game or the program, or replaces the settings of the player.
enum class Ending : std::uint8_t { Quit, Restart, Levels, Replays, Title, Settings };

/// An action that loses a game or settings takes effect when given twice within kSeconds.
class Confirm {
public:
    static constexpr double kSeconds = 2.5;

    /// True if this ending was asked for just before. `now` is any clock (s).
    bool ask(Ending ending, double now) {
        const bool again = asked_ == ending && now - since_ < kSeconds;
        asked_ = again ? std::nullopt : std::optional(ending);
        since_ = now;
        return again;
    }
    void withdraw() { asked_.reset(); }
    /// Text of the pending question; empty if there is none.
    std::string_view question(double now) const {
        if (!asked_ || now - since_ >= kSeconds) {
            return {};
        }
        return *asked_ == Ending::Restart    ? "once more to start again"
               : *asked_ == Ending::Quit     ? "once more to quit"
               : *asked_ == Ending::Settings ? "once more to reset the options"
                                             : "once more to leave the game";
    }

private:
    std::optional<Ending> asked_;
    double since_ = 0; // s
};

} // namespace apart
