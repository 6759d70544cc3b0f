// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/replay_field.hpp>
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
///   apart-replay 3                   # format, always the first line; format 1 has no force,
///                                    # format 2 no aim
///   level keystones 0f3c...          # name; digest of its content, optional if hand-written
///   rules 1                          # kRulesVersion of the recording; optional if hand-written
///   seed 7
///   pure                             # Mode::Pure, or assisted
///   handwritten                      # then there is no digest at the end
///   # tick  paddle  target  launch  force  aim
///   0       0       -       0       0
///   20      0       -       0       0      -400
///   30      0       -       1
///   140     -127    -       0       pull
///   hash 60 5c1d... 120 91ab...      # state after so many ticks; any number of pairs
///   expect 600 blocksLeft <= 20      # tick, field, == != < <= > >=, number or name
///   expect 600 shardBroke >= 3       # number of events of this name until that tick
///   expect by 600 breakImpulse > 9000      # at one tick at least, from 0 to 600
///   expect always 300-600 lives == 3       # at each tick from 300 to 600
///   expect never 300-600 ballSpeed > 20000 # at none
///   end 1200                         # ticks; always the last line except for the digest
///   digest 77aa...                   # over all bytes before this line
///
/// The input line of tick t is applied to the state after t ticks and holds until the next line.
/// See Input. A target or aim of - is none. force is 0, pull or push; it and aim may be omitted.
/// # starts a comment. game/replays.md describes the format and all fields.
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

enum class Comparison : std::uint8_t { Equal, NotEqual, Less, AtMost, Greater, AtLeast };
inline constexpr std::array<std::string_view, 6> kComparisonNames = {"==", "!=", "<",
                                                                     "<=", ">",  ">="};
bool holds(std::int64_t left, Comparison comparison, std::int64_t right);

/// The ticks of a span at which an expectation must hold.
enum class When : std::uint8_t { At, By, Never, Always };
inline constexpr std::array<std::string_view, 4> kWhenNames = {"at", "by", "never", "always"};

struct Expectation {
    std::uint32_t tick = 0; // the last one
    Field field = Field::Result;
    Comparison comparison = Comparison::Equal;
    std::int64_t value = 0;
    int line = 0; // in the file, from 1
    When when = When::At;
    std::uint32_t from = 0; // the first tick of a span

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

/// The problem of a text of more than kLargestReplay.
FileProblem longerThanLargest(const std::string& file);
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
    /// After the last tick.
    std::int64_t valueOf(Field field) const { return values_.valueOf(game_, field); }

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
        std::uint32_t tick = 0; // at which it was found

        /// For example "expect 600 lives == 3, but lives is 2".
        std::string text() const;
    };
    const std::vector<Failure>& failures() const { return failures_; }

private:
    void look();
    void compareHashes();
    void judge(std::size_t index);

    Replay replay_;
    Game game_;
    Input input_;
    std::size_t nextInput_ = 0;
    std::size_t nextHash_ = 0;
    std::optional<Divergence> divergence_;
    std::optional<std::uint32_t> agreed_;
    std::vector<Failure> failures_;
    FieldValues values_;
    std::vector<char> settled_; // of each expectation: met (By), or broken (Never, Always)
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
