// SPDX-License-Identifier: MIT
#include "demo.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace destructoooor {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr int kMostSteps = 4;      // per frame; beyond that, the simulation runs slower
constexpr unsigned kHelpText = 14; // pixels
const kodo_sfml::Rgba kHelpColor{140, 148, 160};

constexpr std::array<const char*, 2> kHelp = {
    "1-4 scene   R restart   click: drop, Tab: shape, wheel: size   right click: explosion   "
    "Space pause   N single step",
    "Up, Down select a value   Left, Right change it   C contacts   I impulses   B bounds   "
    "Escape quit"};

} // namespace

Demo::Demo(const std::string& fontFile) {
    if (!font_.loadFromFile(fontFile)) {
        throw std::runtime_error("The font " + fontFile + " cannot be read.");
    }
    look_.metresPerImpulse = 0.5f;
}

kodo_sfml::Camera Demo::camera() const {
    // The scene is 26 m by 16 m, to the left of the panel.
    const auto width = static_cast<float>(pixels_.x);
    const Real share = std::clamp(1 - Panel::kWidth / width, Real(0.2), Real(1));
    return {{{-13, -2}, {-13 + 26 / share, 15}}, pixels_};
}

void Demo::take(const sf::Event& event) {
    switch (event.type) {
    case sf::Event::Closed:
        quit_ = true;
        break;
    case sf::Event::KeyPressed:
        press(event.key.code);
        break;
    case sf::Event::MouseButtonPressed:
        click(event.mouseButton);
        break;
    case sf::Event::MouseButtonReleased:
        panel_.release();
        break;
    case sf::Event::MouseMoved:
        panel_.drag({static_cast<float>(event.mouseMove.x), static_cast<float>(event.mouseMove.y)},
                    sandbox_);
        break;
    case sf::Event::MouseWheelScrolled:
        size_ = std::clamp(size_ + Real(0.1) * event.mouseWheelScroll.delta, Real(0.3), Real(3));
        break;
    default:
        break;
    }
}

void Demo::press(sf::Keyboard::Key key) {
    using Key = sf::Keyboard::Key;
    if (key >= Key::Num1 && key <= Key::Num4) {
        sandbox_.restart(static_cast<Scene>(key - Key::Num1));
        return;
    }
    switch (key) {
    case Key::Escape:
        quit_ = true;
        break;
    case Key::R:
        sandbox_.restart(sandbox_.scene());
        break;
    case Key::Space:
        paused_ = !paused_;
        break;
    case Key::N:
        paused_ = true;
        stepOnce();
        break;
    case Key::Tab:
        primitive_ = static_cast<Primitive>((static_cast<std::size_t>(primitive_) + 1) %
                                            kPrimitiveNames.size());
        break;
    case Key::Up:
    case Key::Down:
        panel_.choose(key == Key::Up ? -1 : 1);
        break;
    case Key::Left:
    case Key::Right:
        panel_.turn(key == Key::Left ? -1 : 1, sandbox_);
        break;
    case Key::C:
        look_.contacts = !look_.contacts;
        break;
    case Key::I:
        look_.impulses = !look_.impulses;
        break;
    case Key::B:
        look_.bounds = !look_.bounds;
        break;
    default:
        break;
    }
}

void Demo::click(const sf::Event::MouseButtonEvent& button) {
    const kodo_sfml::Pixel pixel{static_cast<float>(button.x), static_cast<float>(button.y)};
    if (button.button == sf::Mouse::Left && panel_.press(pixel, sandbox_)) {
        return;
    }
    const Vec2 place = camera().toWorld(pixel);
    if (button.button == sf::Mouse::Left) {
        sandbox_.drop(primitive_, place, size_);
    } else if (button.button == sf::Mouse::Right) {
        sandbox_.burst(place);
    }
}

void Demo::stepOnce() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    sandbox_.step();
    const double milliseconds =
        std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    stepMilliseconds_ += 0.05 * (milliseconds - stepMilliseconds_);
}

void Demo::advance(double seconds) {
    owed_ = std::min(owed_ + seconds, kMostSteps * static_cast<double>(kStepSeconds));
    for (; owed_ >= static_cast<double>(kStepSeconds); owed_ -= static_cast<double>(kStepSeconds)) {
        if (!paused_) {
            stepOnce();
        }
    }
}

void Demo::draw(kodo_sfml::Painter& painter, kodo_sfml::Size pixels) {
    pixels_ = pixels;
    painter.clear();
    kodo_sfml::paintWorld(painter, camera(), sandbox_.world(), look_);
    const Measures now = sandbox_.measures();
    const auto line = [](const char* format, auto... values) {
        char text[96];
        std::snprintf(text, sizeof text, format, values...);
        return std::string(text);
    };
    const std::array<std::string, 7> lines = {
        line("%s%s", kSceneNames[static_cast<std::size_t>(sandbox_.scene())].data(),
             paused_ ? ", paused" : ""),
        line("click drops: %s of %.1f m",
             kPrimitiveNames[static_cast<std::size_t>(primitive_)].data(),
             static_cast<double>(size_)),
        line("deepest overlap  %.1f mm", 1000 * static_cast<double>(now.maxOverlap)),
        line("top at %.3f m, fastest %.2f m/s", static_cast<double>(now.highest),
             static_cast<double>(now.fastest)),
        line("%zu bodies, %zu asleep", now.bodies, now.asleep),
        line("%zu contacts, %zu visits", now.contacts, now.visits),
        line("step %.2f ms of 16.67", stepMilliseconds_)};
    panel_.setSize(pixels);
    panel_.draw(painter, font_, sandbox_, lines);
    float y = 24;
    for (const char* help : kHelp) {
        painter.text(font_, help, kHelpText, {16, y}, kHelpColor);
        y += 20;
    }
}

} // namespace destructoooor
