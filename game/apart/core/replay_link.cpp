// SPDX-License-Identifier: MIT
#include <apart/core/bit_coder.hpp>
#include <apart/core/replay_link.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace apart {

namespace {

constexpr std::string_view kFragment = "#replay=";
constexpr std::string_view kDigits = // RFC 4648, 5
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
// Both sides learn the words of a replay from it.
constexpr std::string_view kSample =
    "apart-replay 3\nlevel endless:20261126:1 0123456789abcdef\nrules 32\nseed 20261127\npure\n"
    "# tick paddle target launch force aim\nhash 7200 0123456789abcdef\n"
    "expect 7200 result == won\nexpect 7200 score == 12345\nend 7200\n"
    "apart-replay 3\nlevel arch 0ca4b26ff57b1734\nrules 32\nseed 123456\n"
    "# tick paddle target launch force aim\n"
    "expect 1525 result == lost\nexpect 1525 score == 27500\nend 1525\n";

/// Codes a run in one order of calls for both directions.
class RunCoder {
public:
    explicit RunCoder(BitCoder coder) : coder_(std::move(coder)), letters_(256 * 256) {
        BitCoder school;
        std::swap(coder_, school);
        text(std::string(kSample));
        std::swap(coder_, school);
    }

    std::string text(std::string value) {
        std::string found;
        std::size_t before = 0;
        do {
            std::size_t node = 1;
            const unsigned letter =
                found.size() < value.size() ? static_cast<unsigned char>(value[found.size()]) : 0;
            for (int i = 7; i >= 0; --i) {
                const bool one = coder_.bit((letter >> i & 1) != 0, letters_[256 * before + node]);
                node = 2 * node + (one ? 1 : 0);
            }
            before = node - 256;
            found += static_cast<char>(before);
        } while (before != 0 && found.size() < kMostHead);
        found.pop_back();
        return found;
    }

    std::uint32_t count(std::uint32_t value) { return coder_.number(value, counts_); }

    /// False if a reader finds more than a replay may have.
    bool inputs(std::vector<InputChange>& all, std::uint32_t end) {
        if (!entries(all, end, kShortestInput)) {
            return false;
        }
        Input last;
        std::uint32_t tick = 0;
        for (InputChange& change : all) {
            change.tick = tick + coder_.number(change.tick - tick, ticks_);
            input(change.input, last, change.tick - tick);
            tick = change.tick;
            last = change.input;
        }
        return true;
    }

    /// As inputs().
    bool hashes(std::vector<HashMark>& all, std::uint32_t end) {
        if (!entries(all, end, kShortestHash)) {
            return false;
        }
        std::uint32_t tick = 0;
        for (HashMark& mark : all) {
            tick = mark.tick = tick + count(mark.tick - tick);
            mark.hash = bits64(mark.hash);
        }
        return true;
    }

    std::uint64_t bits64(std::uint64_t value) {
        std::uint64_t found = 0;
        for (int i = 63; i >= 0; --i) {
            BitCoder::Odds even;
            found = 2 * found + (coder_.bit((value >> i & 1) != 0, even) ? 1 : 0);
        }
        return found;
    }

    std::string finish() { return coder_.finish(); }

private:
    static constexpr std::size_t kMostHead = 100000; // bytes of a text
    static constexpr std::size_t kShortestInput = std::string_view("0 0 - 0 0\n").size();
    static constexpr std::size_t kShortestHash =
        std::string_view("hash 0 0123456789abcdef\n").size();

    /// Codes the number of entries, whose lines have at least so many bytes. A reader makes them,
    /// unless their text and what it has read before are longer than kLargestReplay.
    template <typename Entry>
    bool entries(std::vector<Entry>& all, std::uint32_t end, std::size_t shortest) {
        const std::uint32_t size = count(static_cast<std::uint32_t>(all.size()));
        const std::size_t made = std::min<std::size_t>(size, std::size_t{end} + 1);
        if (coder_.reads() && made > room_ / shortest) {
            return false;
        }
        room_ -= coder_.reads() ? made * shortest : 0;
        all.resize(made);
        return true;
    }

    /// The place of the target is predicted from its last speed (1/1000 m a tick).
    void input(Input& now, const Input& last, std::uint32_t ticks) {
        const auto flag = [&](bool value, std::size_t which, bool before) {
            return coder_.bit(value, flags_[2 * which + (before ? 1 : 0)]);
        };
        const auto changed = [](std::int32_t value, std::int32_t least, std::int32_t most) {
            return std::clamp(value, least, most);
        };
        const int paddle = now.paddle - last.paddle;
        now.paddle = static_cast<std::int8_t>(
            changed(last.paddle + coder_.signedNumber(paddle, paddles_), -127, 127));
        now.launch = flag(now.launch, 0, last.launch);
        const bool pull = flag(now.force == Force::Pull, 1, last.force == Force::Pull);
        const bool push = !pull && flag(now.force == Force::Push, 2, last.force == Force::Push);
        now.force = pull ? Force::Pull : push ? Force::Push : Force::None;
        const bool target = flag(now.target.has_value(), 3, last.target.has_value());
        const bool aim = flag(now.aim.has_value(), 4, last.aim.has_value());
        constexpr std::int32_t kLeast = std::numeric_limits<std::int16_t>::min();
        constexpr std::int32_t kMost = std::numeric_limits<std::int16_t>::max();
        if (target) {
            const bool follows = ticks == 1;
            const std::int32_t guess = place_ + (follows ? speed_ : 0);
            const std::int32_t error = now.target.value_or(0) - guess;
            BitCoder::NumberOdds& odds = errors_[std::min<std::size_t>(size_, errors_.size() - 1)];
            const std::int32_t found = coder_.signedNumber(error, odds);
            const std::int32_t place = changed(guess + found, kLeast, kMost);
            size_ = 0;
            for (std::int32_t rest = std::abs(found); rest > 0; rest /= 4) {
                ++size_;
            }
            speed_ = place - place_;
            place_ = place;
            now.target = static_cast<std::int16_t>(place);
        } else {
            now.target.reset();
        }
        if (aim) {
            const std::int32_t found = coder_.signedNumber(now.aim.value_or(0) - aim_, aims_);
            aim_ = changed(aim_ + found, kLeast, kMost);
            now.aim = static_cast<std::int16_t>(aim_);
        } else {
            now.aim.reset();
        }
    }

