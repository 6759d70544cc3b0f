// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/core/fracture.hpp>
#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/progress.hpp>
#include <apart/core/things.hpp>
#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace apart {

enum class Result : std::uint8_t { Playing, Won, Lost };
inline constexpr std::array<std::string_view, 3> kResultNames = {"playing", "won", "lost"};

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
    std::span<const Event> events() const { return events_; }

    Result result() const { return result_; }
    std::uint32_t ticks() const { return tick_; }
    std::int32_t score() const { return score_; }
    std::int32_t lives() const { return lives_; } // including the one in play
    std::int32_t combo() const { return combo_; } // blocks broken since the last paddle hit
    std::int32_t blocksLeft() const { return blocksLeft_; } // breakable and not fallen
    std::int32_t blocksAtStart() const { return blocksAtStart_; }

    const Level& level() const { return *level_; }
    std::uint32_t seed() const { return seed_; }
    Mode mode() const { return mode_; }

    // Force field of the paddle.
    kodo::Real meter() const { return meter_; } // 0..1
    Force force() const { return force_; }      // active one; None when the meter is empty

    // Timed powers.
    std::span<const Effect> effects() const { return effects_; }
    kodo::Real secondsLeft(Power power) const; // 0: not active
    BallKind ballKind() const;                 // of all balls in play
    PaddleKind paddleKind() const;
    const Sway& sway() const { return sway_; }
    kodo::Real windSpeed() const; // m/s, to the right; level and effects together

    // Time without damage to a block.
    Patience patience() const { return clock_.patience(); }
    kodo::Real idleSeconds() const;  // of the progress clock, which runs faster at the end
    const Block* nextToFall() const; // its mount fails next; nullptr: none
    bool tears() const;              // a pull acts on nextToFall()
    kodo::Real tornShare() const;    // 0..1, progress of that pull
    const Ledger& ledger() const { return ledger_; }

    // For drawing: world()[body].part(i).convex under world()[body].massFrame().
    const kodo::World& world() const { return world_; }
    std::span<const kodo::BodyId> walls() const { return walls_; }
    /// Part 0 of its body is the bare paddle; further parts are welded to it.
    kodo::BodyId paddle() const { return paddle_; }
    /// Indexed by part of the paddle's body, from part 1.
    std::span<const Weld> welds() const { return welds_; }
    int weldedParts() const { return static_cast<int>(welds_.size()); }
    std::span<const Block> blocks() const { return blocks_; }
    std::span<const Ball> balls() const { return balls_; }
    std::span<const Shard> shards() const { return shards_; }
    std::span<const Part> parts() const { return parts_; }
    std::span<const Obstruction> obstructions() const { return obstructions_; }
    std::span<const Link> links() const { return links_; }
    const Collapse& collapse() const { return collapse_; }
    std::optional<kodo::BodyId> boss() const; // nullopt: none, or defeated
    const Block* findBlock(kodo::BodyId body, std::size_t part = 0) const; // nullptr: none
    /// First wall, block or obstruction on the straight path of a ball along `way` (m).
    std::optional<kodo::QueryHit> ahead(kodo::Vec2 from, kodo::Vec2 way) const;
    bool meetsBlock(kodo::Vec2 from, kodo::Vec2 way) const; // ahead() is breakable
    /// True while a ball waits for `launch`.
    bool serving() const;
    /// Unit direction of the next serve.
    kodo::Vec2 serveHeading() const { return serveHeading_; }
    kodo::Real ballSpeed() const; // m/s; target of the speed servo

    /// Equal for games that continue identically. The same on every machine.
    std::uint64_t stateHash() const;

