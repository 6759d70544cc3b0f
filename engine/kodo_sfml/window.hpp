// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/painter.hpp>

#include <SFML/Graphics/RenderWindow.hpp>
#include <SFML/Window/Event.hpp>
#include <SFML/Window/Mouse.hpp>

#include <optional>
#include <string>

namespace kodo_sfml {

/// A resizable window, drawn in pixels from its upper left corner. Make one only
/// where displayAvailable() says yes.
class Window {
public:
    /// No larger than the screen, and in its middle.
    Window(const std::string& title, sf::Vector2u wantedPixels);

    bool isOpen() const { return window_.isOpen(); }
    void close() { window_.close(); }
    sf::Vector2u size() const { return window_.getSize(); }

    /// The next waiting event, or nothing. A resize has then already been followed.
    std::optional<sf::Event> nextEvent();

    /// Shows a picture; waits for the screen, and so sets the pace of the program.
    void show(const Painter& picture, sf::Color background);

    /// As fast as the screen, or as fast as it goes.
    void setPaced(bool paced);
    bool hasFocus() const { return window_.hasFocus(); }
    void setPointerVisible(bool visible) { window_.setMouseCursorVisible(visible); }
    // Where the mouse is, in pixels of the window; it may be outside.
    sf::Vector2i pointer() const { return sf::Mouse::getPosition(window_); }
    void putPointer(sf::Vector2i pixels) { sf::Mouse::setPosition(pixels, window_); }

private:
    sf::RenderWindow window_;
};

/// Draws a picture of that size without a window and writes it to a file whose ending names the
/// format (png). Needs a display too. False when it cannot be drawn or written.
bool savePicture(const Painter& picture, sf::Vector2u pixels, sf::Color background,
                 const std::string& path);

} // namespace kodo_sfml
