// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls.hpp>

#include <optional>
#include <string_view>

namespace apart {

/// Commands that lose a game ask once: they take effect when given again within kSeconds.
class Confirm {
public:
    static constexpr double kSeconds = 2.5;

    /// True if this command is the second one. `now` is any clock (s).
    bool ask(Command command, double now) {
        const bool again = asked_ == command && now - since_ < kSeconds;
        asked_ = again ? std::nullopt : std::optional(command);
        since_ = now;
        return again;
    }
    /// Text of the pending question; empty if there is none.
    std::string_view question(double now) const {
        if (!asked_ || now - since_ >= kSeconds) {
            return {};
        }
        return *asked_ == Command::Restart ? "once more to start again" : "once more to quit";
    }

private:
    std::optional<Command> asked_;
    double since_ = 0; // s
};

} // namespace apart
