// SPDX-License-Identifier: MIT
// At each size of texts and in each window, texts leave each other free and stay in the picture.
#include <apart/core/assets.hpp>
#include <apart/core/medals.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/results.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kept_free.hpp"
#include "text_room.hpp"

namespace apart {
namespace {

TEST(TextRoom, OfTheScreensAroundTheGame) {
    for (const Mode mode : {Mode::Standard, Mode::Assisted}) {
        inEachSize([&](int percent, Vec2 window) {
            TextScreen room(crowded(percent, mode), window);
            room.expectFree("title");
            room.press(Command::Back);
            room.expectFree("title with a question");
            room.frames(200);
            room.clickItem(Action::Records);
            room.expectFree("records");
            room.clickItem(Action::Replays);
            room.expectFree("replays");
            room.press(Command::Back);
            room.press(Command::Back);
            room.clickItem(Action::Options);
            for (std::size_t page = 0; page < kDialPages.size(); ++page) {
                room.expectFree("options");
                room.clickItem(Action::Reset);
                room.expectFree("options with a question");
                room.press(Command::Up); // the question is gone
                room.clickItem(Action::Page);
            }
            room.clickItem(Action::Keys);
            room.expectFree("keys");
            room.press(Command::Confirm);
            room.expectFree("keys, one is expected");
        });
    }
}

TEST(TextRoom, OfTheHelp) {
    inEachSize([](int percent, Vec2 window) {
        TextScreen room(crowded(percent, Mode::Standard), window);
        room.clickItem(Action::Help);
        for (int i = 0; i < 4; ++i) {
            room.expectFree("help");
            room.frames(100);
        }
        room.press(Command::Right);
        EXPECT_TRUE(room.picture().says("The powers"));
        room.expectFree("powers");
    });
}

TEST(TextRoom, OfEachLevelOnTheMapAndBesideTheField) {
    const std::size_t step = support::kSanitized ? 9 : 1;
    for (const int percent : kSizes) {
        for (const Mode mode : {Mode::Standard, Mode::Assisted}) {
            SCOPED_TRACE(percent);
            const Vec2 window =
                kWindows[1]; // its letters are the smallest: most is lost by rounding
            for (std::size_t i = 0; i < allLevels().size(); i += step) {
                LevelMap map(allLevels(), {kBosses});
                map.choose(i);
                RecordingCanvas canvas;
                canvas.setWindow(window);
                canvas.begin(layout::kShownTitle, {});
                canvas.setTextScale(static_cast<Real>(percent) / 100);
                StageDef def = crowded(percent, mode);
                Records records(def.profile, {}, {}, {});
                records.setMarks(def.marks);
                map.draw(canvas, records, 0);
                EXPECT_EQ(crowdedTexts(canvas, window), std::vector<std::string>{}) << i;
                Profile fresh; // no scores, but medals to win
                fresh.mode = mode;
                Records none(fresh, {}, {}, {});
                none.setMarks(def.marks);
                canvas.begin(layout::kShownTitle, {});
                map.update(none); // most levels are closed
                map.draw(canvas, none, 0);
                EXPECT_EQ(crowdedTexts(canvas, window), std::vector<std::string>{}) << i;

                Game game(allLevels()[i], 1, mode);
                HudLook look;
                look.place = "LEVEL 56 OF 56";
                look.scoreBefore = look.best = 1234567;
                look.pilot = "REPLAY  paused";
                look.foot = "59:59 of 59:59";
                canvas.begin(layout::kShown, {});
                paintHud(canvas, game, look);
                paintServeHint(canvas, game, Bindings{});
                EXPECT_EQ(crowdedTexts(canvas, window), std::vector<std::string>{}) << i;
            }
        }
    }
}

/// Names of the levels where a word of the hints covers a block, a rope, or the dots of the serve.
std::set<std::string> coveredLevels(int percent) {
    std::set<std::string> bad;
    int whole = 0; // levels with their title in the field
    for (const auto& level : allLevels()) {
        Game game(level, 1);
        RecordingCanvas canvas;
        canvas.setTextScale(static_cast<Real>(percent) / 100);
        canvas.begin(layout::kShown, {});
        paintServeHint(canvas, game, Bindings{});
        const std::vector<Aabb> free = keptFree(game);
        EXPECT_TRUE(canvas.says("to serve")) << level->name;
        whole += canvas.says(level->title) ? 1 : 0;
        for (const Stroke& stroke : canvas.strokes()) {
            const Aabb box = boundsOf(stroke, canvas, Real(40));
            if (!stroke.text.empty() && std::any_of(free.begin(), free.end(), [&](const Aabb& f) {
                    return overlap(box, f);
                })) {
                bad.insert(level->name + ": " + stroke.text);
            }
        }
    }
    EXPECT_GE(whole, static_cast<int>(allLevels().size()) * 9 / 10);
    return bad;
}

TEST(TextRoom, WordsBeforeAServeCoverNoBlockRopeOrDot) {
    EXPECT_EQ(coveredLevels(100), std::set<std::string>{});
    EXPECT_EQ(coveredLevels(140), std::set<std::string>{});
}

TEST(TextRoom, OfAGameAndItsPause) {
    for (const Mode mode : {Mode::Standard, Mode::Assisted}) {
        inEachSize([&](int percent, Vec2 window) {
            TextScreen room(crowded(percent, mode), window);
            room.clickItem(Action::Daily);
            room.expectFree("serve");
            makePoints(room);
            room.press(Command::Restart);
            EXPECT_TRUE(room.picture().says("once more"));
            room.expectFree("a question in play");
            room.press(Command::Pause);
            room.expectFree("paused with a question");
            room.frames(200);
            room.expectFree("paused");
        });
    }
}

TEST(TextRoom, OfAReplay) {
    const auto level = allLevels()[3];
    const Replay replay = recordedGame(level, 3, 600);
    inEachSize([&](int percent, Vec2 window) {
        StageDef def = crowded(percent, Mode::Standard);
        def.show = Show{level, 3, Mode::Standard,
                        [&replay](const Game& game) {
                            return game.ticks() < replay.end
                                       ? std::optional(inputAt(replay, game.ticks()))
                                       : std::nullopt;
                        },
                        replay.end};
        TextScreen room(std::move(def), window);
        room.expectFree("replay");
        room.press(Command::Launch);
        room.expectFree("replay, paused");
        room.press(Command::Back);
        room.expectFree("menu of a replay");
        room.press(Command::Back);
        room.press(Command::Confirm);
        room.expectFree("what if");
    });
}

/// The result of a game with points from each source.
TEST(TextRoom, OfTheResult) {
    for (const auto& level : allLevels()) {
        Game game(level, 1);
        RunStatistics run;
        run.broken = run.fallen = run.caught = 123;
        run.bestCombo = run.largestFall = 123;
        run.points = {123456, 123456, 123456, 123456, 12345, 2000};
        run.ticks = 3599 * kTicksPerSecond;
        const std::vector<MedalMarks> marks = {{level->name, 0, {1, 2, 9999999}, 123, 123}};
        inEachSize([&](int percent, Vec2 window) {
            RecordingCanvas canvas;
            canvas.setWindow(window);
            canvas.begin(layout::kShown, {});
            canvas.setTextScale(static_cast<Real>(percent) / 100);
            paintHud(canvas, game, {});
            paintResults(canvas, {game, run, 1234567, true, 9, marks});
            Menu({{Action::NextLevel, "Next level"},
                  {Action::Restart, "Play again"},
                  {Action::Levels, "All levels"},
                  {Action::ToTitle, "Title"}},
                 Real(5.1))
                .draw(canvas);
            EXPECT_EQ(crowdedTexts(canvas, window), std::vector<std::string>{}) << level->name;
        });
    }
}

// Below the result, and below the menu of the pause.
TEST(TextRoom, OfWhatIsLostAndOfErrorsInALevelFile) {
    inEachSize([](int percent, Vec2 window) {
        StageDef def = StageRig::playing();
        def.profile.settings.text = percent;
        def.keeping.save = [](const Profile&) {
            return std::string("Settings and scores are not kept: /home/username/.config/apart/"
                               "profile.toml: cannot be written: No space left on device.");
        };
        def.reload = [] {
            const std::string fault = "/home/username/towers/my_tower.toml:12: width must be a "
                                      "whole number from 100 to 24000";
            return std::optional(LevelChange{nullptr, {fault, fault}});
        };
        TextScreen room(std::move(def), window);
        room.press(Command::Pause);
        EXPECT_TRUE(room.picture().says("my_tower.toml:12: width"));
        room.expectFree("paused");
        room.press(Command::Pause);
        playToTheEnd(room);
        EXPECT_TRUE(room.picture().says("not kept"));
        room.expectFree("results");
    });
}

/// Pairs of texts with less than `gap` (m) between the bounds of their letters, one above the
/// other.
std::vector<std::string> touchingTexts(const RecordingCanvas& canvas, Vec2 window, Real gap) {
    const Real scale = window.x / canvas.visible().extent().x;
    std::vector<std::string> bad;
    for (const Stroke& a : canvas.strokes()) {
        for (const Stroke& b : canvas.strokes()) {
            if (a.text.empty() || b.text.empty() || a.place.y <= b.place.y) {
                continue;
            }
            Aabb lower = boundsOf(b, canvas, scale);
            lower.upper.y += gap;
            if (overlap(boundsOf(a, canvas, scale), lower)) {
                bad.push_back(a.text + " | touches | " + b.text);
            }
        }
    }
    return bad;
}

TEST(TextRoom, LinesOfTheBestScoreDoNotTouch) {
    for (const int percent : kSizes) {
        for (const std::int32_t score : {0, 6140}) {
            StageDef def = crowded(percent, Mode::Standard);
            Records records({}, {}, {}, {});
            records.setMarks(def.marks);
            const std::string& name = def.levels[0]->name;
            records.enter({{Mode::Standard, name}, {score, true, false, false}, {}});
            RecordingCanvas canvas;
            canvas.setWindow(kWindows[0]);
            canvas.begin(layout::kShownTitle, {});
            canvas.setTextScale(static_cast<Real>(percent) / 100);
            LevelMap(def.levels).draw(canvas, records, 0);
            EXPECT_EQ(canvas.says("6 140"), score > 0);
            const auto bad = touchingTexts(canvas, kWindows[0], Real(0.08)); // 3 pixels
            EXPECT_EQ(bad, std::vector<std::string>{}) << percent << " " << score;
        }
    }
}

TEST(TextRoom, LinesOfAnHonourHaveOneSize) {
    const auto level = allLevels()[0];
    const Game game(level, 1);
    const RunStatistics run;
    const std::vector<MedalMarks> marks = {{level->name, 0, {1, 2, 3}, 123, 123}};
    for (const int percent : kSizes) {
        RecordingCanvas canvas;
        canvas.setWindow(kWindows[0]);
        canvas.begin(layout::kShown, {});
        canvas.setTextScale(static_cast<Real>(percent) / 100);
        paintResults(canvas, {game, run, 1, false, 9, marks});
        const Real scale = kWindows[0].x / canvas.visible().extent().x;
        std::vector<Real> heights;
        for (const Stroke& stroke : canvas.strokes()) {
            if (stroke.text == "8 in one combo" || stroke.text == "or fall") {
                heights.push_back(sizeOf(stroke, canvas, scale).y);
            }
        }
        ASSERT_EQ(heights.size(), 2u);
        EXPECT_EQ(heights[0], heights[1]) << percent;
    }
}

/// Texts of the picture with letters below 0.2 m, which is 8 pixels in the usual window.
std::vector<std::string> tinyTexts(const RecordingCanvas& canvas, Vec2 window) {
    const Real scale = window.x / canvas.visible().extent().x;
    std::vector<std::string> bad;
    for (const Stroke& stroke : canvas.strokes()) {
        if (!stroke.text.empty() && sizeOf(stroke, canvas, scale).y < Real(0.2)) {
            bad.push_back(stroke.text);
        }
    }
    return bad;
}

// A level file may have texts of 160 bytes, with or without spaces.
TEST(TextRoom, LongTextsOfALevelAreCutAndStayLegible) {
    std::string words;
    while (words.size() < 155) {
        words += "Wide ";
    }
    for (const std::string& text : {words, std::string(160, 'W')}) {
        inEachSize([&](int percent, Vec2 window) {
            Level level = *glassLevel("x", {7});
            level.title = level.idea = text;
            StageDef def = crowded(percent, Mode::Standard);
            def.levels = {std::make_shared<const Level>(level)};
            def.replays = [&] { return std::vector<ShowEntry>(2, {"Last game: " + text}); };
            TextScreen room(std::move(def), window);
            const auto expectLegible = [&](const std::string& screen) {
                room.expectFree(screen);
                EXPECT_EQ(tinyTexts(room.picture(), window), std::vector<std::string>{}) << screen;
                EXPECT_TRUE(room.picture().says("...")) << screen;
            };
            expectLegible("title");
            room.clickItem(Action::Levels);
            expectLegible("map");
            room.press(Command::Back);
            room.clickItem(Action::Records);
            room.clickItem(Action::Replays);
            expectLegible("replays");
            room.press(Command::Back);
            room.press(Command::Back);
            room.clickItem(Action::Play);
            expectLegible("serve");
            room.press(Command::Pause);
            expectLegible("paused");
            RecordingCanvas canvas;
            canvas.setWindow(window);
            canvas.begin(layout::kShown, {});
            canvas.setTextScale(static_cast<Real>(percent) / 100);
            const RunStatistics run;
            paintResults(canvas, {room.stage.session().game(), run, 1, false, 9, {}});
            EXPECT_EQ(tinyTexts(canvas, window), std::vector<std::string>{});
        });
    }
}

} // namespace
} // namespace apart
