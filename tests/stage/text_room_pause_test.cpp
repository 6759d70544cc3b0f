// SPDX-License-Identifier: MIT
// Texts of the pause leave each other and the menu free.
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include "text_room.hpp"

namespace apart {
namespace {

/// Texts of the picture that lie on an item of the menu and are not its own.
std::vector<std::string> textsOnItems(const RecordingCanvas& canvas, const Menu& menu,
                                      Vec2 window) {
    const Real scale = window.x / canvas.visible().extent().x;
    std::vector<std::string> bad;
    for (const Stroke& stroke : canvas.strokes()) {
        for (std::size_t i = 0; i < menu.items().size(); ++i) {
            if (!stroke.text.empty() && stroke.text != menu.items()[i].label &&
                overlap(boundsOf(stroke, canvas, scale), menu.place(i))) {
                bad.push_back(stroke.text + " lies on " + menu.items()[i].label);
            }
        }
    }
    return bad;
}

// Regression: the menu has seven items then, and the line lay on the first one.
TEST(TextRoom, OfAGameTakenOverFromAReplayOfTheList) {
    const auto level = allLevels()[3];
    const Replay replay = recordedGame(level, 3, 600);
    inEachSize([&](int percent, Vec2 window) {
        StageDef def = crowded(percent, Mode::Standard);
        def.replays = [&] {
            std::vector<ShowEntry> entries(1, {"a game", "2026-11-26", "won", 12345});
            entries[0].load = [&] {
                return Show{level, 3, Mode::Standard,
                            [&replay](const Game& game) {
                                return game.ticks() < replay.end
                                           ? std::optional(inputAt(replay, game.ticks()))
                                           : std::nullopt;
                            },
                            replay.end};
            };
            return entries;
        };
        TextScreen room(std::move(def), window);
        room.clickItem(Action::Records);
        room.clickItem(Action::Replays);
        room.clickItem(Action::Replay);
        room.press(Command::Confirm); // takes over
        ASSERT_EQ(room.stage.menu().items().size(), 7u);
        EXPECT_TRUE(room.picture().says("from there you play"));
        room.expectFree("taken over");
        EXPECT_EQ(textsOnItems(room.picture(), room.stage.menu(), window),
                  std::vector<std::string>{});
    });
}

/// All texts of the picture with a space behind each, in the order of drawing.
std::string textsOf(const RecordingCanvas& canvas) {
    std::string all;
    for (const Stroke& stroke : canvas.strokes()) {
        all += stroke.text.empty() ? "" : stroke.text + ' ';
    }
    return all;
}

// Regression: at 100 % there is no room in the field for those of Lodestone and Escapement.
TEST(TextRoom, ThePauseShowsTheIdeaOfEachLevel) {
    for (const int percent : {100, 140}) {
        const std::size_t step = support::kSanitized ? 9 : 1;
        for (std::size_t i = 0; i < allLevels().size(); i += step) {
            StageDef def = crowded(percent, Mode::Standard);
            def.firstLevel = i;
            def.startAtOnce = true;
            TextScreen room(std::move(def), kWindows[1]);
            room.press(Command::Pause);
            EXPECT_NE(textsOf(room.picture()).find(allLevels()[i]->idea), std::string::npos)
                << allLevels()[i]->name;
            room.expectFree(allLevels()[i]->name);
        }
    }
}

} // namespace
} // namespace apart
