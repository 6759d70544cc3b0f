// SPDX-License-Identifier: MIT
// A World drawn in a window by kodo::sfml. A click drops a box. Usage: draw_world [--frames N]
#include <kodo/kodo.hpp>
#include <kodo_sfml/display.hpp>
#include <kodo_sfml/window.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

int main(int argc, char** argv) {
    long frames = -1; // without end
    if (argc == 3 && std::string_view(argv[1]) == "--frames") {
        frames = std::atol(argv[2]);
    } else if (argc != 1) {
        std::fputs("Usage: draw_world [--frames N]\n", stderr);
        return 2;
    }
    if (!kodo_sfml::displayAvailable()) {
        std::fputs("There is no display.\n", stderr);
        return 3;
    }
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Box{18, 1}, .position = {0, -0.5f}, .type = kodo::BodyType::Static});
    for (int row = 0; row < 8; ++row) {
        for (int i = 0; i < 8 - row; ++i) {
            const float x = static_cast<float>(i) - 0.5f * static_cast<float>(7 - row);
            world.add(
                {.shape = kodo::Box{0.9f, 0.9f}, .position = {x, 0.5f + static_cast<float>(row)}});
        }
    }
    kodo_sfml::Window window("Kodo: a World", {900, 600});
    kodo_sfml::Painter painter;
    long shown = 0;
    for (; window.isOpen() && shown != frames; ++shown) {
        const kodo_draw::Camera camera({{-9, -1.5f}, {9, 10.5f}}, window.size());
        while (const auto event = window.nextEvent()) {
            if (event->type == sf::Event::Closed) {
                window.close();
            } else if (event->type == sf::Event::MouseButtonPressed) {
                const kodo_draw::Pixel pixel{static_cast<float>(event->mouseButton.x),
                                             static_cast<float>(event->mouseButton.y)};
                world.add({.shape = kodo::Box{0.9f, 0.9f}, .position = camera.toWorld(pixel)});
            }
        }
        world.step(1.0f / 60);
        painter.clear();
        kodo_sfml::WorldPainter picture(painter, camera);
        kodo::draw(world, picture, {.contacts = true});
        window.show(painter, {24, 28, 36});
    }
    std::printf("%ld frames, %zu bodies\n", shown, world.bodyCount());
}
