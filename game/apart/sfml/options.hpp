// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace apart {

/// What the command line asks for.
struct Options {
    std::string level;                 // empty: choose on the title screen
    std::optional<std::uint32_t> seed; // none: another one each time
    std::string replay;                // file; empty: the player plays
    std::string screenshot;            // file; empty: open the window
    std::uint32_t at = 600;            // tick of the screenshot
    std::uint32_t frames = 0;          // to be timed; 0: play
    std::uint32_t crowd = 0;           // only frames with so many bodies are timed
    bool mute = false;
    bool probeDisplay = false;
};

// The exit codes of the program.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 2; // wrong use, or a file that cannot be read or written
inline constexpr int kNoDisplay = 3;

/// The options, or the exit code when everything has been said already (help, or an error).
std::variant<Options, int> parseOptions(int argc, char** argv);

} // namespace apart
