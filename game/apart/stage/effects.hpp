// SPDX-License-Identifier: MIT
#pragma once

namespace apart {

/// How much of each effect is shown, in percent. None touches the simulation; 0 is off.
struct EffectSettings {
    int particles = 100;
    int trail = 100;
    int shake = 60;
    int flash = 60;
    int sound = 80;
};

/// As a share, 0..1 for 0..100.
constexpr float share(int percent) {
    return static_cast<float>(percent) / 100.0f;
}

} // namespace apart