    BitCoder coder_;
    std::vector<BitCoder::Odds> letters_; // by the letter before
    BitCoder::NumberOdds counts_;
    BitCoder::NumberOdds ticks_;
    BitCoder::NumberOdds paddles_;
    BitCoder::NumberOdds aims_;
    std::array<BitCoder::NumberOdds, 6> errors_; // of targets, by the size of the last one
    std::array<BitCoder::Odds, 10> flags_;
    std::int32_t place_ = 0; // 1/1000 m, of the last target
    std::int32_t speed_ = 0;
    std::size_t size_ = 0; // of the last error, in pairs of bits
    std::int32_t aim_ = 0;
    std::size_t room_ = kLargestReplay; // bytes of text that a reader may still make of entries
};

/// The replay without inputs, hashes and digest.
std::string headOf(Replay replay) {
    replay.inputs.clear();
    replay.hashes.clear();
    const std::string text = toText(replay);
    return text.substr(0, text.rfind("digest "));
}

/// Hashes at multiples of kLinkHash, and the last one.
std::vector<HashMark> fewHashes(const std::vector<HashMark>& all) {
    std::vector<HashMark> few;
    for (const HashMark& mark : all) {
        if (mark.tick % kLinkHash == 0 || mark.tick == all.back().tick) {
            few.push_back(mark);
        }
    }
    return few;
}

std::string toBase64(std::string_view bytes) {
    std::string text;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char byte : bytes) {
        held = (held << 8) | static_cast<unsigned char>(byte);
        for (bits += 8; bits >= 6; bits -= 6) {
            text += kDigits[held >> (bits - 6) & 63];
        }
    }
    if (bits > 0) {
        text += kDigits[held << (6 - bits) & 63];
    }
    return text;
}

std::optional<std::string> fromBase64(std::string_view text) {
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char letter : text) {
        const std::size_t digit = kDigits.find(letter);
        if (digit == std::string_view::npos) {
            return std::nullopt;
        }
        held = (held << 6) | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(held >> bits & 255);
        }
    }
    const bool whole = bits < 6 && (held & ((1u << bits) - 1)) == 0;
    return whole ? std::optional(bytes) : std::nullopt;
}

} // namespace

std::string packed(const ReplayRun& run) {
    RunCoder coder{BitCoder()};
    coder.count(static_cast<std::uint32_t>(run.size()));
    std::uint64_t digest = 0;
    for (const Replay& replay : run) {
        Replay kept = replay;
        kept.hashes = fewHashes(replay.hashes);
        coder.text(headOf(kept));
        coder.inputs(kept.inputs, kept.end);
        coder.hashes(kept.hashes, kept.end);
        digest ^= digestOf(toText(kept));
    }
    coder.bits64(digest);
    return kPackedMark + coder.finish();
}

Read<ReplayRun> unpacked(std::string_view bytes, const std::string& file) {
    const FileProblem damaged{file, 0, "the replay is damaged"};
    const FileProblem tooLong = longerThanLargest(file);
    constexpr std::uint32_t kMostReplays = 1000;
    if (bytes.empty() || bytes.front() != kPackedMark) {
        return damaged;
    }
    RunCoder coder{BitCoder(bytes.substr(1))};
    const std::uint32_t count = std::min(coder.count(0), kMostReplays);
    std::uint64_t digest = 0;
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::string head = coder.text("");
        const std::string sealed = head + "digest " + toHex(digestOf(head)) + "\n";
        Read<Replay> read =
            parseReplay(head.find("\nhandwritten\n") == std::string::npos ? sealed : head, file);
        if (std::holds_alternative<FileProblem>(read)) {
            return damaged;
        }
        auto& replay = std::get<Replay>(read);
        if (!coder.inputs(replay.inputs, replay.end) || !coder.hashes(replay.hashes, replay.end)) {
            return tooLong;
        }
        const std::string own = toText(replay);
        digest ^= digestOf(own);
        text += own;
        if (text.size() > kLargestReplay) {
            return tooLong;
        }
    }
    if (count == 0 || coder.bits64(0) != digest) {
        return damaged;
    }
    Read<ReplayRun> run = parseRun(text, file);
    const auto* whole = std::get_if<ReplayRun>(&run);
    return whole != nullptr && packed(*whole) != bytes ? damaged : run; // something follows it
}

std::string linkOf(const ReplayRun& run) {
    return std::string(kFragment) + toBase64(packed(run));
}

bool isLink(std::string_view text) {
    return text.find(kFragment) != std::string_view::npos;
}

Read<ReplayRun> runOfLink(std::string_view link) {
    if (link.size() > kLargestReplay) {
        return longerThanLargest("the link");
    }
    const std::size_t start = link.find(kFragment);
    const std::optional<std::string> bytes =
        start == std::string_view::npos ? std::nullopt
                                        : fromBase64(link.substr(start + kFragment.size()));
    return unpacked(bytes.value_or(""), "the link");
}

} // namespace apart
