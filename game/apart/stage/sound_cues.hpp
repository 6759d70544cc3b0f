// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/stage/speaker.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace apart {

/// Maps game events to notes: material sets the voice, impulse the volume, combo the pitch.
class SoundCues {
public:
    /// `volume` 0..1 scales all notes. Repeated notes of one voice within a few ticks are dropped.
    void play(std::span<const Event> events, std::uint32_t tick, float volume, Speaker& speaker);

private:
    std::array<std::uint32_t, kVoiceNames.size()> lastTick_{}; // tick of the last note plus 1; 0:
                                                               // none
};

/// Note of an event; volume 0: none.
Note noteOf(const Event& event);

/// Pitch of the n-th block of a combo: pentatonic scale, at most two octaves up.
float comboPitch(int combo);

} // namespace apart
