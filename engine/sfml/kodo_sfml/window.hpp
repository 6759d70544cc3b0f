// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/painter.hpp>

#include <SFML/Graphics/RenderWindow.hpp>
#include <SFML/Window/Event.hpp>
#include <SFML/Window/Mouse.hpp>

#include <functional>
#include <optional>
#include <string>

namespace kodo_sfml {

/// A resizable window. Coordinates are pixels from its upper left corner. Requires
/// displayAvailable().
class Window {
public:
    /// Opens a centred window, no larger than the screen.
    Window(const std::string& title, Size wantedPixels);

    bool isOpen() const { return window_.isOpen(); }
    /// Samples for each pixel, 0 without multisampling. Without a graphics card the edges of a
    /// Painter are the antialiasing.
    unsigned samples() const { return window_.getSettings().antialiasingLevel; }
    void close() { window_.close(); }
    Size size() const { return {window_.getSize().x, window_.getSize().y}; }

    /// The next pending event, or nothing. After a resize event the view is already updated.
    std::optional<sf::Event> nextEvent();

    /// Shows a picture. If paced, waits for the vertical sync or the frame limit. The overlay is
    /// called after it is drawn, and may use OpenGL: SFML's state is saved around it.
    void show(const Painter& picture, Rgba background, const std::function<void()>& overlay = {});

    /// From a window to the whole screen in its usual resolution, or back. Held keys are forgotten.
    void toggleFullScreen();

    /// true: vertical sync and a frame limit; false: no limit.
    void setPaced(bool paced);
    bool hasFocus() const { return window_.hasFocus(); }
    void setPointerVisible(bool visible) { window_.setMouseCursorVisible(visible); }
    /// Position of the mouse in pixels of the window; may be outside.
    sf::Vector2i pointer() const { return sf::Mouse::getPosition(window_); }
    void putPointer(sf::Vector2i pixels) { sf::Mouse::setPosition(pixels, window_); }

private:
    void open(bool fullScreen);
    sf::ContextSettings context() const;

    std::string title_;
    Size wanted_; // pixels
    bool fullScreen_ = false;
    bool multisampled_ = false;
    sf::RenderWindow window_;
};

/// Draws a picture without a window and writes it to a file; the extension selects the format
/// (png). Needs a display. False if it cannot be drawn or written. Overlay: see Window::show().
bool savePicture(const Painter& picture, Size pixels, Rgba background, const std::string& path,
                 const std::function<void()>& overlay = {});

} // namespace kodo_sfml
