// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/records/recording.hpp>
#include <apart/stage/stage.hpp>

#include <game/level_of_glass.hpp>
#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <vector>

namespace apart {

/// A level with glass blocks in the given columns of its third row.
inline std::shared_ptr<const Level> glassLevel(const char* title,
                                               std::initializer_list<int> columns) {
    Level level = levelOfGlass(columns);
    level.name = "test_" + std::to_string(columns.size());
    level.title = title;
    level.idea = "Only for tests.";
    return std::make_shared<const Level>(level);
}

/// The bot's game on a level, recorded, of at most so many ticks.
inline Replay recordedGame(const std::shared_ptr<const Level>& level, std::uint32_t seed,
                           std::uint32_t mostTicks = 5 * 60 * kTicksPerSecond) {
    Game game(level, seed);
    Recorder recorder(game);
    while (game.ticks() < mostTicks && game.result() == Result::Playing) {
        const Input input = bot(game);
        game.tick(input);
        recorder.record(input, game);
    }
    return recorder.finish(game);
}

/// A stage with recording canvas and speaker.
struct StageRig {
    explicit StageRig(StageDef def) : stage(std::move(def)) {}

    /// Appends each saved profile to `kept`.
    static std::function<std::string(const Profile&)> keeping(std::vector<Profile>& kept) {
        return [&kept](const Profile& profile) {
            kept.push_back(profile);
            return std::string();
        };
    }

    static StageDef twoLevels() {
        StageDef def;
        def.levels = {glassLevel("One block", {7}), glassLevel("Three blocks", {2, 7, 12})};
        return def;
    }
    static StageDef playing() {
        StageDef def = twoLevels();
        def.startAtOnce = true;
        return def;
    }
    static StageDef played() { // by the bot
        StageDef def = playing();
        def.pilot = [](const Game& game) { return std::optional(bot(game)); };
        return def;
    }
    static StageDef playedStraight() { // by the bot, with a serve that is not aimed
        StageDef def = playing();
        def.pilot = [](const Game& game) {
            Input input = bot(game);
            input.aim.reset();
            return std::optional(input);
        };
        return def;
    }

    void frame(const Signals& signals = {}, double seconds = 1.0 / 60) {
        stage.advance(seconds, signals, speaker);
    }
    /// A result lets nothing be chosen at first.
    void untilChoice() {
        while (!stage.takesChoice()) {
            frame();
        }
    }
    void press(Command command) {
        untilChoice();
        Signals signals;
        signals.commands = {command};
        frame(signals);
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
        }
    }
    void click(Vec2 place) {
        untilChoice();
        Signals signals;
        signals.pointer = signals.pointerNow = place;
        signals.clicked = true;
        frame(signals);
    }
    /// Clicks a menu item with the mouse.
    void clickItem(Action action) {
        for (std::size_t i = 0; i < stage.menu().items().size(); ++i) {
            if (stage.menu().items()[i].action == action) {
                return click(stage.menu().place(i).center());
            }
        }
        FAIL() << "no such item";
    }
    void untilOver() {
        for (int i = 0; i < 60 * 300 && stage.screen() == Screen::Playing; ++i) {
            frame(); // five minutes: the bot needs a few seconds per block
        }
    }
    const RecordingCanvas& picture() {
        stage.draw(canvas);
        return canvas;
    }

    Stage stage;
    RecordingSpeaker speaker;
    RecordingCanvas canvas;
};

/// Plays until the game has points; it must not be over then.
inline void makePoints(StageRig& rig) {
    for (int i = 0; i < 60 * 60 && rig.stage.session().game().score() == 0; ++i) {
        const Game& game = rig.stage.session().game();
        Signals signals;
        const Input wish = bot(game);
        const Real x = game.world()[game.paddle()].position().x;
        signals.leftHeld = wish.target && Real(*wish.target) / 1000 < x - Real(0.2);
        signals.rightHeld = wish.target && Real(*wish.target) / 1000 > x + Real(0.2);
        signals.commands = {Command::Launch};
        rig.frame(signals);
    }
    ASSERT_GT(rig.stage.session().game().score(), 0);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Playing);
}

/// One frame of a tick with the bot's move by keys.
inline void makeMove(StageRig& rig) {
    const Game& game = rig.stage.session().game();
    const Input wish = bot(game);
    Signals signals;
    const Real x = game.world()[game.paddle()].position().x;
    if (wish.target) {
        signals.leftHeld = Real(*wish.target) / 1000 < x - Real(0.2);
        signals.rightHeld = Real(*wish.target) / 1000 > x + Real(0.2);
    }
    if (wish.launch && game.result() == Result::Playing) {
        signals.commands = {Command::Launch};
    }
    rig.frame(signals, 1.0 / kTicksPerSecond);
}

/// Plays the bot's moves to the result screen.
inline void playToTheEnd(StageRig& rig) {
    for (int i = 0; i < 120 * 300 && rig.stage.screen() == Screen::Playing; ++i) {
        makeMove(rig);
    }
}

} // namespace apart
