// SPDX-License-Identifier: MIT
#include <apart/stage/records/recording.hpp>
#include <apart/stage/sound/fanfare.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

TEST(Fanfare, PlaysATuneWithFireworksAndEnds) {
    Fanfare fanfare;
    Juice juice(1, {});
    RecordingSpeaker speaker;
    EXPECT_TRUE(fanfare.done());
    fanfare.begin();
    for (int tick = 0; tick < Fanfare::kTicks; ++tick) {
        EXPECT_FALSE(fanfare.done());
        fanfare.tick(juice, 1, Theme::Daybreak, speaker);
    }
    EXPECT_TRUE(fanfare.done());
    EXPECT_GE(speaker.notes.size(), 10u);
    EXPECT_GT(juice.sparks().count(), 0u);
}

TEST(Fanfare, IsSilentAtOnceWhenItIsStopped) {
    Fanfare fanfare;
    Juice juice(1, {});
    RecordingSpeaker speaker;
    fanfare.begin();
    fanfare.tick(juice, 1, Theme::Daybreak, speaker);
    const std::size_t heard = speaker.notes.size();
    fanfare.stop();
    for (int tick = 0; tick < Fanfare::kTicks; ++tick) {
        fanfare.tick(juice, 1, Theme::Daybreak, speaker);
    }
    EXPECT_EQ(speaker.notes.size(), heard);
}

TEST(Fanfare, WithoutVolumeHasFireworksOnly) {
    Fanfare fanfare;
    Juice juice(1, {});
    RecordingSpeaker speaker;
    fanfare.begin();
    for (int tick = 0; tick < Fanfare::kTicks; ++tick) {
        fanfare.tick(juice, 0, Theme::Daybreak, speaker);
    }
    EXPECT_TRUE(speaker.notes.empty());
    EXPECT_GT(juice.sparks().count(), 0u);
}

} // namespace
} // namespace apart
