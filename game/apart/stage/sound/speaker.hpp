// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// Sounds of the game, one per audible event.
enum class Voice : std::uint8_t {
    Glass,
    Wood,
    Brick,
    Stone,
    Steel,
    Wall,
    Paddle,
    Break, // added to the voice of the broken material
    Weld,  // a part is welded to the paddle
    Stick, // a part sticks to the paddle until it fires
    Fire,  // a stuck part fires
    Split, // a block splits into balls
    Serve,
    BallLost,
    Cleared,
    GameOver,
    Choose, // menu selection
    Bumper, // bumper impact
    Good,   // start of a good power
    Bad,    // start of a bad power
    Over,   // end of a power
    Pull,   // the paddle's field pulls
    Push,
    Gulp,   // a shard refills the meter
    Rumble, // a mount gives way
    Boss,   // a boss is defeated
    Splash, // something falls into water, or flies out of it
    Gush,   // a dam breaks
};
inline constexpr std::array<std::string_view, 28> kVoiceNames = {
    "glass",   "wood",      "brick",  "stone",  "steel", "wall",   "paddle",
    "break",   "weld",      "stick",  "fire",   "split", "serve",  "ball lost",
    "cleared", "game over", "choose", "bumper", "good",  "bad",    "over",
    "pull",    "push",      "gulp",   "rumble", "boss",  "splash", "gush"};

struct Note {
    Voice voice = Voice::Wall;
    float pitch = 1;          // factor on the frequency of the voice
    float volume = 1;         // 0..1
    float pan = 0;            // -1 left .. 1 right
    std::uint8_t variant = 0; // below kVariants: slightly different sounds of one voice
};
inline constexpr std::uint8_t kVariants = 3;

/// What music, rumble and room follow, from frame to frame. Shares are 0..1.
struct SoundScene {
    Theme theme = Theme::Daybreak;
    float volume = 0;     // of all but the music
    float music = 0;      // volume of the music
    float combo = 0;      // of the blocks broken in a row, or fallen in this collapse
    float danger = 0;     // of losing a ball or the game
    float rumble = 0;     // of what falls: its momentum
    bool muffled = false; // a menu covers the game
    bool won = false;     // the level is cleared
};

/// Sound output.
class Speaker {
public:
    virtual ~Speaker() = default;
    virtual void play(const Note& note) = 0;
    /// Call once per frame.
    virtual void follow(const SoundScene&) {}
};

/// No output, for --mute or without a sound device.
class SilentSpeaker : public Speaker {
public:
    void play(const Note&) override {}
};

} // namespace apart
