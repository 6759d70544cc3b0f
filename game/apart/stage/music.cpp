// SPDX-License-Identifier: MIT
#include <apart/stage/angle.hpp>
#include <apart/stage/music.hpp>
#include <apart/stage/synth.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace apart {

namespace {

constexpr int kStepsOfBar = 16;
constexpr std::size_t kMostTones = 28;
constexpr float kFollow = 1 / (0.8f * kSampleHertz); // per sample, of the tension

/// The tune of a theme. Degrees count steps of its scale from the root.
struct Tune {
    float beats;               // per minute
    int root;                  // semitones from A at 110 Hz
    std::array<int, 7> scale;  // semitones
    std::array<int, 4> chords; // degree of the root of each bar's chord
    bool bells;                // the arpeggio rings, instead of being plucked
    float air;                 // gain of the ambience
    float airBright;           // 0..1
    float airSwell;            // Hz
    float gain;                // of the whole, so that all themes are equally loud
};
constexpr std::array<int, 7> kMajor = {0, 2, 4, 5, 7, 9, 11};
constexpr std::array<int, 7> kLydian = {0, 2, 4, 6, 7, 9, 11};
constexpr std::array<int, 7> kDorian = {0, 2, 3, 5, 7, 9, 10};
constexpr std::array<int, 7> kHarmonic = {0, 2, 3, 5, 7, 8, 11};
constexpr std::array<int, 7> kPhrygian = {0, 1, 3, 5, 7, 8, 10};

constexpr std::array<Tune, kThemeNames.size()> kTunes = {{
    {84, 5, kMajor, {0, 5, 3, 4}, true, 0.5f, 0.10f, 0.11f, 1},   // Daybreak: birdless morning air
    {76, 0, kDorian, {0, 6, 3, 0}, false, 0.8f, 0.04f, 0.07f, 1}, // Quarry: wind in the pit
    {108, 10, kMajor, {0, 4, 1, 4}, true, 0.4f, 0.22f, 0.23f, 1}, // Fairground: a crowd far off
    {70, 7, kDorian, {0, 3, 0, 6}, false, 1.1f, 0.09f, 0.13f, 1}, // Harbour: waves
    {96, 3, kHarmonic, {0, 3, 4, 0}, false, 0.4f, 0.30f, 0.31f, 1}, // Clockwork: a workshop
    {60, 8, kLydian, {0, 1, 5, 4}, true, 0.6f, 0.05f, 0.05f, 1.3f}, // Observatory: a dome at night
    {88, 5, kPhrygian, {0, 1, 5, 0}, false, 0.8f, 0.05f, 0.09f, 1}, // Fortress: wind on walls
}};

/// sin(2 pi turn) for turn 0..1 from a table; its error is below 0.1 %.
float wave(float turn) {
    constexpr std::size_t kSize = 4096;
    static const std::array<float, kSize> kTable = [] {
        std::array<float, kSize> table{};
        for (std::size_t i = 0; i < kSize; ++i) {
            table[i] = std::sin(kTurn * static_cast<float>(i) / kSize);
        }
        return table;
    }();
    return kTable[static_cast<std::size_t>(turn * kSize) % kSize];
}

const Tune& tuneOf(Theme theme) {
    return kTunes[static_cast<std::size_t>(theme)];
}

} // namespace

Music::Music(Theme theme) : theme_(theme), dice_(static_cast<std::uint32_t>(theme) + 40) {}

/// Frequency of a degree of the scale; 7 degrees are an octave.
float Music::hertzOf(int degree) const {
    const Tune& tune = tuneOf(theme_);
    const int octave = degree >= 0 ? degree / 7 : (degree - 6) / 7;
    const int semitones =
        tune.root + 12 * octave + tune.scale[static_cast<std::size_t>(degree - 7 * octave)];
    return 110 * std::exp2(static_cast<float>(semitones) / 12);
}

void Music::add(Kind kind, int degree, float gain, float seconds) {
    if (tones_.size() >= kMostTones) {
        return;
    }
    const bool drum = kind == Kind::Kick || kind == Kind::Hat;
    const float hertz = drum ? 110.0f : hertzOf(degree);
    const float attack = kind == Kind::Pad ? 0.5f : kind == Kind::Bass ? 0.02f : 0.004f; // s
    const float decay = kind == Kind::Pad ? 0.6f : 0.3f * seconds;                       // s
    const int hold = kind == Kind::Pad ? static_cast<int>(seconds * kSampleHertz) : 0;
    const float pan = drum ? 0 : dice_.between(-0.5f, 0.5f);
    tones_.push_back({kind, hertz / kSampleHertz, 0, gain, pan, 0, 1 / (attack * kSampleHertz),
                      std::exp(-1 / (decay * kSampleHertz)), hold});
}

void Music::takeChord(const Tension& tension) {
    const Tune& tune = tuneOf(theme_);
    const int bar = step_ / kStepsOfBar % 4;
    const int chord = tune.chords[static_cast<std::size_t>(bar)];
    const int step = step_ % kStepsOfBar;
    const float beat = 60 / tune.beats;
    if (step == 0) {
        for (const int third : {0, 2, 4}) {
            add(Kind::Pad, chord + third + (chord > 3 ? 0 : 7), 0.17f, 4 * beat);
        }
        add(Kind::Pad, chord - (chord > 3 ? 7 : 0), 0.16f, 4 * beat);
    }
    const bool busy = tension.combo > 0.35f;
    if (step == 0 || step == 8 || (busy && (step == 6 || step == 11 || step == 14))) {
        const float gain = 0.26f + 0.22f * tension.combo;
        add(Kind::Bass, chord - 7, gain, 1.6f * beat);
    }
}

