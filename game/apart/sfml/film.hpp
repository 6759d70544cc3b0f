// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/play/rerun.hpp>

#include <string>

namespace apart {

/// Writes a fall in slow motion as an animated GIF without an end. Needs a display. Returns why it
/// cannot be written, as a sentence, or "".
std::string writeFilm(Rerun fall, const std::string& path);
/// The film of the largest fall of a replay: of its file, or a link.
std::string filmReplay(const std::string& replay, const std::string& path);

} // namespace apart
