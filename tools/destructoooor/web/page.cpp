// SPDX-License-Identifier: MIT
// The sandbox for a page: functions that sandbox.js calls. Texts and figures stay valid until the
// next call.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "dials.hpp"
#include "hand_use.hpp"

#define SANDBOX_EXPORT __attribute__((used, visibility("default")))

namespace destructoooor {
namespace {

/// Figures as numbers: a kind, the two colours as bytes, the width of lines (pixels), how many
/// numbers or letters follow, and these. Points are in the world (m).
class Figures final : public kodo::DebugDraw {
public:
    enum Kind : std::uint8_t { Line, Polygon, Circle, Text };

    Figures(const kodo::Aabb& view, Real pixel) : view_(view), pixel_(pixel) {}

    kodo::Aabb view() const override { return view_; }
    Real pixel() const override { return pixel_; }
    void line(Vec2 from, Vec2 to, const kodo::DrawStyle& style) override {
        figure(Line, style, 4);
        add(from);
        add(to);
    }
    void circle(Vec2 center, Real radius, const kodo::DrawStyle& style) override {
        figure(Circle, style, 3);
        add(center);
        numbers_.push_back(radius);
    }
    void polygon(std::span<const Vec2> corners, const kodo::DrawStyle& style) override {
        figure(Polygon, style, 2 * corners.size());
        for (const Vec2 corner : corners) {
            add(corner);
        }
    }
    void text(Vec2 middle, std::string_view utf8, const kodo::DrawStyle& style) override {
        figure(Text, style, 2 + utf8.size());
        add(middle);
        for (const char letter : utf8) { // figures of an id: ASCII
            numbers_.push_back(static_cast<float>(letter));
        }
    }

    std::vector<float> take() { return std::move(numbers_); }

private:
    void figure(Kind kind, const kodo::DrawStyle& style, std::size_t count) {
        numbers_.push_back(kind);
        numbers_.push_back(packed(style.line));
        numbers_.push_back(packed(style.fill));
        numbers_.push_back(style.width);
        numbers_.push_back(static_cast<float>(count));
    }
    void add(Vec2 point) { numbers_.insert(numbers_.end(), {point.x, point.y}); }
    static float packed(kodo::DrawColor color) {
        float number = 0;
        std::memcpy(&number, &color, sizeof number);
        return number;
    }

    kodo::Aabb view_;
    Real pixel_;
    std::vector<float> numbers_;
};

std::string quoted(std::string_view text) {
    std::string made = "\"";
    for (const char letter : text) {
        made += letter == '"' || letter == '\\' ? "\\" : "";
        made += letter;
    }
    return made + "\"";
}

/// A list of JSON of what `write` makes of each item.
template <typename List, typename Write>
std::string listed(const List& items, Write write) {
    std::string made = "[";
    for (const auto& item : items) {
        made += (made.size() > 1 ? "," : "") + write(item);
    }
    return made + "]";
}

std::string sceneText(const Scene& scene) {
    const auto number = [](Real value) { return std::to_string(value); };
    return "{\"group\":" + quoted(scene.group) + ",\"name\":" + quoted(scene.name) +
           ",\"question\":" + quoted(scene.question) +
           ",\"expectation\":" + quoted(scene.expectation) +
           ",\"seconds\":" + number(scene.seconds) + ",\"view\":[" + number(scene.view.lower.x) +
           "," + number(scene.view.lower.y) + "," + number(scene.view.upper.x) + "," +
           number(scene.view.upper.y) + "]}";
}

std::string dialText(const Dial& dial) {
    return "{\"group\":" + quoted(dial.group) + ",\"name\":" + quoted(dial.name) +
           ",\"what\":" + quoted(dial.what) + ",\"price\":" + quoted(dial.price) +
           ",\"low\":" + std::to_string(dial.low) + ",\"high\":" + std::to_string(dial.high) +
           ",\"stride\":" + std::to_string(dial.stride) + ",\"lowest\":" + quoted(dial.lowest) +
           ",\"words\":" + listed(dial.words, quoted) + "}";
}

std::string stopText(const Stop& stop) {
    return "{\"scene\":" + quoted(stop.scene) + ",\"text\":" + quoted(stop.text) +
           ",\"look\":" + quoted(stop.look) + ",\"seconds\":" + std::to_string(stop.seconds) + "}";
}

std::string tourText(const Tour& tour) {
    return "{\"name\":" + quoted(tour.name) + ",\"lesson\":" + quoted(tour.lesson) +
           ",\"stops\":" + listed(tour.stops, stopText) + "}";
}

std::string registryText() {
    const auto named = [](const auto& item) { return quoted(item.name); };
    const auto hand = [](const HandWords& one) {
        return "{\"name\":" + quoted(one.name) + ",\"what\":" + quoted(one.what) + "}";
    };
    const auto measure = [](const Measure& one) {
        return "{\"name\":" + quoted(one.name) + ",\"unit\":" + quoted(one.unit) + "}";
    };
    return "{\"scenes\":" + listed(catalogue(), sceneText) +
           ",\"measures\":" + listed(kMeasures, measure) +
           ",\"stages\":" + listed(kodo::kStepStageNames, quoted) +
           ",\"tours\":" + listed(tours(), tourText) + ",\"dials\":" + listed(dials(), dialText) +
           ",\"profiles\":" + listed(profiles(), named) + ",\"hands\":" + listed(kHands, hand) +
           ",\"things\":" + listed(kThingNames, quoted) + "}";
}

Sandbox& sandbox() {
    static Sandbox one;
    return one;
}

constexpr std::size_t kMostBytes = 64'000'000; // of a World from outside

std::string text;             // the last one given to the page
std::vector<float> figures;   // of the last picture
std::vector<std::byte> bytes; // of a World
Stroke stroke;                // of the pointer
kodo::DrawOptions look{};
Dropped dropped;

/// What the work says, or the sentence of its exception.
template <typename Work>
const char* told(Work work) {
    text.clear();
    try {
        work();
    } catch (const std::exception& error) {
        text = error.what();
    }
    return text.c_str();
}

} // namespace
} // namespace destructoooor

