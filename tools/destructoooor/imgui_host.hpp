// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/window.hpp>

#include <string>

namespace destructoooor {

/// Dear ImGui in a window of SFML: passes events on, and draws with its OpenGL 2 back end in SFML's
/// context. One at a time, while a window or a render texture exists.
class ImGuiHost {
public:
    explicit ImGuiHost(const std::string& fontFile);
    ~ImGuiHost();
    ImGuiHost(const ImGuiHost&) = delete;
    ImGuiHost& operator=(const ImGuiHost&) = delete;

    void take(const sf::Event& event);
    /// Begins a frame; seconds since the last one.
    void begin(kodo_sfml::Size pixels, float seconds);
    /// Ends the frame without drawing, or draws it: in the overlay of Window::show().
    void draw();
    bool wantsMouse() const;
    bool wantsKeys() const;
};

} // namespace destructoooor
