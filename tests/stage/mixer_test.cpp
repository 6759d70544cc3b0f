// SPDX-License-Identifier: MIT
// The sound of the game, as samples.
#include <apart/core/assets.hpp>
#include <apart/stage/sound/mixer.hpp>
#include <apart/stage/sound/synth.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "loudness.hpp"
#include "stage_rig.hpp"

namespace apart {
namespace {

constexpr std::size_t kFrame = kSampleRate / 60; // frames of sound for a frame of the picture

std::vector<float> rendered(Mixer& mixer, double seconds) {
    std::vector<float> samples(2 * static_cast<std::size_t>(seconds * kSampleRate));
    mixer.render(samples);
    return samples;
}

float peakOf(std::span<const float> samples) {
    float peak = 0;
    for (const float sample : samples) {
        peak = std::max(peak, std::abs(sample));
    }
    return peak;
}

double energyOf(std::span<const float> samples) {
    double sum = 0;
    for (const float sample : samples) {
        sum += static_cast<double>(sample * sample);
    }
    return sum;
}

/// Hands on to a mixer, and keeps how much fell in each frame.
class Heard : public Speaker {
public:
    explicit Heard(Mixer& mixer) : mixer_(mixer) {}
    void play(const Note& note) override { mixer_.play(note); }
    void follow(const SoundScene& scene) override {
        mixer_.follow(scene);
        rumbles.push_back(scene.rumble);
    }
    std::vector<float> rumbles;

private:
    Mixer& mixer_;
};

/// The sound of the bot's games of a level, with the settings at their start.
std::vector<float> soundOf(const std::string& name, double seconds,
                           std::vector<float>* rumbles = nullptr) {
    StageDef def = StageRig::played();
    def.levels = {std::make_shared<const Level>(std::get<Level>(loadLevel(name)))};
    Stage stage(std::move(def));
    Mixer mixer;
    Heard heard(mixer);
    std::vector<float> all;
    std::vector<float> part(2 * kFrame);
    for (int i = 0; i < 60 * seconds; ++i) {
        Signals signals;
        if (stage.screen() == Screen::Over) {
            signals.commands = {Command::Restart};
        }
        stage.advance(1.0 / 60, signals, heard);
        mixer.render(part);
        all.insert(all.end(), part.begin(), part.end());
    }
    if (rumbles != nullptr) {
        *rumbles = heard.rumbles;
    }
    return all;
}

// A sine of 997 Hz at full scale in both channels has 0 LUFS [ITU-R BS.1770-4].
TEST(Loudness, OfASineIsThatOfTheStandard) {
    std::vector<float> samples;
    for (int i = 0; i < 5 * int(kSampleRate); ++i) {
        const double turn = 2 * std::numbers::pi * 997 * i / kSampleRate;
        samples.insert(samples.end(), 2, static_cast<float>(std::sin(turn)));
    }
    EXPECT_NEAR(loudnessOf(samples, kSampleRate), 0, 0.1);
    for (float& sample : samples) {
        sample *= 0.1f;
    }
    EXPECT_NEAR(loudnessOf(samples, kSampleRate), -20, 0.1);
}

// The bot's games of the first level are little but its fall, which lies above -16 LUFS.
TEST(Mixer, TheFirstLevelIsHardlyEverSilent) {
    const std::vector<float> samples = soundOf("first_light", 16);
    EXPECT_GE(loudnessOf(samples, kSampleRate), -17);
    EXPECT_LE(loudnessOf(samples, kSampleRate), -12);
    EXPECT_LT(silenceOf(samples, kSampleRate, 0.00316f), 0.05); // -50 dB of full scale
    EXPECT_LE(peakOf(samples), Mixer::kCeiling + 1e-6f);
}

// s. A fall or a wait within 24 seconds moves the loudness by 2 LU, within 72 by less than 1.
constexpr double kLong = support::kSanitized ? 24 : 72;

TEST(Mixer, EveryThemeIsAsLoudAndBelowTheCeiling) {
    for (const char* name : support::kSanitized ? std::vector{"arch", "orbit"}
                                                : std::vector{"arch", "card_house", "dam", "cart",
                                                              "orbit", "galleon"}) {
        const std::vector<float> samples = soundOf(name, kLong);
        EXPECT_NEAR(loudnessOf(samples, kSampleRate), -16, 1) << name;
        EXPECT_LE(peakOf(samples), Mixer::kCeiling + 1e-6f) << name;
    }
}

// Loudness of three seconds, the window of EBU Tech 3341 for what lasts. Play is their median where
// nothing falls, of which 24 seconds may have too little.
TEST(Mixer, AFallLiesNineLuAbovePlay) {
    for (const char* name :
         support::kSanitized ? std::vector{"arch"} : std::vector{"arch", "tower"}) {
        std::vector<float> rumbles;
        const std::vector<float> samples = soundOf(name, std::max(kLong, 48.0), &rumbles);
        const std::vector<double> blocks = blocksOf(energiesOf(samples, kSampleRate), 30);
        std::vector<double> calm;
        double loudest = -100;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const auto from = rumbles.begin() + static_cast<std::ptrdiff_t>(6 * i);
            const float most = *std::max_element(from, from + 180);
            if (most < 0.3f) {
                calm.push_back(lufsOf(blocks[i]));
            } else if (most > 0.8f) {
                loudest = std::max(loudest, lufsOf(blocks[i]));
            }
        }
        ASSERT_GT(calm.size(), 10u) << name;
        std::nth_element(calm.begin(), calm.begin() + static_cast<std::ptrdiff_t>(calm.size() / 2),
                         calm.end());
        EXPECT_GE(loudest - calm[calm.size() / 2], 9) << name;
        EXPECT_GE(loudnessRangeOf(samples, kSampleRate), 6) << name;
    }
}

/// Amplitude of a frequency in a sound [Goertzel58].
double amplitudeOf(std::span<const float> samples, double hertz) {
    const double turn = 2 * std::numbers::pi * hertz / kSampleRate;
    double before = 0;
    double last = 0;
    for (const float sample : samples) {
        const double now = static_cast<double>(sample) + 2 * std::cos(turn) * last - before;
        before = last;
        last = now;
    }
    return std::sqrt(
               std::max(last * last + before * before - 2 * std::cos(turn) * last * before, 0.0)) /
           static_cast<double>(samples.size());
}

TEST(Synth, GlassHasATenthOfItsEnergyAboveFourKilohertz) {
    const int variants = support::kSanitized ? 1 : kVariants;
    for (std::uint8_t variant = 0; variant < variants; ++variant) {
        const std::vector<float> sound = synthesise(Voice::Glass, variant);
        double high = 0;
        double all = 0;
        for (double hertz = 50; hertz < 16000; hertz += 1 / (0.6 * 2)) { // half of a bin apart
            const double amplitude = amplitudeOf(sound, hertz);
            all += amplitude * amplitude;
            high += hertz > 4000 ? amplitude * amplitude : 0;
        }
        EXPECT_GT(high, 0.1 * all) << int(variant);
    }
}

TEST(Mixer, NeverExceedsTheCeilingWithAllChannelsAtOnce) {
    Mixer mixer;
    mixer.follow({Theme::Quarry, 1, 1, 1, 1, 1, false, false});
    for (std::size_t i = 0; i < 2 * Mixer::kChannels; ++i) {
        mixer.play({Voice::Boss, 1, 1, 0});
    }
    const std::vector<float> samples = rendered(mixer, 1);
    EXPECT_EQ(mixer.sounding(), Mixer::kChannels);
    EXPECT_LE(peakOf(samples), Mixer::kCeiling + 1e-6f);
    EXPECT_GT(peakOf(samples), 0.7f);
}

TEST(Mixer, ImportantVoicesReplaceOthersAndAreNotReplaced) {
    const auto energyAfter = [](Voice before, Voice last) {
        Mixer mixer;
        mixer.follow({});
        for (std::size_t i = 0; i < Mixer::kChannels; ++i) {
            mixer.play({before, 1, 0, 0}); // silent, so that only the last one is heard
        }
        mixer.play({last, 1, 1, 0});
        return energyOf(rendered(mixer, 0.05));
    };
    EXPECT_GT(energyAfter(Voice::Wall, Voice::BallLost), 0.1);
    EXPECT_GT(energyAfter(Voice::Brick, Voice::Break), 0.1);
    EXPECT_LT(energyAfter(Voice::BallLost, Voice::Wall), 1e-6);
    EXPECT_LT(energyAfter(Voice::Break, Voice::Glass), 1e-6);
}

TEST(Mixer, IsSilentWithoutNotesAndVolumes) {
    Mixer mixer;
    SoundScene scene;
    scene.rumble = scene.combo = scene.danger = 1;
    mixer.follow(scene); // its volumes are 0
    EXPECT_LT(peakOf(rendered(mixer, 1)), 1e-4f);
}

TEST(Mixer, RumblesWithWhatFalls) {
    const auto energyWith = [](float rumble) {
        Mixer mixer;
        SoundScene scene;
        scene.volume = 1;
        scene.rumble = rumble;
        mixer.follow(scene);
        return energyOf(rendered(mixer, 2));
    };
    EXPECT_GT(energyWith(1), 2 * energyWith(0.4f));
    EXPECT_GT(energyWith(0.4f), 10 * energyWith(0) + 1);
}

TEST(Mixer, EachThemeHasItsOwnMusicAndRoom) {
    const auto soundIn = [](std::size_t theme, bool music) {
        Mixer mixer;
        SoundScene scene;
        scene.theme = static_cast<Theme>(theme);
        scene.music = music ? 1.0f : 0.0f;
        mixer.follow(scene);
        if (!music) {
            mixer.play({Voice::Stone, 1, 1, 0});
        }
        return rendered(mixer, 0.3);
    };
    for (const bool music : {true, false}) {
        std::set<std::vector<float>> sounds;
        for (std::size_t theme = 0; theme < kThemeNames.size(); ++theme) {
            EXPECT_TRUE(sounds.insert(soundIn(theme, music)).second) << kThemeNames[theme];
        }
    }
}

TEST(Music, GrowsWithComboAndDanger) {
    const auto energyWith = [](Tension tension) {
        Music music(Theme::Daybreak);
        double energy = 0;
        for (int i = 0; i < 5 * int(kSampleRate); ++i) {
            const Frame frame = music.next(tension);
            energy += static_cast<double>(frame.left * frame.left + frame.right * frame.right);
        }
        return energy;
    };
    const double calm = energyWith({});
    EXPECT_GT(energyWith({1, 0, false, false}), 1.3 * calm);
    EXPECT_GT(energyWith({0, 1, false, false}), 1.1 * calm);
    EXPECT_GT(calm, 1);
    EXPECT_EQ(calm, energyWith({})); // the same samples each time
}

TEST(SoundCues, AHeavierBlockSoundsLower) {
    EXPECT_NEAR(massPitch(0.6f), 1, 1e-5f);
    EXPECT_GT(massPitch(0.2f), massPitch(0.6f));
    EXPECT_LT(massPitch(4), massPitch(1));
    EXPECT_GE(massPitch(1000), 0.5f);
    EXPECT_LE(massPitch(0), 1.5f);
}

TEST(SoundCues, NoTwoHitsSoundQuiteAlike) {
    SoundCues cues;
    RecordingSpeaker speaker;
    Struck hit;
    hit.impulse = 20;
    for (std::uint32_t i = 0; i < 12; ++i) {
        cues.play(std::vector<Event>{hit}, 100 * i, 1, speaker);
    }
    ASSERT_EQ(speaker.notes.size(), 12u);
    int alike = 0;
    for (std::size_t i = 1; i < speaker.notes.size(); ++i) {
        alike += speaker.notes[i].pitch == speaker.notes[i - 1].pitch ? 1 : 0;
        EXPECT_LT(speaker.notes[i].variant, kVariants);
    }
    EXPECT_EQ(alike, 0);
    EXPECT_NE(synthesise(Voice::Stone, 0), synthesise(Voice::Stone, 1));
    EXPECT_NE(synthesise(Voice::Stone, 1), synthesise(Voice::Stone, 2));
}

TEST(SoundScene, FollowsTheGameAndItsSettings) {
    StageRig rig(StageRig::playing());
    rig.frame();
    EXPECT_EQ(rig.speaker.scene.theme, rig.stage.session().game().level().theme);
    EXPECT_FLOAT_EQ(rig.speaker.scene.music, share(Settings{}.music));
    EXPECT_FALSE(rig.speaker.scene.muffled);
    rig.press(Command::Pause);
    rig.frame();
    EXPECT_TRUE(rig.speaker.scene.muffled);
    rig.press(Command::Mute);
    rig.frame();
    EXPECT_EQ(rig.speaker.scene.music, 0);
    EXPECT_EQ(rig.speaker.scene.volume, 0);
}

} // namespace
} // namespace apart
