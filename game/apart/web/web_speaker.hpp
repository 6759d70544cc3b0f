// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/sound/mixer.hpp>

namespace apart {

/// Plays what a Mixer renders with the browser's Web Audio. A browser is silent until the player
/// has pressed a key or a button; start() may be called at each press.
class WebSpeaker final : public Speaker {
public:
    void play(const Note& note) override { mixer_.play(note); }
    void follow(const SoundScene& scene) override { mixer_.follow(scene); }

    void start();
    /// No sound while the page is hidden.
    void pause(bool on);

private:
    Mixer mixer_;
};

} // namespace apart
