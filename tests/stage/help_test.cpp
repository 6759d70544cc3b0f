// SPDX-License-Identifier: MIT
// The help page: scenes that play themselves.
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/inset_canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/screens/help.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "stage_rig.hpp"
#include "text_bounds.hpp"

namespace apart {
namespace {

/// What happened in one showing of a scene.
struct Shown {
    int lost = 0; // lives
    int broke = 0;
    int shards = 0; // caught
    std::map<Mood, int> caught{};
    std::map<Mood, int> released{};
    int pulled = 0; // ticks
    int pushed = 0;
    int combo = 0;
    Real leastMeter = 1;
    Real meterAfter = 0; // largest one after the least
};

template <typename Kind>
int countOf(const Game& game) {
    return static_cast<int>(
        std::count_if(game.events().begin(), game.events().end(),
                      [](const Event& event) { return std::holds_alternative<Kind>(event); }));
}

void look(Shown& shown, const Game& game) {
    shown.lost += countOf<LifeLost>(game);
    shown.broke += countOf<Broke>(game);
    shown.shards += countOf<ShardCaught>(game);
    for (const Event& event : game.events()) {
        if (const auto* caught = std::get_if<Caught>(&event)) {
            ++shown.caught[moodOf(caught->power)];
        } else if (const auto* released = std::get_if<Released>(&event)) {
            ++shown.released[moodOf(released->power)];
        }
    }
    shown.pulled += game.force() == Force::Pull ? 1 : 0;
    shown.pushed += game.force() == Force::Push ? 1 : 0;
    shown.combo = std::max(shown.combo, game.counts().combo);
    if (game.meter() < shown.leastMeter) {
        shown.leastMeter = shown.meterAfter = game.meter();
    }
    shown.meterAfter = std::max(shown.meterAfter, game.meter());
}

struct Showing {
    Shown shown;
    Game end;
};

Showing showingOf(HelpTopic topic) {
    const HelpScene& scene = helpScenes()[static_cast<std::size_t>(topic)];
    Showing showing{{}, Game(levelOf(scene), scene.seed)};
    while (showing.end.ticks() < scene.ticks) {
        showing.end.tick(scene.script(showing.end));
        look(showing.shown, showing.end);
    }
    EXPECT_EQ(showing.shown.lost, 0);
    return showing;
}

TEST(HelpScenes, ShowPullAndPush) {
    const Shown pull = showingOf(HelpTopic::Pull).shown;
    EXPECT_GE(pull.pulled, kTicksPerSecond);
    EXPECT_EQ(pull.pushed, 0);
    EXPECT_GE(pull.shards, 10);
    const Shown push = showingOf(HelpTopic::Push).shown;
    EXPECT_GE(push.pushed, kTicksPerSecond);
    EXPECT_EQ(push.pulled, 0);
    EXPECT_GE(push.broke, 4);
}

TEST(HelpScenes, ShowTheMeterEmptyAndFillAgain) {
    const Shown shown = showingOf(HelpTopic::Meter).shown;
    EXPECT_LT(shown.leastMeter, 0.02);
    EXPECT_GT(shown.meterAfter, 0.3);
    EXPECT_GE(shown.shards, 5);
}

TEST(HelpScenes, ShowPartsOfAllMoods) {
    Shown shown = showingOf(HelpTopic::Moods).shown;
    for (const Mood mood : {Mood::Good, Mood::Mixed, Mood::Bad}) {
        EXPECT_GE(shown.released[mood], 2);
        EXPECT_GE(shown.caught[mood], 1);
    }
}

TEST(HelpScenes, ShowAComboAndAllHonours) {
    EXPECT_GE(showingOf(HelpTopic::Combo).shown.combo, 5);
    const Game end = showingOf(HelpTopic::Honours).end;
    EXPECT_EQ(end.result(), Result::Won);
    EXPECT_EQ(end.lives(), end.level().lives);
    EXPECT_GE(end.collapse().largest, 8);
}

TEST(HelpScenes, TheirBuildingsStandUntouched) {
    for (const HelpScene& scene : helpScenes()) {
        Game game(levelOf(scene), scene.seed);
        for (int i = 0; i < 10 * kTicksPerSecond; ++i) {
            game.tick({});
        }
        EXPECT_EQ(game.blocksLeft(), game.blocksAtStart());
    }
}

TEST(HelpPage, BeginsEachSceneAgainAndShowsTheSame) {
    HelpPage page{Settings{}};
    std::array<std::vector<std::uint64_t>, kHelpTopics> hashes;
    for (int frame = 0; frame < 60 * 26; ++frame) { // the longest scene has 11 s
        page.advance(1.0 / 60);
        for (std::size_t i = 0; i < kHelpTopics; ++i) {
            const Game& game = page.game(static_cast<HelpTopic>(i));
            if (game.ticks() == 400) {
                hashes[i].push_back(game.stateHash());
            }
        }
    }
    for (const auto& own : hashes) {
        ASSERT_GE(own.size(), 2u);
        EXPECT_EQ(own[0], own[1]);
    }
}

TEST(HelpPage, FollowsTheSpeedOfTheGameAndDropsAStall) {
    Settings settings;
    settings.speed = 50;
    HelpPage page(settings);
    for (int frame = 0; frame < 60; ++frame) {
        page.advance(1.0 / 60);
    }
    EXPECT_NEAR(page.game(HelpTopic::Pull).ticks(), 60, 1);
    page.advance(5);
    EXPECT_LE(page.game(HelpTopic::Pull).ticks(), 68u);
}

/// The most flashes of all scenes together within one second.
std::size_t mostFlashes(int calm, int seconds) {
    Settings settings;
    settings.flash = 100;
    settings.calm = calm;
    HelpPage page(settings);
    std::vector<int> starts; // frames
    std::array<float, kHelpTopics> before{};
    for (int frame = 0; frame < 60 * seconds; ++frame) {
        page.advance(1.0 / 60);
        for (std::size_t i = 0; i < kHelpTopics; ++i) {
            const Flashes& flashes = page.play(static_cast<HelpTopic>(i)).juice().flashes();
            EXPECT_TRUE(calm == 0 || flashes.punch() == 0);
            if (flashes.field() > before[i] + 0.1f) {
                starts.push_back(frame);
            }
            before[i] = flashes.field();
        }
    }
    std::size_t most = 0;
    for (std::size_t a = 0; a < starts.size(); ++a) {
        std::size_t within = 0;
        while (a + within < starts.size() && starts[a + within] < starts[a] + 60) {
            ++within;
        }
        most = std::max(most, within);
    }
    return most;
}

TEST(HelpPage, FlashesAtMostThreeASecondAndNotAtAllIfReduced) {
    const std::size_t most = mostFlashes(0, support::kSanitized ? 12 : 30);
    EXPECT_GE(most, 1u); // the test is not vacuous
    EXPECT_LE(most, 3u);
    EXPECT_EQ(mostFlashes(1, support::kSanitized ? 6 : 12), 0u);
}

TEST(HelpPage, PlaysWhileItIsOpenAndTheGameBehindItWaits) {
    StageRig rig(StageRig::playing());
    rig.frames(30);
    rig.press(Command::Pause);
    const std::uint32_t ticks = rig.stage.session().game().ticks();
    rig.clickItem(Action::Help);
    rig.frames(30);
    const std::vector<Stroke> first = rig.picture().strokes();
    rig.frames(30);
    const std::vector<Stroke>& second = rig.picture().strokes();
    const auto same = [](const Stroke& a, const Stroke& b) {
        return a.place == b.place && a.color == b.color;
    };
    EXPECT_FALSE(std::equal(first.begin(), first.end(), second.begin(), second.end(), same));
    EXPECT_EQ(rig.stage.session().game().ticks(), ticks);
    EXPECT_FALSE(rig.picture().says("SCORE")) << "the page covers the game";
    for (const char* words : {"pull", "push", "meter", "marks", "combo", "honours"}) {
        EXPECT_TRUE(rig.picture().says(words)) << words;
    }
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
}

TEST(HelpPage, TellsOfTheHollowServeInOneLineOfItsFullSize) {
    for (const int percent : {100, 140}) {
        for (const bool fingers : {false, true}) {
            Settings settings;
            settings.text = percent;
            HelpPage page{settings};
            Bindings keys;
            keys.fingers = fingers;
            RecordingCanvas canvas;
            canvas.setWindow({1280, 800});
            canvas.begin(layout::kShownTitle, {});
            canvas.setTextScale(static_cast<Real>(percent) / 100);
            page.draw(canvas, keys);
            EXPECT_TRUE(canvas.says("hollow"));
            const auto& strokes = canvas.strokes();
            const auto line = std::find_if(strokes.begin(), strokes.end(), [](const Stroke& text) {
                return text.text.starts_with("at buildings or joints the serve clears nothing");
            });
            ASSERT_NE(line, strokes.end());
            Stroke unbounded = *line;
            unbounded.style.room = 0;
            EXPECT_LE(sizeOf(unbounded, canvas, Real(1280) / Real(31.2)).x, line->style.room)
                << percent;
        }
    }
}

/// What the captions of two scenes with buildings say of a hollow ball, and of a filled one.
struct HollowWords {
    HelpTopic topic;
    const char* hollow;
    const char* filled;
};

// Regression: the scene of the push, which has a building too, did not say so.
TEST(HelpPage, SaysWhileTheServeOfABuildingIsHollow) {
    for (const auto& [topic, hollowText, filledText] :
         {HollowWords{HelpTopic::Honours, "the serve is hollow", "medals by score"},
          HollowWords{HelpTopic::Push, "the ball is hollow: it clears nothing yet",
                      "balls, shards and rubble fly from the paddle"}}) {
        HelpPage page{Settings{}};
        const Game& game = page.game(topic);
        int hollow = 0;
        int filled = 0;
        for (int i = 0; i < 60 * 9; ++i) {
            page.advance(1.0 / 60);
            RecordingCanvas canvas;
            canvas.begin(layout::kShownTitle, {});
            page.draw(canvas, Bindings{});
            const bool is = !game.balls().empty() && game.balls()[0].hollow;
            EXPECT_EQ(canvas.says(hollowText), is) << i;
            EXPECT_EQ(canvas.says(filledText), !is) << i;
            (is ? hollow : filled) += 1;
        }
        EXPECT_GT(hollow, 60);
        EXPECT_GT(filled, 60);
    }
}

TEST(HelpPage, TurnsToAPageOfAllPowersAndBack) {
    StageRig rig(StageRig::twoLevels());
    rig.clickItem(Action::Help);
    EXPECT_FALSE(rig.picture().says("The powers"));
    rig.press(Command::Right);
    const RecordingCanvas& page = rig.picture();
    for (std::size_t i = 1; i < kPowerNames.size(); ++i) {
        EXPECT_TRUE(page.says(kPowerNames[i])) << kPowerNames[i];
        const Color color = page.palette().of(static_cast<Power>(i));
        EXPECT_TRUE(std::any_of(
            page.strokes().begin(), page.strokes().end(),
            [&](const Stroke& stroke) { return stroke.text.empty() && stroke.color == color; }))
            << "a picture of " << kPowerNames[i];
    }
    rig.click({0, 9});
    EXPECT_FALSE(rig.picture().says("The powers"));
    rig.press(Command::Left);
    EXPECT_TRUE(rig.picture().says("The powers"));
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    rig.clickItem(Action::Help);
    EXPECT_FALSE(rig.picture().says("The powers")) << "it opens at the first page";
}

// Regression: the words of the combo were cut by the upper edge.
TEST(HelpPage, WordsOfAGameStayInsideTheFrameOfItsScene) {
    for (const int percent : support::variants({140, 100})) {
        Settings settings;
        settings.text = percent;
        HelpPage page{settings};
        int words = 0;
        for (int i = 0; i < 60 * 11; ++i) {
            page.advance(1.0 / 60);
            RecordingCanvas canvas;
            canvas.setWindow({1280, 800});
            canvas.begin(layout::kShownTitle, {});
            canvas.setTextScale(static_cast<Real>(percent) / 100);
            page.draw(canvas, Bindings{});
            const auto& strokes = canvas.strokes();
            const auto isFrame = [](const Stroke& stroke) {
                return stroke.kind == Stroke::Kind::Outline && stroke.color.a == 153 &&
                       stroke.color.r == palette::kMachine.r;
            };
            const auto frames = std::find_if(strokes.begin(), strokes.end(), isFrame);
            ASSERT_NE(frames, strokes.end());
            const Real height = Real(16.7) - frames->place.y; // of the first row
            for (auto text = strokes.begin(); text != frames; ++text) {
                if (text->kind != Stroke::Kind::Text || text->place.y < 0) {
                    continue;
                }
                const Aabb bounds = boundsOf(*text, canvas, Real(1280) / Real(31.2));
                ++words;
                EXPECT_TRUE(std::any_of(
                    frames, strokes.end(),
                    [&](const Stroke& frame) {
                        return isFrame(frame) &&
                               Aabb{frame.place, frame.place + Vec2{Real(9.2), height}}.contains(
                                   bounds);
                    }))
                    << text->text << " at " << i;
            }
        }
        EXPECT_GT(words, 100);
    }
}

TEST(HelpPage, DrawsFewPrimitives) {
    HelpPage page{Settings{}};
    RecordingCanvas canvas;
    std::size_t most = 0;
    for (int frame = 0; frame < 60 * 12; ++frame) {
        page.advance(1.0 / 60);
        canvas.begin(layout::kShownTitle, {});
        page.draw(canvas, Bindings{});
        most = std::max(most, canvas.strokes().size());
    }
    EXPECT_LT(most, 6000u);
}

TEST(InsetCanvas, MapsItsRegionAndLeavesOutTheRest) {
    RecordingCanvas page;
    page.begin({{0, 0}, {40, 40}}, {});
    InsetCanvas inset(page, {{-2, 0}, {2, 2}}, {{10, 10}, {12, 11}}, Vision::Usual);
    inset.disc({1, 1}, 1, palette::kText, palette::kText);
    inset.disc({5, 1}, 1, palette::kText, palette::kText); // outside
    inset.line({3, 0}, {9, 9}, 1, palette::kText);         // outside
    inset.rectangle({{-9, -9}, {9, 9}}, palette::kText, palette::kText);
    inset.text("word", {-2, 0}, {Real(0.8), palette::kText});
    ASSERT_EQ(page.strokes().size(), 3u);
    EXPECT_EQ(page.strokes()[0].place, (Vec2{Real(11.5), Real(10.5)}));
    EXPECT_EQ(page.strokes()[0].size, Real(0.5));
    EXPECT_EQ(page.strokes()[1].place, (Vec2{10, 10})) << "ends at the edge";
    EXPECT_EQ(page.strokes()[2].style.height, Real(0.4));
}

} // namespace
} // namespace apart
