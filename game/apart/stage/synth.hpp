// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/speaker.hpp>

#include <cstdint>
#include <vector>

namespace apart {

inline constexpr unsigned kSampleRate = 44100; // samples a second, one channel

/// The samples of a voice at pitch 1, made anew each time: the game ships no sound files.
std::vector<std::int16_t> synthesise(Voice voice);

} // namespace apart
