// SPDX-License-Identifier: MIT
#pragma once

namespace kodo_sfml {

/// Can a window be opened? SFML 2.5 ends the program with abort() where there is no X display, so
/// ask here before making any window, texture or render texture.
bool displayAvailable();

/// While it lives, what SFML would write to the standard error stream is dropped.
class QuietSfml {
public:
    QuietSfml();
    ~QuietSfml();
    QuietSfml(const QuietSfml&) = delete;
    QuietSfml& operator=(const QuietSfml&) = delete;

private:
    void* before_; // the stream buffer that comes back
};

} // namespace kodo_sfml
