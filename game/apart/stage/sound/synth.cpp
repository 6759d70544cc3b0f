// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/sound/synth.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace apart {

namespace {

constexpr float kSilent = 1e-4f; // -80 dB

/// One sinusoidal mode of a struck body, with its own frequency ratio and decay time.
struct Partial {
    float ratio;   // factor on the base frequency
    float gain;    // 0..1
    float seconds; // decay time to 1/e
};

/// Recipe of a sound: partials and noise, repeated for each note of a short tune.
struct Recipe {
    float hertz = 440;
    float seconds = 0.3f;
    std::vector<Partial> partials{};
    float noise = 0;             // gain, 0..1
    float noiseSeconds = 0.05f;  // decay time to 1/e
    float noiseBright = 1;       // 1 white .. 0.05 dull
    float slide = 0;             // octaves over the whole duration
    std::vector<int> tune = {0}; // semitones of successive notes
    float beat = 0.09f;          // s between notes
};

Recipe largeRecipeOf(Voice voice) {
    if (voice == Voice::Boss) {
        return {98,    1.9f,          {{1, 0.7f, 0.6f}, {1.5f, 0.4f, 0.5f}, {2.02f, 0.3f, 0.3f}},
                0.9f,  0.3f,          0.2f,
                -0.5f, {0, 0, 7, 12}, 0.16f};
    }
    if (voice == Voice::Gush) {
        return {80, 1.9f, {{1, 0.35f, 0.5f}, {1.5f, 0.2f, 0.4f}}, 0.9f, 0.7f, 0.2f, -0.6f};
    }
    return {210, 0.6f, {{1, 0.25f, 0.06f}, {1.7f, 0.15f, 0.04f}}, 0.9f, 0.12f, 0.55f, 0.9f};
}

Recipe recipeOf(Voice voice) {
    switch (voice) {
    case Voice::Glass:
        return {
            1568,
            0.6f,
            {{1, 0.4f, 0.14f}, {2.76f, 0.45f, 0.12f}, {4.1f, 0.35f, 0.08f}, {5.4f, 0.3f, 0.06f}},
            0.3f,
            0.02f};
    case Voice::Wood:
        return {392,   0.25f,  {{1, 0.9f, 0.05f}, {2.42f, 0.4f, 0.025f}, {4.1f, 0.2f, 0.01f}},
                0.25f, 0.008f, 0.4f};
    case Voice::Brick:
        return {262, 0.3f, {{1, 0.8f, 0.07f}, {1.52f, 0.3f, 0.04f}}, 0.5f, 0.03f, 0.25f};
    case Voice::Stone:
        return {165,  0.4f,   {{1, 0.9f, 0.09f}, {1.61f, 0.4f, 0.05f}, {2.9f, 0.2f, 0.02f}},
                0.5f, 0.025f, 0.15f};
    case Voice::Steel:
        return {523,
                0.9f,
                {{1, 0.5f, 0.3f}, {2.32f, 0.35f, 0.22f}, {3.91f, 0.3f, 0.14f}, {5.2f, 0.2f, 0.08f}},
                0.1f,
                0.006f};
    case Voice::Wall:
        return {220, 0.16f, {{1, 0.7f, 0.04f}, {2, 0.25f, 0.02f}}};
    case Voice::Paddle:
        return {330, 0.3f, {{1, 0.7f, 0.08f}, {2, 0.35f, 0.06f}, {3, 0.2f, 0.03f}}};
    case Voice::Break:
        return {110, 0.5f, {{1, 0.5f, 0.05f}}, 0.9f, 0.09f, 0.5f};
    case Voice::Weld:
        return {392,  0.9f,       {{1, 0.6f, 0.2f}, {2, 0.3f, 0.15f}, {3.01f, 0.15f, 0.1f}},
                0.1f, 0.02f,      1,
                0,    {0, 7, 12}, 0.08f};
    case Voice::Stick:
        return {587, 0.4f, {{1, 0.6f, 0.05f}, {2, 0.2f, 0.03f}}, 0, 0.01f, 1, 0, {0, 0, 0}, 0.11f};
    case Voice::Fire:
        return {180, 0.8f, {{1, 0.5f, 0.25f}, {1.5f, 0.3f, 0.2f}}, 0.7f, 0.22f, 0.3f, 1.6f};
    case Voice::Split:
        return {523,           0.8f, {{1, 0.5f, 0.14f}, {2, 0.3f, 0.1f}}, 0, 0.01f, 1, 0,
                {0, 4, 7, 12}, 0.07f};
    case Voice::Serve:
        return {294, 0.35f, {{1, 0.6f, 0.1f}, {2, 0.3f, 0.06f}}, 0.1f, 0.02f, 0.5f, 0.6f};
    case Voice::BallLost:
        return {330, 0.8f, {{1, 0.7f, 0.3f}, {2, 0.2f, 0.2f}}, 0, 0.01f, 1, -1.2f};
    case Voice::Cleared: // one note of the fanfare
        return {392,
                1.1f,
                {{1, 0.5f, 0.3f}, {2, 0.3f, 0.2f}, {3, 0.15f, 0.1f}, {4.02f, 0.1f, 0.06f}},
                0.05f,
                0.01f};
    case Voice::GameOver:
        return {262,  1.8f, {{1, 0.6f, 0.4f}, {2, 0.2f, 0.25f}}, 0, 0.01f, 1, 0, {0, -2, -5, -9},
                0.24f};
    case Voice::Choose:
        return {660, 0.12f, {{1, 0.5f, 0.03f}, {2, 0.2f, 0.02f}}};
    case Voice::Bumper:
        return {196, 0.4f, {{1, 0.8f, 0.08f}, {2, 0.5f, 0.06f}, {3.01f, 0.3f, 0.04f}}, 0.2f, 0.01f,
                1,   0.7f};
    case Voice::Good:
        return {523, 0.7f, {{1, 0.5f, 0.12f}, {2, 0.3f, 0.1f}}, 0, 0.01f, 1, 0, {0, 7, 12}, 0.07f};
    case Voice::Bad:
        return {233,         0.7f, {{1, 0.5f, 0.14f}, {1.06f, 0.4f, 0.14f}}, 0, 0.01f, 1, 0,
                {0, -1, -6}, 0.1f};
    case Voice::Over:
        return {392, 0.5f, {{1, 0.5f, 0.1f}, {2, 0.2f, 0.06f}}, 0, 0.01f, 1, 0, {0, -5}, 0.09f};
    case Voice::Pull:
        return {150, 0.5f, {{1, 0.4f, 0.2f}, {1.5f, 0.2f, 0.15f}}, 0.3f, 0.15f, 0.12f, -0.8f};
    case Voice::Push:
        return {110, 0.5f, {{1, 0.4f, 0.2f}, {1.5f, 0.2f, 0.15f}}, 0.3f, 0.15f, 0.12f, 1};
    case Voice::Gulp:
        return {330, 0.16f, {{1, 0.6f, 0.03f}}, 0, 0.01f, 1, 1.2f};
    case Voice::Rumble:
        return {62, 0.9f, {{1, 0.6f, 0.25f}, {1.48f, 0.4f, 0.2f}}, 0.8f, 0.25f, 0.06f};
    case Voice::Boss:
    case Voice::Splash:
    case Voice::Gush:
        break;
    }
    return largeRecipeOf(voice);
}

/// Adds one note that starts at sample `start`.
void strike(const Recipe& recipe, int semitones, std::size_t start, std::vector<float>& sound,
            Dice& dice) {
    constexpr float kRate = static_cast<float>(kSampleRate);
    const float base = recipe.hertz * std::exp2(static_cast<float>(semitones) / 12);
    const float bend = std::exp2(recipe.slide / (recipe.seconds * kRate)); // per sample
    for (const Partial& partial : recipe.partials) {
        float turn = 0; // phase in turns
        float step = base * partial.ratio / kRate;
        float level = partial.gain;
        const float decay = std::exp(-1 / (partial.seconds * kRate)); // per sample
        for (std::size_t i = start; i < sound.size() && level > kSilent; ++i) {
            turn += step;
            turn -= std::floor(turn);
            sound[i] += level * std::sin(kTurn * turn);
            step *= bend;
            level *= decay;
        }
    }
    float dull = 0; // state of the low-pass filter
    float level = recipe.noise;
    const float decay = std::exp(-1 / (recipe.noiseSeconds * kRate));
    for (std::size_t i = start; i < sound.size() && level > kSilent; ++i) {
        dull += recipe.noiseBright * (dice.between(-1, 1) - dull);
        sound[i] += level * dull;
        level *= decay;
    }
}

/// Moves the upper partials a little, and the gains more.
void vary(Recipe& recipe, Dice& dice) {
    for (Partial& partial : recipe.partials) {
        partial.ratio *= partial.ratio > 1 ? dice.between(0.975f, 1.025f) : 1.0f;
        partial.gain *= dice.between(0.7f, 1.2f);
        partial.seconds *= dice.between(0.85f, 1.15f);
    }
    recipe.noise *= dice.between(0.8f, 1.2f);
}

} // namespace

