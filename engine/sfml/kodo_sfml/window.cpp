// SPDX-License-Identifier: MIT
#include <kodo_sfml/display.hpp>
#include <kodo_sfml/window.hpp>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/RenderTexture.hpp>
#include <SFML/Window/VideoMode.hpp>

#include <algorithm>

namespace kodo_sfml {

namespace {

constexpr unsigned kSamples = 4;        // for each pixel, with a graphics card
constexpr unsigned kMostFrames = 144;   // 1/s, without vertical sync
constexpr unsigned kFrameOfWindow = 80; // pixels, estimate for title bar and panels

void drawWith(sf::RenderTarget& target, const Painter& picture, Rgba background,
              const std::function<void()>& overlay) {
    target.clear({background.r, background.g, background.b, background.a});
    picture.draw(target);
    if (overlay) {
        target.pushGLStates();
        overlay();
        target.popGLStates();
    }
}

} // namespace

Window::Window(const std::string& title, Size wantedPixels) : title_(title), wanted_(wantedPixels) {
    multisampled_ = !softwareRendering();
    open(false);
}

sf::ContextSettings Window::context() const {
    return sf::ContextSettings(0, 0, multisampled_ ? kSamples : 0);
}

void Window::toggleFullScreen() {
    fullScreen_ = !fullScreen_;
    open(fullScreen_);
}

void Window::open(bool fullScreen) {
    const QuietSfml quiet; // a virtual display has no vertical sync, which SFML reports
    const sf::VideoMode screen = sf::VideoMode::getDesktopMode();
    const auto fit = [](unsigned wanted, unsigned room) {
        return room > 2 * kFrameOfWindow ? std::min(wanted, room - kFrameOfWindow) : wanted;
    };
    const Size size{fit(wanted_.x, screen.width), fit(wanted_.y, screen.height)};
    if (fullScreen) {
        window_.create(screen, title_, sf::Style::Fullscreen, context());
    } else {
        window_.create({size.x, size.y}, title_, sf::Style::Default, context());
        // Done here: SFML 2.5.1 uses the width of the screen for both directions.
        window_.setPosition(
            {static_cast<int>((screen.width - std::min(size.x, screen.width)) / 2),
             static_cast<int>((screen.height - std::min(size.y, screen.height)) / 2)});
    }
    setPaced(true);
    window_.setKeyRepeatEnabled(false);
    window_.requestFocus(); // without a window manager the focus is not given automatically
}

void Window::setPaced(bool paced) {
    const QuietSfml quiet;
    window_.setVerticalSyncEnabled(paced);
    window_.setFramerateLimit(paced ? kMostFrames : 0);
}

std::optional<sf::Event> Window::nextEvent() {
    sf::Event event;
    if (!window_.pollEvent(event)) {
        return std::nullopt;
    }
    if (event.type == sf::Event::Resized) {
        const sf::FloatRect all(0, 0, static_cast<float>(event.size.width),
                                static_cast<float>(event.size.height));
        window_.setView(sf::View(all));
    }
    return event;
}

void Window::show(const Painter& picture, Rgba background, const std::function<void()>& overlay) {
    drawWith(window_, picture, background, overlay);
    window_.display();
}

bool savePicture(const Painter& picture, Size pixels, Rgba background, const std::string& path,
                 const std::function<void()>& overlay) {
    sf::RenderTexture target;
    if (!target.create(pixels.x, pixels.y)) {
        return false;
    }
    drawWith(target, picture, background, overlay);
    target.display();
    return target.getTexture().copyToImage().saveToFile(path);
}

} // namespace kodo_sfml
