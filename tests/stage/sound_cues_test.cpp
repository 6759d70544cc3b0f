// SPDX-License-Identifier: MIT
#include <apart/stage/records/recording.hpp>
#include <apart/stage/sound/sound_cues.hpp>
#include <apart/stage/sound/synth.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace apart {
namespace {

Struck strikeOf(Role what, kodo::Real impulse) {
    Struck hit;
    hit.what = what;
    hit.impulse = impulse;
    return hit;
}

TEST(SoundCues, AHarderImpactIsLouder) {
    const Note soft = noteOf(strikeOf(Role::Paddle, 2));
    const Note hard = noteOf(strikeOf(Role::Paddle, 20));
    EXPECT_EQ(soft.voice, Voice::Paddle);
    EXPECT_GT(hard.volume, soft.volume);
    EXPECT_LE(hard.volume, 1);
}

TEST(SoundCues, EachStuffHasAUniqueVoice) {
    std::vector<Voice> voices;
    for (std::size_t i = 0; i < kStuffNames.size(); ++i) {
        Cracked hit;
        hit.stuff = static_cast<Stuff>(i);
        hit.impulse = 10;
        voices.push_back(noteOf(hit).voice);
    }
    std::sort(voices.begin(), voices.end());
    EXPECT_EQ(std::unique(voices.begin(), voices.end()), voices.end());
}

TEST(SoundCues, ThePitchClimbsWithTheComboForTwoOctaves) {
    EXPECT_EQ(comboPitch(1), 1);
    for (int combo = 1; combo < 11; ++combo) {
        EXPECT_GT(comboPitch(combo + 1), comboPitch(combo)) << combo;
    }
    EXPECT_EQ(comboPitch(11), 4); // two octaves
    EXPECT_EQ(comboPitch(1000), 4);
}

TEST(SoundCues, TheSameVoiceIsNotStartedTwiceAtOnce) {
    SoundCues cues;
    RecordingSpeaker speaker;
    const std::vector<Event> two = {strikeOf(Role::Wall, 20), strikeOf(Role::Wall, 20)};
    cues.play(two, 100, 1, speaker);
    EXPECT_EQ(speaker.notes.size(), 1u);
    cues.play(two, 130, 1, speaker);
    EXPECT_EQ(speaker.notes.size(), 2u);
}

TEST(SoundCues, WithoutVolumeNoNoteIsPlayed) {
    SoundCues cues;
    RecordingSpeaker speaker;
    const std::vector<Event> events = {strikeOf(Role::Wall, 20), Cleared{}};
    cues.play(events, 1, 0, speaker);
    EXPECT_TRUE(speaker.notes.empty());
}

TEST(Synth, EveryVoiceIsAudibleShortAndWithoutClicks) {
    for (std::size_t i = 0; i < kVoiceNames.size(); ++i) {
        SCOPED_TRACE(kVoiceNames[i]);
        const std::vector<float> samples = synthesise(static_cast<Voice>(i));
        ASSERT_FALSE(samples.empty());
        EXPECT_LE(samples.size(), 2 * kSampleRate);
        const auto loudest = std::max_element(samples.begin(), samples.end(), [](float a, float b) {
            return std::abs(a) < std::abs(b);
        });
        EXPECT_GT(std::abs(*loudest), 0.6f);
        EXPECT_LT(std::abs(samples.front()), 0.01f);
        EXPECT_LT(std::abs(samples.back()), 0.01f);
    }
}

TEST(Synth, AVoiceHasTheSameSamplesEachTime) {
    EXPECT_EQ(synthesise(Voice::Break), synthesise(Voice::Break));
}

} // namespace
} // namespace apart
