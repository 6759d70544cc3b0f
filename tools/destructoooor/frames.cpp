// SPDX-License-Identifier: MIT
#include "frames.hpp"

#include <kodo_sfml/display.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>

#include "catalogue/parts.hpp"
#include "imgui_host.hpp"
#include "panel.hpp"

namespace destructoooor {

namespace {

constexpr int kSettling = 900;    // steps until a pile lies
constexpr int kLongest = 3600;    // steps until it sleeps
constexpr std::size_t kWarm = 30; // frames that are not counted

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Everything that a frame needs.
class Screen {
public:
    explicit Screen(const std::string& font) : host_(font) { window_.setPaced(false); }

    FrameTime frame(Workbench& bench) {
        while (const auto event = window_.nextEvent()) {
            host_.take(*event);
        }
        FrameTime time;
        const std::clock_t before = std::clock();
        const double start = now();
        bench.stepOnce();
        const double stepped = now();
        painter_.clear();
        bench.draw(painter_);
        const double drawn = now();
        host_.begin(window_.size(), static_cast<float>(kStepSeconds));
        panel_.build(bench, window_.size());
        const double built = now();
        window_.show(painter_, kBackground, [&] { host_.draw(); });
        time.screen = now() - built;
        time.step = stepped - start;
        time.picture = drawn - stepped;
        time.panels = built - drawn;
        time.processors = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
        return time;
    }

    void measure(Workbench& bench, std::size_t count, const char* what) {
        for (std::size_t i = 0; i < kWarm; ++i) {
            frame(bench);
            if (i == 0) {
                bench.showScene(); // beside the panels
            }
        }
        std::vector<FrameTime> frames;
        for (std::size_t i = 0; i < count; ++i) {
            frames.push_back(frame(bench));
        }
        const kodo::World& world = bench.sandbox.world();
        std::printf("%s: %zu bodies, %.0f awake, %zu triangles, %u x %u pixels, %s\n%s", what,
                    world.bodyCount(), static_cast<double>(bench.sandbox.measures().last().awake),
                    painter_.vertexCount() / 3, window_.size().x, window_.size().y,
                    kodo_sfml::softwareRendering() ? "drawn in software" : "a graphics card",
                    textOf(frames).c_str());
        std::fflush(stdout);
    }

private:
    kodo_sfml::Window window_{"Destructoooor!", kPixels};
    kodo_sfml::Painter painter_;
    ImGuiHost host_;
    Panel panel_;
};

/// The World as it is, asleep or not; `sleep` says whether bodies may.
void letSleep(Workbench& bench, bool sleep) {
    kodo::StepSettings settings = bench.sandbox.settings();
    settings.leaveOut = sleep ? kodo::Features{} : kodo::Features{kodo::Feature::Sleep};
    bench.sandbox.setSettings(settings);
}

} // namespace

std::string textOf(const std::vector<FrameTime>& frames) {
    if (frames.empty()) {
        return "no frames\n";
    }
    const auto sorted = [&](auto part) {
        std::vector<double> times; // ms
        for (const FrameTime& frame : frames) {
            times.push_back(1000 * std::invoke(part, frame));
        }
        std::ranges::sort(times);
        return times;
    };
    const auto at = [](const std::vector<double>& times, double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    char text[160];
    const auto median = [&](auto part) { return at(sorted(part), 0.5); };
    std::snprintf(text, sizeof text,
                  "  %zu frames, medians: step %.2f ms, picture %.2f, panels %.2f, screen %.2f; "
                  "%.2f of processor time\n",
                  frames.size(), median(&FrameTime::step), median(&FrameTime::picture),
                  median(&FrameTime::panels), median(&FrameTime::screen),
                  median(&FrameTime::processors));
    std::string all = text;
    const auto percentiles = [&](const char* what, auto part) {
        const std::vector<double> times = sorted(part);
        std::snprintf(text, sizeof text,
                      "  %s: median %.2f ms, 95 %% within %.2f, 99 %% within %.2f, longest %.2f\n",
                      what, at(times, 0.5), at(times, 0.95), at(times, 0.99), times.back());
        all += text;
    };
    percentiles("without the screen", &FrameTime::own);
    percentiles("with it", &FrameTime::total);
    return all;
}

kodo::World pileOf(std::size_t bodies) {
    constexpr std::size_t kAcross = 50;
    kodo::World world({.gravity = {0, -10}, .settings = kodo::balanced()});
    const std::size_t rows = (bodies + kAcross - 1) / kAcross;
    addRoom(world, 62, 2 + 1.3_r * Real(rows));
    addMixed(world, bodies, kAcross);
    return world;
}

void measureFrames(Workbench& bench, std::size_t frames, std::size_t bodies,
                   const std::string& font) {
    Screen screen(font);
    if (bodies == 0) {
        return screen.measure(bench, frames, "As it is");
    }
    bench.sandbox.take(kodo::toBytes(pileOf(bodies)));
    letSleep(bench, false);
    for (int i = 0; i < kSettling; ++i) {
        bench.stepOnce();
    }
    screen.measure(bench, frames, "Awake");
    letSleep(bench, true);
    for (int i = 0; i < kLongest && bench.sandbox.measures().last().awake > 0; ++i) {
        bench.stepOnce();
    }
    screen.measure(bench, frames, "Asleep");
}

} // namespace destructoooor