std::vector<float> synthesise(Voice voice, std::uint8_t variant) {
    constexpr float kRate = static_cast<float>(kSampleRate);
    constexpr float kEase = 0.003f * kRate; // samples; fades both ends to avoid clicks
    constexpr float kLoudest = 0.8f;
    Recipe recipe = recipeOf(voice);
    Dice dice(static_cast<std::uint32_t>(recipe.hertz) + 1000u * variant);
    if (variant > 0 && recipe.tune.size() == 1) {
        vary(recipe, dice);
    }
    std::vector<float> sound(static_cast<std::size_t>(recipe.seconds * kRate), 0.0f);
    for (std::size_t i = 0; i < recipe.tune.size(); ++i) {
        const auto start = static_cast<std::size_t>(recipe.beat * kRate * static_cast<float>(i));
        strike(recipe, recipe.tune[i], start, sound, dice);
    }
    float peak = 1e-6f;
    for (std::size_t i = 0; i < sound.size(); ++i) {
        const float in = static_cast<float>(i) / kEase;
        const float out = static_cast<float>(sound.size() - 1 - i) / (8 * kEase);
        sound[i] *= std::min({in, out, 1.0f});
        peak = std::max(peak, std::abs(sound[i]));
    }
    for (float& value : sound) {
        value *= kLoudest / peak;
    }
    return sound;
}

} // namespace apart
