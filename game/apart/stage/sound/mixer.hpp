// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/sound/music.hpp>
#include <apart/stage/sound/speaker.hpp>

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace apart {

/// Mixes voices, rumble and music to stereo samples, in the room of the theme and below a limit.
/// Voices are synthesised when they are first heard, or one by one in the meantime, so that the
/// game starts at once. play() and follow() may be called while another thread renders.
class Mixer : public Speaker {
public:
    static constexpr std::size_t kChannels = 24; // voices at once
    static constexpr float kCeiling = 0.79f; // -2 dB of full scale, never exceeded: between samples
                                             // the signal stays below -1 dB

    void play(const Note& note) override;
    void follow(const SoundScene& scene) override;
    /// Interleaved left and right samples, -1..1.
    void render(std::span<float> samples);
    /// Number of voices that sound now. Not while another thread renders.
    std::size_t sounding() const;

private:
    using Sound = std::vector<float>;
    struct Channel {
        const Sound* sound = nullptr; // nullptr: free
        double at = 0;                // sample
        Note note{};
    };
    const Sound& soundOf(Voice voice, std::uint8_t variant);
    void prepareNext();
    void takeNotes();
    void begin(const Note& note);
    Frame voices(float& send);
    Frame rumble();
    void duck();
    Frame limited(Frame sum);

    std::mutex mutex_; // of the two below
    std::vector<Note> notes_;
    SoundScene wanted_;

    // Of the thread that renders.
    std::vector<Note> taken_;
    SoundScene scene_;
    std::array<Sound, kVoiceNames.size() * kVariants> bank_;
    std::size_t prepared_ = 0; // sounds of the bank
    std::array<Channel, kChannels> channels_;
    std::optional<Theme> theme_; // of the two below
    std::optional<Room> room_;
    std::optional<Music> music_;
    Dice dice_{77};
    std::array<float, 2> growl_{}; // states of the filters of the rumble
    float roar_ = 0;               // state of the filter of the roar
    float crack_ = 0;              // level of the last crack
    float crackSide_ = 0;          // where it is, -1..1
    float rumbleNow_ = 0;
    float rumbleMean_ = 0.22f; // of the last 20 s; at first that of most games
    float musicNow_ = 0;
    float duckNow_ = 0; // 0..1, how far the music makes way for a fall
    float gain_ = 1;    // of the limiter
};

} // namespace apart
