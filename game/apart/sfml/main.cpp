// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/text_file.hpp>
#include <apart/core/tuning.hpp>
#include <apart/sfml/film.hpp>
#include <apart/sfml/frame_times.hpp>
#include <apart/sfml/inspector.hpp>
#include <apart/sfml/interruption.hpp>
#include <apart/sfml/options.hpp>
#include <apart/sfml/sfml_canvas.hpp>
#include <apart/sfml/sfml_controls.hpp>
#include <apart/sfml/sfml_speaker.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/stage.hpp>
#include <kodo_sfml/display.hpp>
#include <kodo_sfml/window.hpp>

#include <SFML/Window/Clipboard.hpp>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <stdexcept>

namespace apart {
namespace {

const kodo_draw::Size kPixels{layout::kWindowWidth, layout::kWindowHeight};

constexpr kodo_draw::Rgba kBlack{0, 0, 0};

void complain(const std::string& sentence) {
    std::fprintf(stderr, "apart: %s\n", printable(sentence).c_str());
}

/// The file of a picture: of several, its number stands before the extension.
std::string pathOf(const Options& options, std::uint32_t shot) {
    if (options.shots == 1) {
        return options.screenshot;
    }
    std::filesystem::path path = options.screenshot;
    std::string number = std::to_string(10000 + shot).substr(1);
    path.replace_filename(path.stem().string() + number + path.extension().string());
    return path.string();
}

int takePicture(StageDef def, const Options& options) {
    Stage stage(std::move(def));
    SilentSpeaker silence;
    for (std::uint32_t tick = 0; tick < options.at; ++tick) {
        stage.advance(1.0 / kTicksPerSecond, {}, silence);
    }
    SfmlCanvas canvas(assetsFolder() / "fonts", kPixels);
    for (std::uint32_t shot = 0; shot < options.shots; ++shot) {
        const std::string path = pathOf(options, shot);
        stage.draw(canvas);
        if (!kodo_sfml::savePicture(canvas.picture(), kPixels, kBlack, path)) {
            complain("The picture cannot be written to " + path + ".");
            return kRefused;
        }
        for (std::uint32_t tick = 0; tick < options.every; ++tick) {
            stage.advance(1.0 / kTicksPerSecond, {}, silence);
        }
    }
    return kDone;
}

double secondsBetween(std::chrono::steady_clock::time_point from,
                      std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

/// A file that does not exist yet, beside the profile, or in the current folder without one.
std::string filmFile() {
    const std::optional<std::filesystem::path> profile = profileFile();
    const std::filesystem::path folder = profile ? profile->parent_path() : ".";
    std::filesystem::path path;
    std::error_code error;
    for (int i = 1; path.empty() || std::filesystem::exists(path, error); ++i) {
        path = folder / ("fall" + std::to_string(i) + ".gif");
    }
    return path.string();
}

int play(StageDef def, const Options& options) {
    using Clock = std::chrono::steady_clock;
    def.sharing.copy = [page = options.page](const std::string& text) {
        std::string whole = text;
        whole.insert(whole.find("#replay="), page);
        sf::Clipboard::setString(whole);
    };
    def.sharing.film = [](const Rerun& fall) {
        const std::string path = filmFile();
        const std::string problem = writeFilm(fall, path);
        return problem.empty() ? "The film is in " + path : problem;
    };
    Stage stage(std::move(def));
    kodo_sfml::Window window("aPart", kPixels);
    SfmlCanvas canvas(assetsFolder() / "fonts", window.size());
    SfmlControls controls(window, canvas);
    const std::unique_ptr<Speaker> speaker = makeSpeaker(options.mute);
    Inspector inspector;
    watchForInterruption();
    auto last = Clock::now();
    while (!stage.wantsToQuit()) {
        controls.setBindings(stage.records().profile().bindings);
        Signals signals = controls.poll();
        signals.closed = signals.closed || isInterrupted();
        const auto now = Clock::now();
        const double frame = secondsBetween(last, now);
        stage.advance(frame, signals, *speaker);
        inspector.measure(frame, secondsBetween(now, Clock::now()));
        last = now;
        if (controls.takeInspect()) {
            inspector.toggle();
        }
        if (controls.takeFullScreen()) {
            window.toggleFullScreen();
            window.setPointerVisible(stage.wantsPointer());
        }
        canvas.setSize(window.size());
        stage.draw(canvas);
        if (stage.screen() != Screen::Duel) { // its fields are smaller
            inspector.draw(canvas, shownBy(stage));
        }
        controls.capture(!stage.wantsPointer());
        window.show(canvas.picture(), kBlack);
    }
    window.close();
    return kDone;
}

/// Times the frames of a 60 Hz screen, without waiting for the screen.
int timeFrames(StageDef def, const Options& options) {
    using Clock = std::chrono::steady_clock;
    Stage stage(std::move(def));
    kodo_sfml::Window window("aPart", kPixels);
    window.setPaced(false);
    SfmlCanvas canvas(assetsFolder() / "fonts", window.size());
    SilentSpeaker silence;
    FrameTimes times;
    for (std::uint32_t i = 0; i < options.frames; ++i) {
        while (window.nextEvent()) {
        }
        const std::clock_t busy = std::clock();
        const auto start = Clock::now();
        stage.advance(1.0 / 60, {}, silence);
        const auto played = Clock::now();
        stage.draw(canvas);
        const auto drawn = Clock::now();
        window.show(canvas.picture(), kBlack);
        if (const std::size_t bodies = stage.session().game().world().bodyCount();
            bodies >= options.crowd) {
            times.add({secondsBetween(start, played), secondsBetween(played, drawn),
                       secondsBetween(drawn, Clock::now()),
                       static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC},
                      bodies);
        }
    }
    std::printf("%s\n", times.text().c_str());
    return kDone;
}

int run(const Options& options) {
    const bool display = kodo_sfml::displayAvailable();
    if (options.probeDisplay) {
        return display ? kDone : kNoDisplay;
    }
    StartOptions start = options;
    start.picture = !options.screenshot.empty() || options.frames > 0;
    auto def = setUp(start);
    if (const auto* problem = std::get_if<std::string>(&def)) {
        complain(*problem);
        return kRefused;
    }
    if (!display) {
        complain("There is no display to open a window on. Set DISPLAY, or play without a window: "
                 "apart-headless bot.");
        return kNoDisplay;
    }
    if (!options.film.empty()) {
        const std::string problem = filmReplay(options.replay, options.film, ownLevels());
        if (!problem.empty()) {
            complain(problem);
        }
        return problem.empty() ? kDone : kRefused;
    }
    StageDef stage = std::get<StageDef>(std::move(def));
    for (const auto* sentences : {&stage.leftOut, &stage.notices}) {
        for (const std::string& sentence : *sentences) {
            complain(sentence);
        }
    }
    if (options.frames > 0) {
        return timeFrames(std::move(stage), options);
    }
    return options.screenshot.empty() ? play(std::move(stage), options)
                                      : takePicture(std::move(stage), options);
}

} // namespace
} // namespace apart

int main(int argc, char** argv) {
    try {
        const auto options = apart::parseOptions(argc, argv);
        if (const int* code = std::get_if<int>(&options)) {
            if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
                throw std::runtime_error("the output could not be written to its end");
            }
            return *code;
        }
        return apart::run(std::get<apart::Options>(options));
    } catch (const std::exception& error) {
        apart::complain(error.what());
        return apart::kRefused;
    }
}
