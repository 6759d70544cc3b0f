// SPDX-License-Identifier: MIT
#include "panel.hpp"

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <imgui.h>
#include <stdexcept>
#include <string>

#include "dials.hpp"

namespace destructoooor {

namespace {

// Pixels.
constexpr float kLeft = 230;
constexpr float kRight = 310;
constexpr float kBottom = 96;
constexpr float kPlotHeight = 46;
constexpr float kAboutHeight = 190;
constexpr float kStopHeight = 290;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

void place(float x, float y, float width, float height) {
    ImGui::SetNextWindowPos({x, y});
    ImGui::SetNextWindowSize({width, height});
}

void words(std::string_view text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

void hint(std::string_view text) {
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%.*s", static_cast<int>(text.size()), text.data());
    }
}

/// A graph of one value of the samples, see valueOf(), with the last one.
void plot(const char* name, const char* unit, const std::vector<Sample>& samples,
          std::size_t which) {
    static std::vector<float> values;
    values.clear();
    for (const Sample& sample : samples) {
        values.push_back(valueOf(sample, which));
    }
    const float last = values.empty() ? 0 : values.back();
    ImGui::Text("%s  %.4g %s", name, static_cast<double>(last), unit);
    const auto [low, high] = std::ranges::minmax_element(values);
    const float top = values.empty() ? 1 : *high;
    ImGui::PushID(name);
    ImGui::PlotLines("", values.data(), static_cast<int>(values.size()), 0, nullptr,
                     values.empty() ? 0 : std::min(0.0f, *low), top > 0 ? 1.05f * top : 1,
                     {-1, kPlotHeight});
    ImGui::PopID();
}

/// One button for each profile; the one that was pressed.
const Profile* profileButtons(const char* purpose) {
    const Profile* chosen = nullptr;
    ImGui::PushID(purpose);
    for (const Profile& profile : profiles()) {
        const std::string name(profile.name);
        if (&profile != profiles().data()) {
            ImGui::SameLine(0, 6);
        }
        chosen = ImGui::SmallButton(name.c_str()) ? &profile : chosen;
    }
    ImGui::PopID();
    return chosen;
}

bool dial(const Dial& one, Workbench& bench) {
    const double before = one.value(bench.sandbox);
    const std::string name(one.name);
    if (one.words.size() == 2 && one.words[0] == "off") {
        bool on = before > 0;
        if (!ImGui::Checkbox(name.c_str(), &on)) {
            return false;
        }
        one.set(bench.sandbox, on ? 1 : 0);
        return true;
    }
    if (!one.words.empty()) {
        bool changed = false;
        for (std::size_t i = 0; i < one.words.size(); ++i) {
            const std::string word(one.words[i]);
            if (i > 0) {
                ImGui::SameLine();
            }
            if (ImGui::RadioButton(word.c_str(), before == static_cast<double>(i))) {
                one.set(bench.sandbox, static_cast<double>(i));
                changed = true;
            }
        }
        return changed;
    }
    auto value = static_cast<float>(before);
    ImGui::SetNextItemWidth(150);
    const bool worded = !one.lowest.empty() && before <= one.low;
    const char* const format = worded ? one.lowest.data() : one.stride < 1 ? "%.2f" : "%.0f";
    const bool moved = ImGui::SliderFloat(name.c_str(), &value, static_cast<float>(one.low),
                                          static_cast<float>(one.high), format);
    const double wanted = snapped(one, static_cast<double>(value));
    if (!moved || wanted == before) {
        return false;
    }
    one.set(bench.sandbox, wanted);
    return true;
}

/// Where the tour is, and the ways from there.
void stopButtons(Workbench& bench) {
    const Sandbox::Place place = *bench.sandbox.place();
    const Tour& tour = tours()[place.tour];
    words(tour.name);
    ImGui::TextDisabled("Stop %zu of %zu", place.stop + 1, tour.stops.size());
    if (ImGui::Button("Back")) {
        bench.go(-1);
    }
    ImGui::SameLine();
    if (ImGui::Button("Next")) {
        bench.go(1);
    }
    ImGui::SameLine();
    if (ImGui::Button("Leave")) {
        bench.open(bench.sandbox.sceneIndex());
    }
}

} // namespace

void Panel::build(Workbench& bench, kodo_sfml::Size pixels) {
    const auto width = static_cast<float>(pixels.x);
    const auto height = static_cast<float>(pixels.y);
    const kodo_sfml::Rect free{kLeft, 0, std::max(width - kLeft - kRight, 100.0f),
                               std::max(height - kBottom, 100.0f)};
    bench.setView(pixels, free);
    place(0, 0, kLeft, height);
    if (ImGui::Begin("scenes", nullptr, kFixed)) {
        scenes(bench);
    }
    ImGui::End();
    place(width - kRight, 0, kRight, height);
    if (ImGui::Begin("right", nullptr, kFixed) && ImGui::BeginTabBar("tabs")) {
        const auto tab = [](const char* name, auto content) {
            if (ImGui::BeginTabItem(name)) {
                content();
                ImGui::EndTabItem();
            }
        };
        tab("Dials", [&] { dialTab(bench); });
        tab("Measures", [&] { measureTab(bench); });
        tab("View", [&] { viewTab(bench); });
        tab("File", [&] { fileTab(bench); });
        ImGui::EndTabBar();
    }
    ImGui::End();
    place(kLeft, height - kBottom, width - kLeft - kRight, kBottom);
    if (ImGui::Begin("time", nullptr, kFixed)) {
        timeBar(bench);
    }
    ImGui::End();
}

void Panel::scenes(Workbench& bench) {
    ImGui::BeginChild("list", {0, bench.sandbox.stop() != nullptr ? -kStopHeight : -kAboutHeight});
    if (ImGui::CollapsingHeader("Guided tours", ImGuiTreeNodeFlags_DefaultOpen)) {
        const std::span<const Tour> all = tours();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::optional<Sandbox::Place> place = bench.sandbox.place();
            if (ImGui::Selectable(std::string(all[i].name).c_str(), place && place->tour == i)) {
                bench.visit(i, 0);
            }
            hint(all[i].lesson);
        }
    }
    sceneList(bench);
    ImGui::EndChild();
    ImGui::Separator();
    about(bench);
}

