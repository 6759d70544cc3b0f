// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/core/replay_words.hpp>

namespace apart {

/// Reads a line `expect ...` of a replay, without its number. Returns why it is invalid, or "".
std::string readExpectation(const Words& words, Expectation& expectation);

} // namespace apart
