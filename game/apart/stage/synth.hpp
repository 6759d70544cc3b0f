// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/speaker.hpp>

#include <cstdint>
#include <vector>

namespace apart {

inline constexpr unsigned kSampleRate = 44100; // samples per second, one channel

/// Synthesises a voice at pitch 1. The game ships no sound files.
std::vector<std::int16_t> synthesise(Voice voice);

} // namespace apart