void Music::takeArpeggio(const Tension& tension) {
    const Tune& tune = tuneOf(theme_);
    const int step = step_ % kStepsOfBar;
    const int every = tension.combo > 0.7f ? 1 : tension.combo > 0.35f ? 2 : 4;
    if (step % every != 0 || (tension.muffled && step % 8 != 0)) {
        return;
    }
    const int chord = tune.chords[static_cast<std::size_t>(step_ / kStepsOfBar % 4)];
    constexpr std::array<int, 8> kFigure = {0, 4, 2, 7, 4, 9, 7, 11};
    const auto index = static_cast<std::size_t>(step / every + 3 * (step_ / kStepsOfBar));
    const bool skip = dice_.between(0, 1) > 0.75f + 0.25f * tension.combo;
    if (!skip) {
        add(tune.bells ? Kind::Bell : Kind::Pluck, chord + 7 + kFigure[index % kFigure.size()],
            0.12f + 0.12f * tension.combo, tune.bells ? 2.2f : 1.0f);
    }
}

void Music::takeDrums(const Tension& tension) {
    const int step = step_ % kStepsOfBar;
    const float drums = tension.muffled ? 0 : std::max(tension.combo, tension.danger);
    if (drums > 0.2f && (step == 0 || step == 8 || (drums > 0.6f && step == 10))) {
        add(Kind::Kick, 0, 0.5f * drums, 0.5f);
    }
    if (tension.danger > 0.3f && (step == 3 || step == 11)) { // with the beat before: a heartbeat
        add(Kind::Kick, 0, 0.4f * tension.danger, 0.4f);
    }
    const bool ticks = theme_ == Theme::Clockwork && step % 4 == 0;
    if (ticks || (tension.combo > 0.3f && step % 4 == 2)) {
        add(Kind::Hat, 0, ticks ? 0.10f : 0.12f * tension.combo, 0.12f);
    }
}

void Music::takeStep(const Tension& tension) {
    samplesLeft_ = static_cast<int>(15 * kSampleHertz / tuneOf(theme_).beats);
    takeChord(tension);
    takeArpeggio(tension);
    takeDrums(tension);
    ++step_;
}

float Music::sampleOf(Tone& tone) {
    if (tone.rising) {
        tone.level += tone.attack;
        tone.rising = tone.level < 1;
    } else if (tone.hold > 0) {
        --tone.hold;
    } else {
        tone.level *= tone.decay;
    }
    tone.phase += tone.step;
    tone.phase -= std::floor(tone.phase);
    const float x = tone.phase;
    const auto partial = [x](float ratio) { return wave(ratio * x - std::floor(ratio * x)); };
    switch (tone.kind) {
    case Kind::Pad:
        return tone.gain * tone.level * (partial(1) + 0.35f * partial(2) + 0.12f * partial(3));
    case Kind::Bass:
        return tone.gain * tone.level * (partial(1) + 0.5f * tone.level * partial(2));
    case Kind::Pluck: {
        const float bright = tone.level * tone.level;
        return tone.gain * tone.level *
               (partial(1) + 0.6f * bright * partial(2) + 0.4f * bright * partial(4));
    }
    case Kind::Bell:
        return tone.gain * tone.level * (partial(1) + 0.35f * tone.level * partial(4));
    case Kind::Kick: // its pitch falls with its level
        tone.step = (38 + 70 * tone.level * tone.level) / kSampleHertz;
        return tone.gain * tone.level * partial(1);
    case Kind::Hat:
        return tone.gain * tone.level * tone.level * dice_.between(-1, 1);
    }
    return 0;
}

/// Filtered noise that swells: air, wind, waves.
Frame Music::ambience() {
    const Tune& tune = tuneOf(theme_);
    swell_ += tune.airSwell / kSampleHertz;
    swell_ -= std::floor(swell_);
    const float noise = dice_.between(-1, 1);
    dull_[0] += tune.airBright * (noise - dull_[0]);
    dull_[1] += tune.airBright * (dull_[0] - dull_[1]);
    dull_[2] += 0.002f * (dull_[1] - dull_[2]); // without the lowest frequencies
    const float air = 0.16f * tune.air * (dull_[1] - dull_[2]) / std::sqrt(tune.airBright);
    const float side = 0.5f + 0.35f * wave(swell_);
    return {air * side, air * (1 - side)};
}

Frame Music::next(const Tension& tension) {
    smooth_.combo += kFollow * (tension.combo - smooth_.combo);
    smooth_.danger += kFollow * (tension.danger - smooth_.danger);
    smooth_.muffled = tension.muffled;
    if (--samplesLeft_ <= 0) {
        std::erase_if(tones_, [](const Tone& tone) { return !tone.rising && tone.level < 2e-4f; });
        takeStep(smooth_);
    }
    Frame sum = ambience();
    for (Tone& tone : tones_) {
        const float sample = sampleOf(tone);
        sum.left += sample * (0.5f - 0.5f * tone.pan);
        sum.right += sample * (0.5f + 0.5f * tone.pan);
    }
    const float gain = tuneOf(theme_).gain;
    return {gain * sum.left, gain * sum.right};
}

} // namespace apart
