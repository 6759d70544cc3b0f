// SPDX-License-Identifier: MIT
#include <apart/core/expectation_reader.hpp>
#include <apart/core/replay.hpp>
#include <apart/core/replay_words.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace apart {

namespace {

constexpr std::int64_t kFormat = 3; // the newest

constexpr const char* kHowToEdit =
    "To edit a replay, remove its digest line and add a line handwritten below the seed";

/// Reads a replay line by line up to the first problem. Each read...() returns the reason why its
/// line is invalid, or "".
class ReplayReader {
public:
    ReplayReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    Read<Replay> read() {
        std::size_t start = 0;
        for (line_ = 1; start < text_.size(); ++line_) {
            const std::size_t end = text_.find('\n', start);
            if (end == std::string_view::npos) {
                return problem("the file is cut off: its last line has no end");
            }
            lineStart_ = start;
            const Words words = wordsOf(text_.substr(start, end - start));
            start = end + 1;
            const std::string reason = words.empty() ? "" : readLine(words);
            if (!reason.empty()) {
                return problem(reason);
            }
        }
        --line_;
        if (const std::string reason = whatIsMissing(); !reason.empty()) {
            return problem(reason);
        }
        if (const std::optional<FileProblem> late = lateEntry()) {
            return *late;
        }
        return replay_;
    }

private:
    FileProblem problem(std::string reason) const { return {file_, line_, std::move(reason)}; }

    std::string readLine(const Words& words) {
        const std::string_view first = words[0];
        if (!begun_) {
            return readFormat(words);
        }
        if (hasDigest_ || (ended_ && first != "digest")) {
            return "nothing may follow the end of the replay";
        }
        if (first == "level") {
            return readLevel(words);
        }
        if (first == "rules" || first == "seed") {
            return readHead(words);
        }
        if (first == "handwritten" && words.size() == 1) {
            replay_.handwritten = true;
            return "";
        }
        const auto mode = std::find(kModeNames.begin() + 1, kModeNames.end(), first);
        if (mode != kModeNames.end() && words.size() == 1) {
            if (replay_.mode != Mode::Standard) {
                return "a second mode";
            }
            replay_.mode = static_cast<Mode>(mode - kModeNames.begin());
            return "";
        }
        if (first == "hash") {
            return readHashes(words);
        }
        if (first == "expect") {
            return readExpect(words);
        }
        if (first == "end") {
            return readEnd(words);
        }
        if (first == "digest") {
            return readDigest(words);
        }
        return readInput(words);
    }

    std::string readFormat(const Words& words) {
        const std::optional<std::int64_t> format =
            words.size() == 2 && words[0] == "apart-replay" ? toNumber(words[1]) : std::nullopt;
        if (!format || *format < 1) {
            return "not a replay of this game: its first line, but for comments, must be "
                   "apart-replay 3";
        }
        if (*format > kFormat) {
            return "was written by a newer game: it has format " + std::to_string(*format) +
                   ", and this game reads up to " + std::to_string(kFormat);
        }
        begun_ = true;
        format_ = *format;
        return "";
    }

    std::string readLevel(const Words& words) {
        if (words.size() < 2 || words.size() > 3 || !replay_.level.empty()) {
            return "one line must say: level NAME DIGEST";
        }
        replay_.level = words[1];
        if (words.size() == 3) {
            replay_.levelDigest = fromHex(words[2]);
            if (!replay_.levelDigest) {
                return "the digest of the level must be 16 hexadecimal digits";
            }
        }
        return "";
    }

    std::string readHead(const Words& words) {
        const std::optional<std::int64_t> value =
            words.size() == 2 ? toNumber(words[1]) : std::nullopt;
        if (!value || *value < 0 || *value > std::numeric_limits<std::uint32_t>::max()) {
            return std::string(words[0]) + " needs one whole number from 0 to 4294967295";
        }
        const auto number = static_cast<std::uint32_t>(*value);
        if (words[0] == "rules") {
            if (replay_.rules) {
                return "a second version of the rules";
            }
            replay_.rules = number;
        } else {
            if (hasSeed_) {
                return "a second seed";
            }
            hasSeed_ = true;
            replay_.seed = number;
        }
        return "";
    }

    std::string readInput(const Words& words) {
        const std::optional<std::uint32_t> tick = tickOf(words[0]);
        if (!tick) {
            return quoted(words[0]) + " is neither a tick nor a word of the format";
        }
        const auto columns = static_cast<std::size_t>(3 + format_); // the last may be omitted
        if (words.size() < 4 || words.size() > columns) {
            return format_ == 1 ? "an input line has four columns: tick paddle target launch"
                                : std::string("an input line has the columns tick paddle target "
                                              "launch force") +
                                      (format_ == 2 ? "" : " aim");
        }
        if (!replay_.inputs.empty() && *tick <= replay_.inputs.back().tick) {
            return "the ticks of input lines must rise";
        }
        const std::optional<std::int64_t> paddle = toNumber(words[1]);
        if (!paddle || *paddle < -127 || *paddle > 127) {
            return "paddle must be a whole number from -127 to 127";
        }
        Input input;
        input.paddle = static_cast<std::int8_t>(*paddle);
        if (words[2] != "-") {
            const std::optional<std::int64_t> target = toNumber(words[2]);
            if (!target || *target < -32000 || *target > 32000) {
                return "target must be - or a whole number from -32000 to 32000";
            }
            input.target = static_cast<std::int16_t>(*target);
        }
        if (words[3] != "0" && words[3] != "1") {
            return "launch must be 0 or 1";
        }
        input.launch = words[3] == "1";
        const std::optional<std::size_t> force =
            indexOf(words.size() > 4 ? words[4] : "0", kForceNames);
        if (!force) {
            return "force must be 0, pull or push";
        }
        input.force = static_cast<Force>(*force);
        if (words.size() == 6 && words[5] != "-") {
            const std::optional<std::int64_t> aim = toNumber(words[5]);
            if (!aim || *aim < -kMostAim || *aim > kMostAim) {
                return "aim must be - or a whole number from -" + std::to_string(kMostAim) +
                       " to " + std::to_string(kMostAim);
            }
            input.aim = static_cast<std::int16_t>(*aim);
        }
        replay_.inputs.push_back({*tick, input});
        return "";
    }

