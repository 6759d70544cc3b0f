// SPDX-License-Identifier: MIT
#include <apart/stage/sound/score.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>

namespace apart {

namespace {

constexpr std::array<int, 7> kMajor = {0, 2, 4, 5, 7, 9, 11};
constexpr std::array<int, 7> kLydian = {0, 2, 4, 6, 7, 9, 11};
constexpr std::array<int, 7> kDorian = {0, 2, 3, 5, 7, 9, 10};
constexpr std::array<int, 7> kHarmonic = {0, 2, 3, 5, 7, 8, 11};
constexpr std::array<int, 7> kPhrygian = {0, 1, 3, 5, 7, 8, 10};
constexpr int kBarsOfVerse = 8;

const std::array<Score, kThemeNames.size()> kScores = {{
    {84, // Daybreak: a tune that climbs to the sixth and comes down
     5,
     kMajor,
     {{{0, "4---2-4-"}, {5, "7---5---"}, {3, "5-4-3-5-"}, {4, "4-----.."}}},
     {{{4, "8-6-4-6-"}, {0, "7-----.."}}},
     {{{5, "9-8-7-5-"}, {3, "7---5-3-"}, {1, "5-4-3-1-"}, {4, "4---6-8-"}}}},
    {76, // Quarry: heavy steps
     0,
     kDorian,
     {{{0, "0---2-4-"}, {6, "6-8-6---"}, {3, "5---3-2-"}, {0, "4-----.."}}},
     {{{6, "3---1---"}, {0, "0-----.."}}},
     {{{2, "9---8-6-"}, {6, "8---6---"}, {3, "7-5-3-5-"}, {0, "4---2---"}}}},
    {108, // Fairground: a barrel organ that hops
     10,
     kMajor,
     {{{0, "4.5.7.4."}, {4, "6.8.6.4."}, {1, "5.3.5.7."}, {4, "8-6-4-.."}}},
     {{{4, "8.9.8.6."}, {0, "7---7..."}}},
     {{{3, "7-5-3-5-"}, {0, "4-2-4-7-"}, {3, "7-8-9-7-"}, {4, "8---6-4-"}}}},
    {70, // Harbour: a song for hauling
     7,
     kDorian,
     {{{0, "0-4-4-2-"}, {3, "7-5-3---"}, {0, "4-2-0-2-"}, {6, "1---3---"}}},
     {{{6, "3-1-z-1-"}, {0, "0-----.."}}},
     {{{2, "6-4-2-4-"}, {6, "6---8-6-"}, {3, "7-5-3-5-"}, {0, "4-----.."}}}},
    {96, // Clockwork: wheels that turn
     3,
     kHarmonic,
     {{{0, "0.2.4.2."}, {3, "3.5.7.5."}, {4, "6-4-6-8-"}, {0, "7-4-2---"}}},
     {{{4, "8-6-4-6-"}, {0, "7-----.."}}},
     {{{5, "9-7-5-7-"}, {3, "7-5-3-5-"}, {4, "6-8-6-4-"}, {4, "8-6-4---"}}}},
    {60, // Observatory: long notes far apart
     8,
     kLydian,
     {{{0, "4-----7-"}, {1, "8---5---"}, {5, "9---7---"}, {4, "8-----6-"}}},
     {{{1, "8---5-8-"}, {0, "7-------"}}},
     {{{5, "7---9---"}, {1, "a---8---"}, {0, "9---7---"}, {4, "8-----.."}}}},
    {88, // Fortress: a march down to the flat second
     5,
     kPhrygian,
     {{{0, "4---2-0-"}, {1, "1-3-5-3-"}, {5, "5---7-5-"}, {0, "4-----.."}}},
     {{{1, "5-3-1---"}, {0, "0-----.."}}},
     {{{3, "7-5-3-5-"}, {0, "4-2-0-2-"}, {1, "5-3-1-3-"}, {0, "4---0---"}}}},
}};

std::optional<int> degreeOf(char mark) {
    if (mark >= '0' && mark <= '9') {
        return mark - '0';
    }
    if (mark >= 'a' && mark <= 'c') {
        return 10 + (mark - 'a');
    }
    if (mark >= 'x' && mark <= 'z') {
        return mark - 'z' - 1;
    }
    return std::nullopt;
}

char markAt(const Score& score, int eighth) {
    return barOf(score, eighth / kEighthsOfBar)
        .tune[static_cast<std::size_t>(eighth % kEighthsOfBar)];
}

/// The note of the tune that sounds in an eighth, or was the last one before a rest.
int degreeAround(const Score& score, int eighth) {
    for (int at = eighth; at >= 0; --at) {
        if (const std::optional<int> degree = degreeOf(markAt(score, at))) {
            return *degree;
        }
    }
    return 0;
}

/// In ABC, C is that of 262 Hz, c lies an octave above it and C, below. Degree 0 with root 0 is A
/// at 440 Hz, where both parts are played.
std::string nameInAbc(const Score& score, int degree) {
    constexpr std::array<std::string_view, 12> kNames = {"C",  "^C", "D",  "^D", "E",  "F",
                                                         "^F", "G",  "^G", "A",  "^A", "B"};
    const int fromC = semitonesOf(score, degree) + score.root + 9; // A is 9 above C
    const int octave = fromC >= 0 ? fromC / 12 : (fromC - 11) / 12;
    std::string name{kNames[static_cast<std::size_t>(fromC - 12 * octave)]};
    if (octave > 0) {
        name.back() = static_cast<char>(name.back() + ('a' - 'A'));
        name.append(static_cast<std::size_t>(octave - 1), '\'');
    } else {
        name.append(static_cast<std::size_t>(-octave), ',');
    }
    return name;
}

template <typename Part>
std::string voiceInAbc(const Score& score, Part part) {
    constexpr std::array<std::string_view, 7> kRoman = {"I", "II", "III", "IV", "V", "VI", "VII"};
    std::string text;
    int silent = 0;
    const auto flush = [&] {
        text += silent > 0 ? fmt::format("z{} ", silent) : "";
        silent = 0;
    };
    int left = 0; // eighths of the note that sounds
    for (int eighth = 0; eighth < kEighthsOfForm; ++eighth) {
        if (eighth % kEighthsOfBar == 0) {
            const int chord = barOf(score, eighth / kEighthsOfBar).chord;
            text += fmt::format("\"{}\"", kRoman[static_cast<std::size_t>(chord)]);
        }
        if (const Step step = part(eighth); step.sounds) {
            flush();
            text += fmt::format("{}{} ", nameInAbc(score, step.degree), step.eighths);
            left = step.eighths;
        }
        silent += left-- > 0 ? 0 : 1;
        if (eighth % kEighthsOfBar == kEighthsOfBar - 1) {
            flush();
            text += eighth % (4 * kEighthsOfBar) == 4 * kEighthsOfBar - 1 ? "|\n" : "| ";
        }
    }
    return text;
}

} // namespace

const Score& scoreOf(Theme theme) {
    return kScores[static_cast<std::size_t>(theme)];
}

const Bar& barOf(const Score& score, int bar) {
    const int within = bar % kBarsOfForm;
    const auto line = static_cast<std::size_t>(within % 4);
    if (within / kBarsOfVerse == 2) {
        return score.bridge[line];
    }
    const int last = within % kBarsOfVerse - (kBarsOfVerse - 2);
    return last >= 0 ? score.close[static_cast<std::size_t>(last)] : score.verse[line];
}

int semitonesOf(const Score& score, int degree) {
    const int octave = degree >= 0 ? degree / 7 : (degree - 6) / 7;
    return 12 * octave + score.scale[static_cast<std::size_t>(degree - 7 * octave)];
}

Step leadOf(const Score& score, int eighth) {
    const std::optional<int> degree = degreeOf(markAt(score, eighth));
    if (!degree) {
        return {};
    }
    int end = eighth + 1;
    while (end % kEighthsOfBar != 0 && markAt(score, end) == '-') {
        ++end;
    }
    return {true, *degree, end - eighth};
}

Step SecondPart::next(const Score& score, int eighth) {
    constexpr int kHalf = kEighthsOfBar / 2;
    constexpr int kParallel = 100; // dearer than any leap
    if (eighth % kHalf != 0) {
        return {};
    }
    const int lead = degreeAround(score, eighth);
    const int chord = barOf(score, eighth / kEighthsOfBar).chord;
    int best = lead - 2;
    int least = 1000;
    for (int degree = lead - 7; degree <= lead - 2; ++degree) {
        const int third = ((degree - chord) % 7 + 7) % 7; // 0, 2, 4 in the chord
        if (third > 4 || third % 2 != 0) {
            continue;
        }
        const int gap = lead - degree;
        const bool bare = gap == 4 || gap == 7;
        const bool parallel = begun_ && bare && lastLead_ - last_ == gap && lead != lastLead_;
        const int cost = (begun_ ? 2 * std::abs(degree - last_) : 0) + (bare ? 1 : 0) +
                         (parallel ? kParallel : 0);
        if (cost < least) {
            least = cost;
            best = degree;
        }
    }
    begun_ = true;
    last_ = best;
    lastLead_ = lead;
    return {true, best, kHalf};
}

std::string abcOf(Theme theme) {
    const Score& score = scoreOf(theme);
    const auto number = static_cast<std::size_t>(theme);
    std::string title{kThemeNames[number]};
    title.front() = static_cast<char>(title.front() - ('a' - 'A'));
    SecondPart second;
    return fmt::format("X:{}\nT:{}\nM:4/4\nL:1/8\nQ:1/4={}\nK:none\n", number + 1, title,
                       score.beats) +
           "V:1\n" + voiceInAbc(score, [&](int eighth) { return leadOf(score, eighth); }) +
           "V:2\n" + voiceInAbc(score, [&](int eighth) { return second.next(score, eighth); });
}

} // namespace apart
