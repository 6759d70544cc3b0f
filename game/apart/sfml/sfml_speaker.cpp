// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_speaker.hpp>
#include <apart/stage/sound/synth.hpp>

#include <algorithm>
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

SfmlSpeaker::Stream::Stream(Mixer& mixer) : mixer_(mixer) {
    initialize(2, kSampleRate);
    play();
}

SfmlSpeaker::Stream::~Stream() {
    stop(); // while onGetData() can still be called
}

bool SfmlSpeaker::Stream::onGetData(Chunk& data) {
    mixer_.render(rendered_);
    std::transform(rendered_.begin(), rendered_.end(), samples_.begin(),
                   [](float sample) { return static_cast<sf::Int16>(32767 * sample); });
    data.samples = samples_.data();
    data.sampleCount = samples_.size();
    return true;
}

std::unique_ptr<Speaker> makeSpeaker(bool mute) {
    if (mute || !canPlay()) {
        return std::make_unique<SilentSpeaker>();
    }
    return std::make_unique<SfmlSpeaker>();
}

} // namespace apart
