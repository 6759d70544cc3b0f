// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/text_file.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// A game as text. Level, seed and inputs reproduce it bit for bit. A hand-written replay with
/// `expect` lines is a test.
///
///   apart-replay 2                   # format, always the first line; format 1 has no force
///   level keystones 0f3c...          # name; digest of its content, optional if hand-written
///   rules 1                          # kRulesVersion of the recording; optional if hand-written
///   seed 7
///   pure                             # Mode::Pure
///   handwritten                      # then there is no digest at the end
///   # tick  paddle  target  launch  force
///   0       0       -       0       0
///   30      0       -       1
///   140     -127    -       0       pull
///   hash 60 5c1d... 120 91ab...      # state after so many ticks; any number of pairs
///   expect 600 blocksLeft <= 20      # tick, field, == != < <= > >=, number or name
///   expect 600 shardBroke >= 3       # number of events of this name until that tick
///   end 1200                         # ticks; always the last line except for the digest
///   digest 77aa...                   # over all bytes before this line
///
/// The input line of tick t is applied to the state after t ticks and holds until the next line.
/// See Input. A target of - is none. force is 0, pull or push, and may be omitted. # starts a
/// comment.
struct InputChange {
    std::uint32_t tick = 0;
    Input input;
    friend bool operator==(const InputChange&, const InputChange&) = default;
};
struct HashMark {
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;
    friend bool operator==(const HashMark&, const HashMark&) = default;
};

/// Quantity of an expectation: a value of the state after the tick, or the number of events of a
/// kind so far. Event fields follow in the order of Event's alternatives.
enum class Field : std::uint8_t {
    BlocksLeft,
    Score,
    Lives,
    Combo,
    Balls,
    Shards,
    Parts,       // loose, stuck or launched
    PaddleParts, // welded to the paddle
    PaddleX,     // 1/1000 m
    PaddleMass,  // 1/1000 kg
    Tilt,        // 1/1000 rad, of the paddle
    Lift,        // 1/1000 m, of the paddle
    BallX,       // 1/1000 m, of the first ball; 0 without one
    BallY,
    BallSpeed,   // 1/1000 m/s
    LooseBlocks, // Support::Loose
    Meter,       // 1/1000
    Effects,     // number of active powers
    Wind,        // 1/1000 m/s
    BentBounces, // see Ledger
    LargestFall, // most blocks of one collapse so far
    Result,      // playing won lost
    BallKind,    // round heavy lopsided egg rough
    Patience,    // calm glowing shaking failing
    FirstEvent,
};
inline constexpr std::size_t kStateFields = static_cast<std::size_t>(Field::FirstEvent);
inline constexpr std::size_t kEventKinds = std::variant_size_v<Event>;
inline constexpr std::array<std::string_view, kStateFields + kEventKinds> kFieldNames = {
    "blocksLeft", "score", "lives", "combo", "balls", "shards", "parts", "paddleParts", "paddleX",
    "paddleMass", "tilt", "lift", "ballX", "ballY", "ballSpeed", "looseBlocks", "meter", "effects",
    "wind", "bentBounces", "largestFall", "result", "ballKind", "patience",
    // In the order of Event's alternatives.
    "struck", "cracked", "broke", "released", "caught", "welded", "stuck", "launched", "spent",
    "ballSplit", "served", "ballLost", "lifeLost", "cleared", "lost", "knockedOff", "shardBroke",
    "letGo", "fell", "bossDown", "bumped", "powerBegan", "powerEnded", "ballChanged", "leapt",
    "forceChanged", "shardCaught", "patienceChanged", "loopSeen", "collapsed", "snapped"};
/// Names of the values of a field; empty for a numeric field.
std::span<const std::string_view> valueNames(Field field);
/// Value of a state field.
std::int64_t valueOf(const Game& game, Field field);

enum class Comparison : std::uint8_t { Equal, NotEqual, Less, AtMost, Greater, AtLeast };
inline constexpr std::array<std::string_view, 6> kComparisonNames = {"==", "!=", "<",
                                                                     "<=", ">",  ">="};
bool holds(std::int64_t left, Comparison comparison, std::int64_t right);

struct Expectation {
    std::uint32_t tick = 0;
    Field field = Field::Result;
    Comparison comparison = Comparison::Equal;
    std::int64_t value = 0;
    int line = 0; // in the file, from 1

    std::string text() const; // as in the file
    friend bool operator==(const Expectation&, const Expectation&) = default;
};

struct Replay {
    std::string level;
    std::optional<std::uint64_t> levelDigest;
    std::optional<std::uint32_t> rules;
    std::uint32_t seed = 0;
    Mode mode = Mode::Standard;
    bool handwritten = false;
    std::vector<InputChange> inputs;       // by rising tick
    std::vector<HashMark> hashes;          // by rising tick
    std::vector<Expectation> expectations; // as in the file
    std::uint32_t end = 0;                 // ticks

    friend bool operator==(const Replay&, const Replay&) = default;
};

inline constexpr std::size_t kLargestReplay = 16 * 1024 * 1024; // bytes
inline constexpr std::uint32_t kLongestReplay = 4320000;        // ticks; ten hours
inline constexpr std::uint32_t kHashEvery = 60;                 // ticks, in a recording

Read<Replay> parseReplay(std::string_view text, const std::string& file);
Read<Replay> readReplayFile(const std::filesystem::path& path);
std::string toText(const Replay& replay);

/// Reason why this game and level cannot play the replay, as a sentence; nullopt if they can.
std::optional<std::string> refusal(const Replay& replay, const Level& level);

/// Plays a replay tick by tick and checks its hashes and expectations.
class Playback {
public:
    Playback(Replay replay, std::shared_ptr<const Level> level);

    bool done() const { return game_.ticks() >= replay_.end; }
    void tick();
    const Game& game() const { return game_; }
    const Replay& replay() const { return replay_; }

    /// First hash that differs from the recorded one.
    struct Divergence {
        std::uint32_t tick = 0;
        std::optional<std::uint32_t> agreed{}; // last equal hash
    };
    const std::optional<Divergence>& divergence() const { return divergence_; }
    /// An unmet expectation and the value found instead.
    struct Failure {
        Expectation expectation;
        std::int64_t found = 0;

        /// For example "expect 600 lives == 3, but lives is 2".
        std::string text() const;
    };
    const std::vector<Failure>& failures() const { return failures_; }

private:
    void look();
    std::int64_t valueNow(Field field) const;

    Replay replay_;
    Game game_;
    Input input_;
    std::size_t nextInput_ = 0;
    std::size_t nextHash_ = 0;
    std::optional<Divergence> divergence_;
    std::optional<std::uint32_t> agreed_;
    std::vector<Failure> failures_;
    std::array<std::int64_t, kEventKinds> eventCounts_{};
};

/// Records a running game. record() must be called after each tick with its input.
class Recorder {
public:
    explicit Recorder(const Game& atStart, std::uint32_t hashEvery = kHashEvery);

    void record(const Input& input, const Game& after);
    /// The replay so far, with a final hash.
    Replay finish(const Game& game) const;

private:
    Replay replay_;
    Input last_;
    std::uint32_t hashEvery_;
};

} // namespace apart
