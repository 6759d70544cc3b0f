// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/recording.hpp>
#include <apart/stage/stage.hpp>

#include <initializer_list>
#include <memory>

namespace apart {

/// A level with glass blocks in those columns of its third row.
inline std::shared_ptr<const Level> glassLevel(const char* title,
                                               std::initializer_list<int> columns) {
    Level level;
    level.name = "test";
    level.title = title;
    level.idea = "Only for tests.";
    level.kinds = {{'g', Stuff::Glass, Power::None, Pattern::Shatter, 3000}};
    for (const int column : columns) {
        level.cells.push_back({2, static_cast<std::uint8_t>(column), 0});
    }
    return std::make_shared<const Level>(level);
}

/// A stage with everything around it recorded.
struct StageRig {
    explicit StageRig(StageDef def) : stage(std::move(def)) {}

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

    void frame(const Signals& signals = {}, double seconds = 1.0 / 60) {
        stage.advance(seconds, signals, speaker);
    }
    void press(Command command) {
        Signals signals;
        signals.commands = {command};
        frame(signals);
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
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

} // namespace apart
