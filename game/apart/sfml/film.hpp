// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/play/rerun.hpp>

#include <filesystem>
#include <string>

namespace apart {

/// Writes a fall in slow motion as an animated GIF without an end. Needs a display. Returns why it
/// cannot be written, as a sentence, or "".
std::string writeFilm(Rerun fall, const std::string& path);
/// The film of the largest fall of a replay: of its file, or a link. `ownLevels`: the folder of the
/// player's levels; may be empty.
std::string filmReplay(const std::string& replay, const std::string& path,
                       const std::filesystem::path& ownLevels);

} // namespace apart
