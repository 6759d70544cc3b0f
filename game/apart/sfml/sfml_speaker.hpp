// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/speaker.hpp>

#include <SFML/Audio/Sound.hpp>
#include <SFML/Audio/SoundBuffer.hpp>

#include <array>
#include <memory>

namespace apart {

/// Plays voices on a fixed number of channels; a new sound replaces the oldest.
class SfmlSpeaker : public Speaker {
public:
    SfmlSpeaker();
    void play(const Note& note) override;

private:
    std::array<sf::SoundBuffer, kVoiceNames.size()> voices_;
    std::array<sf::Sound, 24> channels_;
    std::size_t next_ = 0;
};

/// A SilentSpeaker if `mute` is set or there is no audio device. The device is checked first,
/// because SFML prints many errors without one.
std::unique_ptr<Speaker> makeSpeaker(bool mute);

} // namespace apart
