// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/setup.hpp>

#include <cstdint>
#include <string>
#include <variant>

namespace apart {

/// Options of the command line.
struct Options : StartOptions {
    std::string screenshot;   // file; empty: open the window
    std::uint32_t at = 600;   // tick of the screenshot
    std::uint32_t shots = 1;  // number of screenshots
    std::uint32_t every = 5;  // ticks from one to the next
    std::uint32_t frames = 0; // number of frames to time; 0: play
    std::uint32_t crowd = 0;  // least number of bodies in a timed frame
    std::string film;         // file; empty: none
    std::string page;         // address before the links that are copied
    bool mute = false;
    bool probeDisplay = false;
};

// The exit codes of the program.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 2; // wrong use, or a file that cannot be read or written
inline constexpr int kNoDisplay = 3;

/// The options, or the exit code after help or an error was printed.
std::variant<Options, int> parseOptions(int argc, char** argv);

} // namespace apart
