// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/text_file.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// A game as text: level, seed and inputs, so that it can be played again to the bit. A person can
/// write one, with `expect` lines, and it is a test.
///
///   apart-replay 1                   # always the first line
///   level keystones 0f3c...          # name; digest of its content, optional when hand-written
///   rules 1                          # of the game that recorded it; optional when hand-written
///   seed 7
///   handwritten                      # instead of the digest at the end
///   # tick  paddle  target  launch   (a line holds until the next; see Input; - is no target)
///   0       0       -       0
///   30      0       -       1
///   140     -127    -       0
///   hash 60 5c1d... 120 91ab...      # state after so many ticks; as many pairs as you like
///   expect 600 blocksLeft <= 20      # tick, field, == != < <= > >=, number or result
///   end 1200                         # always the last line, but for the digest
///   digest 77aa...                   # over all bytes before this line
///
/// The line of tick t is the input of the (t + 1)-th tick: it leads from the state after t ticks to
/// the next. # starts a comment.
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
    Result,      // playing won lost
};
inline constexpr std::array<std::string_view, 11> kFieldNames = {
    "blocksLeft", "score",       "lives",   "combo",      "balls", "shards",
    "parts",      "paddleParts", "paddleX", "paddleMass", "result"};
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
    int line = 0; // of the file

    std::string text() const; // as in the file
    friend bool operator==(const Expectation&, const Expectation&) = default;
};

struct Replay {
    std::string level;
    std::optional<std::uint64_t> levelDigest;
    std::optional<std::uint32_t> rules;
    std::uint32_t seed = 0;
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

/// Why this game and this level cannot play the replay, as a sentence; or nothing.
std::optional<std::string> refusal(const Replay& replay, const Level& level);

/// Plays a replay, tick by tick.
class Playback {
public:
    Playback(Replay replay, std::shared_ptr<const Level> level);

    bool done() const { return game_.ticks() >= replay_.end; }
    void tick();
    const Game& game() const { return game_; }
    const Replay& replay() const { return replay_; }

    /// Where this game was first seen to differ from the recorded one.
    struct Divergence {
        std::uint32_t tick = 0;
        std::optional<std::uint32_t> agreed{}; // last tick before it whose hash was the same
    };
    const std::optional<Divergence>& divergence() const { return divergence_; }
    /// Of the expectations up to now, those that were not met, with what was found instead.
    struct Failure {
        Expectation expectation;
        std::int64_t found = 0;

        /// Such as "expect 600 lives == 3, but lives is 2".
        std::string text() const;
    };
    const std::vector<Failure>& failures() const { return failures_; }

private:
    void look();

    Replay replay_;
    Game game_;
    Input input_;
    std::size_t nextInput_ = 0;
    std::size_t nextHash_ = 0;
    std::optional<Divergence> divergence_;
    std::optional<std::uint32_t> agreed_;
    std::vector<Failure> failures_;
};

/// Writes down a game while it is played: call record() after each tick with the input of it.
class Recorder {
public:
    explicit Recorder(const Game& atStart, std::uint32_t hashEvery = kHashEvery);

    void record(const Input& input, const Game& after);
    /// What was played so far, with a last hash.
    Replay finish(const Game& game) const;

private:
    Replay replay_;
    Input last_;
    std::uint32_t hashEvery_;
};

} // namespace apart
