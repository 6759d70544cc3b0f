// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/assets.hpp>
#include <apart/core/medals.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "stage_rig.hpp"
#include "text_bounds.hpp"

/// Screens full of text, at each size of texts and in each window.
namespace apart {

inline constexpr std::array<int, 3> kSizes = {100, 120, 140}; // percent
inline constexpr std::array<Vec2, 3> kWindows = {Vec2{1280, 720}, Vec2{960, 720}, Vec2{1920, 1080}};

/// Texts of the picture that leave it or cover each other.
inline std::vector<std::string> crowdedTexts(const RecordingCanvas& canvas, Vec2 window) {
    const Real scale = window.x / canvas.visible().extent().x;
    std::vector<std::pair<const Stroke*, Aabb>> texts;
    for (const Stroke& stroke : canvas.strokes()) {
        if (!stroke.text.empty() && stroke.color.a > 0) {
            texts.emplace_back(&stroke, boundsOf(stroke, canvas, scale));
        }
    }
    std::vector<std::string> bad;
    for (std::size_t a = 0; a < texts.size(); ++a) {
        const auto& [stroke, box] = texts[a];
        if (!canvas.visible().contains(box)) {
            bad.push_back(stroke->text + " leaves the picture");
        }
        for (std::size_t b = 0; b < a; ++b) {
            const bool shadow = stroke->text == texts[b].first->text;
            if (!shadow && overlap(box.grown(Real(-0.01)), texts[b].second)) {
                bad.push_back(stroke->text + " | covers | " + texts[b].first->text);
            }
        }
    }
    return bad;
}

/// Each size and window in turn, under a sanitizer in one window.
template <typename Look>
void inEachSize(Look look) {
    for (const int percent : kSizes) {
        for (const Vec2 window : std::span(kWindows).first(support::kSanitized ? 1 : 3)) {
            SCOPED_TRACE(testing::Message()
                         << percent << " % in " << window.x << " x " << window.y);
            look(percent, window);
        }
    }
}

inline const LevelList& allLevels() {
    static const LevelList levels = [] {
        LevelList list;
        for (const std::string& name : levelNames()) {
            list.push_back(std::make_shared<const Level>(std::get<Level>(loadLevel(name))));
        }
        return list;
    }();
    return levels;
}

/// All levels of the game, with long numbers and texts wherever the player's data stands.
inline StageDef crowded(int percent, Mode mode) {
    StageDef def;
    def.levels = allLevels();
    def.profile.settings.text = percent;
    def.profile.mode = mode;
    for (const auto& level : def.levels) {
        for (const Mode each : {Mode::Standard, Mode::Pure, Mode::Assisted}) {
            def.profile.enter(each, level->name, {1234567, true, true, true});
        }
    }
    for (PlayTotals& totals : def.profile.totals) {
        totals = {12345, 6789, 1234567, 1234567, 234567, 45, 120};
    }
    def.marks = std::get<std::vector<MedalMarks>>(readMedals(assetsFolder() / "medals.toml"));
    def.endless = [](std::uint32_t, std::uint32_t) {
        return glassLevel("An endless row of stones", {7});
    };
    def.today = [] { return Day{20261126}; };
    def.daily = [](Day, std::uint32_t) { return glassLevel("Daily", {2, 7, 12}); };
    def.notices = {
        "The profile /home/username/.config/apart/profile.toml cannot be read: line 12: a "
        "number from 0 to 100 is expected, not 'loud'. It was renamed to "
        "profile.toml.broken, and a new one begins."};
    def.replays = [] {
        const ShowEntry entry{"Last game: Runaway cart (assisted)", "2026-11-26", "cannot be read",
                              1234567};
        return std::vector<ShowEntry>(kMostReplays, entry);
    };
    return def;
}

/// A stage in a window.
struct TextScreen : StageRig {
    TextScreen(StageDef def, Vec2 pixels) : StageRig(std::move(def)), window(pixels) {
        canvas.setWindow(pixels);
    }
    void expectFree(const std::string& screen) {
        frame();
        EXPECT_EQ(crowdedTexts(picture(), window), std::vector<std::string>{}) << screen;
    }
    Vec2 window;
};

} // namespace apart
