// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/sound/speaker.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// Maps game events to notes: material sets the voice, impulse the volume, combo and mass the
/// pitch. No two notes are quite alike.
class SoundCues {
public:
    /// Stores the masses of blocks and shards. Call before each tick: what breaks in it is gone
    /// afterwards.
    void weigh(const Game& game);
    /// `volume` 0..1 scales all notes. Repeated notes of one voice within a few ticks are dropped.
    void play(std::span<const Event> events, std::uint32_t tick, float volume, Speaker& speaker);

private:
    struct Weight {
        kodo::BodyId body;
        float mass; // kg
    };
    float massPitchOf(const Event& event) const;

    std::vector<Weight> weights_; // by body
    Dice dice_{5};
    std::array<std::uint32_t, kVoiceNames.size()> lastTick_{}; // tick of the last note plus 1; 0:
                                                               // none
};

/// Note of an event; volume 0: none.
Note noteOf(const Event& event);

/// Factor on the pitch of a struck body: the frequencies of equal shapes fall with the cube root of
/// their mass. Within half an octave up and an octave down.
float massPitch(float mass);

/// The scene of a game for the continuous sounds; its volumes are left at 0.
SoundScene sceneOf(const Game& game);

/// Pitch of the n-th block of a combo: pentatonic scale, at most two octaves up.
float comboPitch(int combo);

} // namespace apart
