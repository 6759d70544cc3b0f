// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/stage/speaker.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace apart {

/// Turns what happened into sound: the tone by what was struck, the loudness by the impulse, the
/// pitch by the combo.
class Ear {
public:
    /// `volume` 0..1 of all notes. The same voice is not begun twice within a few ticks.
    void hear(std::span<const Event> events, std::uint32_t tick, float volume, Speaker& speaker);

private:
    std::array<std::uint32_t, kVoiceNames.size()> lastTick_{}; // when the voice was begun, plus 1
};

/// The note an event asks for; volume 0: none.
Note noteOf(const Event& event);

/// Pitch of the n-th block in a row: up a scale of five tones, two octaves at most.
float comboPitch(int combo);

} // namespace apart