    std::string readHashes(const Words& words) {
        if (words.size() < 3 || words.size() % 2 != 1) {
            return "a hash line has pairs of a tick and a hash";
        }
        for (std::size_t i = 1; i < words.size(); i += 2) {
            const std::optional<std::uint32_t> tick = tickOf(words[i]);
            const std::optional<std::uint64_t> hash = fromHex(words[i + 1]);
            if (!tick) {
                return tickReason(words[i]);
            }
            if (!hash) {
                return "a hash has 16 hexadecimal digits, unlike " + quoted(words[i + 1]);
            }
            if (!replay_.hashes.empty() && *tick <= replay_.hashes.back().tick) {
                return "the ticks of hashes must rise";
            }
            replay_.hashes.push_back({*tick, *hash});
            hashLines_.push_back(line_);
        }
        return "";
    }

    std::string readExpect(const Words& words) {
        Expectation expectation;
        expectation.line = line_;
        const std::string reason = readExpectation(words, expectation);
        if (reason.empty()) {
            replay_.expectations.push_back(expectation);
        }
        return reason;
    }

    std::string readEnd(const Words& words) {
        const std::optional<std::uint32_t> tick =
            words.size() == 2 ? tickOf(words[1]) : std::nullopt;
        if (!tick) {
            return "end needs one tick, from 0 to " + std::to_string(kLongestReplay);
        }
        replay_.end = *tick;
        ended_ = true;
        return "";
    }

    std::string readDigest(const Words& words) {
        const std::optional<std::uint64_t> digest =
            words.size() == 2 ? fromHex(words[1]) : std::nullopt;
        if (!ended_ || replay_.handwritten || !digest) {
            return "a digest of 16 hexadecimal digits stands after the end of a recorded replay, "
                   "and only there; one that was edited has none";
        }
        if (*digest != digestOf(text_.substr(0, lineStart_))) {
            return std::string("the file was changed after it was recorded: its digest does not "
                               "match. ") +
                   kHowToEdit;
        }
        hasDigest_ = true;
        return "";
    }

    std::string whatIsMissing() const {
        if (!begun_) {
            return "the file is empty";
        }
        if (!ended_) {
            return "the file is cut off: there is no line end TICK";
        }
        if (replay_.level.empty() || !hasSeed_) {
            return replay_.level.empty() ? "there is no line level NAME"
                                         : "there is no line seed N";
        }
        if (!replay_.handwritten && (!replay_.levelDigest || !replay_.rules || !hasDigest_)) {
            return std::string("the file is cut off or was edited: a recorded replay has rules, "
                               "the digest of its level and its own digest at the end. ") +
                   kHowToEdit;
        }
        return "";
    }

    /// The first hash or expectation after the end.
    std::optional<FileProblem> lateEntry() const {
        std::optional<FileProblem> first;
        const auto note = [&](std::uint32_t tick, int line, const char* what) {
            if (tick > replay_.end && (!first || line < first->line)) {
                first = FileProblem{file_, line,
                                    std::string(what) + " comes after the end, tick " +
                                        std::to_string(replay_.end)};
            }
        };
        for (std::size_t i = 0; i < replay_.hashes.size(); ++i) {
            note(replay_.hashes[i].tick, hashLines_[i], "a hash");
        }
        for (const Expectation& expectation : replay_.expectations) {
            note(expectation.tick, expectation.line, "the expectation");
        }
        return first;
    }

    std::string_view text_;
    std::string file_;
    Replay replay_;
    std::vector<int> hashLines_; // of each hash
    int line_ = 1;
    std::size_t lineStart_ = 0;
    bool begun_ = false;
    std::int64_t format_ = kFormat; // 1 lacks the column force, 2 the column aim
    bool hasSeed_ = false;
    bool ended_ = false;
    bool hasDigest_ = false;
};

} // namespace

FileProblem longerThanLargest(const std::string& file) {
    return {file, 0, "is longer than " + std::to_string(kLargestReplay) + " bytes"};
}

Read<Replay> parseReplay(std::string_view text, const std::string& file) {
    if (text.size() > kLargestReplay) {
        return longerThanLargest(file);
    }
    return ReplayReader(text, file).read();
}

Read<Replay> readReplayFile(const std::filesystem::path& path) {
    const Read<std::string> text = readTextFile(path, kLargestReplay);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        return *problem;
    }
    return parseReplay(std::get<std::string>(text), path.string());
}

} // namespace apart
