// SPDX-License-Identifier: MIT
// Destructoooor!: a sandbox with four scenes and all parameters of the simulation [Thesis06,
// Appendix A].
#include <kodo_sfml/display.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <exception>

#include "demo.hpp"

namespace destructoooor {
namespace {

constexpr int kDone = 0;
constexpr int kRefused = 2;
constexpr int kNoDisplay = 3;
const kodo_sfml::Rgba kBackground{30, 33, 40};
const kodo_sfml::Size kPixels{1280, 800};

struct Options {
    int scene = 2;
    int shock = 0;
    int rest = 5;
    int collision = 5;
    unsigned steps = 240;
    std::string picture;
};

void prepare(Demo& demo, const Options& options) {
    kodo::StepSettings settings = demo.sandbox().settings();
    settings.propagation().shockPasses = options.shock;
    settings.propagation().contactPasses = options.rest;
    settings.propagation().impactPasses = options.collision;
    demo.sandbox().setSettings(settings);
    demo.sandbox().restart(static_cast<Scene>(options.scene - 1));
}

int takePicture(Demo& demo, const Options& options) {
    for (unsigned step = 0; step < options.steps; ++step) {
        demo.sandbox().step();
    }
    kodo_sfml::Painter painter;
    demo.draw(painter, kPixels);
    if (!kodo_sfml::savePicture(painter, kPixels, kBackground, options.picture)) {
        std::fprintf(stderr, "destructoooor: The picture cannot be written to %s.\n",
                     options.picture.c_str());
        return kRefused;
    }
    return kDone;
}

int play(Demo& demo) {
    using Clock = std::chrono::steady_clock;
    kodo_sfml::Window window("Destructoooor!", kPixels);
    kodo_sfml::Painter painter;
    auto last = Clock::now();
    while (!demo.wantsToQuit()) {
        while (const auto event = window.nextEvent()) {
            demo.take(*event);
        }
        const auto now = Clock::now();
        demo.advance(std::chrono::duration<double>(now - last).count());
        last = now;
        demo.draw(painter, window.size());
        window.show(painter, kBackground);
    }
    window.close();
    return kDone;
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Destructoooor!: a sandbox of Kodo with four scenes. Bodies can be dropped in, and "
        "parameters of the simulation can be changed while it runs.",
        "destructoooor");
    app.footer("Shock propagation stabilises a stack with few iterations. More collision and rest\n"
               "iterations reduce overlap. The window lists the keys.\n"
               "Exit code: 0 done, 2 wrong use, 3 no display.");
    app.add_option("--scene", options.scene, "1 ground, 2 tower, 3 pyramid, 4 pit")
        ->capture_default_str()
        ->check(CLI::Range(1, 4));
    app.add_option("--shock", options.shock, "Passes of shock propagation")
        ->capture_default_str()
        ->check(CLI::Range(0, 10));
    app.add_option("--rest", options.rest, "Rest iterations")
        ->capture_default_str()
        ->check(CLI::Range(1, 60));
    app.add_option("--collision", options.collision, "Collision iterations")
        ->capture_default_str()
        ->check(CLI::Range(0, 40));
    auto* picture = app.add_option("--picture", options.picture,
                                   "Write a picture (png) after some steps, then exit");
    app.add_option("--steps", options.steps, "Steps before the picture, 60 per second")
        ->capture_default_str()
        ->needs(picture);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        std::fprintf(stderr, "destructoooor: %s. Try destructoooor --help.\n", error.what());
        return kRefused;
    }
    if (!kodo_sfml::displayAvailable()) {
        std::fprintf(stderr, "destructoooor: There is no display for the window. Set DISPLAY.\n");
        return kNoDisplay;
    }
    Demo demo(DESTRUCTOOOOR_FONT);
    prepare(demo, options);
    return options.picture.empty() ? play(demo) : takePicture(demo, options);
}

} // namespace
} // namespace destructoooor

int main(int argc, char** argv) {
    try {
        return destructoooor::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "destructoooor: %s\n", error.what());
        return destructoooor::kRefused;
    }
}
