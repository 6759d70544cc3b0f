// SPDX-License-Identifier: MIT
#include <apart/stage/sound/synth.hpp>
#include <apart/web/web_speaker.hpp>

#include <emscripten/emscripten.h>

#include <algorithm>
#include <array>
#include <span>

namespace apart {

namespace {

constexpr int kFrames = 1024; // of a chunk: 23 ms

// See page.js. False if the browser has no Web Audio.
EM_JS(int, openSound, (int rate, int frames, void* mixer),
      { return Module.openSound(rate, frames, mixer); });
EM_JS(void, setSound, (int on), { Module.setSound(on); });

} // namespace

extern "C" EMSCRIPTEN_KEEPALIVE const float* renderSound(void* mixer, int frames) {
    static std::array<float, 2 * kFrames> samples;
    static_cast<Mixer*>(mixer)->render(
        std::span(samples).first(2 * static_cast<std::size_t>(std::min(frames, kFrames))));
    return samples.data();
}

void WebSpeaker::start() {
    static const bool opened = openSound(static_cast<int>(kSampleRate), kFrames, &mixer_) != 0;
    if (opened) {
        setSound(1);
    }
}

void WebSpeaker::pause(bool on) {
    setSound(on ? 0 : 1);
}

} // namespace apart
