// SPDX-License-Identifier: MIT
#pragma once

namespace kodo_sfml {

/// True if a window can be opened. Must be checked before any window, texture or render texture is
/// created: without an X display, SFML 2.5 ends the program with abort().
bool displayAvailable();

/// True if OpenGL draws with the processor: then multisampling costs more than it gives. Requires
/// displayAvailable().
bool softwareRendering();

/// Suppresses the error messages of SFML during its lifetime.
class QuietSfml {
public:
    QuietSfml();
    ~QuietSfml();
    QuietSfml(const QuietSfml&) = delete;
    QuietSfml& operator=(const QuietSfml&) = delete;

private:
    void* before_; // stream buffer to restore
};

} // namespace kodo_sfml