using namespace destructoooor;

extern "C" {

SANDBOX_EXPORT const char* sandbox_registry() {
    text = registryText();
    return text.c_str();
}

SANDBOX_EXPORT void sandbox_open(std::size_t scene) {
    sandbox().open(scene);
}
SANDBOX_EXPORT void sandbox_visit(std::size_t tour, std::size_t stop) {
    sandbox().visit(tour, stop);
}
SANDBOX_EXPORT void sandbox_step() {
    sandbox().step();
}
SANDBOX_EXPORT double sandbox_tick() {
    return static_cast<double>(sandbox().tick());
}
SANDBOX_EXPORT double sandbox_firstTick() {
    return static_cast<double>(sandbox().firstTick());
}
SANDBOX_EXPORT double sandbox_lastTick() {
    return static_cast<double>(sandbox().lastTick());
}
SANDBOX_EXPORT void sandbox_rewind(double tick) {
    sandbox().rewind(static_cast<std::uint64_t>(tick));
}
/// -1: not yet.
SANDBOX_EXPORT int sandbox_verdict() {
    const std::optional<bool> verdict = sandbox().verdict();
    return verdict ? int{*verdict} : -1;
}
/// Lower and upper 32 bits of the state hash, for tests.
SANDBOX_EXPORT std::uint32_t sandbox_hash(int upper) {
    return static_cast<std::uint32_t>(sandbox().world().stateHash() >> (upper != 0 ? 32 : 0));
}
SANDBOX_EXPORT double sandbox_bodies() {
    return static_cast<double>(sandbox().world().bodyCount());
}

SANDBOX_EXPORT double sandbox_dial(std::size_t dial) {
    return dials()[dial].value(sandbox());
}
SANDBOX_EXPORT bool sandbox_dialShown(std::size_t dial) {
    return dials()[dial].shown(sandbox());
}
SANDBOX_EXPORT const char* sandbox_setDial(std::size_t dial, double value) {
    return told([&] { dials()[dial].set(sandbox(), snapped(dials()[dial], value)); });
}
SANDBOX_EXPORT const char* sandbox_setProfile(std::size_t profile) {
    return told([&] { sandbox().setSettings(profiles()[profile].settings); });
}
SANDBOX_EXPORT const char* sandbox_code() {
    return told([] { text = codeOf(sandbox().settings()); });
}
/// Which profile the settings are, of the World or of the second one: -1 none of them, -2 there is
/// no such World.
SANDBOX_EXPORT int sandbox_profile(bool second) {
    const kodo::World* const world = second ? sandbox().twin() : &sandbox().world();
    if (world == nullptr) {
        return -2;
    }
    const std::span<const Profile> all = profiles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Profile& profile) {
        return profile.settings == world->settings();
    });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}
/// Below 0: without a second World.
SANDBOX_EXPORT void sandbox_compare(int profile) {
    if (profile < 0) {
        sandbox().stopComparing();
    } else {
        sandbox().compareWith(profiles()[static_cast<std::size_t>(profile)].settings);
    }
}
SANDBOX_EXPORT double sandbox_difference() {
    return static_cast<double>(sandbox().difference());
}

