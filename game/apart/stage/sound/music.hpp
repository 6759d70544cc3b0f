// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/sound/room.hpp>
#include <apart/stage/sound/score.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace apart {

/// What the music follows, 0..1 each.
struct Tension {
    float combo = 0;
    float danger = 0;
    bool muffled = false; // a menu covers the game: only the quiet layers play
    bool won = false;     // the tune closes, and its last chord stays
};

/// The music of a theme: its score, synthesised while it plays. Ambience, chords, tune and bass are
/// always there; the second part joins in the second verse or with a combo, then arpeggio and
/// drums, and a heartbeat in danger. The same tensions give the same samples.
class Music {
public:
    explicit Music(Theme theme);
    Frame next(const Tension& tension);

private:
    enum class Kind { Lead, Reed, Pad, Bass, Pluck, Bell, Kick, Hat };
    struct Tone {
        Kind kind;
        float step;      // turns per sample
        float phase = 0; // turns
        float gain;
        float pan;       // -1..1
        float level = 0; // of the envelope, 0..1
        float attack;    // per sample
        float decay;     // factor per sample, after the attack
        int hold;        // samples until the decay
        bool rising = true;
    };
    void takeStep(const Tension& tension);
    void close(const Tension& tension);
    void takeParts(const Tension& tension);
    void takeChord(const Tension& tension);
    void takeDrums(const Tension& tension);
    void takeArpeggio(const Tension& tension);
    void add(Kind kind, int degree, float gain, float seconds);
    float sampleOf(Tone& tone);
    Frame ambience();
    bool rests() const;
    int chord() const;
    float hertzOf(int degree) const;

    Theme theme_;
    Dice dice_;
    std::vector<Tone> tones_;
    Tension smooth_;       // of a second or two
    int samplesLeft_ = 0;  // until the next step, a sixteenth
    int step_ = 0;         // sixteenths since the start of the form
    bool closing_ = false; // the last two bars play, or their chord stays
    SecondPart second_;
    float swell_ = 0;             // turns, of the ambience
    std::array<float, 3> dull_{}; // states of the filters of the ambience
};

} // namespace apart
