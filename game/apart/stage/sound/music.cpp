// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/sound/music.hpp>
#include <apart/stage/sound/synth.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace apart {

namespace {

constexpr int kStepsOfBar = 16;
constexpr std::size_t kMostTones = 36;
constexpr float kFollow = 1 / (0.8f * kSampleHertz); // per sample, of the tension

/// What a theme adds to its score.
struct Manner {
    bool bells;      // the arpeggio rings, instead of being plucked
    float air;       // gain of the ambience
    float airBright; // 0..1
    float airSwell;  // Hz
    float gain;      // of the whole, so that all themes are equally loud
};

constexpr std::array<Manner, kThemeNames.size()> kManners = {{
    {true, 0.5f, 0.10f, 0.11f, 1.15f},  // Daybreak: birdless morning air
    {false, 0.8f, 0.04f, 0.07f, 1},     // Quarry: wind in the pit
    {true, 0.4f, 0.22f, 0.23f, 1},      // Fairground: a crowd far off
    {false, 1.1f, 0.09f, 0.13f, 1},     // Harbour: waves
    {false, 0.4f, 0.30f, 0.31f, 1.7f},  // Clockwork: a workshop
    {true, 0.6f, 0.05f, 0.05f, 1.9f},   // Observatory: a dome at night
    {false, 0.8f, 0.05f, 0.09f, 1.15f}, // Fortress: wind on walls
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

const Manner& mannerOf(Theme theme) {
    return kManners[static_cast<std::size_t>(theme)];
}

} // namespace

Music::Music(Theme theme) : theme_(theme), dice_(static_cast<std::uint32_t>(theme) + 40) {}

/// The form is over, and its last chord stays.
bool Music::rests() const {
    return step_ >= kBarsOfForm * kStepsOfBar;
}

int Music::chord() const {
    const Score& score = scoreOf(theme_);
    return rests() ? score.close[1].chord : barOf(score, step_ / kStepsOfBar).chord;
}

float Music::hertzOf(int degree) const {
    const Score& score = scoreOf(theme_);
    const int semitones = score.root + semitonesOf(score, degree);
    return 110 * std::exp2(static_cast<float>(semitones) / 12);
}

void Music::add(Kind kind, int degree, float gain, float seconds) {
    if (tones_.size() >= kMostTones) {
        return;
    }
    const bool drum = kind == Kind::Kick || kind == Kind::Hat;
    const float hertz = drum ? 110.0f : hertzOf(degree);
    const bool held = kind == Kind::Pad || kind == Kind::Lead || kind == Kind::Reed;
    const float attack = kind == Kind::Pad    ? 0.5f
                         : held               ? 0.04f
                         : kind == Kind::Bass ? 0.02f
                                              : 0.004f;                           // s
    const float decay = kind == Kind::Pad ? 0.6f : held ? 0.15f : 0.3f * seconds; // s
    const int hold = held ? static_cast<int>(seconds * kSampleHertz) : 0;
    const float pan = drum                 ? 0
                      : kind == Kind::Lead ? 0.1f
                      : kind == Kind::Reed ? -0.35f
                                           : dice_.between(-0.5f, 0.5f);
    tones_.push_back({kind, hertz / kSampleHertz, 0, gain, pan, 0, 1 / (attack * kSampleHertz),
                      std::exp(-1 / (decay * kSampleHertz)), hold});
}

/// Tune and second part.
void Music::takeParts(const Tension& tension) {
    constexpr int kOctaves = 14; // degrees above the root at 110 Hz
    if (step_ % 2 != 0 || rests()) {
        return;
    }
    const Score& score = scoreOf(theme_);
    const int eighth = step_ / 2;
    const float seconds = 30 / score.beats; // of an eighth
    if (const Step lead = leadOf(score, eighth); lead.sounds) {
        add(Kind::Lead, lead.degree + kOctaves, 0.2f + 0.08f * tension.combo,
            0.92f * seconds * static_cast<float>(lead.eighths));
    }
    const Step second = second_.next(score, eighth);
    const bool joins = step_ / kStepsOfBar >= kBarsOfForm / 4 || tension.combo > 0.2f;
    if (second.sounds && joins) {
        add(Kind::Reed, second.degree + kOctaves, 0.11f + 0.05f * tension.combo,
            0.95f * seconds * static_cast<float>(second.eighths));
    }
}

void Music::takeChord(const Tension& tension) {
    const int root = chord();
    const int step = step_ % kStepsOfBar;
    const float beat = 60 / scoreOf(theme_).beats;
    if (step == 0) {
        for (const int third : {0, 2, 4}) {
            add(Kind::Pad, root + third + (root > 3 ? 0 : 7), 0.13f, 4 * beat);
        }
        add(Kind::Pad, root - (root > 3 ? 7 : 0), 0.13f, 4 * beat);
    }
    const bool busy = tension.combo > 0.35f && !rests();
    if (step == 0 || (step == 8 && !rests()) || (busy && (step == 6 || step == 11 || step == 14))) {
        const float gain = 0.22f + 0.24f * tension.combo;
        add(Kind::Bass, root - 7, gain, 1.6f * beat);
    }
}

void Music::takeArpeggio(const Tension& tension) {
    const int step = step_ % kStepsOfBar;
    const int every = tension.combo > 0.7f ? 1 : tension.combo > 0.35f ? 2 : 4;
    if (step % every != 0 || (tension.muffled && step % 8 != 0) || rests()) {
        return;
    }
    constexpr std::array<int, 8> kFigure = {0, 4, 2, 7, 4, 9, 7, 11};
    const auto index = static_cast<std::size_t>(step / every + 3 * (step_ / kStepsOfBar));
    const bool skip = dice_.between(0, 1) > 0.75f + 0.25f * tension.combo;
    if (!skip) {
        const bool bells = mannerOf(theme_).bells;
        add(bells ? Kind::Bell : Kind::Pluck, chord() + 7 + kFigure[index % kFigure.size()],
            0.06f + 0.16f * tension.combo, bells ? 2.2f : 1.0f);
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

/// A won game jumps on a beat to the last two bars; the form begins again when another one starts.
void Music::close(const Tension& tension) {
    constexpr int kStepsOfBeat = 4;
    if (tension.won == closing_ || step_ % kStepsOfBeat != 0) {
        return;
    }
    closing_ = tension.won;
    step_ = closing_ ? (kBarsOfForm - 2) * kStepsOfBar : 0;
    second_ = {};
}

void Music::takeStep(const Tension& tension) {
    samplesLeft_ = static_cast<int>(15 * kSampleHertz / scoreOf(theme_).beats);
    close(tension);
    takeChord(tension);
    takeParts(tension);
    takeArpeggio(tension);
    takeDrums(tension);
    ++step_;
    const int end = kBarsOfForm * kStepsOfBar;
    if (step_ == end + kStepsOfBar || (step_ == end && !closing_)) {
        step_ = closing_ ? end : 0;
        second_ = {};
    }
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
    case Kind::Lead: // a flute
        return tone.gain * tone.level * (partial(1) + 0.28f * partial(2) + 0.08f * partial(3));
    case Kind::Reed: // odd partials, as of a clarinet
        return tone.gain * tone.level * (partial(1) + 0.3f * partial(3) + 0.12f * partial(5));
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
    const Manner& manner = mannerOf(theme_);
    swell_ += manner.airSwell / kSampleHertz;
    swell_ -= std::floor(swell_);
    const float noise = dice_.between(-1, 1);
    dull_[0] += manner.airBright * (noise - dull_[0]);
    dull_[1] += manner.airBright * (dull_[0] - dull_[1]);
    dull_[2] += 0.002f * (dull_[1] - dull_[2]); // without the lowest frequencies
    const float air = 0.16f * manner.air * (dull_[1] - dull_[2]) / std::sqrt(manner.airBright);
    const float side = 0.5f + 0.35f * wave(swell_);
    return {air * side, air * (1 - side)};
}

Frame Music::next(const Tension& tension) {
    smooth_.combo += kFollow * (tension.combo - smooth_.combo);
    smooth_.danger += kFollow * (tension.danger - smooth_.danger);
    smooth_.muffled = tension.muffled;
    smooth_.won = tension.won;
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
    const float gain = mannerOf(theme_).gain;
    return {gain * sum.left, gain * sum.right};
}

} // namespace apart
