// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/window.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <string>

#include "hand_use.hpp"

namespace destructoooor {

/// The state of the program beside the Sandbox: hand, camera, pause. Takes events, draws the scene.
class Workbench {
public:
    Sandbox sandbox;

    Hand hand = Hand::Drag;
    Dropped dropped;
    bool paused = false;
    bool quit = false;
    kodo::DrawOptions look{};
    std::string message; // about the last action; empty: none

    /// Pixels of the window that are not covered by panels.
    void setView(kodo_sfml::Size pixels, kodo_sfml::Rect free);
    void showScene(); // the camera shows all of the scene
    void open(std::size_t scene);
    void visit(std::size_t tour, std::size_t stop);
    void restart();
    /// A file of a World; `message` tells what happened.
    void load(const std::string& file);
    void save(const std::string& file);
    void go(int by); // as many scenes farther, or stops of the present tour

    /// An event that no panel wants.
    void take(const sf::Event& event);
    /// Runs the steps of this time (s), but only a few per call.
    void advance(double seconds);
    void stepOnce();
    void draw(kodo_sfml::Painter& painter) const;
    kodo_sfml::Camera camera() const;

private:
    void arrive();
    void press(sf::Keyboard::Key key);

    kodo_sfml::Size pixels_{1280, 720};
    kodo_sfml::Rect free_{0, 0, 1280, 720};
    Vec2 middle_{};        // m, centre of the view
    Real height_ = 16;     // m, of the view
    double owed_ = 0;      // s, not simulated yet
    bool panning_ = false; // right or middle button
    Stroke stroke_;        // of the left button
    kodo_sfml::Pixel mouse_{};
};

} // namespace destructoooor
