// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/sound/mixer.hpp>

#include <SFML/Audio/SoundStream.hpp>

#include <array>
#include <memory>

namespace apart {

/// Streams what a Mixer renders to the sound device.
class SfmlSpeaker : public Speaker {
public:
    void play(const Note& note) override { mixer_.play(note); }
    void follow(const SoundScene& scene) override { mixer_.follow(scene); }

private:
    /// Has a thread of its own, which renders.
    class Stream : public sf::SoundStream {
    public:
        explicit Stream(Mixer& mixer);
        ~Stream() override;

    private:
        bool onGetData(Chunk& data) override;
        void onSeek(sf::Time) override {}

        /// Frames of a chunk, 12 ms: SFML queues three, which is the delay of a sound.
        static constexpr std::size_t kFrames = 512;
        Mixer& mixer_;
        std::array<float, 2 * kFrames> rendered_{};
        std::array<sf::Int16, 2 * kFrames> samples_{};
    };

    Mixer mixer_;
    Stream stream_{mixer_};
};

/// A SilentSpeaker if `mute` is set or there is no audio device. The device is checked first,
/// because SFML prints many errors without one.
std::unique_ptr<Speaker> makeSpeaker(bool mute);

} // namespace apart
