// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <array>
#include <string>
#include <string_view>

namespace apart {

// The written music of a theme. Degrees count steps of its scale from the root: 7 are an octave,
// and negative ones lie below.

inline constexpr int kBarsOfForm = 32; // four times eight: verse, verse, bridge, verse
inline constexpr int kEighthsOfBar = 8;
inline constexpr int kEighthsOfForm = kBarsOfForm * kEighthsOfBar;

/// A bar: its chord, a triad of the scale, and the tune. Each character is an eighth: a digit is a
/// degree, a b c are 10 11 12, z y x are -1 -2 -3, '-' holds the note and '.' rests.
struct Bar {
    int chord; // degree of the root
    std::string_view tune;
};

struct Score {
    float beats;              // per minute
    int root;                 // semitones from A at 110 Hz
    std::array<int, 7> scale; // semitones
    std::array<Bar, 4> verse; // the last bar opens
    std::array<Bar, 2> close; // the last two bars of the eight, in place of those of the verse
    std::array<Bar, 4> bridge;
};

const Score& scoreOf(Theme theme);
/// Bar 0..31 of the form; higher numbers repeat it.
const Bar& barOf(const Score& score, int bar);
int semitonesOf(const Score& score, int degree);

/// A note that begins in an eighth.
struct Step {
    bool sounds = false; // false: a rest, or an earlier note goes on
    int degree = 0;
    int eighths = 0; // duration
};
/// The tune in an eighth of the form, counted from its start.
Step leadOf(const Score& score, int eighth);
/// The second part: half notes of the chord below the tune. Each is the nearest to the one before
/// that makes no parallel fifth or octave with the tune.
class SecondPart {
public:
    Step next(const Score& score, int eighth);

private:
    int last_ = 0;     // degree, of this part
    int lastLead_ = 0; // degree
    bool begun_ = false;
};

/// Both parts of a theme in ABC notation 2.1, with its chords as roman numerals.
std::string abcOf(Theme theme);

} // namespace apart
