// SPDX-License-Identifier: MIT
#include <apart/stage/dice.hpp>
#include <apart/stage/fanfare.hpp>
#include <apart/stage/palette.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

struct Beat {
    int tick;
    int semitones;
    float volume;
    bool firework;
};
constexpr std::array<Beat, 16> kTune = {{
    {0, 0, 0.8f, true},
    {14, 4, 0.7f, false},
    {28, 7, 0.7f, false},
    {42, 12, 0.9f, true},
    {70, 9, 0.7f, true},
    {84, 12, 0.7f, false},
    {98, 16, 0.9f, true},
    {126, 14, 0.7f, false},
    {140, 12, 0.7f, true},
    {154, 14, 0.7f, false},
    {168, 12, 0.9f, true}, // last chord, rising
    {168, 16, 0.7f, true},
    {168, 19, 0.6f, false},
    {200, 24, 0.6f, true},
    {230, 24, 0.3f, true},
    {260, 24, 0.2f, true},
}};

} // namespace

void Fanfare::tick(Juice& juice, float volume, Speaker& speaker) {
    for (std::size_t i = 0; i < kTune.size() && !done(); ++i) {
        const Beat& beat = kTune[i];
        if (beat.tick != tick_) {
            continue;
        }
        if (volume > 0) {
            const float pitch = std::exp2(static_cast<float>(beat.semitones) / 12);
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
