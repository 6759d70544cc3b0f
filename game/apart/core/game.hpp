// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game_state.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace apart {

/// The rules of aPart without a screen: a function of level, seed and inputs. A Game is a value: a
/// copy is a snapshot that continues identically.
///
/// The field is kFieldWidth by kFieldHeight (tuning.hpp): x from -width/2 to width/2, y from 0 up.
/// Its ratio is 4 to 3, which leaves room for the score in a 16 to 10 window.
class Game {
public:
    Game(std::shared_ptr<const Level> level, std::uint32_t seed, Mode mode = Mode::Standard);
    Game(const Level& level, std::uint32_t seed, Mode mode = Mode::Standard);

    /// Advances by kTickSeconds. After the end bodies still move, but nothing is scored.
    void tick(const Input& input);
    /// Events of the last tick.
    std::span<const Event> events() const { return state_.events; }

    Result result() const { return state_.result; }
    std::uint32_t ticks() const { return state_.tick; }
    const Counts& counts() const { return state_.counts; }
    std::int32_t score() const { return state_.counts.score; }
    std::int32_t lives() const { return state_.counts.lives; } // including the one in play
    std::int32_t blocksLeft() const { return state_.counts.blocksLeft; } // breakable and not fallen
    std::int32_t blocksAtStart() const { return state_.counts.blocksAtStart; }

    const Level& level() const { return *state_.origin.level; }
    std::uint32_t seed() const { return state_.origin.seed; }
    Mode mode() const { return state_.origin.mode; }

    /// What the rules derive from the state: paths of balls, powers, time without damage, and so
    /// on.
    const GameState& state() const { return state_; }

    // Force field of the paddle.
    kodo::Real meter() const { return state_.paddle.field.meter; } // 0..1
    Force force() const { return state_.paddle.field.force; }      // None when the meter is empty

    std::span<const Effect> effects() const { return state_.powers.effects; }
    const Sway& sway() const { return state_.paddle.sway; }
    const Ledger& ledger() const { return state_.ledger; }

    // For drawing: world()[body].part(i).convex under world()[body].massFrame().
    const kodo::World& world() const { return state_.world; }
    std::span<const kodo::BodyId> walls() const { return state_.walls; }
    /// Part 0 of its body is the bare paddle; further parts are welded to it.
    kodo::BodyId paddle() const { return state_.paddle.body; }
    /// Indexed by part of the paddle's body, from part 1.
    std::span<const Weld> welds() const { return state_.paddle.welds; }
    std::span<const Block> blocks() const { return state_.blocks; }
    std::span<const Ball> balls() const { return state_.balls; }
    std::span<const Shard> shards() const { return state_.shards; }
    std::span<const Part> parts() const { return state_.parts; }
    std::span<const Obstruction> obstructions() const { return state_.obstructions; }
    std::span<const Link> links() const { return state_.buildings.links; }
    std::span<const Water> waters() const { return state_.waters; }
    const Collapse& collapse() const { return state_.buildings.collapse; }
    std::optional<kodo::BodyId> boss() const {
        return state_.livingBoss();
    } // nullopt: none, or defeated
    /// True while a ball waits for `launch`.
    bool serving() const { return state_.serving(); }
    /// Unit direction of the next serve.
    kodo::Vec2 serveHeading() const { return state_.paddle.serveHeading; }

    /// Equal for games that continue identically. The same on every machine.
    std::uint64_t stateHash() const { return state_.hash(); }

private:
    friend struct GameTestAccess; // for tests
    friend struct Trial;          // editor/trial.hpp

    GameState state_;
};

} // namespace apart