private:
    friend struct GameTestAccess; // for tests

    // Setup.
    void buildField();
    void buildBlocks();
    void buildBoss();
    void buildObstructions();
    void buildFreeBlocks();
    void buildLinks();
    void addBlock(Block block);
    void hang(Block& block);
    void newPaddle();
    void newServe();

    // Before the step.
    void serve();
    void leap();
    void useForce(const Input& input);
    void applyForces();
    kodo::Vec2 draw(kodo::BodyId body, kodo::Vec2 center, kodo::Real acceleration,
                    kodo::Real reach);
    void pushPaddleBack(kodo::Vec2 impulse);
    kodo::Vec2 tear(kodo::Vec2 center);
    void steer(const Input& input);
    void driveBoss();
    void fireParts();
    /// Sets the velocity and adds the gained kinetic energy (J) to `work`.
    static void drive(kodo::BodyRef body, kodo::Vec2 velocity, double& work);

    // After the step.
    struct BossImpact {
        std::uint32_t key = 0;
        kodo::Vec2 point;
        kodo::Vec2 impulse;
    };
    void judge();
    void judgeAlive(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgeBreakable(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgeBall(const kodo::CollisionRecord& hit, kodo::BodyId ball);
    void judgeBlock(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgeShard(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgePart(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgePaddle(const kodo::CollisionRecord& hit);
    void judgeObstruction(const kodo::CollisionRecord& hit, kodo::BodyId body);
    void judgeBoss();
    void catchPart(std::size_t index, const kodo::CollisionRecord& hit);
    void catchShard(std::size_t index, kodo::Vec2 point);
    void catchBlock(std::size_t index, kodo::Vec2 point);
    void addToMeter(Stuff stuff, kodo::Real mass, kodo::Vec2 point);
    void knockOffWorn();
    void knockOff(std::size_t weld);
    Stuff stuffOf(kodo::BodyId body, std::size_t part) const;

    kodo::Transform frameOf(const Block& block) const; // at the centre of the block
    kodo::BodyId detach(std::size_t index);
    void letGo(std::size_t index, LetGo::Why why);
    void letGoNext(LetGo::Why why);
    void dropUnsupported(kodo::Vec2 last);
    void watchBuildings();
    void watchLinks();
    void dropLinks(kodo::BodyId body);
    void markFallen(std::size_t index, LetGo::Why why);
    std::int32_t addToCollapse(const Block& block, kodo::Vec2 place);
    void endCollapse();
    void breakBlock(std::size_t index, kodo::Vec2 point, kodo::Vec2 impact);
    struct Carried { // frame and motion of a block that breaks
        kodo::Transform frame;
        PieceMotion motion;
    };
    int addPieces(const Block& block, const kodo::Shape& shape, const Carried& before,
                  kodo::Vec2 hit, kodo::Vec2 impulse);
    void breakShard(std::size_t index, kodo::Vec2 point, kodo::Real impulse);

    void beginPower(Power power, kodo::Vec2 point, kodo::Vec2 origin);
    void endPower(std::size_t effect);
    void endOldPowers();
    void refreshPowers();
    void reshapeBalls();
    void renewFields();
    bool weldWings();

    void govern();
    void governBall(Ball& ball);
    bool isRubble(kodo::BodyId body) const;
    bool canCarry(kodo::BodyId body) const; // dynamic bar of a motor or block
    void watchProgress();
    void removeGone();
    void removeGoneBalls();
    void removeGoneBlocks();
    void removeGoneParts();
    void removeGoneShards();
    void letGoOfParts();
    void conclude();

    std::shared_ptr<const Level> level_;
    std::uint32_t seed_ = 0;
    Mode mode_ = Mode::Standard;
    std::uint32_t tick_ = 0;
    Result result_ = Result::Playing;
    std::int32_t score_ = 0;
    std::int32_t lives_ = 0;
    std::int32_t combo_ = 0;
    std::int32_t blocksLeft_ = 0;
    std::int32_t blocksAtStart_ = 0;
    std::uint32_t serves_ = 0;

    kodo::World world_;
    std::vector<kodo::BodyId> walls_;
    kodo::BodyId paddle_;
    kodo::Real paddleSpeed_ = 0; // m/s
    std::vector<Weld> welds_;
    kodo::Vec2 serveHeading_{0, 1};
    std::vector<Block> blocks_;
    std::vector<Ball> balls_;
    std::vector<Shard> shards_;
    std::vector<Part> parts_;
    std::vector<Obstruction> obstructions_;
    std::vector<Link> links_;
    Collapse collapse_;
    Sway sway_;
    Force force_ = Force::None;
    kodo::Real meter_ = 1;
    std::vector<Effect> effects_;
    ProgressClock clock_;
    Patience shownPatience_ = Patience::Calm; // of the last PatienceChanged
    kodo::Real tornSpeed_ = 0; // m/s that the pull would have given a free nextToFall()
    Ledger ledger_;
    kodo::BodyId boss_;
    kodo::Real bossHome_ = 0; // m; x of the middle of its oscillation
    int bossWay_ = 1;         // 1: to the right
    std::vector<Event> events_;
    // Used within one tick and cleared at its end.
    std::vector<BossImpact> bossImpacts_;
    bool fieldsStale_ = false;
};

} // namespace apart
