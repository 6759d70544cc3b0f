// SPDX-License-Identifier: MIT
// The written music of the themes.
#include <apart/stage/sound/music.hpp>
#include <apart/stage/sound/score.hpp>
#include <apart/stage/sound/synth.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace apart {
namespace {

constexpr std::size_t kThemes = kThemeNames.size();

bool inChord(int degree, int chord) {
    const int third = ((degree - chord) % 7 + 7) % 7;
    return third == 0 || third == 2 || third == 4;
}

TEST(Score, EveryBarHasEightEighthsAndBeginsOnItsChord) {
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        const Score& score = scoreOf(static_cast<Theme>(theme));
        for (int bar = 0; bar < kBarsOfForm; ++bar) {
            ASSERT_EQ(barOf(score, bar).tune.size(), std::size_t{kEighthsOfBar})
                << kThemeNames[theme];
            const Step first = leadOf(score, bar * kEighthsOfBar);
            ASSERT_TRUE(first.sounds) << kThemeNames[theme] << ", bar " << bar + 1;
            EXPECT_TRUE(inChord(first.degree, barOf(score, bar).chord))
                << kThemeNames[theme] << ", bar " << bar + 1;
        }
    }
}

TEST(Score, TheFormIsVerseVerseBridgeVerseAndClosesOnTheRoot) {
    std::set<std::string> tunes;
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        const Score& score = scoreOf(static_cast<Theme>(theme));
        std::string whole;
        for (int bar = 0; bar < kBarsOfForm; ++bar) {
            whole += barOf(score, bar).tune;
        }
        const auto part = [&](int from) {
            return whole.substr(std::size_t{64} * std::size_t(from), 64);
        };
        EXPECT_EQ(part(0), part(1));
        EXPECT_NE(part(0), part(2));
        EXPECT_EQ(part(0), part(3));
        EXPECT_TRUE(tunes.insert(whole).second) << "each theme has its own tune";
        for (const int bar : {7, 15, 31}) {
            EXPECT_EQ(barOf(score, bar).chord, 0);
            EXPECT_EQ(leadOf(score, bar * kEighthsOfBar).degree % 7, 0) << kThemeNames[theme];
        }
        EXPECT_EQ(&barOf(score, kBarsOfForm), &barOf(score, 0));
    }
}

TEST(Score, TheSecondPartLiesBelowInTheChordWithoutParallelFifths) {
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        const Score& score = scoreOf(static_cast<Theme>(theme));
        SecondPart second;
        std::optional<Step> before;
        int leadBefore = 0;
        int lead = 0;
        for (int eighth = 0; eighth < kEighthsOfForm; ++eighth) {
            const Step tune = leadOf(score, eighth);
            lead = tune.sounds ? tune.degree : lead;
            const Step step = second.next(score, eighth);
            if (!step.sounds) {
                continue;
            }
            EXPECT_TRUE(inChord(step.degree, barOf(score, eighth / kEighthsOfBar).chord));
            const int gap = lead - step.degree;
            EXPECT_GE(gap, 2);
            EXPECT_LE(gap, 7);
            if (before && lead != leadBefore && (gap == 4 || gap == 7)) {
                EXPECT_NE(leadBefore - before->degree, gap)
                    << kThemeNames[theme] << ", eighth " << eighth;
            }
            before = step;
            leadBefore = lead;
        }
    }
}

/// Share of the energy of a sound in the pitch classes of a chord of the theme, of that in the
/// pitches of its scale, by correlation.
double shareOfChord(const std::vector<float>& samples, const Score& score, int chord) {
    double inside = 0;
    double all = 0;
    for (int degree = 0; degree < 14; ++degree) {
        const double hertz = 110 * std::exp2((score.root + semitonesOf(score, degree)) / 12.0);
        double sine = 0;
        double cosine = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double turn = 2 * std::numbers::pi * hertz * static_cast<double>(i) / kSampleRate;
            sine += static_cast<double>(samples[i]) * std::sin(turn);
            cosine += static_cast<double>(samples[i]) * std::cos(turn);
        }
        const double energy = sine * sine + cosine * cosine;
        all += energy;
        inside += inChord(degree, chord) ? energy : 0;
    }
    return inside / all;
}

TEST(Music, AWonGameClosesOnTheChordOfTheRootAndStaysThere) {
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        const Score& score = scoreOf(static_cast<Theme>(theme));
        Music music(static_cast<Theme>(theme));
        const double bar = 240 / static_cast<double>(score.beats); // s
        const auto play = [&](double seconds, bool won) {
            std::vector<float> samples;
            for (int i = 0; i < int(seconds * kSampleRate); ++i) {
                const Frame frame = music.next({0, 0, false, won});
                samples.push_back(frame.left + frame.right);
            }
            return samples;
        };
        play(1.1 * bar, false);
        play(2.4 * bar, true); // at most a beat until the close begins, then two bars
        EXPECT_GT(shareOfChord(play(0.5 * bar, true), score, 0), 0.9) << kThemeNames[theme];
        play(bar, true);
        EXPECT_GT(shareOfChord(play(0.5 * bar, true), score, 0), 0.9) << kThemeNames[theme];
    }
}

// APART_WRITE_SCORE=FILE writes the notes that the page holds.
TEST(Score, ThePageHasTheNotes) {
    std::string notes;
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        notes += "```abc\n" + abcOf(static_cast<Theme>(theme)) + "```\n\n";
    }
    if (const char* file = std::getenv("APART_WRITE_SCORE")) {
        std::ofstream(file) << notes;
    }
    std::ifstream page(APART_MUSIC_PAGE);
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    for (std::size_t theme = 0; theme < kThemes; ++theme) {
        EXPECT_NE(text.find(abcOf(static_cast<Theme>(theme))), std::string::npos)
            << kThemeNames[theme];
    }
}

} // namespace
} // namespace apart
