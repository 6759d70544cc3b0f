// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/sound/speaker.hpp>

#include <cstdint>
#include <vector>

namespace apart {

inline constexpr unsigned kSampleRate = 44100; // samples per second, one channel
inline constexpr float kSampleHertz = static_cast<float>(kSampleRate);

/// Synthesises a voice at pitch 1: samples -1..1. The game ships no sound files. Variants differ in
/// their partials and noise as two strokes on one body do.
std::vector<float> synthesise(Voice voice, std::uint8_t variant = 0);

} // namespace apart