/// The pointer at a point (m): 0 pressed, 1 moved, 2 released, 3 abandoned, so that its hand does
/// not act. Returns why a hand does nothing.
SANDBOX_EXPORT const char* sandbox_pointer(int phase, std::size_t hand, float x, float y) {
    return told([&] {
        const Vec2 at{x, y};
        switch (phase) {
        case 0:
            stroke.press(sandbox(), static_cast<Hand>(hand), at);
            break;
        case 1:
            stroke.move(sandbox(), at);
            break;
        case 2:
            text = stroke.release(sandbox(), dropped, at);
            break;
        default:
            stroke.abandon(sandbox());
            break;
        }
    });
}
SANDBOX_EXPORT void sandbox_setDropped(std::size_t thing, float size) {
    dropped = {static_cast<Thing>(thing), size};
}

/// Options in the order of the page: joints, contacts, impulses, bounds, velocities, centres,
/// labels, islands.
SANDBOX_EXPORT void sandbox_look(unsigned options) {
    const auto set = [&](unsigned bit) { return (options >> bit & 1u) != 0; };
    look.joints = set(0);
    look.contacts = set(1);
    look.impulses = set(2);
    look.bounds = set(3);
    look.velocities = set(4);
    look.centers = set(5);
    look.labels = set(6);
    look.islands = set(7);
}
/// Draws what a view (m) shows; returns how many numbers sandbox_figures() has.
SANDBOX_EXPORT std::size_t sandbox_draw(float left, float bottom, float right, float top,
                                        float pixel) {
    Figures picture({{left, bottom}, {right, top}}, pixel);
    drawScene(sandbox(), picture, look);
    const std::span<const Vec2> path = stroke.path();
    for (std::size_t i = 1; i < path.size(); ++i) {
        picture.line(path[i - 1], path[i], {.line = {255, 220, 90}});
    }
    figures = picture.take();
    return figures.size();
}
SANDBOX_EXPORT const float* sandbox_figures() {
    return figures.data();
}

/// Writes the World as bytes, and returns their number; sandbox_bytes() has them.
SANDBOX_EXPORT std::size_t sandbox_save() {
    bytes = kodo::toBytes(sandbox().world());
    return bytes.size();
}
/// Room for as many bytes of a World, for sandbox_take(). Returns why there is none, or "".
SANDBOX_EXPORT const char* sandbox_reserve(std::size_t size) {
    return told([&] {
        if (size > kMostBytes) {
            throw std::length_error("More than 64 MB are too many for this page.");
        }
        bytes.resize(size);
    });
}
SANDBOX_EXPORT std::byte* sandbox_bytes() {
    return bytes.data();
}
/// The World as a scene file.
SANDBOX_EXPORT const char* sandbox_text() {
    return told([] { text = sandbox().text(); });
}
SANDBOX_EXPORT const char* sandbox_notHeld() {
    return told([] { text = sandbox().notHeld(); });
}
/// Goes on with the scene file in sandbox_bytes(). Returns its mistakes, or "".
SANDBOX_EXPORT const char* sandbox_takeText() {
    return told([] {
        const std::string file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        sandbox().takeText(file, "the file");
    });
}
SANDBOX_EXPORT const char* sandbox_title() {
    return told([] { text = sandbox().fileTitle(); });
}
SANDBOX_EXPORT void sandbox_restart() {
    sandbox().restart();
}
/// Of what has been opened (m): 0 left, 1 bottom, 2 right, 3 top.
SANDBOX_EXPORT float sandbox_view(int side) {
    const kodo::Aabb view = sandbox().view();
    const float all[] = {view.lower.x, view.lower.y, view.upper.x, view.upper.y};
    return all[side];
}
SANDBOX_EXPORT const char* sandbox_take() {
    return told([] { sandbox().take(bytes); });
}

/// A value of the last step, see valueOf(). A time is the mean of the last second, since the clock
/// of a browser is coarse.
SANDBOX_EXPORT float sandbox_measure(std::size_t which) {
    const Measures& measures = sandbox().measures();
    const bool time = which >= kMeasures.size() || kMeasures[which].value == &Sample::step;
    const std::size_t steps = std::min<std::size_t>(measures.samples().size(), 60);
    if (!time || steps == 0) {
        return valueOf(measures.last(), which);
    }
    float sum = 0;
    for (const Sample& sample : std::span(measures.samples()).last(steps)) {
        sum += valueOf(sample, which);
    }
    return sum / static_cast<float>(steps);
}
/// The values of the steps before as well, the oldest one first: their number, and
/// sandbox_figures() has them.
SANDBOX_EXPORT std::size_t sandbox_history(std::size_t which) {
    figures.clear();
    for (const Sample& sample : sandbox().measures().samples()) {
        figures.push_back(valueOf(sample, which));
    }
    return figures.size();
}

} // extern "C"