void Panel::sceneList(Workbench& bench) {
    const Scene& present = bench.sandbox.scene();
    const std::span<const Scene> all = catalogue();
    const bool touring = bench.sandbox.stop() != nullptr;
    const bool arrived = !touring && shown_ != bench.sandbox.sceneIndex();
    shown_ = bench.sandbox.sceneIndex();
    for (std::size_t i = 0; i < all.size();) {
        const std::string group(all[i].group);
        if (arrived && group == present.group) {
            ImGui::SetNextItemOpen(true);
        }
        const bool open = ImGui::CollapsingHeader(group.c_str());
        for (; i < all.size() && all[i].group == group; ++i) {
            const std::string name(all[i].name);
            const bool chosen =
                !touring && !bench.sandbox.isLoaded() && i == bench.sandbox.sceneIndex();
            if (open && ImGui::Selectable(name.c_str(), chosen)) {
                bench.open(i);
            }
            if (open && chosen && arrived) {
                ImGui::SetScrollHereY();
            }
        }
    }
}

/// What the scene or the stop of a tour is about, and whether it is as expected.
void Panel::about(Workbench& bench) {
    if (bench.sandbox.stop() != nullptr) {
        stopButtons(bench);
    }
    if (bench.sandbox.isLoaded()) {
        words(bench.sandbox.fileTitle().empty() ? "A World that was saved."
                                                : bench.sandbox.fileTitle());
        return;
    }
    const Stop* const stop = bench.sandbox.stop();
    words(stop != nullptr ? stop->text : bench.sandbox.scene().question);
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, {0.65f, 0.75f, 0.85f, 1});
    words(stop != nullptr ? "Look at: " + std::string(stop->look)
                          : std::string(bench.sandbox.scene().expectation));
    ImGui::PopStyleColor();
    if (stop != nullptr) {
        const Sample last = bench.sandbox.measures().last();
        ImGui::Text("Deepest overlap %.1f mm,\n%.0f visits of contacts",
                    static_cast<double>(last.overlap), static_cast<double>(last.visits));
    }
    if (const std::optional<bool> verdict = bench.sandbox.verdict()) {
        ImGui::TextColored(*verdict ? ImVec4{0.5f, 0.9f, 0.5f, 1} : ImVec4{1, 0.5f, 0.4f, 1},
                           *verdict ? "As expected." : "Not as expected.");
    } else {
        ImGui::TextDisabled("Judged after %.1f s, if untouched.",
                            static_cast<double>(bench.sandbox.judgedAfter()));
    }
}

void Panel::dialTab(Workbench& bench) {
    if (const Profile* const chosen = profileButtons("settings")) {
        bench.sandbox.setSettings(chosen->settings);
    }
    std::string_view group;
    for (const Dial& one : dials()) {
        if (!one.shown(bench.sandbox)) {
            continue;
        }
        if (group != one.group) {
            group = one.group;
            ImGui::Separator();
        }
        try {
            dial(one, bench);
        } catch (const kodo::BadDefinition& error) {
            bench.message = error.what();
        }
        hint(std::string(one.what) + (one.price.empty() ? "" : "\n") + std::string(one.price));
    }
    ImGui::Separator();
    if (ImGui::Button("Reset")) {
        bench.restart();
    }
    hint("The scene and all dials as they were.");
    ImGui::SameLine();
    if (ImGui::Button("Copy as code")) {
        ImGui::SetClipboardText(codeOf(bench.sandbox.settings()).c_str());
        bench.message = "The settings are in the clipboard.";
    }
    ImGui::Separator();
    ImGui::TextUnformatted("Beside it, from here on:");
    if (const Profile* const chosen = profileButtons("beside")) {
        bench.sandbox.compareWith(chosen->settings);
    }
    if (bench.sandbox.twin() != nullptr) {
        ImGui::TextColored({1, 0.5f, 0.5f, 1}, "Red outlines: apart by %.4g m",
                           static_cast<double>(bench.sandbox.difference()));
        if (ImGui::SmallButton("Stop comparing")) {
            bench.sandbox.stopComparing();
        }
    }
}

