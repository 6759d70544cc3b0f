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

    const Level& level() const { return *state_.level; }
    std::uint32_t seed() const { return state_.seed; }
    Mode mode() const { return state_.mode; }

    // Force field of the paddle.
    kodo::Real meter() const { return state_.field.meter; } // 0..1
    Force force() const { return state_.field.force; } // active one; None when the meter is empty

    // Timed powers.
    std::span<const Effect> effects() const { return state_.effects; }
    kodo::Real secondsLeft(Power power) const { return state_.secondsLeft(power); } // 0: not active
    BallKind ballKind() const { return state_.ballKind(); } // of all balls in play
    PaddleKind paddleKind() const { return state_.paddleKind(); }
    const Sway& sway() const { return state_.paddle.sway; }
    kodo::Real windSpeed() const {
        return state_.windSpeed();
    } // m/s, to the right; level and effects together

    // Time without damage to a block.
    Patience patience() const { return state_.patience(); }
    kodo::Real idleSeconds() const {
        return state_.idleSeconds();
    } // of the progress clock, which runs faster at the end
    const Block* nextToFall() const {
        return state_.nextToFall();
    }                                             // its mount fails next; nullptr: none
    bool tears() const { return state_.tears(); } // a pull acts on nextToFall()
    kodo::Real tornShare() const { return state_.tornShare(); } // 0..1, progress of that pull
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
    std::span<const Link> links() const { return state_.links; }
    std::span<const Water> waters() const { return state_.waters; }
    const Collapse& collapse() const { return state_.collapse; }
    std::optional<kodo::BodyId> boss() const {
        return state_.livingBoss();
    } // nullopt: none, or defeated
    const Block* findBlock(kodo::BodyId body, std::size_t part = 0) const {
        return state_.findBlock(body, part);
    } // nullptr: none
    /// First wall, block or obstruction on the straight path of a ball along `way` (m).
    std::optional<kodo::QueryHit> ahead(kodo::Vec2 from, kodo::Vec2 way) const {
        return state_.ahead(from, way);
    }
    bool meetsBlock(kodo::Vec2 from, kodo::Vec2 way) const {
        return state_.meetsBlock(from, way);
    } // ahead() is breakable
    /// True while Level::keep, of an honour, has not fallen.
    bool keeps() const { return state_.keeps(); }
    /// True while a ball waits for `launch`.
    bool serving() const { return state_.serving(); }
    /// Length (m) of a ball's path, with its bounces off what stands still, from a point along a
    /// unit heading to the first block that counts; none if it meets none in six bounces.
    std::optional<kodo::Real> wayToBlock(kodo::Vec2 from, kodo::Vec2 heading) const {
        return state_.wayToBlock(from, heading);
    }
    /// Unit direction of the next serve.
    kodo::Vec2 serveHeading() const { return state_.paddle.serveHeading; }
    kodo::Real ballSpeed() const { return state_.ballSpeed(); } // m/s; target of the speed servo

    /// Equal for games that continue identically. The same on every machine.
    std::uint64_t stateHash() const { return state_.hash(); }

private:
    friend struct GameTestAccess; // for tests
    friend struct Trial;          // editor/trial.hpp

    GameState state_;
};

} // namespace apart
