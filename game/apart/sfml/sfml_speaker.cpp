// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_speaker.hpp>
#include <apart/stage/synth.hpp>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace apart {

namespace {

#ifdef __linux__
/// True if a playback device exists: a node such as pcmC0D0p, with p for playback.
bool soundCard() {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/dev/snd", error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("pcm") && name.ends_with("p")) {
            return true;
        }
    }
    return false;
}

bool soundServer() {
    if (std::getenv("PULSE_SERVER") != nullptr) {
        return true;
    }
    const char* folder = std::getenv("XDG_RUNTIME_DIR");
    std::error_code error;
    return folder != nullptr &&
           (std::filesystem::exists(std::filesystem::path(folder) / "pulse/native", error) ||
            std::filesystem::exists(std::filesystem::path(folder) / "pipewire-0", error));
}

bool canPlay() {
    return soundCard() || soundServer();
}
#else
bool canPlay() {
    return true;
}
#endif

} // namespace

SfmlSpeaker::SfmlSpeaker() {
    for (std::size_t i = 0; i < voices_.size(); ++i) {
        const std::vector<std::int16_t> samples = synthesise(static_cast<Voice>(i));
        voices_[i].loadFromSamples(samples.data(), samples.size(), 1, kSampleRate);
    }
    for (sf::Sound& channel : channels_) {
        channel.setRelativeToListener(true);
        channel.setAttenuation(0); // positions are used for panning only
    }
}

void SfmlSpeaker::play(const Note& note) {
    sf::Sound& channel = channels_[next_];
    next_ = (next_ + 1) % channels_.size();
    channel.stop();
    channel.setBuffer(voices_[static_cast<std::size_t>(note.voice)]);
    channel.setPitch(note.pitch);
    channel.setVolume(100 * note.volume);
    channel.setPosition(note.pan, 0, -1);
    channel.play();
}

std::unique_ptr<Speaker> makeSpeaker(bool mute) {
    if (mute || !canPlay()) {
        return std::make_unique<SilentSpeaker>();
    }
    return std::make_unique<SfmlSpeaker>();
}

} // namespace apart
