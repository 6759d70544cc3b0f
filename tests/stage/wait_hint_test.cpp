// SPDX-License-Identifier: MIT
// What picture and words say after a long time without damage, and when.
#include <apart/core/bot.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/play/play.hpp>
#include <apart/stage/records/recording.hpp>
#include <apart/stage/screens/results.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <variant>

namespace apart {
namespace {

/// A block of glass above a ledge that closes the field: no ball comes to it.
std::shared_ptr<const Level> outOfReach(const std::string& hold) {
    const std::string text = "format = 1\ntitle = \"t\"\nidea = \"i\"\n"
                             "[[ledge]]\nx = 0\ny = 9000\nwidth = 24000\nheight = 400\n"
                             "[legend.g]\nstuff = \"glass\"\nhold = \"" +
                             hold + "\"\n[[block]]\nkind = \"g\"\nx = 3000\ny = 9600\n";
    Read<Level> read = parseLevel(text, "wait", "wait");
    return std::make_shared<const Level>(std::get<Level>(std::move(read)));
}

/// Stays below the ball. `away`: moves aside while the ball is far, which fills a hollow one.
Input follow(const Game& game, bool away) {
    Input input;
    const kodo::BodyView ball = game.world()[game.balls()[0].body];
    const bool far = ball.velocity().y > 0;
    const Real x = ball.position().x + (away && far ? Real(1.5) : Real(0));
    input.target = static_cast<std::int16_t>(1000 * std::clamp(x, Real(-9), Real(9)));
    input.launch = game.serving();
    input.aim = 0;
    return input;
}

bool isHollow(const Game& game) {
    return std::any_of(game.balls().begin(), game.balls().end(),
                       [](const Ball& ball) { return ball.hollow; });
}

/// Words about mounts and waiting until the blocks shake, in the first wait so long.
std::set<std::string> wordsOf(Play& play, bool away) {
    std::set<std::string> words;
    SilentSpeaker silence;
    while (play.game().state().patience() < Patience::Failing &&
           play.game().ticks() < 30 * kTicksPerSecond) {
        play.tick(follow(play.game(), away), silence);
        for (const Popup& popup : play.juice().popups()) {
            words.insert(popup.text);
        }
        if (play.game().state().patience() == Patience::Shaking &&
            play.game().state().idleSeconds() > 6) {
            return words;
        }
    }
    ADD_FAILURE() << "there is no such wait";
    return words;
}

// Regression: a level without mounts was told of them.
TEST(WaitHint, SpeaksOfMountsWhereTheNextBlockHasOne) {
    Play mounted(outOfReach("mounted"), 1, Mode::Standard, Settings{});
    const std::set<std::string> ofMounts = wordsOf(mounted, true);
    EXPECT_TRUE(ofMounts.contains("pull now"));
    EXPECT_TRUE(ofMounts.contains("the mounts give way soon"));
    Play standing(outOfReach("standing"), 1, Mode::Standard, Settings{});
    const std::set<std::string> ofFalls = wordsOf(standing, true);
    ASSERT_FALSE(isHollow(standing.game()));
    EXPECT_TRUE(ofFalls.contains("pull now"));
    EXPECT_TRUE(ofFalls.contains("blocks fall by themselves soon"));
    EXPECT_FALSE(ofFalls.contains("the mounts give way soon"));
}

/// What is drawn of the block.
std::vector<Stroke> strokesOfBlock(const Play& play) {
    RecordingCanvas canvas;
    canvas.begin(layout::kShown, {});
    play.draw(canvas, 1);
    std::vector<Stroke> strokes;
    for (const Stroke& stroke : canvas.strokes()) {
        if (length(stroke.place - Vec2{3, Real(9.6)}) < Real(0.7)) {
            strokes.push_back(stroke);
        }
    }
    return strokes;
}

// Regression: blocks shook and glowed while the ball was hollow, though nothing gives way then.
TEST(WaitHint, IsNotGivenWhileTheBallIsHollow) {
    SilentSpeaker silence;
    for (const bool away : {false, true}) {
        Play play(outOfReach("standing"), 1, Mode::Standard, Settings{});
        const std::set<std::string> words = wordsOf(play, away);
        ASSERT_EQ(isHollow(play.game()), !away);
        EXPECT_EQ(words.contains("pull now"), away);
        const std::vector<Stroke> before = strokesOfBlock(play);
        ASSERT_FALSE(before.empty());
        for (int i = 0; i < 7; ++i) {
            play.tick(follow(play.game(), away), silence);
        }
        const std::vector<Stroke> after = strokesOfBlock(play);
        const bool still = std::equal(before.begin(), before.end(), after.begin(), after.end(),
                                      [](const Stroke& a, const Stroke& b) {
                                          return a.place == b.place && a.color.r == b.color.r &&
                                                 a.color.g == b.color.g;
                                      });
        EXPECT_EQ(still, !away);
    }
}

// Regression: the prize was 0 without a reason.
TEST(Results, OfALevelThatCameDownByItselfSayThatNoBlowCounts) {
    Play play(outOfReach("standing"), 1, Mode::Standard, Settings{});
    SilentSpeaker silence;
    RunStatistics statistics;
    while (play.game().result() == Result::Playing && play.game().ticks() < 60 * kTicksPerSecond) {
        play.tick(follow(play.game(), true), silence);
        statistics.update(play.game());
    }
    ASSERT_EQ(play.game().result(), Result::Won);
    ASSERT_EQ(play.game().counts().bestBlow, 0);
    RecordingCanvas canvas;
    canvas.begin(layout::kShown, {});
    paintResults(canvas, {play.game(), statistics, play.game().score(), false, 9});
    EXPECT_TRUE(canvas.says("no block fell by a blow"));
    EXPECT_FALSE(canvas.says("best blow: 0"));
}

} // namespace
} // namespace apart
