// SPDX-License-Identifier: MIT
#include "workbench.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace destructoooor {

namespace {

constexpr int kMostSteps = 4; // per frame; beyond that, the simulation runs slower
const kodo_sfml::Rgba kPathColor{255, 220, 90};

kodo_sfml::Pixel toFloat(int x, int y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

} // namespace

void Workbench::setView(kodo_sfml::Size pixels, kodo_sfml::Rect free) {
    pixels_ = pixels;
    free_ = free;
}

void Workbench::showScene() {
    const kodo::Aabb view = sandbox.view();
    middle_ = view.center();
    const auto shape = static_cast<Real>(free_.height / std::max(free_.width, 1.0f));
    height_ = std::max(view.extent().y, view.extent().x * shape);
}

void Workbench::open(std::size_t scene) {
    sandbox.open(scene);
    arrive();
}

void Workbench::visit(std::size_t tour, std::size_t stop) {
    sandbox.visit(tour, stop);
    arrive();
}

void Workbench::restart() {
    sandbox.restart();
    arrive();
}

void Workbench::load(const std::string& file) {
    try {
        sandbox.load(file);
        arrive();
        message = "Loaded " + file + ".";
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
}

void Workbench::save(const std::string& file) {
    try {
        sandbox.save(file);
        const std::string lacking = file.ends_with(".toml") ? sandbox.notHeld() : "";
        message = "Saved as " + file + "." + (lacking.empty() ? "" : " Not held: " + lacking + ".");
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
}

void Workbench::go(int by) {
    const auto moved = [by](std::size_t index) { return static_cast<int>(index) + by; };
    if (const std::optional<Sandbox::Place> place = sandbox.place()) {
        const auto stops = static_cast<int>(tours()[place->tour].stops.size());
        const int stop = std::clamp(moved(place->stop), 0, stops - 1);
        visit(place->tour, static_cast<std::size_t>(stop));
    } else {
        const auto scenes = static_cast<int>(catalogue().size());
        open(static_cast<std::size_t>((moved(sandbox.sceneIndex()) + scenes) % scenes));
    }
}

void Workbench::arrive() {
    showScene();
    message.clear();
}

kodo_sfml::Camera Workbench::camera() const {
    // The free part of the window shows the view; the camera knows the whole window.
    const Real metre = height_ / static_cast<Real>(std::max(free_.height, 1.0f)); // per pixel
    const Vec2 freeMiddle{static_cast<Real>(free_.left + free_.width / 2),
                          static_cast<Real>(free_.top + free_.height / 2)};
    const Vec2 shown{static_cast<Real>(pixels_.x) * metre, static_cast<Real>(pixels_.y) * metre};
    const Vec2 lower = middle_ - Vec2{freeMiddle.x * metre, shown.y - freeMiddle.y * metre};
    return {{lower, lower + shown}, pixels_};
}

void Workbench::take(const sf::Event& event) {
    switch (event.type) {
    case sf::Event::KeyPressed:
        press(event.key.code);
        break;
    case sf::Event::MouseButtonPressed:
        mouse_ = toFloat(event.mouseButton.x, event.mouseButton.y);
        if (event.mouseButton.button == sf::Mouse::Left) {
            message.clear();
            stroke_.press(sandbox, hand, camera().toWorld(mouse_));
        } else {
            panning_ = true;
        }
        break;
    case sf::Event::MouseButtonReleased:
        if (event.mouseButton.button == sf::Mouse::Left) {
            const Vec2 at = camera().toWorld(toFloat(event.mouseButton.x, event.mouseButton.y));
            if (std::string why = stroke_.release(sandbox, dropped, at); !why.empty()) {
                message = std::move(why);
            }
        } else {
            panning_ = false;
        }
        break;
    case sf::Event::MouseMoved: {
        const kodo_sfml::Pixel to = toFloat(event.mouseMove.x, event.mouseMove.y);
        const Vec2 at = camera().toWorld(to);
        if (panning_) {
            middle_ += camera().toWorld(mouse_) - at;
        } else {
            stroke_.move(sandbox, at);
        }
        mouse_ = to;
        break;
    }
    case sf::Event::MouseWheelScrolled: {
        const auto turn = static_cast<Real>(event.mouseWheelScroll.delta);
        if (hand == Hand::Drop && !panning_) {
            dropped.size =
                std::clamp(dropped.size + 0.1f * event.mouseWheelScroll.delta, 0.2f, 4.0f);
        } else {
            height_ = std::clamp(height_ * std::pow(Real(0.9), turn), Real(1), Real(400));
        }
        break;
    }
    default:
        break;
    }
}

void Workbench::press(sf::Keyboard::Key key) {
    using Key = sf::Keyboard::Key;
    switch (key) {
    case Key::Escape:
        quit = true;
        break;
    case Key::R:
        restart();
        break;
    case Key::Space:
        paused = !paused;
        break;
    case Key::N:
        paused = true;
        stepOnce();
        break;
    case Key::B:
        paused = true;
        sandbox.rewind(sandbox.tick() - std::min<std::uint64_t>(sandbox.tick(), 1));
        break;
    case Key::PageDown:
        go(1);
        break;
    case Key::PageUp:
        go(-1);
        break;
    case Key::Home:
        showScene();
        break;
    case Key::E:
        hand = Hand::Explode;
        break;
    case Key::Num0:
        hand = Hand::Spring;
        break;
    default:
        if (key >= Key::Num1 && key <= Key::Num9) {
            hand = static_cast<Hand>(key - Key::Num1);
        }
        break;
    }
}

void Workbench::stepOnce() {
    sandbox.step();
}

void Workbench::advance(double seconds) {
    const auto step = static_cast<double>(kStepSeconds);
    owed_ = paused ? 0 : std::min(owed_ + seconds, kMostSteps * step);
    for (; owed_ >= step; owed_ -= step) {
        stepOnce();
    }
}

void Workbench::draw(kodo_sfml::Painter& painter) const {
    const kodo_sfml::Camera view = camera();
    kodo_sfml::WorldPainter picture(painter, view);
    drawScene(sandbox, picture, look);
    const std::span<const Vec2> path = stroke_.path();
    for (std::size_t i = 1; i < path.size(); ++i) {
        painter.line(view.toPixels(path[i - 1]), view.toPixels(path[i]), 2, kPathColor);
    }
    if (path.size() == 1 && hand != Hand::Drag && hand != Hand::Drop) {
        painter.line(view.toPixels(path[0]), mouse_, 2, kPathColor);
    }
}

} // namespace destructoooor
