// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/sound/fanfare.hpp>
#include <apart/stage/sound/score.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr int kNote = 10; // semitones of Voice::Cleared, G, above A at 220 Hz

struct Beat {
    int tick;
    int degree; // of the scale of the theme
    float volume;
    bool firework;
};
constexpr std::array<Beat, 16> kTune = {{
    {0, 0, 0.8f, true},
    {14, 2, 0.7f, false},
    {28, 4, 0.7f, false},
    {42, 7, 0.9f, true},
    {70, 5, 0.7f, true},
    {84, 7, 0.7f, false},
    {98, 9, 0.9f, true},
    {126, 8, 0.7f, false},
    {140, 7, 0.7f, true},
    {154, 8, 0.7f, false},
    {168, 7, 0.9f, true}, // last chord, rising
    {168, 9, 0.7f, true},
    {168, 11, 0.6f, false},
    {200, 14, 0.6f, true},
    {230, 14, 0.3f, true},
    {260, 14, 0.2f, true},
}};

} // namespace

void Fanfare::tick(Juice& juice, float volume, Theme theme, Speaker& speaker) {
    for (std::size_t i = 0; i < kTune.size() && !done(); ++i) {
        const Beat& beat = kTune[i];
        if (beat.tick != tick_) {
            continue;
        }
        if (volume > 0) {
            const Score& score = scoreOf(theme);
            const int fromG = score.root + semitonesOf(score, beat.degree) - kNote;
            const float pitch = std::exp2(static_cast<float>(fromG) / 12);
            speaker.play({Voice::Cleared, pitch, beat.volume * volume, 0});
        }
        if (beat.firework) {
            Dice dice(static_cast<std::uint32_t>(i));
            juice.firework({dice.between(-10, 10), dice.between(7, 16)},
                           juice.tints().power[1 + i % (kPowerNames.size() - 1)]);
        }
    }
    ++tick_;
}

} // namespace apart
