// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/speaker.hpp>

#include <SFML/Audio/Sound.hpp>
#include <SFML/Audio/SoundBuffer.hpp>

#include <array>
#include <memory>

namespace apart {

/// Plays the voices, as many at once as there are channels; the oldest makes room.
class SfmlSpeaker : public Speaker {
public:
    SfmlSpeaker();
    void play(const Note& note) override;

private:
    std::array<sf::SoundBuffer, kVoiceNames.size()> voices_;
    std::array<sf::Sound, 24> channels_;
    std::size_t next_ = 0;
};

/// Silent when it is asked to be or when there is nothing to play on. SFML would write a hundred
/// lines of errors without a device, so that is found out beforehand.
std::unique_ptr<Speaker> makeSpeaker(bool mute);

} // namespace apart
