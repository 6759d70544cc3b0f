// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// The sounds of the game, one for each thing that can be told by ear.
enum class Voice : std::uint8_t {
    Glass,
    Wood,
    Brick,
    Stone,
    Steel,
    Wall,
    Paddle,
    Break, // under the tone of what broke
    Weld,  // a part became one with the paddle
    Stick, // a part sticks and counts down
    Fire,  // it went off
    Split, // a block became balls
    Serve,
    BallLost,
    Cleared,
    GameOver,
    Choose, // in menus
    Bumper, // kicks
    Good,   // a power begins that is welcome
    Bad,    // one that is not
    Over,   // a power ends
    Pull,   // the paddle's field
    Push,
    Gulp,   // a shard fed the meter
    Rumble, // a mount gives way
    Boss,   // it is down
};
inline constexpr std::array<std::string_view, 26> kVoiceNames = {
    "glass", "wood", "brick", "stone", "steel",     "wall",    "paddle",    "break",  "weld",
    "stick", "fire", "split", "serve", "ball lost", "cleared", "game over", "choose", "bumper",
    "good",  "bad",  "over",  "pull",  "push",      "gulp",    "rumble",    "boss"};

struct Note {
    Voice voice = Voice::Wall;
    float pitch = 1;  // times the frequency of the voice
    float volume = 1; // 0..1
    float pan = 0;    // -1 left .. 1 right
};

/// What the game is heard through.
class Speaker {
public:
    virtual ~Speaker() = default;
    virtual void play(const Note& note) = 0;
};

/// For --mute, and where there is no sound device.
class SilentSpeaker : public Speaker {
public:
    void play(const Note&) override {}
};

} // namespace apart
