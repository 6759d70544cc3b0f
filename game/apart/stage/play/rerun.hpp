// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/stage/play/play.hpp>

#include <cstdint>
#include <optional>

namespace apart {

/// The collapse that ended a game, shown again and again in slow motion.
class Rerun {
public:
    static constexpr double kPace = 0.3; // ratio to the usual speed

    /// `start`: the game shortly before the collapse; `record`: of the whole game.
    Rerun(const Play& start, Replay record)
        : start_(start), now_(start), record_(std::move(record)) {}

    void advance(double seconds);
    double seconds() const; // until it begins again
    const Play& play() const { return now_; }
    Real share() const;

private:
    Play start_;
    Play now_;
    Replay record_;
    double owed_ = 0; // s
};

/// A fall within a game.
struct Fall {
    std::int32_t blocks = 0;
    Rerun rerun;
};
/// The largest fall of a replay, from half a second before it to a second after it; none if nothing
/// falls.
std::optional<Fall> largestFall(const Replay& replay, const std::shared_ptr<const Level>& level);

/// Input of a replay at a tick.
Input inputAt(const Replay& replay, std::uint32_t tick);

} // namespace apart