void Panel::measureTab(const Workbench& bench) {
    const std::vector<Sample>& samples = bench.sandbox.measures().samples();
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
        plot(kMeasures[i].name.data(), kMeasures[i].unit.data(), samples, i);
    }
    ImGui::Separator();
    for (std::size_t i = 0; i < kodo::kStepStageNames.size(); ++i) {
        plot(kodo::kStepStageNames[i].data(), "us", samples, kMeasures.size() + i);
    }
}

void Panel::viewTab(Workbench& bench) {
    ImGui::Checkbox("Shapes", &bench.look.shapes);
    ImGui::Checkbox("Joints", &bench.look.joints);
    ImGui::Checkbox("Contacts", &bench.look.contacts);
    ImGui::Checkbox("Impulses", &bench.look.impulses);
    ImGui::Checkbox("Bounds", &bench.look.bounds);
    ImGui::Checkbox("Velocities", &bench.look.velocities);
    ImGui::Checkbox("Centres of mass", &bench.look.centers);
    ImGui::Checkbox("Colours of islands", &bench.look.islands);
    if (ImGui::Button("Whole scene (Home)")) {
        bench.showScene();
    }
    ImGui::Separator();
    words("Right button: move the view. Wheel: closer, farther.\n"
          "Space: pause. N: one step. B: one step back. R: restart.\n"
          "1 to 9, 0, E: the hands below, from left to right. Tab: through the dials.\n"
          "Page up, page down: another scene or stop. Escape: quit.");
}

void Panel::fileTab(Workbench& bench) {
    words("NAME.toml: a scene file, to be read and written by hand, and played beside Box2D by "
          "tools/sidebyside NAME.toml. Another name: all bytes of the World.");
    ImGui::InputText("File", file_, sizeof file_);
    if (ImGui::Button("Save scene")) {
        bench.save(file_);
    }
    ImGui::SameLine();
    if (ImGui::Button("Load scene")) {
        bench.load(file_);
    }
}

void Panel::timeBar(Workbench& bench) {
    if (ImGui::Button(bench.paused ? "Play" : "Pause", {64, 0})) {
        bench.paused = !bench.paused;
    }
    ImGui::SameLine();
    if (ImGui::Button("Step")) {
        bench.paused = true;
        bench.stepOnce();
    }
    ImGui::SameLine();
    if (ImGui::Button("Restart")) {
        bench.restart();
    }
    ImGui::SameLine();
    Sandbox& sandbox = bench.sandbox;
    auto tick = static_cast<int>(sandbox.tick());
    char text[48];
    std::snprintf(text, sizeof text, "%.2f s", static_cast<double>(tick) / 60);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderInt("##time", &tick, static_cast<int>(sandbox.firstTick()),
                         static_cast<int>(sandbox.lastTick()), text)) {
        bench.paused = true;
        sandbox.rewind(static_cast<std::uint64_t>(std::max(tick, 0)));
    }
    hint("Drag: back and forth in time. A step from there begins another branch.");
    for (std::size_t i = 0; i < kHands.size(); ++i) {
        const std::string name(kHands[i].name);
        const bool chosen = i == static_cast<std::size_t>(bench.hand);
        if (i > 0) {
            ImGui::SameLine(0, 4);
        }
        if (chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, {0.26f, 0.59f, 0.98f, 0.9f});
        }
        if (ImGui::SmallButton(name.c_str())) {
            bench.hand = static_cast<Hand>(i);
        }
        hint(kHands[i].what);
        if (chosen) {
            ImGui::PopStyleColor();
        }
    }
    if (!bench.message.empty()) {
        ImGui::TextColored({1, 0.8f, 0.4f, 1}, "%s", bench.message.c_str());
    } else if (bench.hand == Hand::Drop) {
        for (std::size_t i = 0; i < kThingNames.size(); ++i) {
            const std::string name(kThingNames[i]);
            if (i > 0) {
                ImGui::SameLine();
            }
            if (ImGui::RadioButton(name.c_str(),
                                   i == static_cast<std::size_t>(bench.dropped.thing))) {
                bench.dropped.thing = static_cast<Thing>(i);
            }
        }
    } else {
        words(kHands[static_cast<std::size_t>(bench.hand)].what);
    }
}

} // namespace destructoooor
