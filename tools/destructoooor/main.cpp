// SPDX-License-Identifier: MIT
// Destructoooor!: a sandbox of scenes in which every parameter of the simulation can be changed
// [Thesis06, Appendix A].
#include <kodo/version.hpp>
#include <kodo_sfml/display.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "frames.hpp"
#include "imgui_host.hpp"
#include "panel.hpp"

namespace destructoooor {
namespace {

constexpr int kDone = 0;
constexpr int kRefused = 2;
constexpr int kNoDisplay = 3;

struct Options {
    std::string scene = "Pyramid";
    std::string file;
    std::string tour;
    std::size_t stop = 1;
    unsigned steps = 120;
    std::string picture;
    std::size_t frames = 0;
    std::size_t bodies = 0;
    bool list = false;
};

/// The index of a scene or a tour.
template <typename Item>
std::optional<std::size_t> named(std::span<const Item> all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &Item::name);
    return found != all.end() ? std::optional(static_cast<std::size_t>(found - all.begin()))
                              : std::nullopt;
}

void list() {
    for (const Tour& tour : tours()) {
        std::printf("%-22s %-32s %s\n", "Guided tour", std::string(tour.name).c_str(),
                    std::string(tour.lesson).c_str());
    }
    for (const Scene& scene : catalogue()) {
        std::printf("%-22s %-32s %s\n", std::string(scene.group).c_str(),
                    std::string(scene.name).c_str(), std::string(scene.question).c_str());
    }
}

/// Two frames: the first one tells the panels how large their content is.
void frame(ImGuiHost& host, Panel& panel, Workbench& bench, kodo_sfml::Size pixels, float seconds) {
    host.begin(pixels, seconds);
    panel.build(bench, pixels);
}

int takePicture(Workbench& bench, const Options& options) {
    for (unsigned step = 0; step < options.steps; ++step) {
        bench.stepOnce();
    }
    std::unique_ptr<ImGuiHost> host;
    Panel panel;
    kodo_sfml::Painter painter;
    bench.setView(kPixels, {230, 0, 740, 624});
    bench.showScene();
    bench.draw(painter);
    const bool written =
        kodo_sfml::savePicture(painter, kPixels, kBackground, options.picture, [&] {
            host = std::make_unique<ImGuiHost>(DESTRUCTOOOOR_FONT);
            frame(*host, panel, bench, kPixels, 0.1f);
            host->draw();
            frame(*host, panel, bench, kPixels, 0.1f);
            host->draw();
            host.reset();
        });
    if (!written) {
        std::fprintf(stderr, "destructoooor: The picture cannot be written to %s.\n",
                     options.picture.c_str());
        return kRefused;
    }
    return kDone;
}

int play(Workbench& bench) {
    using Clock = std::chrono::steady_clock;
    kodo_sfml::Window window("Destructoooor!", kPixels);
    kodo_sfml::Painter painter;
    ImGuiHost host(DESTRUCTOOOOR_FONT);
    Panel panel;
    auto last = Clock::now();
    bool first = true;
    while (!bench.quit) {
        while (const auto event = window.nextEvent()) {
            host.take(*event);
            const bool mouse = event->type == sf::Event::MouseButtonPressed ||
                               event->type == sf::Event::MouseWheelScrolled;
            const bool keys = event->type == sf::Event::KeyPressed;
            if (event->type == sf::Event::Closed) {
                bench.quit = true;
            } else if (!(mouse && host.wantsMouse()) && !(keys && host.wantsKeys())) {
                bench.take(*event);
            }
        }
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last).count();
        last = now;
        bench.advance(seconds);
        frame(host, panel, bench, window.size(), static_cast<float>(seconds));
        if (std::exchange(first, false)) {
            bench.showScene();
        }
        painter.clear();
        bench.draw(painter);
        window.show(painter, kBackground, [&] { host.draw(); });
    }
    return kDone;
}

int refuse(const std::string& problem) {
    std::fprintf(stderr, "destructoooor: %s. --list prints all of them.\n", problem.c_str());
    return kRefused;
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Destructoooor!: a sandbox of Kodo. Scenes with a question each; bodies can be "
                 "thrown, cut, welded and tied, and every parameter changed while it runs.",
                 "destructoooor");
    app.footer("The window tells the keys, in the tab 'View'.\n"
               "Exit code: 0 done, 2 wrong use, 3 no display.");
    app.set_version_flag("--version", "Kodo " + std::to_string(KODO_VERSION_MAJOR) + '.' +
                                          std::to_string(KODO_VERSION_MINOR) + '.' +
                                          std::to_string(KODO_VERSION_PATCH));
    auto* file = app.add_option("FILE", options.file, "A scene file (.toml) or a saved World");
    app.add_option("--scene", options.scene, "Name of a scene, see --list")
        ->capture_default_str()
        ->excludes(file);
    auto* ofTour = app.add_option("--tour", options.tour, "Name of a guided tour, see --list");
    app.add_option("--stop", options.stop, "Stop of the tour")
        ->capture_default_str()
        ->needs(ofTour);
    app.add_flag("--list", options.list, "Print all tours and scenes, then exit");
    auto* picture = app.add_option("--picture", options.picture,
                                   "Write a picture (png) after some steps, then exit");
    app.add_option("--steps", options.steps, "Steps before the picture, 60 per second")
        ->capture_default_str()
        ->needs(picture);
    auto* frames = app.add_option("--frames", options.frames,
                                  "Draw so many frames as fast as possible, print their times, "
                                  "then exit");
    frames->check(CLI::Range(1u, 100000u))->excludes(picture);
    app.add_option("--bodies", options.bodies,
                   "Of a pile of so many bodies, awake and asleep, instead of a scene")
        ->check(CLI::Range(1u, 100000u))
        ->excludes(file)
        ->needs(frames);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        std::fprintf(stderr, "destructoooor: %s. Try destructoooor --help.\n", error.what());
        return kRefused;
    }
    if (options.list) {
        list();
        return kDone;
    }
    const std::optional<std::size_t> scene = named(catalogue(), options.scene);
    if (!scene) {
        return refuse("There is no scene '" + options.scene + "'");
    }
    const std::optional<std::size_t> tour = named(tours(), options.tour);
    if (!tour && !options.tour.empty()) {
        return refuse("There is no tour '" + options.tour + "'");
    }
    if (tour && (options.stop < 1 || options.stop > tours()[*tour].stops.size())) {
        return refuse("That tour has " + std::to_string(tours()[*tour].stops.size()) + " stops");
    }
    if (!kodo_sfml::displayAvailable()) {
        std::fprintf(stderr, "destructoooor: There is no display for the window. Set DISPLAY.\n");
        return kNoDisplay;
    }
    Workbench bench;
    tour ? bench.visit(*tour, options.stop - 1) : bench.open(*scene);
    if (!options.file.empty()) {
        bench.sandbox.load(options.file); // throws a sentence
        bench.showScene();
    }
    if (options.frames > 0) {
        measureFrames(bench, options.frames, options.bodies, DESTRUCTOOOOR_FONT);
        return kDone;
    }
    return options.picture.empty() ? play(bench) : takePicture(bench, options);
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
